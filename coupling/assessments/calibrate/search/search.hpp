#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "coupling/assessments/calibrate/search/ruling.hpp"
#include "coupling/assessments/calibrate/search/self_distance.hpp"
#include "coupling/assessments/calibrate/search/simulator.hpp"

namespace coupling::calibrate {

/// A parameter set that was tried and kept.
struct Member {
    Point point;
    double weight = 0.0;              ///< sums to 1 over a wave
    std::vector<double> distances{};  ///< to each observation
    std::vector<double> summary{};    ///< Shown::summary
    std::vector<double> figures{};    ///< of the first wave alone: Shown::figures
};

/// One round of the search.
struct Wave {
    double tolerance = 0.0;  ///< distance together up to which sets were kept; infinite in the first
    double goal = 0.0;       ///< SelfDistance::at_90 while it went on
    std::uint64_t tried = 0;
    std::uint64_t kept = 0;
};

/// Why a search ended.
enum class SearchEnd : std::uint8_t {
    close,     ///< sets are as near to what was observed as the model is to itself
    few_kept,  ///< too few sets would come nearer
    budget,    ///< calibrate.most_sets
    few_sets,  ///< those within the next tolerance are too few for a covariance: more would be needed
};

/// A round of a search with emulators.
struct RuledRound {
    std::uint64_t sets = 0;     ///< that fall
    std::uint64_t not_run = 0;  ///< that were drawn before them and ruled out
    double checks = 0.0;        ///< share of its sets that are drawn from what is ruled out [-]
};

/// What a search with emulators has beside: all sets that fell, and what each round ruled out.
struct Ruled {
    std::vector<Member> fallen;      ///< in rounds behind the first, without weights
    std::vector<RuledRound> rounds;  ///< behind the first, with the one under way
    std::vector<Ruling> rulings;     ///< before each of them; all up to it count
    std::vector<double> scatter;     ///< of each figure of the summary: tolerated()
    std::uint64_t beyond = 0;        ///< of all sets that fell, those in the part that is ruled out now
    std::uint64_t beyond_kept = 0;   ///< of these, sets that are kept all the same
    double beyond_weight = 0.0;      ///< weight of these in the population [-]

    [[nodiscard]] std::uint64_t not_run() const;
};

/// A search as it stands: all that is needed to go on.
struct SearchState {
    std::vector<Wave> waves;         ///< finished ones
    std::vector<Member> first;       ///< the first wave, as far as it is, with figures
    std::vector<Member> population;  ///< of the last finished wave
    SelfDistance scale;
    Wave begun;                    ///< the wave under way; tried = 0: not begun
    std::vector<Member> accepted;  ///< by it so far, without weights
    bool is_done = false;
    SearchEnd end = SearchEnd::close;
    Ruled ruled{};  ///< of a search with emulators

    [[nodiscard]] std::uint64_t tried() const;
    /// The share of what the widths allow that no ruling rules out [-].
    [[nodiscard]] double left() const { return ruled.rulings.empty() ? 1.0 : ruled.rulings.back().left; }
};

/// How long, how many.
struct SearchPlan {
    std::uint64_t first_sets = 0;
    std::uint64_t sets = 0;
    std::uint64_t most_sets = 0;
    std::uint64_t rocks = 0;
    bool emulates = false;  ///< ruled_search
};

/// Approximate Bayesian computation with sequential Monte Carlo (Toni et al. 2009; Del Moral et al. 2012).
///
/// A first wave covers what the widths allow. Each further wave moves the sets of the one before by a normal
/// kernel of twice their covariance and keeps those within a tolerance that falls to the median of the wave
/// before. The distances of the observations count by what samples of the model itself show, at the mean of
/// the present sets; the search ends where the tolerance is what 90 % of such samples stay below: a nearer
/// set cannot be told from the truth. Candidates are judged in the order of their numbers, so that nothing
/// depends on threads. `keep` is called with each state from which the search can go on; `moved` with sets
/// done. Throws Interrupted.
void search(const Simulator& simulator, const SearchPlan& plan, SearchState& state,
            const std::function<void(const SearchState&)>& keep,
            const std::function<void(std::uint64_t sets)>& moved);

}  // namespace coupling::calibrate
