#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "rockfall/tally/target.hpp"

namespace rockfall {

/// Finds the targets near a place or a piece of a path, so that a rock costs the same beside twenty houses
/// and beside twenty thousand.
///
/// A grid over all targets. Each cell lists the targets of which a side runs through it, and the areas that
/// reach into it. Sides are entered with a millimetre around them: what a sum of coordinates rounds away
/// cannot hide a target that lies on the way.
class TargetIndex {
public:
    TargetIndex() = default;
    /// Requires targets with bounds (`with_bounds`), which must outlive the index.
    /// Pieces find the targets within `reach_m` of them.
    explicit TargetIndex(std::span<const Target> targets, double reach_m = 0.0);

    /// Targets whose lines a straight piece may meet or come within the reach of, each once, in rising order.
    /// The list holds until the next call.
    std::span<const std::uint32_t> near_piece(const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m) {
        if (columns_ == 0 || (from_m.x() < low_m_.x() && to_m.x() < low_m_.x()) ||
            (from_m.x() > high_m_.x() && to_m.x() > high_m_.x()) ||
            (from_m.y() < low_m_.y() && to_m.y() < low_m_.y()) ||
            (from_m.y() > high_m_.y() && to_m.y() > high_m_.y())) {
            return {};
        }
        return here_.has(from_m) && here_.has(to_m) ? sides_.of(here_.cell) : look_up(from_m, to_m);
    }
    /// Areas that a point may lie in, in rising order.
    [[nodiscard]] std::span<const std::uint32_t> areas_near(const Eigen::Vector2d& point_m) const;

private:
    /// Numbers of targets, cell by cell.
    struct Lists {
        std::vector<std::uint32_t> begins;  ///< of each cell in `targets`, and the end of the last
        std::vector<std::uint32_t> targets;
        [[nodiscard]] std::span<const std::uint32_t> of(std::size_t cell) const {
            return std::span{targets}.subspan(begins[cell], begins[cell + 1] - begins[cell]);
        }
    };
    struct Cells {
        int first_column, last_column, first_row, last_row;
    };
    /// A cell of the grid, of which a piece was asked last: most pieces are short and stay there.
    struct Here {
        Eigen::Vector2d low_m = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
        Eigen::Vector2d high_m = Eigen::Vector2d::Zero();
        std::size_t cell = 0;
        [[nodiscard]] bool has(const Eigen::Vector2d& place_m) const {
            return place_m.x() > low_m.x() && place_m.x() < high_m.x() && place_m.y() > low_m.y() &&
                   place_m.y() < high_m.y();
        }
    };
    std::span<const std::uint32_t> look_up(const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m);
    /// Cells under a rectangle, cut to the grid; none (last before first) where it lies beside it.
    [[nodiscard]] Cells cells_under(const Eigen::Vector2d& low_m, const Eigen::Vector2d& high_m) const;
    [[nodiscard]] std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
               static_cast<std::size_t>(column);
    }
    template <class EachPair>
    [[nodiscard]] Lists lists_of(const EachPair& each_pair) const;

    Eigen::Vector2d low_m_ = Eigen::Vector2d::Zero();
    Eigen::Vector2d high_m_ = Eigen::Vector2d::Zero();
    double per_cell_ = 1.0;  ///< 1 / size of a cell
    int columns_ = 0;
    int rows_ = 0;
    Lists sides_;
    Lists areas_;
    Here here_;
    std::vector<std::uint32_t> found_;
    std::vector<std::uint32_t> asked_at_;  ///< by target, the number of the call that found it
    std::uint32_t call_ = 0;
};

}  // namespace rockfall
