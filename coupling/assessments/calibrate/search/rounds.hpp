#pragma once

#include <functional>
#include <vector>

#include "coupling/assessments/calibrate/search/search.hpp"

namespace coupling::calibrate {

/// What all kinds of searches do: the first round, the scale at the present sets, the end.
class Rounds {
public:
    Rounds(const Simulator& simulator, const SearchPlan& plan, SearchState& state,
           const std::function<void(const SearchState&)>& keep,
           const std::function<void(std::uint64_t)>& moved)
        : simulator_{simulator}, plan_{plan}, state_{state}, keep_{keep}, moved_{moved} {}

protected:
    /// Candidates between two states from which a search can go on.
    static constexpr std::uint64_t sets_at_once = 256;
    /// Below this share of kept sets a search is given up, once it has tried so many.
    static constexpr double least_kept = 0.005;
    static constexpr std::uint64_t tried_before_giving_up = 2'000;

    /// Sets that cover what the widths allow, as far as they have not fallen yet.
    void simulate_first();
    /// Of these the nearest one. No scale is known yet: each observation counts by its median among them.
    [[nodiscard]] const Point& nearest_of_first() const;
    /// The scale at a point, after a round that was added to the waves. Returns summaries of samples there.
    std::vector<std::vector<double>> rescale(const Point& centre);
    /// A set that shows nothing of what was seen is never near.
    [[nodiscard]] bool is_within(const std::vector<double>& distances, double tolerance) const;
    /// So many that their covariance means something.
    [[nodiscard]] std::size_t least_parents() const;
    /// Whether no round can follow, as waves have numbers up to most_waves.
    [[nodiscard]] bool is_last() const { return state_.waves.size() + 1 >= most_waves / 2; }
    /// Ends the search with what it has.
    void end(SearchEnd end);

    const Simulator& simulator_;
    const SearchPlan& plan_;
    SearchState& state_;
    const std::function<void(const SearchState&)>& keep_;
    const std::function<void(std::uint64_t)>& moved_;

private:
    [[nodiscard]] std::vector<Witnessed> witnessed() const;
};

}  // namespace coupling::calibrate
