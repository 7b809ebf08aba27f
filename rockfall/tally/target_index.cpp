#include "rockfall/tally/target_index.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rockfall {
namespace {

constexpr double slack_m = 1e-3;
/// Cells of the grid for each side of a target: about as large as a house in a village [choice].
constexpr double cells_per_side = 1.0;
constexpr double smallest_cell_m = 5.0;
constexpr int most_cells_across = 2048;

Target bounds_of(const Roof& roof) {
    Target area;
    area.parts = {roof.ring_m};
    return with_bounds(std::move(area));
}

}  // namespace

TargetIndex::TargetIndex(std::span<const Target> targets, double reach_m) : asked_at_(targets.size(), 0) {
    if (targets.empty()) {
        return;
    }
    std::size_t sides = 0;
    low_m_ = targets.front().low_m;
    high_m_ = targets.front().high_m;
    for (const Target& target : targets) {
        low_m_ = low_m_.cwiseMin(target.low_m);
        high_m_ = high_m_.cwiseMax(target.high_m);
        for (const auto& part : target.parts) {
            sides += part.size() - 1;
        }
        for (const Roof& roof : target.roofs) {
            const Target area = bounds_of(roof);
            low_m_ = low_m_.cwiseMin(area.low_m);
            high_m_ = high_m_.cwiseMax(area.high_m);
        }
    }
    const double around_m = reach_m + slack_m;
    low_m_.array() -= around_m;
    high_m_.array() += around_m;
    const Eigen::Vector2d extent_m = high_m_ - low_m_;
    const double wanted_m =
        std::sqrt(extent_m.prod() / (cells_per_side * static_cast<double>(std::max<std::size_t>(sides, 1))));
    const double cell_m = std::max({smallest_cell_m, wanted_m, extent_m.maxCoeff() / most_cells_across});
    per_cell_ = 1.0 / cell_m;
    columns_ = std::max(1, static_cast<int>(std::ceil(extent_m.x() * per_cell_)));
    rows_ = std::max(1, static_cast<int>(std::ceil(extent_m.y() * per_cell_)));

    const auto each_cell = [&](const Eigen::Vector2d& low, const Eigen::Vector2d& high, const auto& enter) {
        const Cells under =
            cells_under((low.array() - around_m).matrix(), (high.array() + around_m).matrix());
        for (int row = under.first_row; row <= under.last_row; ++row) {
            for (int column = under.first_column; column <= under.last_column; ++column) {
                enter(index(column, row));
            }
        }
    };
    sides_ = lists_of([&](const auto& enter) {
        for (std::uint32_t number = 0; number < targets.size(); ++number) {
            for (const auto& part : targets[number].parts) {
                for (std::size_t i = 0; i + 1 < part.size(); ++i) {
                    // A long side is entered in pieces, or the rectangle around it would fill the grid.
                    const Eigen::Vector2d way_m = part[i + 1] - part[i];
                    const int pieces = std::max(1, static_cast<int>(std::ceil(way_m.norm() * per_cell_)));
                    for (int k = 0; k < pieces; ++k) {
                        const Eigen::Vector2d a = part[i] + (static_cast<double>(k) / pieces) * way_m;
                        const Eigen::Vector2d b = part[i] + (static_cast<double>(k + 1) / pieces) * way_m;
                        each_cell(a.cwiseMin(b), a.cwiseMax(b),
                                  [&](std::size_t cell) { enter(cell, number); });
                    }
                }
            }
            for (const Roof& roof : targets[number].roofs) {  // what hits the roof may hit what lies below
                const Target area = bounds_of(roof);
                each_cell(area.low_m, area.high_m, [&](std::size_t cell) { enter(cell, number); });
            }
        }
    });
    areas_ = lists_of([&](const auto& enter) {
        for (std::uint32_t number = 0; number < targets.size(); ++number) {
            if (targets[number].is_area) {
                each_cell(targets[number].low_m, targets[number].high_m,
                          [&](std::size_t cell) { enter(cell, number); });
            }
        }
    });
}

template <class EachPair>
TargetIndex::Lists TargetIndex::lists_of(const EachPair& each_pair) const {
    const std::size_t cells = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
    Lists lists;
    // Twice over the same pairs: how many each cell has, then which. A target that comes twice in a row to a
    // cell is entered once.
    std::vector<std::uint32_t> last(cells, ~0U);
    lists.begins.assign(cells + 1, 0);
    each_pair([&](std::size_t cell, std::uint32_t target) {
        lists.begins[cell + 1] += last[cell] != target ? 1U : 0U;
        last[cell] = target;
    });
    for (std::size_t cell = 0; cell < cells; ++cell) {
        lists.begins[cell + 1] += lists.begins[cell];
    }
    lists.targets.resize(lists.begins.back());
    std::vector<std::uint32_t> next(lists.begins.begin(), lists.begins.end() - 1);
    std::fill(last.begin(), last.end(), ~0U);
    each_pair([&](std::size_t cell, std::uint32_t target) {
        if (last[cell] != target) {
            lists.targets[next[cell]++] = target;
            last[cell] = target;
        }
    });
    return lists;
}

TargetIndex::Cells TargetIndex::cells_under(const Eigen::Vector2d& low_m,
                                            const Eigen::Vector2d& high_m) const {
    if ((high_m.array() < low_m_.array()).any() || (low_m.array() > high_m_.array()).any()) {
        return {0, -1, 0, -1};
    }
    const auto cell = [&](double way_m, int count) {
        return std::clamp(static_cast<int>(way_m * per_cell_), 0, count - 1);
    };
    return {cell(low_m.x() - low_m_.x(), columns_), cell(high_m.x() - low_m_.x(), columns_),
            cell(low_m.y() - low_m_.y(), rows_), cell(high_m.y() - low_m_.y(), rows_)};
}

std::span<const std::uint32_t> TargetIndex::look_up(const Eigen::Vector2d& from_m,
                                                    const Eigen::Vector2d& to_m) {
    found_.clear();
    const Cells under = cells_under(from_m.cwiseMin(to_m), from_m.cwiseMax(to_m));
    if (under.first_row == under.last_row && under.first_column == under.last_column) {
        // Nearer to its borders rounding may lead into the next cell.
        constexpr double border_share = 1e-6;
        const Eigen::Vector2d corner{under.first_column, under.first_row};
        here_ = {low_m_ + (corner.array() + border_share).matrix() / per_cell_,
                 low_m_ + (corner.array() + (1.0 - border_share)).matrix() / per_cell_,
                 index(under.first_column, under.first_row)};
        return sides_.of(here_.cell);
    }
    if (++call_ == 0) {  // the counter came round: old marks would look new
        std::fill(asked_at_.begin(), asked_at_.end(), 0);
        call_ = 1;
    }
    for (int row = under.first_row; row <= under.last_row; ++row) {
        for (int column = under.first_column; column <= under.last_column; ++column) {
            for (const std::uint32_t target : sides_.of(index(column, row))) {
                if (asked_at_[target] != call_) {
                    asked_at_[target] = call_;
                    found_.push_back(target);
                }
            }
        }
    }
    std::sort(found_.begin(), found_.end());
    return found_;
}

std::span<const std::uint32_t> TargetIndex::areas_near(const Eigen::Vector2d& point_m) const {
    if (columns_ == 0 || (point_m.array() < low_m_.array()).any() ||
        (point_m.array() > high_m_.array()).any()) {
        return {};
    }
    const Cells under = cells_under(point_m, point_m);
    return areas_.of(index(under.first_column, under.first_row));
}

}  // namespace rockfall
