#include "coupling/inputs/forest/tops/canopy_tops.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>

namespace coupling {
namespace {

/// A cell beside another one, and how far its centre is.
struct CanopyStep {
    int columns;
    int rows;
    double distance_m;

    [[nodiscard]] bool is_neighbour() const { return std::abs(columns) <= 1 && std::abs(rows) <= 1; }
};

/// All steps up to a distance, the nearest first, as most cells have a higher one beside them.
std::vector<CanopyStep> steps_within(double distance_m, const config::GridFrame& frame) {
    const int columns = std::max(1, static_cast<int>(distance_m / frame.cell_width_m));
    const int rows = std::max(1, static_cast<int>(distance_m / frame.cell_height_m));
    std::vector<CanopyStep> steps;
    for (int row = -rows; row <= rows; ++row) {
        for (int column = -columns; column <= columns; ++column) {
            const CanopyStep step{column, row,
                                  std::hypot(column * frame.cell_width_m, row * frame.cell_height_m)};
            if ((column != 0 || row != 0) && (step.is_neighbour() || step.distance_m <= distance_m)) {
                steps.push_back(step);
            }
        }
    }
    std::stable_sort(steps.begin(), steps.end(), [](const CanopyStep& a, const CanopyStep& b) {
        return a.is_neighbour() != b.is_neighbour() ? a.is_neighbour() : a.distance_m < b.distance_m;
    });
    return steps;
}

/// Cells that are no lower than any in their window, and which of them are one tree.
class TopCells {
public:
    TopCells(const config::Raster<double>& heights_m, const CanopyWindowLaw& window, double least_m)
        : heights_m_{heights_m}, window_{window} {
        double highest_m = 0.0;
        for (const double height_m : heights_m.values) {
            highest_m = height_m > highest_m ? height_m : highest_m;  // not for NaN
        }
        steps_ = steps_within(0.5 * window.width_m(highest_m), heights_m.frame);
        for (std::size_t i = 0; i < heights_m.values.size(); ++i) {
            if (heights_m.values[i] >= least_m && is_highest(i)) {
                cells_.push_back(i);
            }
        }
        parents_.resize(cells_.size());
        std::iota(parents_.begin(), parents_.end(), std::size_t{0});
        join_equal_ones();
    }

    TreeTops tops() {
        struct Group {
            double columns = 0.0;  ///< sums
            double rows = 0.0;
            double cells = 0.0;
            bool is_beside_unknown = false;
        };
        std::vector<Group> groups(cells_.size());
        for (std::size_t i = 0; i < cells_.size(); ++i) {
            const config::Cell cell = heights_m_.frame.cell_of(cells_[i]);
            Group& group = groups[first_of(i)];
            group.columns += cell.column;
            group.rows += cell.row;
            group.cells += 1.0;
            group.is_beside_unknown = group.is_beside_unknown || is_beside_unknown(cell);
        }
        TreeTops found;
        const config::GridFrame& frame = heights_m_.frame;
        for (std::size_t i = 0; i < cells_.size(); ++i) {
            const Group& group = groups[i];
            if (group.cells > 0.0 && group.is_beside_unknown) {
                ++found.beside_unknown;
            } else if (group.cells > 0.0) {
                const double column = group.columns / group.cells + 0.5;
                const double row = group.rows / group.cells + 0.5;
                found.tops.push_back({frame.x_west_m + column * frame.cell_width_m,
                                      frame.y_south_m + (frame.rows - row) * frame.cell_height_m,
                                      heights_m_.values[cells_[i]]});
            }
        }
        return found;
    }

private:
    /// Calls `visit` with the index of each cell of the window until it says no.
    template <class Visit>
    void visit_window(std::size_t index, const Visit& visit) const {
        const config::Cell cell = heights_m_.frame.cell_of(index);
        const double reach_m = 0.5 * window_.width_m(heights_m_.values[index]);
        for (const CanopyStep& step : steps_) {
            if (!step.is_neighbour() && step.distance_m > reach_m) {
                return;
            }
            const config::Cell there{cell.column + step.columns, cell.row + step.rows};
            if (heights_m_.frame.contains(there) && !visit(heights_m_.frame.index(there))) {
                return;
            }
        }
    }

    [[nodiscard]] bool is_highest(std::size_t index) const {
        bool is_highest = true;
        visit_window(index, [&](std::size_t other) {
            is_highest = !(heights_m_.values[other] > heights_m_.values[index]);
            return is_highest;
        });
        return is_highest;
    }

    [[nodiscard]] bool is_beside_unknown(config::Cell cell) const {
        for (int row = -1; row <= 1; ++row) {
            for (int column = -1; column <= 1; ++column) {
                const config::Cell there{cell.column + column, cell.row + row};
                if (!heights_m_.frame.contains(there) || std::isnan(heights_m_.at(there))) {
                    return true;
                }
            }
        }
        return false;
    }

    void join_equal_ones() {
        for (std::size_t i = 0; i < cells_.size(); ++i) {
            visit_window(cells_[i], [&](std::size_t other) {
                if (heights_m_.values[other] == heights_m_.values[cells_[i]]) {
                    const auto found = std::lower_bound(cells_.begin(), cells_.end(), other);
                    if (found != cells_.end() && *found == other) {
                        join(i, static_cast<std::size_t>(found - cells_.begin()));
                    }
                }
                return true;
            });
        }
    }

    std::size_t first_of(std::size_t i) {
        while (parents_[i] != i) {
            parents_[i] = parents_[parents_[i]];
            i = parents_[i];
        }
        return i;
    }

    void join(std::size_t a, std::size_t b) {
        const std::size_t first = first_of(a);
        const std::size_t second = first_of(b);
        parents_[std::max(first, second)] = std::min(first, second);
    }

    const config::Raster<double>& heights_m_;
    const CanopyWindowLaw& window_;
    std::vector<CanopyStep> steps_;
    std::vector<std::size_t> cells_;    ///< rising
    std::vector<std::size_t> parents_;  ///< of each of them an earlier one of its tree, or itself
};

}  // namespace

TreeTops tree_tops(const config::Raster<double>& heights_m, const CanopyWindowLaw& window,
                   double least_height_m) {
    return TopCells{heights_m, window, least_height_m}.tops();
}

}  // namespace coupling
