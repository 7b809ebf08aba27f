#include "coupling/inputs/forest/tops/canopy_input.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/forest/tops/canopy_tops.hpp"
#include "coupling/inputs/grids/filled_holes.hpp"
#include "coupling/inputs/scenario/tree_settings.hpp"
#include "coupling/inputs/systems/coordinate_systems.hpp"

namespace coupling {
namespace {

using config::joined;

/// No tree of the Alps is higher: spruce of 62.7 m in Slovenia [lit], and an error of the scan.
constexpr double highest_tree_m = 70.0;
/// Wider cells lose half of the tree tops (README.md of the folder above).
constexpr double fine_canopy_cell_m = 1.0;
/// Ground, or what grows on it.
constexpr double low_vegetation_m = 2.0;
constexpr const char* expected_heights = "heights of the vegetation above the ground, in metres";

/// What the cells of a raster hold.
struct CanopyValues {
    std::size_t known = 0;
    double high = 0.0;  ///< 1 % of the cells above 0 are higher
    double highest = 0.0;
    double low = 0.0;              ///< 1 % of the known cells are lower
    std::size_t below_ground = 0;  ///< by more than 2 m
    bool are_whole = true;         ///< all of them
};

double value_at_share(std::vector<double>& values, double share) {
    const auto place = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + place, values.end());
    return values[static_cast<std::size_t>(place)];
}

CanopyValues values_of_canopy(const config::Raster<double>& heights) {
    std::vector<double> known;
    std::copy_if(heights.values.begin(), heights.values.end(), std::back_inserter(known),
                 [](double value) { return !std::isnan(value); });
    CanopyValues values;
    values.known = known.size();
    if (known.empty()) {
        return values;
    }
    for (const double value : known) {
        values.below_ground += value < -low_vegetation_m ? 1U : 0U;
        values.are_whole = values.are_whole && value == std::round(value);
    }
    values.highest = *std::max_element(known.begin(), known.end());
    values.low = value_at_share(known, 0.01);
    std::erase_if(known, [](double value) { return value <= 0.0; });
    values.high = known.empty() ? 0.0 : value_at_share(known, 0.99);
    return values;
}

[[noreturn]] void refuse_canopy(const std::string& file, std::string found, std::string advice) {
    config::fail(config::ExitCode::data, {file}, std::move(found), expected_heights, std::move(advice));
}

std::string in_metres(double height) {
    return config::to_text(std::round(10.0 * height) / 10.0);
}

/// What makes metres of such heights.
const char* unit_advice(double high) {
    constexpr double tallest_in_feet = 210.0;
    if (high <= tallest_in_feet) {
        return "write them in metres: multiply feet by 0.3048, divide decimetres by 10";
    }
    return high <= 10.0 * highest_tree_m    ? "write them in metres: divide decimetres by 10"
           : high <= 100.0 * highest_tree_m ? "write them in metres: divide centimetres by 100"
                                            : "write them in metres: divide millimetres by 1000";
}

void refuse_other_values(const CanopyValues& values, const std::string& file) {
    if (values.known == 0) {
        refuse_canopy(file, "no cell with a height", "look whether this is the right band and NODATA value");
    }
    const bool are_shares = values.highest > 0.0 && values.highest <= 1.0;
    const bool are_percent = values.are_whole && values.high > highest_tree_m && values.highest <= 100.0;
    if (are_shares || are_percent) {
        refuse_canopy(file,
                      joined("values up to ", config::to_text(values.highest),
                             ", which look like crown cover in ", are_shares ? "shares" : "percent"),
                      "name a raster of cover as stands.cover, with the stems in stands.records");
    }
    if (values.high <= highest_tree_m) {
        return;
    }
    if (values.low <= low_vegetation_m) {  // there is ground between the trees
        refuse_canopy(file, joined("heights up to ", in_metres(values.high), ": another unit"),
                      unit_advice(values.high));
    }
    refuse_canopy(
        file,
        joined("heights from ", in_metres(values.low), " to ", in_metres(values.high), ": heights above sea"),
        "subtract the terrain (QGIS: Raster calculator; gdal_calc.py -A surface.tif -B terrain.tif "
        "--calc=A-B)");
}

config::Features features_of_tops(const std::vector<TreeTop>& tops, std::string file) {
    config::Features features;
    features.file = std::move(file);
    for (const char* column : {"x_m", "y_m", "height_m"}) {
        features.add_column(column);
    }
    for (const TreeTop& top : tops) {
        features.cells.push_back({config::to_text(top.x_m), config::to_text(top.y_m),
                                  config::to_text(std::round(100.0 * top.height_m) / 100.0)});
        features.numbers.push_back(static_cast<std::uint32_t>(features.cells.size()));
    }
    return features;
}

void warn_of_tops(const TreeTops& found, const std::string& file, Reading& reading) {
    const double least_m = reading.trees().canopy_least_height_m;
    reading.warn({file},
                 joined(counted(found.tops.size(), "tree top"), " of ", config::to_text(least_m),
                        " m and more, taken from a canopy raster"),
                 "all stems",
                 "trees below the crowns of others and most small ones are missing: of a mapped stand in the "
                 "French Prealps a scan showed 21 of 26 trees above 20 m, 17 of 28 from 15 to 20 m and 13 of "
                 "49 from 5 to 15 m. Protection from rocks of 0.5 m came out 10 to 17 points too low in six "
                 "mapped stands: take stand records where there are any, or say in what you publish that "
                 "trees are missing",
                 config::Effect::answer);
    if (found.tops.empty()) {
        reading.warn({file}, "no tree tops", "at least one, or no trees.canopy for a bare slope");
    }
    if (found.beside_unknown > 0) {
        reading.note(joined(file, ": ", counted(found.beside_unknown, "tree top"),
                            " left out beside cells without a height or at the border; if NODATA stands for "
                            "open ground, write 0 there"));
    }
}

}  // namespace

