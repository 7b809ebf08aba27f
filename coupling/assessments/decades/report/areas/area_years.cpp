#include "coupling/assessments/decades/report/areas/area_years.hpp"

#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::decades {
namespace {

using report::page_text;

/// Years from one to the next, where these are always the same and many enough to be said so.
std::optional<int> common_step(const std::vector<int>& years) {
    constexpr std::size_t least_for_a_step = 4;
    if (years.size() < least_for_a_step) {
        return std::nullopt;
    }
    for (std::size_t i = 2; i < years.size(); ++i) {
        if (years[i] - years[i - 1] != years[1] - years[0]) {
            return std::nullopt;
        }
    }
    return years[1] - years[0];
}

/// Years of the run as calendar years; requires one at least.
std::string calendar_in_words(const std::vector<int>& years, int start_calendar_year) {
    const auto calendar = [&](int year) { return std::to_string(start_calendar_year + year); };
    if (const auto step = common_step(years)) {
        const std::string first = calendar(years.front());
        const std::string last = calendar(years.back());
        return *step == 1 ? page_text("each year from {first} to {last}", {{"first", first}, {"last", last}})
                          : page_text("every {step} years from {first} to {last}",
                                      {{"step", std::to_string(*step)}, {"first", first}, {"last", last}});
    }
    std::vector<std::string> texts;
    for (const int year : years) {
        texts.push_back(calendar(year));
    }
    return page_text("in {years}", {{"years", report::join_with_and(texts)}});
}

std::string after_in_words(const std::string& row, int years) {
    return years == 0 ? page_text("in the year of {row}", {{"row", row}})
           : years == 1
               ? page_text("1 year after {row}", {{"row", row}})
               : page_text("{years} years after {row}", {{"years", std::to_string(years)}, {"row", row}});
}

}  // namespace

std::string when_in_words(const PlannedYears& planned, const Regime& regime, std::size_t row,
                          int start_calendar_year) {
    if (!planned.after && planned.years.empty()) {
        return page_text("not in the years of the run");
    }
    if (planned.once) {
        return page_text("once from {year} on, where {condition}",
                         {{"year", std::to_string(start_calendar_year + planned.years.front())},
                          {"condition", planned.condition}});
    }
    const std::string when = planned.after ? after_in_words(regime.interventions()[*planned.after].name,
                                                            regime.interventions()[row].after_years)
                                           : calendar_in_words(planned.years, start_calendar_year);
    return planned.condition.empty()
               ? when
               : page_text("{when}, where {condition}", {{"when", when}, {"condition", planned.condition}});
}

std::string years_on_map(const PlannedYears& planned, int start_calendar_year) {
    if (planned.years.empty() || !planned.condition.empty()) {
        return "";
    }
    const auto calendar = [&](std::size_t i) {
        return std::to_string(start_calendar_year + planned.years[i]);
    };
    constexpr std::size_t most = 2;
    return planned.years.size() > most    ? calendar(0) + " …"
           : planned.years.size() == most ? report::join_with_commas({calendar(0), calendar(1)})
                                          : calendar(0);
}

}  // namespace coupling::decades
