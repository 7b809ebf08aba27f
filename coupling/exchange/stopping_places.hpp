#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "coupling/exchange/bare_year.hpp"
#include "forest/stand/patch.hpp"
#include "rockfall/ensemble.hpp"
#include "rockfall/tally/target_distance.hpp"

namespace coupling::exchange {

/// Width of a band of distance from a target on the map [m]: that of a patch.
inline constexpr double distance_band_m = forest::patch_side_m;

/// What the rocks of a target, those that arrive there over the bare slope, did in one place on their way
/// through the forest: in a band of distance from the target, or on a patch. Whole numbers, so that sums do
/// not depend on their order. A tree is any stem here, living or dead, or a log.
struct PlaceCounts {
    /// Spared rocks (they arrive over the bare slope and not through the forest) whose last tree stands here,
    /// minus rocks made worse (they arrive through the forest alone) whose last tree before the target does.
    std::int32_t spared = 0;
    std::uint32_t came = 0;            ///< rocks of the target that came here
    std::uint32_t met = 0;             ///< of these, those that met a tree of this place
    std::uint32_t missed = 0;          ///< of these, those that went on without
    std::uint32_t missed_arrived = 0;  ///< of these, those that arrive

    void add(const PlaceCounts& other);
    [[nodiscard]] bool empty() const { return came == 0 && spared == 0; }
    friend bool operator==(const PlaceCounts&, const PlaceCounts&) = default;
};

/// Where the forest stops the rocks of a year.
struct StoppingPlaces {
    std::vector<std::vector<PlaceCounts>> bands;  ///< by target, by band from the target on
    std::vector<std::int32_t> without_tree;       ///< by target: `spared` of rocks that met no tree at all
    /// By patch, sums over the targets; the last one is ground without a patch, and rocks without a tree.
    std::vector<PlaceCounts> patches;
};

/// Counts where the forest stops the rocks of a year, rock by rock, from what they met and from which of them
/// arrive over the bare slope. Nothing falls again.
///
/// A rock's path is taken as straight on the map between its start, its hits and its end. What it meets
/// beyond a target that it has reached does not count for this target. Of hits on stems and logs the one
/// farther from the start is the later one. A rock that leans on a tree without a hit has its last tree where
/// it lies.
class StoppingPlaceCounter {
public:
    /// `distances`: of each target. `origin_m`: of the coordinates of the terrain. All must outlive it.
    StoppingPlaceCounter(std::span<const rockfall::TargetDistance> distances, const forest::PatchGrid& grid,
                         const Eigen::Vector2d& origin_m, std::span<const rockfall::PlacedStem> stems);

    /// The rocks of a chunk through the forest. `bare`: the same rocks over the bare slope.
    void add(const rockfall::ChunkRows& rows, const BareYear& bare);

    [[nodiscard]] StoppingPlaces take() { return std::move(places_); }

private:
    /// A tree or log on the way of a rock.
    struct Meeting {
        Eigen::Vector2d tree_m;  ///< where it stands; of a log, where it was hit
        Eigen::Vector2d rock_m;  ///< where the rock was
        double from_start_m;     ///< of the rock, on the map
    };
    /// A rock and the rows that belong to it.
    struct RowsOfRock {
        const rockfall::RockRecord& fall;
        std::span<const std::pair<std::uint64_t, rockfall::TreeHitRecord>> tree_hits;
        std::span<const std::pair<std::uint64_t, rockfall::LogHitRecord>> log_hits;
        std::span<const rockfall::ArrivalRecord> arrivals;
    };

    void add_rock(const RowsOfRock& rock, const BareYear& bare);
    void find_meetings(const RowsOfRock& rock);
    /// `met`: what the rock met before the target. `end_m`: its place at the target, or where it ended.
    void credit(std::size_t target, std::span<const Meeting> met, std::int32_t rocks);
    void count_bands(std::size_t target, std::span<const Meeting> met, const rockfall::RockRecord& fall,
                     bool arrives);
    void count_patches(std::span<const Meeting> met, const Eigen::Vector2d& start_m,
                       const Eigen::Vector2d& end_m, bool arrives);
    void visit(std::size_t patch);
    void visit_between(const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m);
    [[nodiscard]] std::size_t patch_at(const Eigen::Vector2d& place_m) const;
    PlaceCounts& band(std::size_t target, std::size_t number);

    std::span<const rockfall::TargetDistance> distances_;
    const forest::PatchGrid& grid_;
    Eigen::Vector2d origin_m_;
    std::span<const rockfall::PlacedStem> stems_;
    StoppingPlaces places_;

    // Of the present rock.
    std::vector<Meeting> meetings_;
    std::vector<std::size_t> bands_met_;
    std::vector<std::uint32_t> visited_;
    std::vector<std::uint64_t> visit_of_patch_;  ///< number of the rock and target that came there last
    std::uint64_t visit_ = 0;
};

}  // namespace coupling::exchange
