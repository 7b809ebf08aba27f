#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "coupling/assessments/collapse/collapse_site.hpp"
#include "coupling/assessments/collapse/floor_watch.hpp"
#include "coupling/assessments/collapse/hand_over.hpp"
#include "rockfall/rock_mass/rock_mass.hpp"

namespace coupling::collapse {

/// Figures of the whole mass at a time.
struct FrameRow {
    double time_s = 0.0;
    rockfall::rock_mass::Ledger ledger;
    double mean_speed_mps = 0.0;       ///< of the free blocks, by mass
    double largest_speed_mps = 0.0;    ///< of any block since the frame before
    double front_m = 0.0;              ///< largest way in plan of any block from its start
    double mean_displacement_m = 0.0;  ///< of the free blocks from their start, by mass
    // Change of the velocity since the frame before, by the time between them; 0 where there is none before.
    double mean_acceleration_mps2 = 0.0;     ///< of the free blocks, by mass
    double largest_acceleration_mps2 = 0.0;  ///< of any of them
    double moving_share = 0.0;               ///< of the free blocks
    double moving_m3 = 0.0;                  ///< their volume
    double bonds_intact = 0.0;
    double broken_by_tension = 0.0;
    double broken_by_shear = 0.0;
    double residual_share = 0.0;

    /// An acceleration; nothing at the start, before which no frame was kept.
    [[nodiscard]] std::optional<double> known(double acceleration_mps2) const {
        return time_s > 0.0 ? std::optional{acceleration_mps2} : std::nullopt;
    }
};

/// Where a block is at a time and how it moves, for pictures and series.
struct BlockPlace {
    float centre_m[3];
    float attitude[4];  ///< w, x, y, z
    float speed_mps;
    float velocity_mps[3];
    float energy_j;  ///< translation and rotation

    [[nodiscard]] Eigen::Vector3d centre() const { return Eigen::Vector3f{centre_m}.cast<double>(); }
    [[nodiscard]] Eigen::Vector3d velocity() const { return Eigen::Vector3f{velocity_mps}.cast<double>(); }
};

/// A block that reached a target, when it first did.
struct TargetHit {
    double target = 0.0;
    double block = 0.0;
    double time_s = 0.0;
    double x_m = 0.0, y_m = 0.0;
    double speed_mps = 0.0;
    double energy_j = 0.0;
    double translational_j = 0.0;
    double volume_m3 = 0.0;
    double wall = -1.0;  ///< of a target that is an area: number of the wall (WallNumber); -1: none
};

/// What is kept of a collapse while it runs.
struct CollapseRecord {
    std::vector<FrameRow> rows;
    std::vector<std::vector<BlockPlace>> frames;  ///< of the free blocks
    std::vector<TargetHit> hits;
    std::vector<FloorWatch> floors;     ///< of each target; without cells where it is a line
    std::vector<double> cell_blocks;    ///< on the map: blocks whose centre passed
    std::vector<double> cell_energy_j;  ///< largest energy of a block
    std::vector<double> cell_speed_mps;
    std::vector<double> last_cell;        ///< of each free block; -1: none
    std::vector<double> block_speed_mps;  ///< largest of each free block
    std::vector<double> block_energy_j;
    double largest_speed_mps = 0.0;  ///< since the last frame

    CollapseRecord() = default;
    explicit CollapseRecord(const CollapseSite& site);

    /// Looks at the blocks between two frames.
    void observe(const CollapseSite& site, const rockfall::rock_mass::RockMass& mass,
                 const HandOver& hand_over = {});
    /// Keeps a state.
    void add_frame(const CollapseSite& site, const rockfall::rock_mass::RockMass& mass,
                   const HandOver& hand_over = {});

    /// All of it as numbers, and back. False if they are not those of such a site.
    [[nodiscard]] std::vector<double> packed() const;
    bool unpack(std::span<const double> numbers);

private:
    std::vector<std::vector<std::uint8_t>> reached_;  ///< target by block
    std::vector<double> start_x_m_, start_y_m_;
};

}  // namespace coupling::collapse
