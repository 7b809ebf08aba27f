#pragma once

#include <cstdint>
#include <vector>

#include "coupling/exchange/bare_year.hpp"
#include "coupling/exchange/impacts.hpp"
#include "coupling/exchange/stopping_places.hpp"
#include "coupling/inputs/parameters/parameter_draws.hpp"
#include "coupling/inputs/site.hpp"
#include "coupling/results/figures/figures.hpp"
#include "forest/stand/stand.hpp"
#include "rockfall/ensemble.hpp"
#include "rockfall/tally/target_distance.hpp"

namespace coupling {
struct Scenario;
}

namespace coupling::exchange {

/// Paths that the view of a year shows.
inline constexpr std::uint64_t most_paths = 60;

/// Hits and energy that a living tree took from the rocks of a year.
struct TreeLoad {
    forest::TreeId tree{};
    rockfall::StemTally tally;
};

/// The rocks of one year.
struct YearFalls {
    rockfall::EnsembleTally tally{config::GridFrame{}, 0, 0};  ///< cells in chosen years only
    RocksAtTargets at_targets;                                 ///< through the forest
    RocksAtTargets at_targets_bare;                            ///< over the bare slope
    std::vector<TreeLoad> loads;                               ///< of stems that were hit
    std::vector<RockHit> hits;                                 ///< in the order of rocks
    std::vector<rockfall::PathRecord> paths;                   ///< of some rocks, if asked for
    std::vector<PairedCounts>
        living{};              ///< by target: the same rocks through the living trees alone, if asked for
    bool with_forest = false;  ///< false: no stem stood on the slope
    std::vector<bool> met_dead_wood{};  ///< by rock: a snag, a stump or a log was in its way
    /// By target, of the rocks that met no dead wood: among living trees alone they fall the same way.
    std::vector<PairedCounts> past_dead_wood{};
    StoppingPlaces stopping{};  ///< where the forest stops them
};

/// Simulates the rocks of a year over the bare slope, and the same rocks over the slope with the forest as it
/// stands. Made once for a run; shared by its members and their threads.
class YearlyRockfall {
public:
    /// Refers to scenario and site as long as it lives. `fracture_energy`: by species of the forest, relative
    /// to fir. `standing`: stems that do not grow, in absolute coordinates.
    YearlyRockfall(const Scenario& scenario, const Site& site, std::vector<double> fracture_energy,
                   std::vector<rockfall::Stem> standing);

    /// What is not known of a forest, as the replicate has it: drawn with what is not known of its falls.
    [[nodiscard]] forest::ForestFactors forest_of(std::uint32_t replicate) const;

    /// Random numbers are keyed by replicate and year: all regimes see the same rocks. The result does not
    /// depend on the number of threads. Throws Interrupted.
    [[nodiscard]] BareYear simulate_bare(std::uint32_t replicate, std::int32_t year, bool with_cells,
                                         int threads) const;
    /// The same rocks through the forest. `bare` is what simulate_bare gave for them; cells are counted where
    /// it has counted them. `with_paths`: some rocks keep their paths, at most most_paths and the same in all
    /// years. Throws Interrupted.
    [[nodiscard]] YearFalls simulate(const forest::Stand& stand, const BareYear& bare,
                                     std::uint32_t replicate, bool with_paths, int threads) const;

    /// The same rocks through the living trees alone: by target. `falls` is what simulate gave for them; only
    /// rocks that met dead wood there fall again. Throws Interrupted.
    [[nodiscard]] std::vector<PairedCounts> simulate_living(const forest::Stand& stand, const BareYear& bare,
                                                            const YearFalls& falls, std::uint32_t replicate,
                                                            int threads) const;

    /// Both, where nobody else needs the falls over the bare slope.
    [[nodiscard]] YearFalls simulate(const forest::Stand& stand, std::uint32_t replicate, std::int32_t year,
                                     bool with_paths, int threads) const {
        return simulate(stand, simulate_bare(replicate, year, true, threads), replicate, with_paths, threads);
    }

    [[nodiscard]] std::uint64_t rocks() const { return rocks_; }

private:
    /// Refers to the draws of the replicate.
    [[nodiscard]] rockfall::Assessment assessment(const rockfall::StemIndex& stems,
                                                  const ParameterDraws& draws, std::uint32_t replicate,
                                                  std::int32_t year, bool with_cells) const;

    const Scenario& scenario_;
    const Site& site_;
    config::GridFrame frame_;
    rockfall::StartLaw start_;
    std::vector<rockfall::Chunk> chunks_;
    std::vector<double> fracture_energy_;
    std::vector<rockfall::Stem> standing_;
    std::vector<rockfall::TargetDistance> distances_;  ///< by target
    rockfall::NetIndex nets_;
    std::uint64_t rocks_;
};

}  // namespace coupling::exchange
