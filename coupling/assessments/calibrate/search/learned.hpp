#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "coupling/assessments/calibrate/search/adjustment.hpp"
#include "coupling/assessments/calibrate/search/search.hpp"

namespace coupling::calibrate {

/// A parameter before and after.
struct Learned {
    ParameterDraws::Component component;
    double median = 1.0;  ///< factor after
    double low = 1.0;     ///< 5 % and 95 % of factors after
    double high = 1.0;
    double learned = 0.0;          ///< how much narrower its logarithm is than before [-]; below 0: wider
    double by_chance = 0.0;        ///< up to here `learned` cannot be distinguished from chance: Chance
    double wider_by_chance = 0.0;  ///< as much wider is chance, too
    std::string partner{};         ///< the parameter with which it trades off most
    double correlation = 0.0;      ///< with that one, of the logarithms

    /// Whether so much is learned in one of twenty cases at most where nothing is.
    [[nodiscard]] bool is_beyond_chance() const { return learned > by_chance; }
    [[nodiscard]] bool has_too_few_sets() const { return by_chance >= 1.0; }
};

/// Sets of equal weight that are worth as much: 1 / sum of squared weights.
double effective_sets(const std::vector<Member>& members);

/// What the variance of weighted values is where nothing was learned: `mean` of what it was before, scattered
/// as chi-square with so many degrees of freedom.
struct Chance {
    double degrees = 0.0;  ///< 0: too few sets
    double mean = 1.0;

    /// How much narrower values are in one of twenty cases or fewer; 1 where there are too few sets.
    [[nodiscard]] double narrower() const;
    /// How much wider; infinite where there are too few.
    [[nodiscard]] double wider() const;
};

/// Values and weights as they were before a regression, and what that followed of chance.
///
/// The variance of sum w (x-m)^2 is sum w^2 ((x-m)^2-v)^2. Weights fall with the square of a value where they
/// are what was known before over a wider density from which sets were drawn: the tails then count little,
/// and the sum scatters less than that of as many equal weights as 1 / sum w^2. Normal values count by w^2 as
/// normal ones with another variance, t v; so this is v^2 (3 t^2 - 2 t + 1) sum w^2, with t = sum w^2 (x-m)^2
/// / (v sum w^2), which scatters less than fourth powers do. With equal weights t is 1, and chi-square exact.
/// All in units of v: a narrow sample has the level of one of which nothing is known.
///
/// A regression takes sum w^2 x'N^-1 x (Adjustment::followed) of the degrees. It follows a value where
/// weights are large by (x-m)^2/v as much, but all are widened alike: the mean.
Chance chance_of(const std::vector<double>& values, const std::vector<double>& weights,
                 const Adjustment& adjustment);

/// What sets that were kept say of each parameter, and how they came to lie where they do.
std::vector<Learned> learned_of(const Space& space, const std::vector<Member>& members,
                                const Adjustment& adjustment);

}  // namespace coupling::calibrate
