#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "config/random/stream.hpp"

namespace rockfall {

/// One block of a virtual surface: a sphere, partly below the base plane z = 0.
struct Block {
    double x_m = 0.0;  ///< [0, side of the patch)
    double y_m = 0.0;  ///< [0, side of the patch)
    double z_m = 0.0;  ///< of the centre, [0, radius]
    double radius_m = 0.0;

    [[nodiscard]] double top_m() const { return z_m + radius_m; }
    [[nodiscard]] double plan_area_m2() const;
};

/// Blocks of one kind, as a field person would describe them.
struct BlockKind {
    double low_m = 0.4;              ///< diameters are uniform between low and high, (0, 5]
    double high_m = 0.8;             ///< the same as low: all blocks alike
    std::vector<double> observed_m;  ///< not empty: diameters are drawn from these, with equal chance
    double cover = 0.1;              ///< share of the patch under these blocks [-], [0, largest_cover]
    double burial = 0.25;            ///< share of the diameter below ground [-], [0, 0.5]
    double gathering = 0.0;          ///< probability that a block comes to lie at a present one [-], [0, 1]

    [[nodiscard]] double largest_m() const;
    [[nodiscard]] double mean_plan_area_m2() const;  ///< of one block
};

/// Beyond about this cover random places run out (jamming of spheres thrown one by one) [-].
inline constexpr double largest_cover = 0.55;

/// Side of the square that stands for an endless surface, unless its blocks are few.
inline constexpr double default_patch_m = 24.0;

/// Side of a square large enough for about 32 blocks of each kind: from 24 m to 200 m, with at most about 200
/// 000 blocks [choice]. On a smaller one a sparse cover would depend on the size of one or two blocks.
double patch_side_m(std::span<const BlockKind> kinds);

/// Which of many surfaces of the same description, all different and each always the same.
struct SurfaceKey {
    std::uint64_t seed = 0;
    std::uint32_t number = 0;
};

/// A square of ground with blocks on it, repeated without end in x and y.
///
/// Blocks never overlap in plan, so cover is the exact sum of their plan areas. A grid of cells finds
/// neighbours; what lies beyond a border is the block on the other side.
///
///     y ^  +-----+-----+-----+
///       |  |     |  o  |     |    cell (column, row), column along x from 0; any whole number is a
///       |  +-----+-----+-----+    column, counted on over the border
///       |  |  o  |     | o   |
///       +--+-----+-----+-----+--> x
class BlockCover {
public:
    /// Requires 0 < largest block <= side.
    BlockCover(double side_m, double largest_block_m);

    [[nodiscard]] double side_m() const { return side_m_; }
    [[nodiscard]] const std::vector<Block>& blocks() const { return blocks_; }
    [[nodiscard]] double cover() const { return plan_area_m2_ / (side_m_ * side_m_); }
    [[nodiscard]] double highest_m() const { return highest_m_; }  ///< 0 without blocks
    /// Height of the blocks above the base plane, each weighted by its plan area: what a rock meets on the
    /// covered part. 0 without blocks.
    [[nodiscard]] double mean_projection_m() const;

    /// Puts the block there, its place brought into the patch, unless it would overlap another in plan.
    bool add(Block block);

    [[nodiscard]] double cell_m() const { return cell_m_; }
    /// Blocks with centres in a cell, and how far the cell has to be moved to lie where it was asked for.
    struct Cell {
        std::span<const Block> blocks;
        double shift_x_m;
        double shift_y_m;
    };
    [[nodiscard]] Cell cell(std::int64_t column, std::int64_t row) const;

private:
    [[nodiscard]] bool has_room_for(const Block& block) const;

    double side_m_;
    std::int64_t cells_along_;
    double cell_m_;  ///< not below the largest diameter, so that nine cells hold all blocks in touch
    std::vector<std::vector<Block>> cells_;
    std::vector<Block> blocks_;
    double plan_area_m2_ = 0.0;
    double highest_m_ = 0.0;
};

/// How long a block looks for a place [choice].
struct LayingEffort {
    int looks_at_others = 200;  ///< after these it takes any place
    int looks_anywhere =
        20'000;  ///< after these the patch counts as full; at half cover one in hundreds fits
};

/// Lays blocks by imitation of natural deposition (Rammer et al. 2010, section 3.2.2: "added blocks gather at
/// present ones", until a given cover is reached).
///
/// Kinds are laid one after the other. A block draws its diameter, then looks for a place: with the
/// probability `gathering` in touch with a block that is there, any of them with equal chance, on a random
/// side; else anywhere. Where it would overlap it looks again, after many times for a place anywhere.
/// The last block of a kind is laid with the probability that makes the mean cover over many surfaces the
/// stated one. Where no place is left (covers near `largest_cover`) laying ends early: compare `cover()`.
///
/// Each block draws from a stream of its own, keyed by seed, number of the surface and number of the block.
BlockCover lay_blocks(std::span<const BlockKind> kinds, double side_m, const SurfaceKey& key,
                      const LayingEffort& effort = {});

}  // namespace rockfall
