#pragma once

#include <Eigen/Core>
#include <functional>
#include <span>
#include <vector>

#include "rockfall/rock_mass/convex_cell.hpp"

namespace rockfall::rock_mass {

/// A plane piece of the border of a body: a convex polygon in space.
struct Facet {
    std::vector<Eigen::Vector3d> corners_m;
};

/// A body of rock by its border and by what lies inside it.
struct Body {
    std::vector<Facet> border;
    std::function<bool(const Eigen::Vector3d&)> contains;
};

/// What a body makes of a convex cell.
struct Division {
    std::vector<ConvexCell> inside;
    std::vector<ConvexCell> outside;
};

/// Divides cells by the border of a body: exact, as pieces of the cell between planes of facets that pass
/// through it. Cuts that would divide only what lies on one side are taken back. New faces are made by
/// `made_by`. `facets`: numbers of those that may pass through the cell.
Division divide(const ConvexCell& cell, const Body& body, std::span<const std::uint32_t> facets, int made_by);

/// Facets of a body found by place.
class FacetIndex {
public:
    FacetIndex(const Body& body, double bin_m);
    /// Numbers of facets whose box meets that of a cell, ascending.
    [[nodiscard]] std::vector<std::uint32_t> near(const ConvexCell& cell) const;

private:
    struct FacetBox {
        Eigen::Vector3d low_m;
        Eigen::Vector3d high_m;
    };
    std::vector<FacetBox> boxes_;
    double bin_m_;
    Eigen::Vector2d low_m_;
    int columns_ = 1, rows_ = 1;
    std::vector<std::vector<std::uint32_t>> bins_;  ///< in plan
};

/// Pieces smaller than `least_size_m` (size_m of convex_cell.hpp) go to the neighbour with which they
/// share the largest face, where both together are convex; `left_out_m3` is the volume of those that found
/// none.
struct Merged {
    std::vector<ConvexCell> cells;
    double left_out_m3 = 0.0;
    std::size_t merged = 0;
    std::size_t left_out = 0;
};
Merged merge_slivers(std::vector<ConvexCell> cells, double least_size_m);

}  // namespace rockfall::rock_mass
