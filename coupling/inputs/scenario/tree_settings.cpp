#include "coupling/inputs/scenario/tree_settings.hpp"

namespace coupling {

void declare(config::Options& options, TreeSettings& settings) {
    options.file("trees.file", settings.file,
                 {.meaning = "CSV with tree_id, x_m, y_m, species, dbh_cm, height_m; none: bare slope only"});
    options.file(
        "trees.canopy", settings.canopy,
        {.meaning = "instead: grid of vegetation heights above the ground (canopy-height model, cells "
                    "of 2 m at most), of which the tree tops are taken; species by trees.species"});
    options.choice("trees.canopy_window", settings.canopy_window,
                   {{"pitkaenen", CanopyWindow::pitkaenen}, {"popescu", CanopyWindow::popescu}},
                   {.meaning = "width around a tree top of height h in which none is higher: pitkaenen "
                               "1.2 m + 0.16 h, popescu 2.51503 m + 0.00901 h^2",
                    .source = "Pitkänen et al. 2004; Popescu and Wynne 2004 (pines and broadleaves together)",
                    .needs = {{"trees.canopy"}}});
    options.number("trees.canopy_least_height_m", settings.canopy_least_height_m,
                   {.unit = "m",
                    .low = 2.0,
                    .high = 40.0,
                    .meaning = "tree tops of trees.canopy below this height are left out",
                    .source = "choice, as Monnet 2011",
                    .needs = {{"trees.canopy"}}});
    // Of both kinds of trees: what has no effect is judged in Reading::note_settings.
    options.text("trees.species", settings.species,
                 {.meaning = "code or name of the species of all trees of trees.canopy, and of trees.file "
                             "where it has no column species: tree tops of a laser scan. Several with "
                             "shares: PIAB 60, FASY 40",
                  .needs = {{"trees.file"}}});
    options.file("trees.species_areas", settings.species_areas,
                 {.meaning = "polygons with the species of such trees, or several with shares; elsewhere "
                             "trees.species holds",
                  .needs = {{"trees.file"}}});
    options.file(
        "trees.logs", settings.logs,
        {.meaning = "CSV of lying logs: x1_m, y1_m, x2_m, y2_m, species, dbh_cm, clearance_m, strength"});
    options.flag("trees.swap_xy", settings.swap_xy,
                 {.meaning = "x_m and y_m of trees.file stand in each other's column",
                  .source = "choice",
                  .needs = {{"trees.file"}}});
    options.flag("trees.swap_logs_xy", settings.swap_logs_xy,
                 {.meaning = "x and y of trees.logs stand in each other's columns",
                  .source = "choice",
                  .needs = {{"trees.logs"}}});
    options.flag("trees.bounds", settings.bounds,
                 {.meaning = "of trees that are derived from tops or records: some rocks fall once more "
                             "through the thinnest and the thickest forest that they may be",
                  .source = "choice"});
}

void check(const TreeSettings& settings, const config::Options& options, config::Problems& problems) {
    if (settings.canopy.empty()) {
        return;
    }
    if (!settings.file.empty()) {
        problems.add(config::ExitCode::settings, options.place_of("trees.canopy"),
                     "trees.canopy beside trees.file", "only one of them");
    }
    if (settings.species.empty() && settings.species_areas.empty()) {
        problems.add(config::ExitCode::settings, options.place_of("trees.species"),
                     "trees.canopy without trees.species", "the species of the trees, which no raster knows",
                     "set trees.species = PIAB, or the species that stands there most");
    }
}

}  // namespace coupling