void refuse_wrong_canopy(const config::Raster<double>& heights_m, const std::string& projection,
                         const std::string& file) {
    const double cell_m = std::max(heights_m.frame.cell_width_m, heights_m.frame.cell_height_m);
    if (cell_m > widest_canopy_cell_m * (1.0 + 1e-6)) {
        config::fail(config::ExitCode::data, {file}, joined("cells of ", config::to_text(cell_m), " m"),
                     "cells of 2 m or less, in which single crowns show",
                     "take the canopy-height model of the survey in cells of 0.5 or 1 m; where there is none "
                     "use stands.records, perhaps with stands.cover");
    }
    if (const auto unit = plausible::height_unit_in(projection); unit && !unit->is_metres_upwards()) {
        refuse_canopy(file, joined("heights in ", unit->name), "write the heights in metres");
    }
    refuse_other_values(values_of_canopy(heights_m), file);
}

std::vector<config::Problem> warnings_of_canopy(const config::Raster<double>& heights_m,
                                                const std::string& file) {
    const CanopyValues values = values_of_canopy(heights_m);
    std::vector<config::Problem> warnings;
    const double cell_m = std::max(heights_m.frame.cell_width_m, heights_m.frame.cell_height_m);
    if (cell_m > fine_canopy_cell_m * (1.0 + 1e-6)) {
        warnings.push_back(
            {config::ExitCode::data,
             {file},
             joined("cells of ", config::to_text(cell_m), " m"),
             "cells of 1 m or less, in which most crowns of 15 m and more show",
             "take a finer raster: cells of 2 m showed 25 tree tops of a stand where 1 m showed 57"});
    }
    if (values.are_whole) {
        warnings.push_back({config::ExitCode::data,
                            {file},
                            "heights in whole metres",
                            "heights to a tenth of a metre",
                            "take the raster with decimals: neighbours of one height become one tree"});
    }
    constexpr double many = 0.01;
    if (static_cast<double>(values.below_ground) > many * static_cast<double>(values.known)) {
        warnings.push_back({config::ExitCode::data,
                            {file},
                            joined(counted(values.below_ground, "cell"), " more than 2 m below the ground"),
                            "surface and terrain of one survey",
                            "check that both have the same system of heights and lie on each other"});
    }
    if (values.highest > highest_tree_m) {
        const auto too_high = static_cast<std::size_t>(
            std::count_if(heights_m.values.begin(), heights_m.values.end(),
                          [](double height_m) { return height_m > highest_tree_m; }));
        warnings.push_back({config::ExitCode::data,
                            {file},
                            joined(counted(too_high, "cell"), " above 70 m, taken as unknown"),
                            "heights of trees",
                            "look for power lines, and for cliffs that surface and terrain place apart"});
    }
    return warnings;
}

std::size_t clean_canopy(config::Raster<double>& heights_m) {
    constexpr double small_hole_m2 = 4.0;
    for (double& height_m : heights_m.values) {
        height_m = height_m > highest_tree_m ? std::numeric_limits<double>::quiet_NaN() : height_m;
    }
    return grids::fill_holes(heights_m, small_hole_m2).holes;
}

config::Table canopy_table(Reading& reading) {
    const TreeSettings& settings = reading.trees();
    const std::string file = reading.shown(settings.canopy);
    config::Raster<double> heights_m = reading.grid("trees.canopy", "canopy", settings.canopy);
    refuse_wrong_canopy(heights_m, reading.system_of("canopy"), file);
    for (config::Problem& warning : warnings_of_canopy(heights_m, file)) {
        reading.warn(warning.place, warning.found, warning.expected, warning.advice);
    }
    if (const std::size_t holes = clean_canopy(heights_m); holes > 0) {
        reading.note(joined(file, ": ", counted(holes, "hole"), " of at most 4 m2 filled from around it"));
    }
    const TreeTops found = tree_tops(
        heights_m, settings.canopy_window == CanopyWindow::popescu ? window_of_popescu : window_of_pitkaenen,
        settings.canopy_least_height_m);
    warn_of_tops(found, file, reading);
    return config::Table::of(features_of_tops(found.tops, file));
}

}  // namespace coupling
