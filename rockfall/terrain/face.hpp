#pragma once

#include <Eigen/Core>

#include "rockfall/terrain/terrain.hpp"

namespace rockfall {

/// The plane of a triangle with its upward unit normal.
struct Face {
    Plane plane;
    Eigen::Vector3d normal;

    explicit Face(const Plane& of) : plane{of}, normal{of.normal()} {}
};

}  // namespace rockfall
