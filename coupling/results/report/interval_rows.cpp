#include "coupling/results/report/interval_rows.hpp"

#include <cmath>
#include <utility>

#include "config/text/joined.hpp"
#include "coupling/results/text/element.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::report {

using config::joined;

std::string interval_in_words(const Interval& interval, Written written) {
    if (std::isnan(interval.low)) {
        return std::isinf(interval.high)
                   ? page_text("not known")
                   : page_text("at most {interval_high}", {{"interval_high", written(interval.high)}});
    }
    if (std::isinf(interval.high)) {
        return page_text("from {interval_low} on", {{"interval_low", written(interval.low)}});
    }
    return page_text("{interval_low} to {interval_high}",
                     {{"interval_low", written(interval.low)}, {"interval_high", written(interval.high)}});
}

std::string cause_bar(const std::vector<NamedShare>& causes) {
    constexpr double width = 150.0;
    constexpr double height = 10.0;
    std::string parts = element(
        "rect", {{"x", 0.0}, {"y", 0.0}, {"width", width}, {"height", height}, {"class", "area bare"}});
    double x = 0.0;
    double opacity = 1.0;
    for (const auto& [name, share] : causes) {
        parts += element(
            "rect",
            {{"x", x}, {"y", 0.0}, {"width", width * share}, {"height", height}, {"fill-opacity", opacity}},
            element("title", {}, escaped(name)));
        x += width * share;
        opacity *= 0.6;
    }
    return element("svg",
                   {{"class", "causes"},
                    {"viewBox", joined("0 0 ", place(width), " ", place(height))},
                    {"width", width},
                    {"height", height},
                    {"role", "img"},
                    {"aria-label", page_text("what brings the second interval")}},
                   parts);
}

void IntervalRows::add(const std::string& name, const std::optional<DrawnFigure>& figure, Written written) {
    if (!figure) {
        return;
    }
    const std::vector<NamedShare> causes = main_causes(*figure, draws_);
    rows_.push_back({{"figure", name},
                     {"value", written(figure->value)},
                     {"of_rocks", interval_in_words(figure->of_rocks, written)},
                     {"of_all", interval_in_words(figure->of_all, written)},
                     {"bar", causes.empty() ? "" : cause_bar(causes)},
                     {"causes", join_with_semicolons(
                                    {main_causes_in_words(*figure, draws_), spread_in_words(*figure)})}});
}

void IntervalRows::end_group(const std::string& name) {
    if (!rows_.empty()) {
        groups_.push_back({{"name", name}, {"figures", std::exchange(rows_, {})}});
    }
}

PageFields IntervalRows::fields() && {
    return {{"groups", std::move(groups_)}};
}

}  // namespace coupling::report
