#include "coupling/assessments/nets/figures/design_columns.hpp"

#include "coupling/results/tables/figure_columns.hpp"

namespace coupling {
namespace {

constexpr const char* by_settings = "section [design]: coupling/assessments/nets/README.md";

ColumnsOf<BarrierDesign> held_columns() {
    return {{ColumnsOf<Share>{{"design_held",
                               "rocks, of those that reach the net, that one of this class and height would "
                               "hold",
                               from_counting, &Share::part},
                              share_columns("design_held", "share of the rocks that reach the net")},
             &BarrierDesign::held},
            {"design_over", "rocks that would pass over it", from_counting,
             [](const BarrierDesign& of) { return of.over.part; }},
            {"design_through", "rocks that would break through it", from_counting,
             [](const BarrierDesign& of) { return of.through.part; }}};
}

/// Where the percentiles may lie, and what their upper ends ask for.
ColumnsOf<DesignSpread> spread_columns() {
    constexpr const char* of_draws = "draws of what is not known (parameter_draws.csv)";
    return {{"all_energy_low_kj", 3,
             "lower end of the 95 % interval of percentile_energy_kj with all that is not known; empty: "
             "nothing was drawn, or too few rocks",
             of_draws, [](const DesignSpread& of) { return of.energy_kj.low; }},
            {"all_energy_high_kj", 3, "upper end of it", of_draws,
             [](const DesignSpread& of) { return of.energy_kj.high; }},
            {"all_height_low_m", 3,
             "lower end of the 95 % interval of percentile_height_m with all that is not known", of_draws,
             [](const DesignSpread& of) { return of.height_m.low; }},
            {"all_height_high_m", 3, "upper end of it", of_draws,
             [](const DesignSpread& of) { return of.height_m.high; }},
            {"upper_class", "energy class that the upper end of the energies asks for, by the same rule",
             by_settings, [](const DesignSpread& of) { return of.at_upper_ends.energy_class; }},
            {"upper_capacity_kj", 0, "maximum energy level of that class, as design_capacity_kj",
             "net_classes.csv", [](const DesignSpread& of) { return of.at_upper_ends.capacity_kj; }},
            {"upper_height_m", 2,
             "height that the upper end of the heights asks for: the next one on offer; where none is that "
             "high, rounded up to 10 cm",
             by_settings, [](const DesignSpread& of) { return of.at_upper_ends.height_m; }}};
}

}  // namespace

ColumnsOf<BarrierDesign> needed_columns(const char* energies, const char* heights) {
    return {{"percentile_energy_kj", 3, energies, by_settings, &BarrierDesign::percentile_energy_kj},
            {"design_energy_kj", 3, "that times the partial factor of the rule", by_settings,
             &BarrierDesign::design_energy_kj},
            {"design_class", "weakest energy class that takes the design energy", "net_classes.csv",
             &BarrierDesign::energy_class},
            {"design_capacity_kj", 0,
             "maximum energy level of the class; of the open class the design energy rounded up to 100 kJ",
             "net_classes.csv", &BarrierDesign::capacity_kj},
            {"percentile_height_m", 3, heights, by_settings, &BarrierDesign::percentile_height_m},
            {"design_height_m", 3, "that times the partial factor of the rule, plus the freeboard",
             by_settings, &BarrierDesign::design_height_m},
            {"sold_height_m", 2,
             "lowest height on offer (design.sold_heights_m) that is not below it; empty: none is that high",
             by_settings, &BarrierDesign::sold_height_m},
            {spread_columns(), &BarrierDesign::spread}};
}

ColumnsOf<BarrierDesign> design_columns() {
    return {needed_columns(
                "percentile (design.percentile) of the energies of the rocks that reach the net; empty: too "
                "few rocks for it",
                "percentile of the heights of passage: centre of the rock above the ground plus its radius"),
            held_columns()};
}

}  // namespace coupling
