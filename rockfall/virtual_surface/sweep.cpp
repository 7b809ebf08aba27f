#include "rockfall/virtual_surface/sweep.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace rockfall {

namespace {

/// Touches one block after the other and keeps the first in time.
class FirstTouch {
public:
    FirstTouch(const Eigen::Vector3d& centre_m, const Eigen::Vector3d& direction, double radius_m,
               double length_m, double widest_sine)
        : centre_m_{centre_m},
          direction_{direction},
          radius_m_{radius_m},
          widest_sine_squared_{widest_sine * widest_sine},
          along_m_{length_m} {}

    void meet(const Block& block, double shift_x_m, double shift_y_m) {
        const Eigen::Vector3d to_block_m =
            Eigen::Vector3d{block.x_m + shift_x_m, block.y_m + shift_y_m, block.z_m} - centre_m_;
        const double abeam_m = to_block_m.dot(direction_);
        const double contact_m = radius_m_ + block.radius_m;
        const double off_line_m2 = to_block_m.squaredNorm() - abeam_m * abeam_m;
        if (abeam_m <= 0.0 || off_line_m2 >= contact_m * contact_m * widest_sine_squared_) {
            return;
        }
        const double along_m = abeam_m - std::sqrt(contact_m * contact_m - off_line_m2);
        if (along_m >= 0.0 && along_m <= along_m_) {
            along_m_ = along_m;
            towards_ = (to_block_m - along_m * direction_) / contact_m;
            touched_ = true;
        }
    }
    [[nodiscard]] bool is_within(double along_m) const { return touched_ && along_m_ <= along_m; }
    [[nodiscard]] std::optional<BlockContact> contact() const {
        return touched_ ? std::optional<BlockContact>{{along_m_, towards_}} : std::nullopt;
    }

private:
    const Eigen::Vector3d& centre_m_;
    const Eigen::Vector3d& direction_;
    double radius_m_;
    double widest_sine_squared_;
    double along_m_;
    Eigen::Vector3d towards_{Eigen::Vector3d::Zero()};
    bool touched_ = false;
};

std::int64_t cell_of(double x_m, double cell_m) {
    return static_cast<std::int64_t>(std::floor(x_m / cell_m));
}

}  // namespace

Sweep::Sweep(const BlockCover& cover, double diameter_m)
    : cover_{cover}, radius_m_{0.5 * diameter_m}, reach_m_{0.0} {
    assert(diameter_m > 0.0);
    for (const Block& block : cover.blocks()) {
        const double contact_m = radius_m_ + block.radius_m;
        const double above_m = std::max(0.0, radius_m_ - block.z_m);
        reach_m_ = std::max(reach_m_, std::sqrt(contact_m * contact_m - above_m * above_m));
    }
}

std::optional<BlockContact> Sweep::first_contact(const Eigen::Vector3d& centre_m,
                                                 const Eigen::Vector3d& direction, double length_m,
                                                 double widest_sine) const {
    FirstTouch first{centre_m, direction, radius_m_, length_m, widest_sine};
    const double cell_m = cover_.cell_m();
    const double piece_m = std::max(cell_m, reach_m_);
    for (double seen_m = 0.0; seen_m < length_m; seen_m += piece_m) {
        const double end_m = std::min(length_m, seen_m + piece_m);
        const Eigen::Vector3d a = centre_m + seen_m * direction;
        const Eigen::Vector3d b = centre_m + end_m * direction;
        const std::int64_t last_column = cell_of(std::max(a.x(), b.x()) + reach_m_, cell_m);
        const std::int64_t last_row = cell_of(std::max(a.y(), b.y()) + reach_m_, cell_m);
        for (std::int64_t j = cell_of(std::min(a.y(), b.y()) - reach_m_, cell_m); j <= last_row; ++j) {
            for (std::int64_t i = cell_of(std::min(a.x(), b.x()) - reach_m_, cell_m); i <= last_column; ++i) {
                const BlockCover::Cell cell = cover_.cell(i, j);
                for (const Block& block : cell.blocks) {
                    first.meet(block, cell.shift_x_m, cell.shift_y_m);
                }
            }
        }
        if (first.is_within(end_m)) {
            break;
        }
    }
    return first.contact();
}

}  // namespace rockfall
