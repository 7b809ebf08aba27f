#include "coupling/assessments/today/figures/target_design.hpp"

#include <limits>

#include "config/units/constants.hpp"
#include "coupling/assessments/nets/figures/design_columns.hpp"
#include "coupling/assessments/nets/figures/net_quantiles.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/figures/drawn_spread.hpp"
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

/// A quantity that is counted in fine bins at each target.
struct BinnedQuantity {
    const rockfall::LogBins& bins;
    rockfall::BinCounts rockfall::ArrivalTally::*counts;
    double rockfall::ArrivalTally::*largest;
    std::uint64_t rockfall::ArrivalTally::*sum;
    double of_sum;  ///< from the unit of the sum to that of the bins
};

constexpr double m_per_mm = 0.001;
const BinnedQuantity binned_energy{rockfall::fine_energy_bins, &rockfall::ArrivalTally::energy,
                                   &rockfall::ArrivalTally::energy_max_j,
                                   &rockfall::ArrivalTally::energy_sum_j, 1.0};
const BinnedQuantity binned_top_height{rockfall::fine_height_bins, &rockfall::ArrivalTally::top_height,
                                       &rockfall::ArrivalTally::top_height_max_m,
                                       &rockfall::ArrivalTally::top_height_sum_mm, m_per_mm};

/// A percentile in fine bins, never above the largest value.
QuantileEstimate percentile_at(const rockfall::ArrivalTally& tally, const BinnedQuantity& of,
                               double percentile) {
    return quantile_estimate(of.bins, (tally.*of.counts).all(), percentile / 100.0, tally.*of.largest);
}

/// Its interval with all that is not known; nothing where nothing was drawn, or too few strata to know.
std::optional<Interval> interval_of_all(const RunResults& results, std::size_t target, rockfall::Cover cover,
                                        const BinnedQuantity& of, const QuantileEstimate& percentile) {
    if (results.draws == nullptr || !results.draws->has_spread()) {
        return std::nullopt;
    }
    const auto at = [&](const rockfall::TargetTally& tally) -> const rockfall::ArrivalTally& {
        return tally.by_cover[index_of(cover)];
    };
    const std::vector<rockfall::StratumTally>& strata = results.tally.strata;
    const std::vector<StratumFigure> means = means_of_strata(strata.size(), [&](std::size_t k) {
        const rockfall::ArrivalTally& tally = at(strata[k].targets[target]);
        return sample_of_bins(
            tally.*of.counts, of.of_sum * static_cast<double>(tally.*of.sum),
            [&](std::uint64_t bin) { return 0.5 * (of.bins.low_of(bin) + of.bins.high_of(bin)); });
    });
    const rockfall::ArrivalTally& pooled = at(results.tally.targets[target]);
    const double mean = of.of_sum * static_cast<double>(pooled.*of.sum) / static_cast<double>(pooled.reached);
    const auto figure = DrawnSpread{strata.size()}.figure(
        percentile.value, percentile.interval, above_nothing,  // the upper edge of a rock is above the ground
        scaled(means, mean > 0.0 ? percentile.value / mean : 1.0));
    return figure ? std::optional{figure->of_all} : std::nullopt;
}

std::optional<Interval> in_kj(const std::optional<Interval>& energy_j) {
    return energy_j
               ? std::optional{Interval{energy_j->low / config::j_per_kj, energy_j->high / config::j_per_kj}}
               : std::nullopt;
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
            if (tally.reached >= rocks_to_tell(settings.share())) {
                const QuantileEstimate energy_j = percentile_at(tally, binned_energy, settings.percentile);
                const QuantileEstimate height_m =
                    percentile_at(tally, binned_top_height, settings.percentile);
                designs.back().design =
                    design_for(energy_j.value / config::j_per_kj, height_m.value, settings);
                add_spread(*designs.back().design,
                           in_kj(interval_of_all(results, target, cover, binned_energy, energy_j)),
                           interval_of_all(results, target, cover, binned_top_height, height_m), settings);
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
