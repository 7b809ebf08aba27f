#include "coupling/assessments/profile/falls/profile_intervals.hpp"

#include <functional>

#include "config/units/constants.hpp"
#include "coupling/inputs/parameters/parameter_knowledge.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/figures/drawn_spread.hpp"

namespace coupling::profile {
namespace {

using MomentsOf = std::function<const Moments&(const StratumOnProfile&)>;

std::vector<StratumFigure> means(const ProfileTally& tally, double unit, const MomentsOf& moments_of) {
    return means_of_strata(tally.strata.size(), [&](std::size_t k) -> StratumSample {
        const Moments& moments = moments_of(tally.strata[k]);
        if (moments.count() == 0) {
            return {};
        }
        return {static_cast<double>(moments.count()), moments.mean() / unit,
                moments.squares() / (unit * unit)};
    });
}

std::optional<DrawnFigure> mean(const DrawnSpread& spread, double value, const FigureLimits& limits,
                                const std::vector<StratumFigure>& strata) {
    return spread.figure(value, interval_of_mean(value, strata), limits, strata);
}

std::optional<DrawnFigure> percentile_95(const DrawnSpread& spread, const Spread& values,
                                         const rockfall::LogBins& bins, double unit,
                                         const FigureLimits& limits,
                                         const std::vector<StratumFigure>& strata) {
    const double value = values.quantile(bins, 0.95) / unit;
    const Interval of_rocks = quantile_estimate(bins, values.counts, 0.95, values.moments.most()).interval;
    const double mean = values.moments.mean() / unit;
    return spread.figure(value, {of_rocks.low / unit, of_rocks.high / unit}, limits,
                         scaled(strata, mean > 0.0 ? value / mean : 1.0));
}

}  // namespace

ParameterDraws draws_on(const Scenario& scenario, const ProfileSite& site, std::uint64_t rocks) {
    std::vector<bool> occurs(site.slope.types.size());
    for (std::size_t k = 0; k + 1 < site.corners.size(); ++k) {
        occurs[site.corners[k].surface] = true;  // the last one carries no ground
    }
    const DrawnSite drawn{site.slope.types, std::move(occurs), false};
    const rockfall::FallLaw& law = scenario.rockfall.fall;
    return site.knowledge->is_drawn ? draw_parameters(*site.knowledge, drawn, law, scenario.run.seed, rocks)
                                    : central_draw(*site.knowledge, drawn, law);
}

std::optional<ProfileIntervals> intervals_of(const ProfileTally& tally, const ParameterDraws& draws) {
    using namespace rockfall;
    if (tally.strata.empty()) {
        return std::nullopt;
    }
    const DrawnSpread spread{draws, false};
    ProfileIntervals intervals;
    intervals.run_out_mean_m =
        mean(spread, tally.run_out_m.mean(), {},
             means(
                 tally, 1.0, [](const StratumOnProfile& stratum) -> auto& { return stratum.run_out_m; }));
    for (std::size_t i = 0; i < tally.stations.size(); ++i) {
        const StationTally& station = tally.stations[i];
        const auto of_strata = [&](double unit, Moments StratumOnProfile::Passing::*quantity) {
            return means(
                tally, unit, [&](const StratumOnProfile& stratum) -> auto& {
                    return stratum.stations[i].*quantity;
                });
        };
        std::vector<StratumShare> shares;
        for (const StratumOnProfile& stratum : tally.strata) {
            shares.push_back({stratum.stations[i].energy_j.count(), stratum.rocks});
        }
        ProfileIntervals::AtStation& at = intervals.stations.emplace_back();
        at.share = spread.share(share_of(station.energy_j.moments.count(), tally.rocks), shares);
        if (station.energy_j.moments.count() == 0) {
            continue;
        }
        const auto energies = of_strata(config::j_per_kj, &StratumOnProfile::Passing::energy_j);
        at.energy_mean_kj =
            mean(spread, station.energy_j.moments.mean() / config::j_per_kj, above_nothing, energies);
        at.energy_95_kj = percentile_95(spread, station.energy_j, fine_energy_bins, config::j_per_kj,
                                        above_nothing, energies);
        at.speed_mean_mps = mean(spread, station.speed_mps.moments.mean(), above_nothing,
                                 of_strata(1.0, &StratumOnProfile::Passing::speed_mps));
        at.height_95_m = percentile_95(spread, station.height_m, fine_height_bins, 1.0, {},
                                       of_strata(1.0, &StratumOnProfile::Passing::height_m));
    }
    return intervals;
}

}  // namespace coupling::profile
