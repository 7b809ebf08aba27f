#include "coupling/assessments/collapse/floor_watch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace coupling::collapse {
namespace {

double squared_distance(const Eigen::Vector2d& point_m, const Eigen::Vector2d& from_m,
                        const Eigen::Vector2d& to_m) {
    const Eigen::Vector2d way_m = to_m - from_m;
    const double length2 = way_m.squaredNorm();
    const double share = length2 > 0.0 ? std::clamp((point_m - from_m).dot(way_m) / length2, 0.0, 1.0) : 0.0;
    return (point_m - from_m - share * way_m).squaredNorm();
}

}  // namespace

FloorWatch::FloorWatch(const rockfall::Target& target) : low_m_{target.low_m}, high_m_{target.high_m} {
    constexpr double cells_a_side = 100.0;
    const Eigen::Vector2d size_m = high_m_ - low_m_;
    if (!target.is_area || size_m.maxCoeff() <= 0.0) {
        return;
    }
    cell_m_ = size_m.maxCoeff() / cells_a_side;
    const auto count = [&](double side_m) { return static_cast<int>(std::ceil(side_m / cell_m_ - 1e-9)); };
    for (int row = 0; row < count(size_m.y()); ++row) {
        for (int column = 0; column < count(size_m.x()); ++column) {
            const Eigen::Vector2d middle_m = low_m_ + cell_m_ * Eigen::Vector2d{column + 0.5, row + 0.5};
            if (rockfall::is_inside(target, middle_m)) {
                middles_m_.push_back(middle_m);
            }
        }
    }
    largest_j_.assign(middles_m_.size(), -1.0);
}

void FloorWatch::pass(const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m, double radius_m,
                      double energy_j) {
    const Eigen::Vector2d low_m = from_m.cwiseMin(to_m).array() - radius_m;
    const Eigen::Vector2d high_m = from_m.cwiseMax(to_m).array() + radius_m;
    if ((high_m.array() < low_m_.array()).any() || (low_m.array() > high_m_.array()).any()) {
        return;
    }
    for (std::size_t k = 0; k < middles_m_.size(); ++k) {
        if (energy_j > largest_j_[k] &&
            squared_distance(middles_m_[k], from_m, to_m) <= radius_m * radius_m) {
            largest_j_[k] = energy_j;
        }
    }
}

double FloorWatch::floor_m2() const {
    return static_cast<double>(middles_m_.size()) * cell_m_ * cell_m_;
}

double FloorWatch::reached_m2(double least_j) const {
    const auto reached = std::count_if(largest_j_.begin(), largest_j_.end(), [&](double energy_j) {
        return energy_j >= 0.0 && energy_j >= least_j;
    });
    return static_cast<double>(reached) * cell_m_ * cell_m_;
}

std::vector<Wall> walls_of(const rockfall::Target& target) {
    std::vector<Wall> walls;
    for (const auto& ring : target.parts) {
        for (std::size_t i = 0; i + 1 < ring.size(); ++i) {
            walls.push_back({ring[i], ring[i + 1]});
        }
    }
    return walls;
}

std::size_t wall_met(const rockfall::Target& target, const Eigen::Vector2d& from_m,
                     const Eigen::Vector2d& to_m) {
    const std::vector<Wall> walls = walls_of(target);
    const auto cross = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
        return a.x() * b.y() - a.y() * b.x();
    };
    const Eigen::Vector2d path_m = to_m - from_m;
    double first = std::numeric_limits<double>::infinity(), nearest_m2 = first;
    std::size_t crossed = walls.size(), near = 0;
    for (std::size_t k = 0; k < walls.size(); ++k) {
        const Eigen::Vector2d edge_m = walls[k].to_m - walls[k].from_m;
        const Eigen::Vector2d to_wall_m = walls[k].from_m - from_m;
        const double across = cross(path_m, edge_m);
        if (across != 0.0) {
            const double share = cross(to_wall_m, edge_m) / across;
            const double along = cross(to_wall_m, path_m) / across;
            if (share >= 0.0 && share <= 1.0 && along >= 0.0 && along <= 1.0 && share < first) {
                first = share;
                crossed = k;
            }
        }
        const double apart_m2 = squared_distance(to_m, walls[k].from_m, walls[k].to_m);
        if (apart_m2 < nearest_m2) {
            nearest_m2 = apart_m2;
            near = k;
        }
    }
    return crossed < walls.size() ? crossed : near;
}

}  // namespace coupling::collapse
