#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "coupling/inputs/site.hpp"
#include "coupling/results/report/map/labels.hpp"
#include "coupling/results/report/map/map_furniture.hpp"

namespace coupling::report {

/// Distances are written smaller than names.
inline constexpr double mark_lettering = 0.75;

/// A distance along a line, beside its mark.
struct DistanceMark {
    DrawnPoint at;
    std::string text;
    [[nodiscard]] double text_x() const { return at.x + 8.0; }
    [[nodiscard]] double text_y() const { return at.y - 7.0; }
};

/// Marks along the lines among the targets at round distances. Those whose number would leave the sheet or
/// lie over its scale bar or north arrow are left out, and so are lines that are too short for them.
std::vector<DistanceMark> distance_marks_of(
    const Site& site, const SheetSize& sheet,
    const std::function<DrawnPoint(const Eigen::Vector2d&)>& on_sheet);

/// Where no name is to stand.
std::vector<LetteredBox> covered_by(const std::vector<DistanceMark>& marks, double lettering);

}  // namespace coupling::report
