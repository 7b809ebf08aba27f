#include "coupling/assessments/nets/figures/barrier_design.hpp"

#include <algorithm>
#include <cmath>

#include "config/units/constants.hpp"
#include "coupling/assessments/nets/figures/net_quantiles.hpp"
#include "coupling/inputs/nets/net_classes.hpp"

namespace coupling {
namespace {

constexpr double open_class_step_kj = 100.0;
constexpr double unsold_steps_per_m = 10.0;

template <class Value>
double percentile_of(std::span<const Passage> rocks, double percentile, const Value& value_of) {
    std::vector<double> values;
    for (const Passage& rock : rocks) {
        values.push_back(value_of(rock));
    }
    std::sort(values.begin(), values.end());
    return quantile_of(values, 0.01 * percentile).value;
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

Passage passage_of(const rockfall::NetCrossingRecord& crossing) {
    return {static_cast<double>(crossing.energy_j) / config::j_per_kj, static_cast<double>(crossing.height_m),
            static_cast<double>(crossing.radius_m)};
}

BarrierDesign design_for(double percentile_energy_kj, double percentile_height_m,
                         const DesignSettings& settings) {
    const DesignMargins margins = margins_of(settings);
    BarrierDesign design;
    design.percentile_energy_kj = percentile_energy_kj;
    design.percentile_height_m = percentile_height_m;
    design.design_energy_kj = margins.energy_factor * design.percentile_energy_kj;
    design.design_height_m = margins.height_factor * design.percentile_height_m + margins.freeboard_m;

    const NetClass& of_design = class_for(design.design_energy_kj);
    design.energy_class = of_design.name;
    design.capacity_kj = std::isfinite(of_design.mel_kj)
                             ? of_design.mel_kj
                             : open_class_step_kj * std::ceil(design.design_energy_kj / open_class_step_kj);
    const std::vector<double>& sold_m = settings.sold_heights_m;
    const auto next = std::lower_bound(sold_m.begin(), sold_m.end(), design.design_height_m);
    if (next != sold_m.end()) {
        design.sold_height_m = *next;
    }
    design.height_m = design.sold_height_m.value_or(std::ceil(design.design_height_m * unsold_steps_per_m) /
                                                    unsold_steps_per_m);
    return design;
}

std::optional<BarrierDesign> design_barrier(std::span<const Passage> rocks, const DesignSettings& settings) {
    if (rocks.size() < rocks_to_tell(0.01 * settings.percentile)) {
        return std::nullopt;
    }
    BarrierDesign design = design_for(
        percentile_of(rocks, settings.percentile, [](const Passage& rock) { return rock.energy_kj; }),
        percentile_of(rocks, settings.percentile, [](const Passage& rock) { return rock.top_m(); }),
        settings);
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
