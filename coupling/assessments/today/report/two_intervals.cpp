#include <utility>

#include "config/text/joined.hpp"
#include "coupling/assessments/today/report/sections.hpp"
#include "coupling/results/figures/drawn_words.hpp"
#include "coupling/results/figures/most_reached.hpp"
#include "coupling/results/report/interval_rows.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::report {
namespace {

using config::joined;

std::string on_slope(const char* figure, Cover cover) {
    return joined(page_text(figure), ", ", title_of(cover));
}

}  // namespace

std::optional<PageFields> two_intervals(const RunResults& results, const Figures& figures) {
    if (!figures.drawn) {
        return std::nullopt;
    }
    const std::vector<Cover> covers = covers_of(results);
    IntervalRows rows{*results.draws};
    for (const std::size_t i : most_reached(results.tally.targets, most_target_cards)) {
        const TargetFigures& target = figures.targets[i];
        const DrawnTarget& drawn = figures.drawn->targets[i];
        for (const Cover cover : covers) {
            rows.add(on_slope("Rocks that arrive", cover), drawn.by_cover[index_of(cover)].share, percent);
        }
        rows.add(page_text("Protection effect"), drawn.protection, percent);
        for (const Cover cover : covers) {
            const DrawnArrivals& at = drawn.by_cover[index_of(cover)];
            rows.add(on_slope("95 % of the energies below, kJ", cover), at.energy_95_kj, three_digits);
            rows.add(on_slope("95 % of the heights below, m", cover), at.height_95_m, three_digits);
        }
        // A target that no rock reaches has no figures.
        rows.end_group(target.name.empty() ? target.id : target.name);
    }
    for (const Cover cover : covers) {
        const DrawnRunOut& run_out = figures.drawn->run_outs[index_of(cover)];
        rows.add(on_slope("Mean run-out, m", cover), run_out.mean_m, three_digits);
        rows.add(on_slope("95 % of the run-outs below, m", cover), run_out.p95_m, three_digits);
    }
    rows.end_group(page_text("All rocks"));
    PageFields fields = std::move(rows).fields();
    fields.push_back({"strata", grouped(results.draws->falls.size())});
    return fields;
}

std::optional<PageFields> answer_with_all(const RunResults& results, const Figures& figures,
                                          std::size_t target) {
    if (!figures.drawn) {
        return std::nullopt;
    }
    const DrawnTarget& drawn = figures.drawn->targets[target];
    const Cover cover = results.with_forest ? Cover::forest : Cover::bare;
    if (figures.targets[target].at(cover).share.part == 0 && !drawn.protection) {
        return std::nullopt;  // no rock, of which nothing more is known
    }
    const std::optional<DrawnFigure>& share = drawn.by_cover[index_of(cover)].share;
    const std::optional<DrawnFigure>& main = drawn.leading(cover);
    const std::vector<NamedShare> causes =
        main ? main_causes(*main, *results.draws) : std::vector<NamedShare>{};
    return PageFields{
        {"has_share", share.has_value()},
        {"has_effect", drawn.protection.has_value()},
        {"effect_is_open", share && !drawn.protection && figures.targets[target].protection.has_value()},
        {"share", share ? interval_in_words(share->of_all, percent) : ""},
        {"effect", drawn.protection ? interval_in_words(drawn.protection->of_all, percent) : ""},
        {"has_no_spread", drawn.has_hidden_spread(cover)},
        {"has_causes", !causes.empty()},
        {"causes", main ? main_causes_in_words(*main, *results.draws) : ""},
        {"bar", causes.empty() ? "" : cause_bar(causes)}};
}

}  // namespace coupling::report
