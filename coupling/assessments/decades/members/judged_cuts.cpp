#include "coupling/assessments/decades/members/judged_cuts.hpp"

#include <algorithm>
#include <array>
#include <set>

#include "config/text/joined.hpp"
#include "coupling/inputs/scenario/scenario.hpp"

namespace coupling::decades {

bool is_rock_year(std::int32_t year, const Scenario& scenario) {
    const auto every = static_cast<std::int32_t>(scenario.forest.rockfall_every);
    return every > 0 && (year % every == 0 || year == static_cast<std::int32_t>(scenario.run.years));
}

std::vector<std::int32_t> rock_years_of(const Scenario& scenario) {
    std::vector<std::int32_t> years;
    for (std::int32_t year = 0; year <= static_cast<std::int32_t>(scenario.run.years); ++year) {
        if (is_rock_year(year, scenario)) {
            years.push_back(year);
        }
    }
    return years;
}

bool is_cut(std::string_view treatment) {
    constexpr std::array others{Treatment::salvage, Treatment::tend, Treatment::fence, Treatment::plant,
                                Treatment::plant_clusters};
    return std::none_of(others.begin(), others.end(),
                        [&](Treatment other) { return name_of(other) == treatment; });
}

bool is_judged(std::int32_t cut, std::span<const std::int32_t> rock_years) {
    constexpr std::int32_t years_after = 2;
    return std::any_of(rock_years.begin(), rock_years.end(),
                       [&](std::int32_t year) { return year >= cut && year <= cut + years_after; });
}

std::vector<std::string> unjudged_plans(std::span<const Regime> regimes, const Scenario& scenario) {
    const std::vector<std::int32_t> rock_years = rock_years_of(scenario);
    const auto years = static_cast<std::int32_t>(scenario.run.years);
    std::vector<std::string> sentences;
    for (const Regime& regime : regimes) {
        std::set<std::int32_t> unjudged;
        for (const Intervention& row : regime.interventions()) {
            const bool by_calendar = row.after.empty() && row.treatment != Treatment::fell_list;
            if (rock_years.empty() || !by_calendar || !is_cut(name_of(row.treatment))) {
                continue;
            }
            const std::int32_t last =
                std::min(years, static_cast<std::int32_t>(row.last_year.value_or(years)));
            const std::int32_t step = std::max(1, row.every_years.value_or(years + 1));
            for (std::int32_t year = row.first_year; year <= last; year += step) {
                if (!is_judged(year, rock_years)) {
                    unjudged.insert(year);
                }
            }
        }
        if (!unjudged.empty()) {
            sentences.push_back(config::joined(
                "regime ", regime.name(), " may cut in year ", std::to_string(*unjudged.begin()),
                ", and no rocks fall then or in the two years after: what such cuts cost is not judged; set "
                "run.rockfall_every to 1, with fewer rocks a year, which takes no longer"));
        }
    }
    return sentences;
}

}  // namespace coupling::decades
