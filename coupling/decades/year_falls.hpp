#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "coupling/decades/records.hpp"
#include "coupling/inputs/scenario.hpp"
#include "coupling/inputs/site.hpp"
#include "forest/stand.hpp"
#include "forest/wounds.hpp"
#include "rockfall/ensemble.hpp"

namespace coupling::decades {

/// Thinner trees are no obstacles: rocks bend them [choice; Rockyfor3D takes the same limit].
inline constexpr double least_obstacle_cm = 5.0;

/// Paths that the view of a year shows.
inline constexpr std::uint64_t most_paths = 60;

/// Ends a run from within.
struct Interrupted {};

/// Length of a log on the map: it lies along the ground of its patch.
double plan_length_m(const forest::Log& log, const forest::PatchGrid& grid);

/// What a stem took from the rocks of a year.
struct StemTake {
    forest::TreeId tree{};
    rockfall::StemTally tally;
};

/// A rock that met a tree, as the forest wants to know it, with the number of the rock.
struct RockHit {
    std::uint64_t rock = 0;
    forest::Impact impact;
};

/// The rocks of a year over the bare slope: the same for all regimes.
struct BareYear {
    std::int32_t year = 0;
    rockfall::RunTally run;
    std::vector<rockfall::ArrivalTally> targets;
    std::vector<rockfall::CellSums> cells;  ///< in chosen years only
    /// Which rocks arrived: a bit for each rock and target, targets of a rock side by side.
    std::vector<std::uint64_t> arrived;

    [[nodiscard]] bool has_arrived(std::uint64_t rock, std::size_t target) const {
        const std::uint64_t bit = rock * targets.size() + target;
        return (arrived[bit / 64] >> (bit % 64) & 1U) != 0;
    }
    void mark_arrived(std::uint64_t rock, std::size_t target) {
        const std::uint64_t bit = rock * targets.size() + target;
        arrived[bit / 64] |= std::uint64_t{1} << (bit % 64);
    }
};

/// The rocks of one year.
struct FallsOfYear {
    rockfall::EnsembleTally tally{config::GridFrame{}, 0, 0};  ///< bare cells in chosen years only
    std::vector<StemTake> takes;                               ///< of stems that were hit
    std::vector<RockHit> hits;                                 ///< in the order of rocks
    std::vector<rockfall::PathRecord> paths;                   ///< of some rocks, if asked for
    bool with_forest = false;                                  ///< false: no stem stood on the slope
};

/// Lets the rocks of a year fall over the bare slope, and the same rocks over the slope with the forest as it
/// stands. Made once for a run; shared by its members and their threads.
class RockSeason {
public:
    /// Refers to scenario and site as long as it lives. `fracture_energy`: by species of the forest, relative
    /// to fir. `standing`: stems that do not grow, in absolute coordinates.
    RockSeason(const Scenario& scenario, const Site& site, std::vector<double> fracture_energy,
               std::vector<rockfall::Stem> standing);

    /// Random numbers are keyed by replicate and year: all regimes see the same rocks. The result does not
    /// depend on the number of threads. Throws Interrupted.
    [[nodiscard]] BareYear fall_bare(std::uint32_t replicate, std::int32_t year, bool with_cells,
                                     int threads) const;
    /// The same rocks through the forest. `bare` is what fall_bare gave for them. `with_paths`: some rocks
    /// keep their paths, at most most_paths and the same in all years.
    [[nodiscard]] FallsOfYear fall(const forest::Stand& stand, const BareYear& bare, std::uint32_t replicate,
                                   bool with_paths, int threads) const;

    /// Both, where nobody else wants what falls over the bare slope.
    [[nodiscard]] FallsOfYear fall(const forest::Stand& stand, std::uint32_t replicate, std::int32_t year,
                                   bool with_paths, int threads) const {
        return fall(stand, fall_bare(replicate, year, true, threads), replicate, with_paths, threads);
    }

    [[nodiscard]] std::uint64_t rocks() const { return rocks_; }

private:
    /// What rocks meet in a year, and whose it is.
    struct Obstacles {
        std::vector<rockfall::Stem> stems;
        std::vector<const forest::Tree*> trees;  ///< one a stem; nullptr: none that lives here
        std::vector<rockfall::Log> logs;
    };
    /// Living trees, snags and stumps, stems that do not grow; logs.
    [[nodiscard]] Obstacles obstacles_of(const forest::Stand& stand) const;
    [[nodiscard]] rockfall::Assessment assessment(const rockfall::StemIndex& stems, std::uint32_t replicate,
                                                  std::int32_t year) const;
    [[nodiscard]] double fracture_energy(forest::SpeciesId species) const {
        return fracture_energy_[forest::index_of(species)];
    }

    const Scenario& scenario_;
    const Site& site_;
    config::GridFrame frame_;
    rockfall::StartLaw start_;
    std::vector<rockfall::Chunk> chunks_;
    std::vector<double> fracture_energy_;
    std::vector<rockfall::Stem> standing_;
    rockfall::NetIndex nets_;
    std::uint64_t rocks_;
};

/// Writes the figures of a year's rocks down.
void record_falls(const FallsOfYear& falls, std::int32_t year, MemberYears& kept);
/// What they left in the cells of the map.
void record_cells(const FallsOfYear& falls, std::int32_t year, MemberYears& kept);
void record_paths(const FallsOfYear& falls, std::int32_t year, MemberYears& kept);

}  // namespace coupling::decades
