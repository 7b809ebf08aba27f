#include "coupling/inputs/scenario/release_settings.hpp"

#include <utility>

#include "coupling/inputs/scenario/start_settings.hpp"

namespace coupling {
namespace {

constexpr double largest_diameter_m = 20.0;

void declare_sources(config::Options& options, ReleaseSettings& release) {
    options.file("release.source", release.source,
                 {.meaning = "grid on the frame of the DEM: 0 no source, k > 0 release zone k"});
    options.file("release.source_shapes", release.source_shapes,
                 {.meaning = "instead: CSV with wkt (points, lines or polygons) and perhaps zone"});
    options.number(
        "release.steeper_than_deg", release.steeper_than_deg,
        {.unit = "deg",
         .low = 0.0,
         .high = 89.0,
         .meaning = "> 0: rocks break off from cells steeper than this only; without other sources "
                    "from all such cells (zone 1)"});
    options.number("release.undrawn_steeper_than_deg", release.undrawn_steeper_than_deg,
                   {.unit = "deg",
                    .low = 0.0,
                    .high = 89.0,
                    .meaning = "> 0: release.steeper_than_deg as long as nothing is drawn in the layers of "
                               "run.drawing that release.source_shapes names",
                    .needs = {{"run.drawing"}}});
    options.count("release.rocks", release.rocks,
                  {.low = 0.0,
                   .high = 4e9,
                   .meaning = "rocks in all; 0: rocks_per_source for each source, on a profile 10 000",
                   .source = "choice"});
    options.count("release.rocks_per_source", release.rocks_per_source,
                  {.low = 0.0,
                   .high = 1e9,
                   .meaning = "rocks for each source cell, point or line piece, on average",
                   .source = "choice",
                   .needs = {{"release.rocks", {"0"}}}});
    declare_density(options, "release", release.density_kgpm3);
    options.number("release.elongation", release.elongation,
                   {.unit = "-",
                    .low = 1.0,
                    .high = 10.0,
                    .meaning = "longest side of a rock by its shortest, median, where no shape is given",
                    .source = "Fujiwara et al. 1978, second hand: fragments 2 : 1.4 : 1",
                    .needs = {{"rockfall.loss_by_elongation"}}});
    options.number("release.elongation_scatter", release.elongation_scatter,
                   {.unit = "-",
                    .low = 0.0,
                    .high = 1.0,
                    .meaning = "standard deviation of its logarithm",
                    .source = "choice",
                    .needs = {{"rockfall.loss_by_elongation"}}});
    options.flag("release.random_place", release.random_place,
                 {.meaning = "rocks start anywhere in their source; no: at its centre", .source = "choice"});
}

void declare_diameter(config::Options& options, ReleaseSettings& release) {
    options.choice(
        "release.diameter_kind", release.diameter_kind,
        {{"fixed", DiameterKind::fixed},
         {"classes", DiameterKind::classes},
         {"uniform", DiameterKind::uniform},
         {"lognormal", DiameterKind::lognormal}},
        {.meaning = "which law rock sizes follow", .source = "choice", .needs = {{"hazard.blocks", {""}}}});
    options.number("release.diameter_m", release.diameter_m,
                   {.unit = "m",
                    .low = 0.01,
                    .high = largest_diameter_m,
                    .meaning = "diameter (fixed), or its mean (lognormal)",
                    .source = "choice",
                    .needs = {{"hazard.blocks", {""}}, {"release.diameter_kind", {"fixed", "lognormal"}}}});
    options.number("release.diameter_deviation_m", release.diameter_deviation_m,
                   {.unit = "m",
                    .low = 0.0,
                    .high = largest_diameter_m,
                    .meaning = "standard deviation of the diameter (lognormal)",
                    .needs = {{"hazard.blocks", {""}}, {"release.diameter_kind", {"lognormal"}}}});
    options.number("release.diameter_low_m", release.diameter_low_m,
                   {.unit = "m",
                    .low = 0.0,
                    .high = largest_diameter_m,
                    .meaning = "smallest diameter (uniform, lognormal)",
                    .needs = {{"hazard.blocks", {""}}, {"release.diameter_kind", {"uniform", "lognormal"}}}});
    options.number("release.diameter_high_m", release.diameter_high_m,
                   {.unit = "m",
                    .low = 0.0,
                    .high = largest_diameter_m,
                    .meaning = "largest diameter (uniform, lognormal)",
                    .needs = {{"hazard.blocks", {""}}, {"release.diameter_kind", {"uniform", "lognormal"}}}});
    options.numbers("release.diameter_classes_m", release.diameter_classes_m,
                    {.unit = "m",
                     .low = 0.01,
                     .high = largest_diameter_m,
                     .meaning = "diameters (classes), such as 0.5, 1, 1.5",
                     .needs = {{"hazard.blocks", {""}}, {"release.diameter_kind", {"classes"}}}});
    options.numbers("release.diameter_shares", release.diameter_shares,
                    {.low = 0.0,
                     .high = 1e9,
                     .meaning = "how often each of them occurs, in any scale",
                     .needs = {{"hazard.blocks", {""}}, {"release.diameter_kind", {"classes"}}}});
}

void declare_starts(config::Options& options, ReleaseSettings& release) {
    declare_start(options, "release",
                  {release.start_height_m, release.start_speed_mps, release.start_dip_deg},
                  {{"release.fall_height_m", {"0"}}});
    options.number("release.start_scatter_deg", release.start_scatter_deg,
                   {.unit = "deg",
                    .low = 0.0,
                    .high = 180.0,
                    .meaning = "largest turn of the start away from the fall line",
                    .source = "choice"});
    options.number("release.fall_height_m", release.fall_height_m,
                   {.unit = "m",
                    .low = 0.0,
                    .high = 1000.0,
                    .meaning = "> 0: dropped at rest from this height instead",
                    .source = "choice"});
}

}  // namespace

void declare(config::Options& options, ReleaseSettings& release) {
    declare_sources(options, release);
    declare_diameter(options, release);
    declare_starts(options, release);
    declare_shapes(options, release.shapes);
}

rockfall::DiameterLaw diameter_law(const ReleaseSettings& release) {
    using rockfall::DiameterLaw;
    switch (release.diameter_kind) {
        case DiameterKind::classes: {
            // Classes that never occur are left out: the law wants positive shares.
            std::vector<double> diameters_m;
            std::vector<double> shares;
            for (std::size_t i = 0; i < release.diameter_classes_m.size(); ++i) {
                if (release.diameter_shares[i] > 0.0) {
                    diameters_m.push_back(release.diameter_classes_m[i]);
                    shares.push_back(release.diameter_shares[i]);
                }
            }
            return DiameterLaw::classes(std::move(diameters_m), shares);
        }
        case DiameterKind::uniform:
            return DiameterLaw::uniform(release.diameter_low_m, release.diameter_high_m);
        case DiameterKind::lognormal:
            return DiameterLaw::lognormal(release.diameter_m, release.diameter_deviation_m,
                                          release.diameter_low_m, release.diameter_high_m);
        case DiameterKind::fixed:
            break;
    }
    return DiameterLaw::fixed(release.diameter_m);
}

rockfall::StartLaw start_law(const ReleaseSettings& release) {
    rockfall::StartLaw law;
    law.diameter = diameter_law(release);
    law.density_kgpm3 = release.density_kgpm3;
    law.elongation = release.shape_elongation.value_or(
        rockfall::ElongationLaw{release.elongation, release.elongation_scatter});
    law.height_m = release.start_height_m;
    law.speed_mps = release.start_speed_mps;
    law.dip = config::Angle::from_degrees(release.start_dip_deg);
    law.heading_scatter = config::Angle::from_degrees(release.start_scatter_deg);
    law.random_place = release.random_place;
    law.shape = release.shape_law;
    if (law.shape) {
        if (const auto own_m = law.shape->own_diameter_m()) {
            law.diameter = rockfall::DiameterLaw::fixed(*own_m);
        }
    }
    if (release.fall_height_m > 0.0) {
        law.height_m = release.fall_height_m;
        law.speed_mps = 0.0;
    }
    return law;
}

}  // namespace coupling
