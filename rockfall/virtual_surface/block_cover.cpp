#include "rockfall/virtual_surface/block_cover.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <optional>

#include "config/math/elementary.hpp"

namespace rockfall {

namespace {

std::int64_t floor_division(std::int64_t a, std::int64_t b) {
    return a >= 0 ? a / b : -((b - 1 - a) / b);
}

/// A length brought into [0, side).
double wrapped(double x_m, double side_m) {
    const double inside_m = x_m - side_m * std::floor(x_m / side_m);
    return inside_m < side_m ? inside_m : 0.0;
}

double drawn_diameter_m(const BlockKind& kind, double u) {
    if (kind.observed_m.empty()) {
        return kind.low_m + u * (kind.high_m - kind.low_m);
    }
    const auto count = static_cast<double>(kind.observed_m.size());
    return kind.observed_m[static_cast<std::size_t>(u * count)];
}

/// A unit vector in plan whose direction is uniform: u counts turns.
std::array<double, 2> direction_in_plan(double u) {
    // Half turns by sine and cosine, which reach a right angle either way; the other half is its opposite.
    const double sign = u < 0.5 ? 1.0 : -1.0;
    const double half = u < 0.5 ? u : u - 0.5;
    const config::SinCos turn = config::sin_cos_of((half - 0.25) * 2.0 * std::numbers::pi);
    return {sign * turn.cos, sign * turn.sin};
}

/// The block with a place, laid; false where none was found.
bool lay(Block block, double gathering, const LayingEffort& effort, config::RandomStream& stream,
         BlockCover& cover) {
    for (int look = 0; look < effort.looks_at_others + effort.looks_anywhere; ++look) {
        const bool may_gather = look < effort.looks_at_others && !cover.blocks().empty();
        if (may_gather && stream.uniform() < gathering) {
            const auto count = static_cast<double>(cover.blocks().size());
            const Block& present = cover.blocks()[static_cast<std::size_t>(stream.uniform() * count)];
            const auto [east, north] = direction_in_plan(stream.uniform());
            const double apart_m = present.radius_m + block.radius_m;
            block.x_m = present.x_m + apart_m * east;
            block.y_m = present.y_m + apart_m * north;
        } else {
            block.x_m = cover.side_m() * stream.uniform();
            block.y_m = cover.side_m() * stream.uniform();
        }
        if (cover.add(block)) {
            return true;
        }
    }
    return false;
}

}  // namespace

double Block::plan_area_m2() const {
    return std::numbers::pi * radius_m * radius_m;
}

double BlockKind::largest_m() const {
    return observed_m.empty() ? high_m : *std::max_element(observed_m.begin(), observed_m.end());
}

double BlockKind::mean_plan_area_m2() const {
    if (observed_m.empty()) {
        const double mean_square_m2 = (low_m * low_m + low_m * high_m + high_m * high_m) / 3.0;
        return 0.25 * std::numbers::pi * mean_square_m2;
    }
    double sum_m2 = 0.0;
    for (const double diameter_m : observed_m) {
        sum_m2 += 0.25 * std::numbers::pi * diameter_m * diameter_m;
    }
    return sum_m2 / static_cast<double>(observed_m.size());
}

double patch_side_m(std::span<const BlockKind> kinds) {
    constexpr double wanted_blocks = 32.0;
    constexpr double most_blocks = 200'000.0;
    constexpr double largest_side_m = 200.0;
    constexpr double least_m2 = default_patch_m * default_patch_m;
    double area_m2 = least_m2;
    double blocks_per_m2 = 0.0;
    for (const BlockKind& kind : kinds) {
        if (kind.cover > 0.0) {
            area_m2 = std::max(area_m2, wanted_blocks * kind.mean_plan_area_m2() / kind.cover);
            blocks_per_m2 += kind.cover / kind.mean_plan_area_m2();
        }
    }
    if (blocks_per_m2 * area_m2 > most_blocks) {
        area_m2 = std::max(least_m2, most_blocks / blocks_per_m2);
    }
    return std::min(largest_side_m, std::sqrt(area_m2));
}

BlockCover::BlockCover(double side_m, double largest_block_m)
    : side_m_{side_m},
      cells_along_{std::max<std::int64_t>(1, static_cast<std::int64_t>(side_m / largest_block_m))},
      cell_m_{side_m / static_cast<double>(cells_along_)},
      cells_(static_cast<std::size_t>(cells_along_ * cells_along_)) {
    assert(largest_block_m > 0.0 && largest_block_m <= side_m);
}

double BlockCover::mean_projection_m() const {
    double sum_m3 = 0.0;
    for (const Block& block : blocks_) {
        sum_m3 += block.plan_area_m2() * block.top_m();
    }
    return blocks_.empty() ? 0.0 : sum_m3 / plan_area_m2_;
}

bool BlockCover::add(Block block) {
    block.x_m = wrapped(block.x_m, side_m_);
    block.y_m = wrapped(block.y_m, side_m_);
    assert(2.0 * block.radius_m <= cell_m_ * (1.0 + 1e-12));
    if (!has_room_for(block)) {
        return false;
    }
    const auto along = [&](double x_m) {
        return std::min(cells_along_ - 1, static_cast<std::int64_t>(x_m / cell_m_));
    };
    cells_[static_cast<std::size_t>(along(block.y_m) * cells_along_ + along(block.x_m))].push_back(block);
    blocks_.push_back(block);
    plan_area_m2_ += block.plan_area_m2();
    highest_m_ = std::max(highest_m_, block.top_m());
    return true;
}

BlockCover::Cell BlockCover::cell(std::int64_t column, std::int64_t row) const {
    const std::int64_t patch_x = floor_division(column, cells_along_);
    const std::int64_t patch_y = floor_division(row, cells_along_);
    const std::int64_t index =
        (row - patch_y * cells_along_) * cells_along_ + (column - patch_x * cells_along_);
    return {cells_[static_cast<std::size_t>(index)], static_cast<double>(patch_x) * side_m_,
            static_cast<double>(patch_y) * side_m_};
}

bool BlockCover::has_room_for(const Block& block) const {
    // Blocks laid in touch are apart by the sum of their radii but for rounding, which is no overlap.
    constexpr double rounding = 1.0 - 1e-9;
    const auto column = static_cast<std::int64_t>(block.x_m / cell_m_);
    const auto row = static_cast<std::int64_t>(block.y_m / cell_m_);
    for (std::int64_t j = row - 1; j <= row + 1; ++j) {
        for (std::int64_t i = column - 1; i <= column + 1; ++i) {
            const Cell near = cell(i, j);
            for (const Block& other : near.blocks) {
                const double dx_m = other.x_m + near.shift_x_m - block.x_m;
                const double dy_m = other.y_m + near.shift_y_m - block.y_m;
                const double apart_m = (other.radius_m + block.radius_m) * rounding;
                if (dx_m * dx_m + dy_m * dy_m < apart_m * apart_m) {
                    return false;
                }
            }
        }
    }
    return true;
}

BlockCover lay_blocks(std::span<const BlockKind> kinds, double side_m, const SurfaceKey& key,
                      const LayingEffort& effort) {
    double largest_m = 1e-3;
    for (const BlockKind& kind : kinds) {
        assert(kind.cover >= 0.0 && kind.cover <= largest_cover && kind.burial >= 0.0 && kind.burial <= 0.5);
        largest_m = std::max(largest_m, kind.largest_m());
    }
    BlockCover cover{side_m, largest_m};
    std::uint64_t number = 0;
    for (const BlockKind& kind : kinds) {
        double missing_m2 = kind.cover * side_m * side_m;
        while (missing_m2 > 0.0) {
            config::RandomStream stream{{key.seed, key.number, 0, number++}, config::Purpose::block};
            Block block;
            block.radius_m = 0.5 * drawn_diameter_m(kind, stream.uniform());
            block.z_m = block.radius_m * (1.0 - 2.0 * kind.burial);
            const double area_m2 = block.plan_area_m2();
            const bool is_laid = stream.uniform() * area_m2 < missing_m2;
            if (is_laid && !lay(block, kind.gathering, effort, stream, cover)) {
                return cover;
            }
            missing_m2 -= area_m2;
        }
    }
    return cover;
}

}  // namespace rockfall
