#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "config/random/stream.hpp"
#include "rockfall/motion/rigid/law.hpp"
#include "rockfall/slope/slope.hpp"

namespace rockfall::rigid {

/// Roughness of the ground below the cells of the terrain, as one block meets it [choice].
///
/// A triangular lattice in plan with the block's diameter as spacing, turned and shifted by chance. Each node
/// is moved vertically by a draw of its own, and the ground is linear between nodes: one fixed, continuous
/// surface for each rock, so that the energy of the block stays what it is. Roughness finer than the block is
/// bridged by it and left out.
///
/// The standard deviation of a node is that of its ground type, less what cells of the terrain show already:
/// times sqrt(1 - spacing / cell), 0 where cells are no coarser than the block. It is a quarter of the
/// spacing at most (a mean tilt of 27 degrees).
class Bumps {
public:
    /// None: the terrain as it is.
    Bumps() = default;
    Bumps(const SlopeView& slope, const Law& law, double diameter_m, const config::StreamKey& key);

    /// No node of the ground is moved farther [m].
    [[nodiscard]] double highest_m() const { return highest_m_; }

    /// A point of the plan in the axes of the lattice, in which nodes are whole numbers.
    struct Place {
        double u, v;
    };
    [[nodiscard]] Place place_of(const Eigen::Vector2d& plan_m) const;

    /// Upward normal of ground with this gradient and a height that besides changes with u and v so much.
    [[nodiscard]] Eigen::Vector3d normal_of(const Eigen::Vector2d& gradient,
                                            const Eigen::Vector2d& slope_m) const;

    /// Nodes around a circle in plan.
    struct Nodes {
        int first_u = 0, first_v = 0;
        int along_u = 0, along_v = 0;
        std::vector<double> heights_m;  ///< row by row of v
        bool flat = true;               ///< all heights are 0

        [[nodiscard]] double at(int u, int v) const {
            return heights_m[static_cast<std::size_t>((v - first_v) * along_u + u - first_u)];
        }
    };
    /// Requires `under`: a triangle near the circle.
    void find_nodes(const Eigen::Vector2d& centre_m, double radius_m, std::uint32_t under,
                    Nodes& nodes) const;

private:
    [[nodiscard]] Eigen::Vector2d plan_of(int u, int v) const;
    [[nodiscard]] double deviation_m(std::uint32_t triangle, const Eigen::Vector2d& plan_m) const;

    SlopeView slope_;
    const Law* law_ = nullptr;
    config::RandomStream draws_{{}, config::Purpose::roughness};
    double spacing_m_ = 1.0;
    double highest_m_ = 0.0;
    Eigen::Vector2d origin_m_ = Eigen::Vector2d::Zero();
    Eigen::Vector2d along_ = Eigen::Vector2d::UnitX();  ///< of the rows
};

}  // namespace rockfall::rigid
