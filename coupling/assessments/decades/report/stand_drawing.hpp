#pragma once

#include <span>
#include <string>
#include <vector>

#include "coupling/assessments/decades/members/records.hpp"
#include "coupling/assessments/decades/report/forest_ground.hpp"
#include "forest/stand/species.hpp"

namespace coupling::decades {

/// A tree as a picture wants it. A group of young trees is drawn as one.
using DrawnTrees = std::vector<const TreeRow*>;

/// A drawing with what it leaves out, as a sentence; empty if nothing.
struct Drawing {
    std::string svg;
    std::string left_out;
};

/// The stand from above. The ground of a picture is drawn once and referred to by its id.
class PlanDrawing {
public:
    PlanDrawing(const forest::PatchGrid& grid, const ForestGround& ground, const config::GridFrame& shown,
                std::string id);

    /// Forest ground and contours. Once on a page.
    [[nodiscard]] std::string definitions() const;
    /// Crowns by species, from small trees to tall ones, and the strip that is seen from the side.
    [[nodiscard]] Drawing crowns(const DrawnTrees& trees, const Transect& strip) const;
    /// Trees as points whose size goes with the diameter, and the part that another drawing enlarges.
    [[nodiscard]] Drawing points(const DrawnTrees& trees, const config::GridFrame& window) const;
    [[nodiscard]] double contour_step_m() const { return contour_step_m_; }

private:
    [[nodiscard]] double x_of(double x_m) const { return (x_m - frame_.x_west_m) * per_m_; }
    [[nodiscard]] double y_of(double y_m) const { return (frame_.y_north_m() - y_m) * per_m_; }
    [[nodiscard]] double width() const { return x_of(frame_.x_east_m()); }
    [[nodiscard]] double height() const { return y_of(frame_.y_south_m); }
    [[nodiscard]] std::string forest_cells() const;
    [[nodiscard]] std::string contours() const;
    [[nodiscard]] std::string sheet(const std::string& label, const std::string& drawing) const;
    [[nodiscard]] std::string strip_outline(const Transect& strip) const;

    const forest::PatchGrid& grid_;
    const ForestGround& ground_;
    config::GridFrame frame_;
    std::string id_;
    double per_m_;
    double contour_step_m_;
};

/// Width of the strip that is seen from the side.
inline constexpr double strip_m = 10.0;
/// Stems are drawn thicker than they are, or they could not be seen.
inline constexpr double stem_widening = 2.0;

/// Trees of the strip, the ones at the back first.
DrawnTrees trees_in_strip(const DrawnTrees& trees, const Transect& strip);

/// The stand from the side: ground, stems and crowns along the strip, heights and distances at one scale.
/// `top_m` is the height above sea level that the drawing reaches at least.
Drawing side_view(const DrawnTrees& in_strip, const forest::SpeciesTable& species, const ForestGround& ground,
                  const Transect& strip, double top_m);

/// Height above sea level of the highest tree top, or of the ground.
double top_of(const DrawnTrees& in_strip, const ForestGround& ground, const Transect& strip);

}  // namespace coupling::decades
