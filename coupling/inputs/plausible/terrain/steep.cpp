#include "coupling/inputs/plausible/terrain/steep.hpp"

#include <algorithm>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/plausible/terrain/limits.hpp"

namespace coupling::plausible::terrain {
namespace {

using config::joined;

double squared_tangent(double slope_deg) {
    const double tangent = std::tan(slope_deg * M_PI / 180.0);
    return tangent * tangent;
}

std::string whole_percent(double share) {
    return config::to_text(std::round(100.0 * share));
}

}  // namespace

SlopeShares slope_shares(const HeightField& field) {
    const double above_45 = squared_tangent(limits::warning_median_deg);
    const double above_60 = squared_tangent(limits::very_steep_deg);
    const double above_75 = squared_tangent(limits::error_median_deg);
    const double least_bend_m = 1e-3 * field.cell_m();  // a millimetre in a metre: rounding of even planes
    std::size_t cells = 0;
    std::size_t steep = 0;
    std::size_t very_steep = 0;
    std::size_t walls = 0;
    std::size_t bent = 0;
    for (int row = 1; row + 1 < field.rows; ++row) {
        for (int column = 1; column + 1 < field.columns; ++column) {
            const double west = field.at(row, column - 1);
            const double east = field.at(row, column + 1);
            const double north = field.at(row - 1, column);
            const double south = field.at(row + 1, column);
            const double across = (east - west) / (2.0 * field.column_spacing_m);
            const double along = (north - south) / (2.0 * field.row_spacing_m);
            const double squared = across * across + along * along;
            if (std::isnan(squared)) {
                continue;
            }
            ++cells;
            steep += squared > above_45 ? 1 : 0;
            very_steep += squared > above_60 ? 1 : 0;
            walls += squared > above_75 ? 1 : 0;
            const double twice = 2.0 * field.at(row, column);
            bent += std::max(std::abs(east + west - twice), std::abs(north + south - twice)) > least_bend_m
                        ? 1
                        : 0;
        }
    }
    if (cells < limits::fewest_cells) {
        return {};
    }
    const double all = static_cast<double>(cells);
    return {cells, static_cast<double>(steep) / all, static_cast<double>(very_steep) / all,
            static_cast<double>(walls) / all, static_cast<double>(bent) > 0.2 * all};
}

std::optional<Finding> judge_steepness(const HeightField& field) {
    const SlopeShares shares = slope_shares(field);
    // A rebuilt slope may be an even plane, but not a wall from edge to edge.
    if (!shares.has_texture && shares.above_60_deg < 0.5) {
        return std::nullopt;
    }
    const char* advice =
        "multiply heights in feet by 0.3048, divide decimetres by 10, and give the size of the cells in "
        "metres";
    if (shares.has_texture && shares.above_75_deg >= 0.5) {
        return Finding{true,
                       joined(whole_percent(shares.above_75_deg), " % of the cells steeper than 75 degrees"),
                       "heights and cells in metres", advice};
    }
    if (shares.above_60_deg >= limits::warning_share_of_60) {
        return Finding{
            false, joined(whole_percent(shares.above_60_deg), " % of the cells steeper than 60 degrees"),
            "less than 15 %, as on mountainsides", joined("check the unit of the heights: ", advice)};
    }
    if (shares.above_45_deg >= 0.5) {
        return Finding{
            false, joined(whole_percent(shares.above_45_deg), " % of the cells steeper than 45 degrees"),
            "less than half, as on mountainsides", joined("check the unit of the heights: ", advice)};
    }
    return std::nullopt;
}

std::optional<Finding> judge_cell_size(const HeightField& field) {
    if (field.cell_m() <= limits::coarsest_cell_m) {
        return std::nullopt;
    }
    return Finding{false,
                   joined("cells of ", config::to_text(std::round(10.0 * field.cell_m()) / 10.0), " m"),
                   "1 to 10 m: larger cells lose cliffs, benches and gullies",
                   "take a terrain model of smaller cells, as resampling this one does not help"};
}

}  // namespace coupling::plausible::terrain
