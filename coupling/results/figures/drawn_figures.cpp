#include "coupling/results/figures/drawn_figures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include "config/units/constants.hpp"
#include "coupling/results/figures/drawn_spread.hpp"
#include "coupling/results/figures/few_rocks.hpp"
#include "coupling/results/figures/figures.hpp"

namespace coupling {
namespace {

using config::j_per_kj;
using rockfall::StratumTally;

constexpr double mm_per_m = 1000.0;

class StrataFigures {
public:
    StrataFigures(const RunResults& results, const Figures& figures)
        : results_{results}, figures_{figures}, strata_{results.tally.strata} {
        for (const bool with_obstacles : {false, true}) {
            spreads_[index_of(with_obstacles ? Cover::forest : Cover::bare)] =
                DrawnSpread{*results.draws, with_obstacles};
        }
    }

    [[nodiscard]] DrawnFigures all() const {
        DrawnFigures drawn;
        for (std::size_t target = 0; target < figures_.targets.size(); ++target) {
            DrawnTarget& of_target = drawn.targets.emplace_back();
            for (const Cover cover : covers_of(results_)) {
                of_target.by_cover[index_of(cover)] = arrivals(target, cover);
            }
            of_target.protection = protection(target);
        }
        for (const Cover cover : covers_of(results_)) {
            drawn.run_outs[index_of(cover)] = run_out(cover);
        }
        return drawn;
    }

private:
    /// `cover`: the slope whose laws decide the figure.
    [[nodiscard]] const DrawnSpread& on(Cover cover) const { return *spreads_[index_of(cover)]; }

    [[nodiscard]] std::optional<DrawnFigure> share(std::size_t target, Cover cover) const {
        std::vector<StratumShare> shares;
        for (const StratumTally& stratum : strata_) {
            shares.push_back({stratum.targets[target].by_cover[index_of(cover)].reached,
                              stratum.run_outs[index_of(cover)].rocks});
        }
        return on(cover).share(figures_.targets[target].at(cover).share, shares);
    }

    [[nodiscard]] std::vector<StratumFigure> means(
        const std::function<StratumSample(std::size_t)>& sample) const {
        return means_of_strata(strata_.size(), sample);
    }

    [[nodiscard]] DrawnArrivals arrivals(std::size_t target, Cover cover) const {
        const ArrivalFigures& pooled = figures_.targets[target].at(cover);
        const auto of = [&](std::size_t k) -> const rockfall::ArrivalTally& {
            return strata_[k].targets[target].by_cover[index_of(cover)];
        };
        const std::vector<StratumFigure> energies = means([&](std::size_t k) {
            return sample_of_bins(of(k).energy, static_cast<double>(of(k).energy_sum_j) / j_per_kj,
                                  [](std::uint64_t bin) {
                                      const auto& bins = rockfall::fine_energy_bins;
                                      return 0.5 * (bins.low_of(bin) + bins.high_of(bin)) / j_per_kj;
                                  });
        });
        const std::vector<StratumFigure> heights = means([&](std::size_t k) {
            return sample_of_bins(of(k).height, static_cast<double>(of(k).height_sum_mm) / mm_per_m,
                                  [](std::uint64_t bin) {
                                      const auto& bins = rockfall::fine_height_bins;
                                      return 0.5 * (bins.low_of(bin) + bins.high_of(bin));
                                  });
        });
        const Distribution& energy = pooled.energy_kj;
        const Distribution& height = pooled.height_m;
        return {
            share(target, cover),
            on(cover).figure(energy.mean, interval_of_mean(energy.mean, energies), above_nothing, energies),
            on(cover).figure(energy.p95, energy.p95_interval, above_nothing,
                             scaled(energies, energy.p95 / energy.mean)),
            on(cover).figure(height.p95, height.p95_interval, FigureLimits{},
                             scaled(heights, height.mean > 0.0 ? height.p95 / height.mean : 1.0))};
    }

