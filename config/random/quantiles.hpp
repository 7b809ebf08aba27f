#pragma once

namespace config {

// Quantiles that statistics of results need, by Boost.Math in double precision alone: with its usual long
// double they would differ between processors, and tools that watch a program (valgrind) know none.

/// Quantile of Student's t distribution.
double students_t_quantile(double degrees_of_freedom, double share_below);

/// One-sided bounds of Clopper and Pearson (1934) of a probability of which `hits` of `trials` were seen:
/// below the least (above the greatest) one so many or more (or fewer) hits have at most this chance. 0
/// without a hit, 1 with nothing but hits.
double least_probability(double trials, double hits, double chance);
double greatest_probability(double trials, double hits, double chance);

/// Chance that at most so many of some trials hit; with `most` below 0 it is none.
double chance_of_at_most(double most, double trials, double probability);
/// Chance that more do, without the rounding of 1 - chance_of_at_most.
double chance_of_more_than(double most, double trials, double probability);
/// A count near the one below which a share of the draws lies, never above it.
double binomial_count(double trials, double probability, double share_below);

/// Of a sample of a normal distribution: so many deviations below its mean lies a bound that a share of the
/// distribution exceeds, but for this chance of being wrong (one-sided tolerance limit; Wald & Wolfowitz
/// 1946, exact by the noncentral t distribution). Requires at least two values, share and chance in (0, 1).
double tolerance_factor(double values, double share_above, double chance);

/// Quantile of the gamma distribution with scale 1.
double gamma_quantile(double shape, double share_below);

}  // namespace config
