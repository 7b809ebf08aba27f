#include <algorithm>
#include <cmath>

#include "config/text/joined.hpp"
#include "coupling/assessments/today/report/sections.hpp"
#include "coupling/results/figures/drawn_words.hpp"
#include "coupling/results/text/element.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::report {
namespace {

using config::joined;

/// Writes a value of a figure.
using Written = std::string (*)(double);

std::string interval_of(const Interval& interval, Written written) {
    if (std::isinf(interval.high)) {
        return page_text("from {interval_low} on", {{"interval_low", written(interval.low)}});
    }
    return page_text("{interval_low} to {interval_high}",
                     {{"interval_low", written(interval.low)}, {"interval_high", written(interval.high)}});
}

/// Its parts are what single parameters bring, darkest first; what is left is joint or small.
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

class IntervalRows {
public:
    explicit IntervalRows(const RunResults& results) : draws_{*results.draws} {}

    void add(const std::string& name, const std::optional<DrawnFigure>& figure, Written written) {
        if (!figure) {
            return;
        }
        const std::vector<NamedShare> causes = main_causes(*figure, draws_);
        rows_.push_back({{"figure", name},
                         {"value", written(figure->value)},
                         {"of_rocks", interval_of(figure->of_rocks, written)},
                         {"of_all", interval_of(figure->of_all, written)},
                         {"bar", causes.empty() ? "" : cause_bar(causes)},
                         {"causes", main_causes_in_words(*figure, draws_)}});
    }
    [[nodiscard]] std::vector<PageFields> rows() && { return std::move(rows_); }

private:
    const ParameterDraws& draws_;
    std::vector<PageFields> rows_;
};

std::string on_slope(const char* figure, Cover cover) {
    return joined(page_text(figure), ", ", title_of(cover));
}

}  // namespace

std::optional<PageFields> two_intervals(const RunResults& results, const Figures& figures) {
    if (!figures.drawn) {
        return std::nullopt;
    }
    constexpr std::size_t most_targets = 4;
    const std::vector<Cover> covers = covers_of(results);
    std::vector<PageFields> groups;
    // A target that no rock reaches has no figures.
    const auto add_group = [&](const std::string& name, IntervalRows rows) {
        if (std::vector<PageFields> of_group = std::move(rows).rows(); !of_group.empty()) {
            groups.push_back({{"name", name}, {"figures", std::move(of_group)}});
        }
    };
    for (std::size_t i = 0; i < std::min(most_targets, figures.targets.size()); ++i) {
        const TargetFigures& target = figures.targets[i];
        const DrawnTarget& drawn = figures.drawn->targets[i];
        IntervalRows rows{results};
        for (const Cover cover : covers) {
            rows.add(on_slope("Rocks that arrive", cover), drawn.by_cover[index_of(cover)].share, percent);
        }
        rows.add(page_text("Protection effect"), drawn.protection, percent);
        for (const Cover cover : covers) {
            const DrawnArrivals& at = drawn.by_cover[index_of(cover)];
            rows.add(on_slope("95 % of the energies below, kJ", cover), at.energy_95_kj, three_digits);
            rows.add(on_slope("95 % of the heights below, m", cover), at.height_95_m, three_digits);
        }
        add_group(target.name.empty() ? target.id : target.name, std::move(rows));
    }
    IntervalRows rows{results};
    for (const Cover cover : covers) {
        const DrawnRunOut& run_out = figures.drawn->run_outs[index_of(cover)];
        rows.add(on_slope("Mean run-out, m", cover), run_out.mean_m, three_digits);
        rows.add(on_slope("95 % of the run-outs below, m", cover), run_out.p95_m, three_digits);
    }
    add_group(page_text("All rocks"), std::move(rows));
    return PageFields{{"strata", grouped(results.draws->falls.size())}, {"groups", groups}};
}

std::optional<PageFields> answer_with_all(const RunResults& results, const Figures& figures,
                                          std::size_t target) {
    if (!figures.drawn) {
        return std::nullopt;
    }
    const DrawnTarget& drawn = figures.drawn->targets[target];
    const std::optional<DrawnFigure>& share =
        drawn.by_cover[index_of(results.with_forest ? Cover::forest : Cover::bare)].share;
    if (!share) {
        return std::nullopt;
    }
    const std::optional<DrawnFigure>& main = drawn.protection ? drawn.protection : share;
    const std::vector<NamedShare> causes = main_causes(*main, *results.draws);
    return PageFields{{"has_effect", drawn.protection.has_value()},
                      {"share", interval_of(share->of_all, percent)},
                      {"effect", drawn.protection ? interval_of(drawn.protection->of_all, percent) : ""},
                      {"has_causes", !causes.empty()},
                      {"causes", main_causes_in_words(*main, *results.draws)},
                      {"bar", causes.empty() ? "" : cause_bar(causes)}};
}

}  // namespace coupling::report
