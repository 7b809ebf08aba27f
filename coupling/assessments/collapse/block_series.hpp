#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "coupling/assessments/collapse/collapse_results.hpp"

namespace coupling::collapse {

/// Why a block is shown by itself.
enum class Chosen : std::uint8_t { fastest, farthest, median };

/// A block that tables and charts show over time, and why; without reasons where all blocks are wanted.
struct SeriesBlock {
    std::size_t number = 0;
    std::vector<Chosen> reasons{};
};

/// The block with the largest speed, the one that went farthest in plan, and the one in the middle by its
/// way among those that moved by more than a metre; a block may be several of these.
std::vector<SeriesBlock> chosen_blocks(const CollapseResults& results);

/// A block at the time of a frame.
struct BlockMoment {
    double time_s = 0.0;
    Eigen::Vector3d place_m;      ///< absolute
    double displacement_m = 0.0;  ///< distance from its start
    double speed_mps = 0.0;
    /// Change of its velocity since the frame before, by the time between them.
    std::optional<double> acceleration_mps2;
    double kinetic_j = 0.0;
    double released_j = 0.0;  ///< by its height below its start
    /// Released and not kinetic: what contacts, bonds, ground and trees took from it so far. Below 0 where
    /// other blocks push it.
    [[nodiscard]] double given_up_j() const { return released_j - kinetic_j; }
};
BlockMoment moment_of(const CollapseResults& results, std::size_t block, std::size_t frame);

/// Means over all blocks at the time of a frame: energies of the ledger by the number of blocks, the rest by
/// mass.
struct MeanMoment {
    double speed_mps = 0.0;
    std::optional<double> acceleration_mps2;
    double displacement_m = 0.0;
    double kinetic_j = 0.0;
    double friction_j = 0.0;
    double fracture_j = 0.0;
    double strain_j = 0.0;
    double given_up_j = 0.0;  ///< released by gravity and not kinetic
};
MeanMoment mean_moment(const CollapseResults& results, std::size_t frame);

/// The frames of pictures: those nearest to collapse.picture_times_s, or five over the whole time. In rising
/// order, none twice.
std::vector<std::size_t> picture_frames(const CollapseResults& results);

}  // namespace coupling::collapse
