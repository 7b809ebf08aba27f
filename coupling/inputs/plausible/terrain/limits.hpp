#pragma once

#include <cstddef>

/// The limits of all rules on heights, each with what real ground was measured to have: on 16 real places and
/// one interpolated survey of 0.5 to 10 m, and on the wrong terrains that `tests/plausible/terrain_rates.py`
/// makes of them, with a prototype of the rules. What the program itself says of them stands in README.md of
/// this folder. "Real" below is the largest value of them, "wrong" the smallest of the wrong ones that the
/// rule is for. All are choices between the two [choice].
namespace coupling::plausible::terrain::limits {

/// A verdict from statistics needs so many known cells: 20 x 20.
inline constexpr int fewest_cells = 400;

// --- uneven: mean second difference over mean first difference of neighbours [-] ---
/// Real 0.56 (10 m, Silvretta), synthetic noise of 0.3 m 0.61; pictures, result rasters and surface models
/// 0.83 to 1.8.
inline constexpr double uneven_error = 0.85;
inline constexpr double uneven_warning = 0.70;
/// Gentle ground is rough compared with its slope (0.94 on a river bed, at 0.12): the mean second difference
/// over the distance must reach this as well [-]. Real ground that is steeper: 0.25 at a ratio of 0.56.
inline constexpr double least_bend = 0.15;
/// Gentle values with that ratio between direct neighbours are no ground either (real 0.73 of whole metres,
/// 0.61 else): a warning.
inline constexpr double uneven_gentle = 1.0;
inline constexpr double least_gentle_bend = 0.005;
/// A single damaged cell counts for no more than such a difference over the distance [-].
inline constexpr double largest_difference = 10.0;
/// Neighbours at distances up to this: crowns are 3 to 8 m wide.
inline constexpr double crown_reach_m = 4.0;
/// Ground of centimetre scans is rough at every scale: not judged below.
inline constexpr double finest_cell_m = 0.4;

// --- ups and downs: how often a line runs through its whole range, over its cells [-] ---
/// Real 0.03; a published speed raster and |sine| waves 0.1 to 0.3.
inline constexpr double traverses_per_cell = 0.10;
/// A short line over a cliff runs through its range once or twice, too.
inline constexpr double fewest_traverses = 4.0;
/// Only where neighbours differ by so much of their distance [-]: flat ground crosses its range by noise.
inline constexpr double least_mean_gradient = 0.40;

// --- steep: shares of cells by slope ---
/// Half of the cells above 45 degrees or 15 % above 60: real 39 degrees and 11 %; heights in feet 45 to 69
/// degrees where the ground is alpine. Slopes of 60 and 70 degrees can be meant (a validation case has them),
/// so these are warnings. Half above 75 degrees: no terrain with a runout; heights in decimetres.
inline constexpr double warning_median_deg = 45.0;
inline constexpr double warning_share_of_60 = 0.15;
inline constexpr double very_steep_deg = 60.0;
inline constexpr double error_median_deg = 75.0;

// --- steps: share of exactly level neighbours where the ground around rises by 15 degrees ---
/// Real 0.006; nearest neighbour 0.3 to 0.9, contour terraces of 5 and 10 m 0.15 to 0.9.
inline constexpr double level_error = 0.10;
inline constexpr double level_warning = 0.02;
inline constexpr double rising_deg = 15.0;
/// Rise is taken over so many cells on either side.
inline constexpr int rising_reach = 4;

// --- stripes ---
/// Agreement in sign of the line residuals of four blocks, minus chance [-1, 1]: real 0.30 (0.48 in windows
/// of 60 cells), stripes 0.6 to 1.
inline constexpr double stripe_agreement = 0.55;
/// Step (70 % are smaller) between neighbouring lines over their distance [-]. Natural ribs of 0.04 pass.
inline constexpr double stripe_warning = 0.05;
inline constexpr double stripe_error = 0.12;
/// Stripes change side at least so often, from line to line: longer waves are landforms.
inline constexpr double least_turns = 0.10;
/// The largest part from the centre that is looked at: stripes go through the whole grid.
inline constexpr int stripe_window = 500;

// --- spikes: height over all neighbours ---
/// In cells and metres; real 1.9 cells, 9.3 m at 5 m and 16 m at 10 m cells.
inline constexpr double spike_cells = 3.0;
inline constexpr double spike_m = 5.0;
/// A bird, a mast or a damaged value fills up to 2 x 2 cells; larger ones are left to `unevenness`.
inline constexpr std::size_t spike_group = 4;
/// A single cell that is bent by so much along its row, its column and both diagonals, and by so many times
/// more than any cell within this many cells: real up to 1.91 times (5.1 m at 5 m cells; all others from 3 m
/// on 1.4, at 10 m cells 1.9); the tip of a cone, however steep and at any size of cells, 2.62 times, smooth
/// hollows less. On rough ground, whose largest bend says little of the others: more than any of them, and so
/// many times the root of their mean square; real up to 4.85 times (the same cell; all others 4.24), the tip
/// of a cone 4.05 times.
inline constexpr double lone_m = 3.0;
inline constexpr double lone_ratio = 3.5;
inline constexpr double lone_roughness = 6.0;
inline constexpr int lone_reach = 4;

// --- upside down: mean depth of closed hollows ---
/// Real hollows 0.015 m, where the same terrain upside down has 0.07 to 4 m (where it has summits at all).
inline constexpr double hollows_m = 0.05;
inline constexpr double hollows_ratio = 5.0;
inline constexpr double least_relief_m = 50.0;
inline constexpr int fewest_hollow_cells = 2500;
/// Larger grids are averaged to about so many cells.
inline constexpr int hollow_cells = 20'000;

// --- crowns: how far the heights stand up at the listed trees, by median ---
/// On bare ground 0.00 to 0.02 of the height of the tree and up to 0.4 m (10 m cells); on the scanned surface
/// of a mapped plot (chablais3, cells of 0.5 to 10 m) 0.15 to 0.25, under synthetic crowns 0.2 to 0.8.
inline constexpr double bump_error = 0.12;
inline constexpr double bump_error_m = 1.5;
inline constexpr double bump_warning = 0.06;
inline constexpr double bump_warning_m = 1.0;
inline constexpr int fewest_trees = 20;
inline constexpr double least_tree_m = 8.0;
/// Distance of the ground that is taken for "around" [m], and at least two cells.
inline constexpr double around_m = 5.0;

// --- cells ---
/// Walls of 6 to 20 m above platforms of 5 to 15 m: mean run-out of rocks of 0.95 m is off by 2 % with cells
/// of 1 m, by 5 to 19 % with 2 m and up to 60 % with 5 m (geometry of tests/rockfall/wall_test.cpp).
inline constexpr double coarsest_for_walls_m = 1.25;
/// A wall rises within one or two cells more steeply than this, is steeper by these angles than the ground at
/// its gentler and its other side, and rises by so much more than that.
inline constexpr double wall_deg = 50.0;
inline constexpr double wall_bend_deg = 25.0;
inline constexpr double wall_lesser_bend_deg = 10.0;
inline constexpr double wall_m = 4.0;
/// Noise reaches less: its standard deviation in that difference is the root of 6.
inline constexpr double wall_noises = 10.0;
inline constexpr std::size_t fewest_walls = 10;
/// Rockyfor3D asks for 1 to 10 m (Dorren 2016) [lit].
inline constexpr double coarsest_cell_m = 10.5;

}  // namespace coupling::plausible::terrain::limits
