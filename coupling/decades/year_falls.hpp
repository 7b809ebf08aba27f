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

/// Ends a run from within.
struct Interrupted {};

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

/// The rocks of one year.
struct FallsOfYear {
    rockfall::EnsembleTally tally{config::GridFrame{}, 0, 0};
    std::vector<StemTake> takes;  ///< of stems that were hit
    std::vector<RockHit> hits;    ///< in the order of rocks
    bool with_forest = false;     ///< false: no stem stood on the slope
};

/// Lets the rocks of a year fall: over the slope with the forest as it stands, and the same rocks over the
/// bare slope. Made once for a run; shared by its members and their threads.
class RockSeason {
public:
    /// Refers to scenario and site as long as it lives. `fracture_energy`: by species of the forest, relative
    /// to fir. `standing`: stems that do not grow, in absolute coordinates.
    RockSeason(const Scenario& scenario, const Site& site, std::vector<double> fracture_energy,
               std::vector<rockfall::Stem> standing);

    /// Random numbers are keyed by replicate and year: all regimes see the same rocks. The result does not
    /// depend on the number of threads. Throws Interrupted.
    [[nodiscard]] FallsOfYear fall(const forest::Stand& stand, std::uint32_t replicate, std::int32_t year,
                                   int threads) const;

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
    std::uint64_t rocks_;
};

/// Writes the figures of a year's rocks down.
void record_falls(const FallsOfYear& falls, std::int32_t year, MemberYears& kept);
/// What they left in the cells of the map.
void record_cells(const FallsOfYear& falls, std::int32_t year, MemberYears& kept);

}  // namespace coupling::decades
