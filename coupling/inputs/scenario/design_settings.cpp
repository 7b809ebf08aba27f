#include "coupling/inputs/scenario/design_settings.hpp"

#include <algorithm>
#include <functional>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"

namespace coupling {

DesignMargins margins_of(const DesignSettings& design) {
    if (design.rule == DesignRule::none) {
        return {};
    }
    return {design.energy_factor, design.height_factor, design.freeboard_m};
}

void declare(config::Options& options, DesignSettings& design) {
    const std::vector<config::Need> today{{"run.years", {"0"}}};
    const std::vector<config::Need> own{{"design.rule", {"own"}}, {"run.years", {"0"}}};
    options.choice("design.rule", design.rule, {{"none", DesignRule::none}, {"own", DesignRule::own}},
                   {.meaning = "what a barrier gets beyond the percentiles of the rocks: nothing, or the "
                               "factors and the freeboard given here",
                    .source = "choice",
                    .needs = today});
    options.number("design.percentile", design.percentile,
                   {.unit = "%",
                    .low = 50.0,
                    .high = 99.99,
                    .meaning = "percentile of energy and height of the rocks at a barrier by which it is "
                               "designed",
                    .source = "UNI 11211-4, ONR 24810: the 95th or 99th (Marchelli 2022)",
                    .needs = today});
    options.number("design.energy_factor", design.energy_factor,
                   {.low = 1.0,
                    .high = 5.0,
                    .meaning = "partial factor on the energy at a barrier",
                    .source = "choice",
                    .needs = own});
    options.number("design.height_factor", design.height_factor,
                   {.low = 1.0,
                    .high = 5.0,
                    .meaning = "partial factor on the height of passage at a barrier (centre of the rock "
                               "plus its radius)",
                    .source = "choice",
                    .needs = own});
    options.number("design.freeboard_m", design.freeboard_m,
                   {.unit = "m",
                    .low = 0.0,
                    .high = 10.0,
                    .meaning = "upper part of a barrier that no rock should hit",
                    .source = "choice",
                    .needs = own});
    options.numbers("design.sold_heights_m", design.sold_heights_m,
                    {.unit = "m",
                     .low = 0.1,
                     .high = 50.0,
                     .meaning = "heights of the barriers on offer, rising: a design takes the next one",
                     .source = "choice",
                     .needs = today});
}

void check(const DesignSettings& design, const config::Options& options, config::Problems& problems) {
    const std::vector<double>& heights_m = design.sold_heights_m;
    if (heights_m.empty()) {
        problems.add(config::ExitCode::settings, options.place_of("design.sold_heights_m"),
                     "no design.sold_heights_m", "at least one height",
                     "leave the setting out for half metres");
    }
    const auto fall = std::adjacent_find(heights_m.begin(), heights_m.end(), std::greater_equal<double>{});
    if (fall != heights_m.end()) {
        problems.add(config::ExitCode::settings, options.place_of("design.sold_heights_m"),
                     config::joined("design.sold_heights_m with ", config::to_text(*fall), " before ",
                                    config::to_text(*(fall + 1))),
                     "rising heights");
    }
    const DesignMargins margins = margins_of(design);
    if (design.rule == DesignRule::own && margins.energy_factor == 1.0 && margins.height_factor == 1.0 &&
        margins.freeboard_m == 0.0) {
        problems.add(config::ExitCode::settings, options.place_of("design.rule"),
                     "design.rule own that adds nothing",
                     "design.energy_factor, design.height_factor or design.freeboard_m",
                     "give those of your guideline, or take rule none");
    }
}

}  // namespace coupling
