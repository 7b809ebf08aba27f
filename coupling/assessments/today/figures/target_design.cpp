#include "coupling/assessments/today/figures/target_design.hpp"

#include <algorithm>

#include "config/units/constants.hpp"
#include "coupling/assessments/nets/figures/design_columns.hpp"
#include "coupling/assessments/nets/figures/net_quantiles.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/figures/figures.hpp"
#include "coupling/results/tables/figure_columns.hpp"

namespace coupling {
namespace {

struct DesignAtTarget : TargetDesign {
    const rockfall::Target& of;
};

TableOf<DesignAtTarget> target_design_table() {
    return {
        "target_design.csv",
        "The barrier that the rocks at each target ask for, by the rule of [design].",
        "a target on one slope",
        {{target_columns(),
          [](const auto& row) {
              return TargetName{row.of.id, row.of.name};
          }},
         {cover_column(), [](const auto& row) { return name_of(row.cover); }},
         {"reached", "rocks that arrive", from_counting, &DesignAtTarget::reached},
         {needed_columns("percentile (design.percentile) of the energies of the rocks that arrive at the "
                         "target; empty: too few rocks for it",
                         "percentile of the heights of the highest point of a rock above the ground where "
                         "it first meets the target"),
          &DesignAtTarget::design}}};
}

/// A percentile of a quantity in fine bins, never above the largest value.
double percentile_of_bins(const rockfall::LogBins& bins, const rockfall::BinCounts& counts, double percentile,
                          double largest) {
    return std::min(rockfall::quantile(bins, counts.all(), 0.01 * percentile), largest);
}

}  // namespace

std::vector<TargetDesign> target_designs(const RunResults& results) {
    const DesignSettings& settings = results.scenario.design;
    std::vector<TargetDesign> designs;
    if (settings.rule == DesignRule::none) {
        return designs;
    }
    for (std::size_t target = 0; target < results.tally.targets.size(); ++target) {
        for (const rockfall::Cover cover : covers_of(results)) {
            const rockfall::ArrivalTally& tally = results.tally.targets[target].by_cover[index_of(cover)];
            designs.push_back({target, cover, tally.reached, std::nullopt});
            if (tally.reached >= rocks_to_tell(0.01 * settings.percentile)) {
                designs.back().design =
                    design_for(percentile_of_bins(rockfall::fine_energy_bins, tally.energy,
                                                  settings.percentile, tally.energy_max_j) /
                                   config::j_per_kj,
                               percentile_of_bins(rockfall::fine_height_bins, tally.top_height,
                                                  settings.percentile, tally.top_height_max_m),
                               settings);
            }
        }
    }
    return designs;
}

void write_target_designs(const RunResults& results, const std::filesystem::path& folder,
                          std::vector<WrittenFile>& written) {
    const std::vector<TargetDesign> designs = target_designs(results);
    if (designs.empty()) {
        return;
    }
    written.push_back(target_design_table().write(folder, [&](auto& rows) {
        for (const TargetDesign& design : designs) {
            rows.add({design, results.site.targets[design.target]});
        }
    }));
}

TableLayout target_design_layout() {
    return target_design_table();
}

}  // namespace coupling
