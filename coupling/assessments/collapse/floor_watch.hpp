#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "rockfall/tally/target.hpp"

namespace coupling::collapse {

/// The floor of a target that is an area, in square cells: which of them blocks covered on their way, and
/// with which energy.
///
/// A block covers the cells whose middle its sphere of equal volume passes over in plan, at any height. The
/// target does not hold it.
class FloorWatch {
public:
    /// Cells of a hundredth of the target's longer side [choice]; none for a line.
    explicit FloorWatch(const rockfall::Target& target);

    /// A block went straight from one place to another, in coordinates of the terrain.
    void pass(const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m, double radius_m, double energy_j);

    [[nodiscard]] double cell_m() const { return cell_m_; }
    [[nodiscard]] double floor_m2() const;
    /// Of cells that a block of at least this energy covered.
    [[nodiscard]] double reached_m2(double least_j) const;

    /// Largest energy of a block on each cell [J]; below 0: none came.
    [[nodiscard]] const std::vector<double>& largest_j() const { return largest_j_; }
    [[nodiscard]] std::vector<double>& largest_j() { return largest_j_; }

private:
    Eigen::Vector2d low_m_;
    Eigen::Vector2d high_m_;
    double cell_m_ = 0.0;
    std::vector<Eigen::Vector2d> middles_m_;
    std::vector<double> largest_j_;
};

/// A side of a target that is an area, numbered from 0 ring by ring.
struct Wall {
    Eigen::Vector2d from_m;  ///< in coordinates of the terrain
    Eigen::Vector2d to_m;

    [[nodiscard]] double length_m() const { return (to_m - from_m).norm(); }
};
std::vector<Wall> walls_of(const rockfall::Target& target);

/// Number of the wall that a straight way meets: the one that it crosses first, or else the one nearest to
/// its end. Requires an area.
std::size_t wall_met(const rockfall::Target& target, const Eigen::Vector2d& from_m,
                     const Eigen::Vector2d& to_m);

}  // namespace coupling::collapse
