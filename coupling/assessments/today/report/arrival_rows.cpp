#include "coupling/assessments/today/report/arrival_rows.hpp"

#include <cmath>

#include "config/text/joined.hpp"
#include "coupling/results/figures/effect_words.hpp"
#include "coupling/results/figures/few_rocks.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::report {
namespace {

using config::joined;

std::string rocks_cell(const ArrivalFigures& figures) {
    return joined(grouped(figures.share.part), " <span class=\"soft\">(", rate_per_1000(figures.share.value),
                  ")</span>");
}

std::string stopped_cell(const PairedCounts& paired) {
    const auto effect = protection_effect(paired);
    if (!effect || too_few_for_protection(paired)) {
        return "–";
    }
    // Where no rock comes through, the interval has a lower end only.
    const double high = effect->one_sided ? effect->value : effect->interval.high;
    return joined(percent(effect->value), " <span class=\"soft\">(",
                  page_text("{low} to {high}", {{"low", fixed(100.0 * effect->interval.low, 0)},
                                                {"high", fixed(100.0 * high, 0)}}),
                  ")</span>");
}

std::string energies_cell(const ArrivalFigures& figures) {
    return figures.share.part == 0
               ? "–"
               : joined(three_digits(figures.energy_kj.p95), " / ", three_digits(figures.energy_kj.max));
}

}  // namespace

std::vector<std::string> arrival_heads(const std::string& first, bool with_forest) {
    std::vector<std::string> heads{first, page_text("rocks without forest")};
    if (with_forest) {
        heads.push_back(page_text("rocks with forest"));
        heads.push_back(page_text("the forest stops"));
    }
    heads.push_back(page_text("energy without forest"));
    if (with_forest) {
        heads.push_back(page_text("energy with forest"));
    }
    return heads;
}

void add_arrival_cells(std::vector<std::string>& cells, const rockfall::TargetTally& tally,
                       std::uint64_t rocks, bool with_forest) {
    const ArrivalFigures bare = figures_of(tally.by_cover[index_of(Cover::bare)], rocks);
    const ArrivalFigures forest = figures_of(tally.by_cover[index_of(Cover::forest)], rocks);
    cells.push_back(rocks_cell(bare));
    if (with_forest) {
        cells.push_back(rocks_cell(forest));
        cells.push_back(stopped_cell(paired_counts(tally)));
    }
    cells.push_back(energies_cell(bare));
    if (with_forest) {
        cells.push_back(energies_cell(forest));
    }
}

}  // namespace coupling::report
