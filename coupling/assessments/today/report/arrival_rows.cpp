#include "coupling/assessments/today/report/arrival_rows.hpp"

#include <optional>

#include "config/text/joined.hpp"
#include "coupling/results/figures/effect_words.hpp"
#include "coupling/results/figures/few_rocks.hpp"
#include "coupling/results/text/markup.hpp"

namespace coupling::report {
namespace {

using config::joined;

std::optional<PageFields> effect_of(const PairedCounts& paired) {
    const auto effect = protection_effect(paired);
    if (!effect || too_few_for_protection(paired)) {
        return std::nullopt;
    }
    // Where no rock comes through, the interval has a lower end only.
    const double high = effect->one_sided ? effect->value : effect->interval.high;
    return PageFields{{"value", percent(effect->value)},
                      {"low", fixed(100.0 * effect->interval.low, 0)},
                      {"high", fixed(100.0 * high, 0)}};
}

/// 95th percentile and largest value.
std::string high_end(const ArrivalFigures& figures, const Distribution& of) {
    return figures.share.part == 0 ? "–" : joined(three_digits(of.p95), " / ", three_digits(of.max));
}

}  // namespace

PageFields arrival_cells(const rockfall::TargetTally& tally, std::uint64_t rocks) {
    const ArrivalFigures bare = figures_of(tally.by_cover[index_of(Cover::bare)], rocks);
    const ArrivalFigures forest = figures_of(tally.by_cover[index_of(Cover::forest)], rocks);
    return {{"bare_rocks", grouped(bare.share.part)},
            {"bare_rate", rate_per_1000(bare.share.value)},
            {"forest_rocks", grouped(forest.share.part)},
            {"forest_rate", rate_per_1000(forest.share.value)},
            {"effect", effect_of(paired_counts(tally))},
            {"bare_energy", high_end(bare, bare.energy_kj)},
            {"forest_energy", high_end(forest, forest.energy_kj)},
            {"bare_top", high_end(bare, bare.top_height_m)},
            {"forest_top", high_end(forest, forest.top_height_m)}};
}

}  // namespace coupling::report
