#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "rockfall/terrain/terrain.hpp"

namespace rockfall {

/// CGAL's own Delaunay triangulation of a terrain's vertices, with exact predicates: the judge of our walk.
/// The one test source that includes CGAL stands behind it.
class CgalOracle {
public:
    explicit CgalOracle(const Terrain& terrain);
    ~CgalOracle();
    CgalOracle(const CgalOracle&) = delete;
    CgalOracle& operator=(const CgalOracle&) = delete;

    /// What lies under a point: a triangle with its corners in ascending order, or the outside of the convex
    /// hull, or an edge or corner, where the triangle is a matter of choice.
    struct Found {
        enum class Kind { triangle, outside, edge_or_corner } kind;
        std::array<std::uint32_t, 3> corners{};
    };
    [[nodiscard]] Found locate(double x_m, double y_m) const;

private:
    struct Mesh;
    std::unique_ptr<Mesh> mesh_;
};

}  // namespace rockfall
