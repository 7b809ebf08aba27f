#include "coupling/assessments/nets/figures/barrier_design.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "config/units/constants.hpp"
#include "coupling/assessments/nets/figures/net_quantiles.hpp"
#include "coupling/inputs/nets/net_classes.hpp"
#include "coupling/results/figures/drawn_spread.hpp"

namespace coupling {
namespace {

constexpr double open_class_step_kj = 100.0;
constexpr double unsold_steps_per_m = 10.0;

constexpr auto energy_of_passage = [](const Passage& rock) { return rock.energy_kj; };
constexpr auto top_of_passage = [](const Passage& rock) { return rock.top_m(); };

template <class Value>
QuantileEstimate percentile_of(std::span<const Passage> rocks, double percentile, const Value& value_of) {
    std::vector<double> values;
    for (const Passage& rock : rocks) {
        values.push_back(value_of(rock));
    }
    std::sort(values.begin(), values.end());
    return quantile_of(values, percentile / 100.0);
}

/// A percentile has too few rocks in a stratum: it is taken to change as the mean does [choice], as in all
/// results.
template <class Value>
std::optional<Interval> interval_of_passages(std::span<const Passage> rocks, std::uint32_t strata,
                                             const QuantileEstimate& percentile, const Value& value_of) {
    std::vector<StratumSample> samples(strata);
    double sum = 0.0;
    for (const Passage& rock : rocks) {
        StratumSample& of = samples[rock.stratum];
        const double value = value_of(rock);
        const double off = value - of.mean;
        of.count += 1.0;
        of.mean += off / of.count;
        of.squares += off * (value - of.mean);
        sum += value;
    }
    const std::vector<StratumFigure> means =
        means_of_strata(strata, [&](std::size_t k) { return samples[k]; });
    const double mean = sum / static_cast<double>(rocks.size());
    const auto figure = DrawnSpread{strata}.figure(percentile.value, percentile.interval, above_nothing,
                                                   scaled(means, percentile.value / mean));
    return figure ? std::optional{figure->of_all} : std::nullopt;
}

BarrierToOrder to_order(double percentile_energy_kj, double percentile_height_m,
                        const DesignSettings& settings) {
    const DesignMargins margins = margins_of(settings);
    const double energy_kj = margins.energy_factor * percentile_energy_kj;
    const double height_m = margins.height_factor * percentile_height_m + margins.freeboard_m;
    const NetClass& weakest = class_for(energy_kj);
    BarrierToOrder barrier;
    barrier.energy_class = weakest.name;
    barrier.capacity_kj = std::isfinite(weakest.mel_kj)
                              ? weakest.mel_kj
                              : open_class_step_kj * std::ceil(energy_kj / open_class_step_kj);
    const std::vector<double>& sold_m = settings.sold_heights_m;
    const auto next = std::lower_bound(sold_m.begin(), sold_m.end(), height_m);
    if (next != sold_m.end()) {
        barrier.sold_height_m = *next;
    }
    barrier.height_m =
        barrier.sold_height_m.value_or(std::ceil(height_m * unsold_steps_per_m) / unsold_steps_per_m);
    return barrier;
}

struct Outcomes {
    std::uint64_t held = 0;
    std::uint64_t over = 0;
    std::uint64_t through = 0;
};

Outcomes outcomes_of(std::span<const Passage> rocks, double capacity_kj, double height_m) {
    Outcomes outcomes;
    for (const Passage& rock : rocks) {
        ++(rock.centre_m > height_m       ? outcomes.over
           : rock.energy_kj > capacity_kj ? outcomes.through
                                          : outcomes.held);
    }
    return outcomes;
}

}  // namespace

Passage passage_of(const rockfall::NetCrossingRecord& crossing, std::uint32_t stratum) {
    return {static_cast<double>(crossing.energy_j) / config::j_per_kj, static_cast<double>(crossing.height_m),
            static_cast<double>(crossing.radius_m), stratum};
}

BarrierDesign design_for(double percentile_energy_kj, double percentile_height_m,
                         const DesignSettings& settings) {
    const DesignMargins margins = margins_of(settings);
    BarrierDesign design;
    static_cast<BarrierToOrder&>(design) = to_order(percentile_energy_kj, percentile_height_m, settings);
    design.percentile_energy_kj = percentile_energy_kj;
    design.percentile_height_m = percentile_height_m;
    design.design_energy_kj = margins.energy_factor * percentile_energy_kj;
    design.design_height_m = margins.height_factor * percentile_height_m + margins.freeboard_m;
    return design;
}

void add_spread(BarrierDesign& design, const std::optional<Interval>& energy_kj,
                const std::optional<Interval>& height_m, const DesignSettings& settings) {
    if (energy_kj && height_m && std::isfinite(energy_kj->high) && std::isfinite(height_m->high)) {
        design.spread = {*energy_kj, *height_m, to_order(energy_kj->high, height_m->high, settings)};
    }
}

std::optional<BarrierDesign> design_barrier(std::span<const Passage> rocks, const DesignSettings& settings,
                                            std::uint32_t strata) {
    if (rocks.size() < rocks_to_tell(settings.share())) {
        return std::nullopt;
    }
    const QuantileEstimate energy = percentile_of(rocks, settings.percentile, energy_of_passage);
    const QuantileEstimate height = percentile_of(rocks, settings.percentile, top_of_passage);
    BarrierDesign design = design_for(energy.value, height.value, settings);
    if (strata > 1) {
        add_spread(design, interval_of_passages(rocks, strata, energy, energy_of_passage),
                   interval_of_passages(rocks, strata, height, top_of_passage), settings);
    }
    const Outcomes outcomes = outcomes_of(rocks, design.capacity_kj, design.height_m);
    design.held = share_of(outcomes.held, rocks.size());
    design.over = share_of(outcomes.over, rocks.size());
    design.through = share_of(outcomes.through, rocks.size());
    return design;
}

std::vector<ClassOutcome> outcomes_by_class(std::span<const Passage> rocks, const BarrierDesign& design) {
    std::vector<ClassOutcome> all;
    for (const NetClass& entry : net_classes()) {
        const bool recommended = entry.name == design.energy_class;
        const Outcomes outcomes =
            outcomes_of(rocks, recommended ? design.capacity_kj : entry.mel_kj, design.height_m);
        all.push_back({entry.name, entry.mel_kj, entry.sel_kj, design.height_m,
                       share_of(outcomes.held, rocks.size()), share_of(outcomes.over, rocks.size()),
                       share_of(outcomes.through, rocks.size()), recommended});
    }
    return all;
}

}  // namespace coupling
