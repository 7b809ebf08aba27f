#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "coupling/assessments/calibrate/search/search.hpp"

namespace coupling::calibrate {

/// A parameter before and after.
struct Learned {
    ParameterDraws::Component component;
    double median = 1.0;  ///< factor after
    double low = 1.0;     ///< 5 % and 95 % of factors after
    double high = 1.0;
    double learned = 0.0;      ///< how much narrower its logarithm is than before [-]; below 0: wider
    double by_chance = 0.0;    ///< up to here `learned` cannot be told from nothing: learned_by_chance()
    std::string partner{};     ///< the parameter with which it trades off most
    double correlation = 0.0;  ///< with that one, of the logarithms

    /// Whether so much is learned in one of twenty cases at most where nothing is.
    [[nodiscard]] bool is_beyond_chance() const { return learned > by_chance; }
};

/// Sets of equal weight that are worth as much: 1 / sum of squared weights.
double effective_sets(const std::vector<Member>& members);

/// How much narrower than before a sample of so many sets is by chance, in one of twenty cases, where nothing
/// was learned: by the chi-square distribution of a sample variance. A regression by `figures` figures takes
/// as many degrees of freedom, at most half of them. 1 of fewer than two sets.
double learned_by_chance(double effective_sets, std::size_t figures);

/// What sets that were kept say of each parameter. `figures`: by which they were moved to what was observed.
std::vector<Learned> learned_of(const Space& space, const std::vector<Member>& members, std::size_t figures);

}  // namespace coupling::calibrate
