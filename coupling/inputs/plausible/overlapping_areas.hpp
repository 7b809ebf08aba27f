#pragma once

#include <cstddef>
#include <vector>

#include "config/geometry/shape.hpp"

namespace coupling::plausible {

/// Area of a polygon with its parts and holes.
double area_m2(const config::Shape& polygon);

/// Two areas over each other, by their places in the list.
struct Overlap {
    std::size_t first;
    std::size_t second;
    double share;  ///< of the smaller one that lies in the other (0, 1], sampled to a few hundredths
};

/// All pairs of polygons that share more than `least_share` of the smaller one, in order. Requires closed
/// rings.
std::vector<Overlap> overlapping(const std::vector<const config::Shape*>& areas, double least_share);

}  // namespace coupling::plausible