    [[nodiscard]] std::optional<DrawnFigure> protection(std::size_t target) const {
        const TargetFigures& pooled = figures_.targets[target];
        if (!pooled.protection || pooled.protection->one_sided || pooled.paired.forest() == 0 ||
            too_few_for_protection(pooled.paired) ||
            !can_show_spread(static_cast<double>(pooled.paired.bare()), strata_.size())) {
            return std::nullopt;
        }
        const auto bare = static_cast<double>(pooled.paired.bare());
        const auto forest = static_cast<double>(pooled.paired.forest());
        const auto changed =
            static_cast<double>(pooled.paired.only_bare) + static_cast<double>(pooled.paired.only_forest);
        std::vector<StratumFigure> strata;
        std::size_t with_arrivals = 0;
        for (std::size_t k = 0; k < strata_.size(); ++k) {
            const PairedCounts paired = paired_counts(strata_[k].targets[target]);
            if (paired.bare() == 0) {
                continue;
            }
            ++with_arrivals;
            if (changed > 0.0) {
                const auto arriving = static_cast<double>(paired.bare());
                // Of the ratio of arrivals r over n rocks: r^2 (b + c) / (n_0 n_f), by the delta method.
                strata.push_back({1.0 - static_cast<double>(paired.forest()) / arriving,
                                  forest / bare * changed / bare / arriving, k});
            }
        }
        if (!are_most(with_arrivals, strata_.size())) {
            return std::nullopt;
        }
        return on(Cover::forest)
            .figure(pooled.protection->value, pooled.protection->interval,
                    {.least = -std::numeric_limits<double>::infinity(), .most = 1.0}, strata);
    }

    [[nodiscard]] DrawnRunOut run_out(Cover cover) const {
        constexpr double bin_m = rockfall::RunTally::run_out_bin_m;
        const Distribution& pooled = figures_.at(cover).run_out_m;
        const std::vector<StratumFigure> strata = means([&](std::size_t k) {
            const rockfall::RunOutTally& of = strata_[k].run_outs[index_of(cover)];
            return sample_of_bins(of.bins, static_cast<double>(of.sum_mm) / mm_per_m,
                                  [](std::uint64_t bin) { return (static_cast<double>(bin) + 0.5) * bin_m; });
        });
        return {on(cover).figure(pooled.mean, interval_of_mean(pooled.mean, strata), FigureLimits{}, strata),
                on(cover).figure(pooled.p95, of_run_out_95(cover), FigureLimits{},
                                 scaled(strata, pooled.p95 / pooled.mean))};
    }

    /// By order statistics; whole bins, as those of other percentiles.
    [[nodiscard]] Interval of_run_out_95(Cover cover) const {
        const rockfall::RunTally& tally = results_.tally.runs[index_of(cover)];
        const Ranks ranks = quantile_ranks(tally.stopped(), 0.95);
        Interval found{0.0, std::numeric_limits<double>::infinity()};
        std::uint64_t rank = 0;
        for (std::size_t bin = 0; bin < tally.run_out.size(); ++bin) {
            const std::uint64_t before = rank;
            rank += tally.run_out[bin];
            const double low_m = static_cast<double>(bin) * rockfall::RunTally::run_out_bin_m;
            if (before < ranks.low && ranks.low <= rank) {
                found.low = low_m;
            }
            if (before < ranks.high && ranks.high <= rank) {
                found.high = std::min(low_m + rockfall::RunTally::run_out_bin_m, tally.max_run_out_m);
            }
        }
        return found;
    }

    const RunResults& results_;
    const Figures& figures_;
    const std::vector<StratumTally>& strata_;
    std::array<std::optional<DrawnSpread>, rockfall::covers> spreads_;  ///< by slope
};

}  // namespace

std::optional<DrawnFigures> drawn_figures(const RunResults& results, const Figures& figures) {
    if (results.draws == nullptr || results.tally.strata.empty()) {
        return std::nullopt;
    }
    return StrataFigures{results, figures}.all();
}

}  // namespace coupling
