#pragma once

#include <cstddef>
#include <vector>

#include "config/grid/raster.hpp"

namespace coupling {

/// Width of the window of a tree top, by its height: about the width of its crown.
struct CanopyWindowLaw {
    double a_m;      ///< of a tree without height
    double b;        ///< [-]
    double c_per_m;  ///< of the squared height

    [[nodiscard]] double width_m(double height_m) const { return a_m + (b + c_per_m * height_m) * height_m; }
};

/// Pitkänen, Maltamo, Hyyppä and Yu (2004, ISPRS Archives XXXVI-8/W2, 187): crowns in southern Finland
/// (coefficients as two public implementations give them).
inline constexpr CanopyWindowLaw window_of_pitkaenen{.a_m = 1.2, .b = 0.16, .c_per_m = 0.0};
/// Popescu and Wynne (2004, PERS 70:589): pines and broadleaves of Virginia together. 2 m wider at 20 m, 5 m
/// wider at 30 m.
inline constexpr CanopyWindowLaw window_of_popescu{.a_m = 2.51503, .b = 0.0, .c_per_m = 0.00901};

/// A tree that stands out of the canopy.
struct TreeTop {
    double x_m = 0.0;
    double y_m = 0.0;
    double height_m = 0.0;  ///< that of its cell
    friend bool operator==(const TreeTop&, const TreeTop&) = default;
};

struct TreeTops {
    std::vector<TreeTop> tops;       ///< row by row from the north-west
    std::size_t beside_unknown = 0;  ///< left out: their crown may go on where the raster says nothing
};

/// The tree tops of a raster of vegetation heights above the ground: cells of `least_height_m` and more of
/// which no other one is higher in a circle as wide as the window of their height, or among the eight
/// neighbours where that is narrower. Heights are not smoothed.
///
/// Cells of one height within each other's window are one tree, in the middle of them. A top beside a cell
/// without a height, or at the border, is left out and counted: the flank of a crown that a hole cuts would
/// be one. So the tops of a part of the raster are those of the whole, and a turned or mirrored raster has
/// the turned or mirrored tops. NaN: no height.
TreeTops tree_tops(const config::Raster<double>& heights_m, const CanopyWindowLaw& window,
                   double least_height_m);

}  // namespace coupling
