#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "rockfall/rock_mass/overlap.hpp"
#include "rockfall/terrain/terrain.hpp"

namespace rockfall::rock_mass {

/// A triangle of the ground with all that is below it: a one-sided prism.
struct GroundPrism {
    Plane3 top;                   ///< upwards
    std::array<Plane3, 3> sides;  ///< vertical, normals out of the prism
    Eigen::Vector2d low_m;        ///< box in plan
    Eigen::Vector2d high_m;
    double highest_m;
};

/// The ground under a rock mass: an elastic foundation as the blocks are, with pressure that grows with the
/// depth below the plane of the triangle above. Force and energy as in overlap.hpp, of the ground alone, as
/// it has no surface of its own that enters a block. So a plane divided into triangles in any way gives the
/// same.
class Ground {
public:
    Ground() = default;
    explicit Ground(const Terrain& terrain);

    [[nodiscard]] bool empty() const { return prisms_.empty(); }
    [[nodiscard]] std::span<const GroundPrism> prisms() const { return prisms_; }

    /// Prisms whose box in plan meets the given one, ascending.
    [[nodiscard]] std::vector<std::uint32_t> prisms_in(const Eigen::Vector2d& low_m,
                                                       const Eigen::Vector2d& high_m) const;

    /// Highest point of prisms.
    [[nodiscard]] double highest_m(std::span<const std::uint32_t> prisms) const;

    /// Overlap with a block, the block being the second body; with its slope where that is asked for.
    [[nodiscard]] Overlap overlap_of(std::span<const std::uint32_t> prisms, const PlacedBlock& block,
                                     const Eigen::Vector3d& about_m, OverlapSlope* slope = nullptr) const;

    /// Its energy for c = 1 [m4].
    [[nodiscard]] double energy_m4(std::span<const std::uint32_t> prisms, const PlacedBlock& block) const;

private:
    std::vector<GroundPrism> prisms_;
    /// Cells over the plan, each with the prisms whose box it meets.
    Eigen::Vector2d low_m_ = Eigen::Vector2d::Zero();
    double bin_m_ = 1.0;
    std::array<int, 2> bins_{0, 0};
    std::vector<std::uint32_t> first_;
    std::vector<std::uint32_t> listed_;

    struct BinRange {
        std::array<int, 2> from;
        std::array<int, 2> to;
    };
    [[nodiscard]] BinRange bins_of(const Eigen::Vector2d& low_m, const Eigen::Vector2d& high_m) const;
    [[nodiscard]] std::size_t bin_at(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(bins_[0]) +
               static_cast<std::size_t>(column);
    }
};

}  // namespace rockfall::rock_mass
