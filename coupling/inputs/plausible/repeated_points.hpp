#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <string>

#include "coupling/inputs/reading/reading.hpp"

namespace coupling::plausible {

/// Points on the place of another with a height that differs by more than 0.5 m [choice: surveys of one place
/// differ less]. A terrain has one height at each place, so that one of the two is lost.
std::size_t points_with_two_heights(std::span<const Eigen::Vector3d> points);

/// An error where more than a tenth of the points are such [choice], as of two surveys or of crowns and
/// ground in one file; a warning where fewer are.
void judge_repeated_points(std::span<const Eigen::Vector3d> points, const std::string& file,
                           Reading& reading);

}  // namespace coupling::plausible
