#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "config/geometry/shape.hpp"
#include "config/units/angle.hpp"
#include "forest/stand/patch.hpp"
#include "forest/stand/stand.hpp"

namespace forest {

/// Where an intervention acts: what lies in one of the polygons, in one of the management units and on
/// patches of a steepness. An empty list leaves everything in.
struct TreatmentArea {
    std::vector<config::Shape> polygons{};
    std::vector<std::uint32_t> management_units{};
    double from_slope_deg = 0.0;  ///< of the patch
    double to_slope_deg = 90.0;
    friend bool operator==(const TreatmentArea&, const TreatmentArea&) = default;
};

/// Whether a place of the forest belongs to an area; false off the patches.
bool belongs(const TreatmentArea& area, const PatchGrid& grid, double x_m, double y_m);

/// Trees of an area, as places in trees().
std::vector<std::size_t> trees_in(const Stand& stand, const TreatmentArea& area);
/// Patches whose middle lies in an area.
std::vector<PatchId> patches_in(const PatchGrid& grid, const TreatmentArea& area);
/// Forest in an area on the map, to a 25th of a patch [ha].
double area_ha(const PatchGrid& grid, const TreatmentArea& area);

/// A corridor along a line: a rectangle for each piece, and a polygon of 16 corners where two of them meet.
/// What lies in any of them lies in the corridor. Requires two points and more, width_m > 0.
std::vector<config::Shape> corridor(std::span<const config::Point2> line, double width_m);

/// A rectangle around a centre; `direction` of its length counter-clockwise from east.
config::Shape rectangle(config::Point2 centre, double length_m, double width_m, config::Angle direction);

/// A slit cut, as mountain forests are opened: long and narrow, oblique to the fall line, so that no rock
/// finds a long open way (Wunder & Brang 2003).
struct Slit {
    double length_m = 50.0;                                          ///< > 0, usually 40-70
    double width_m = 15.0;                                           ///< > 0, usually 15-20
    config::Angle to_fall_line = config::Angle::from_degrees(45.0);  ///< of the long axis, 0 = straight down
};

/// How far one sees down the fall line in the middle of a slit [m].
double open_length_m(const Slit& slit);

/// Direction of the fall line, counter-clockwise from east: of one patch, or the mean over a forest.
config::Angle fall_line_of(const Patch& patch);
config::Angle mean_fall_line(const PatchGrid& grid);

/// A slit around a centre on a slope with this fall line.
config::Shape slit_at(config::Point2 centre, config::Angle fall_line, const Slit& slit);

/// Slits in lines down the slope, as rungs of ladders: `gap_m` apart along the line, lines `lines_m` apart.
/// Of `entries` rungs one is cut, so that further entries open the forest between; on every second line that
/// is the rung half a cycle off, so that slits of one entry stand on gaps, as left and right of a cable line.
/// Slits with less than half of their area in the forest are left out. Requires entry < entries.
std::vector<config::Shape> ladder_of_slits(const PatchGrid& grid, const Slit& slit, double gap_m,
                                           double lines_m, int entry, int entries);

/// Strips of a width over the whole forest, side by side along `direction` of their length; every
/// `entries`-th, beginning with `entry`.
std::vector<config::Shape> strips(const PatchGrid& grid, double width_m, config::Angle direction, int entry,
                                  int entries);

}  // namespace forest
