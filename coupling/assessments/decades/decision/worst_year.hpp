#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace coupling::decades {

/// Fewer replicates do not show their spread [choice].
inline constexpr std::size_t least_replicates_of_courses = 6;

/// The probability that a forest keeps a threshold in its worst year, as far as replicates tell it: values
/// that are equally likely.
///
/// The replicates whose lowest year keeps the threshold are counted, and the count says how sure the
/// probability is. Behind the noise of the rocks a replicate keeps it in some draws of its course
/// (course_law.hpp) and not in others: it counts with the share of the draws of a group, since a count of
/// each draw alone would have the chance of the replicates in it twice. No law is taken for how forests
/// differ: events make their lowest years anything but normal.
class WorstYear {
public:
    /// Of the replicates that keep it in each group of draws, with parts of replicates. Requires a group,
    /// counts in [0, replicates].
    WorstYear(std::span<const double> kept, std::size_t replicates);
    /// The value below which a share of them lies.
    [[nodiscard]] double at(double share) const { return quantile(middles_, share); }
    [[nodiscard]] double median() const { return at(0.5); }
    /// The probability is below this with at most that chance, for the verdict *yes*.
    [[nodiscard]] double at_least(double chance) const { return quantile(lows_, chance); }
    /// The probability is above this with at most that chance, for the verdict *no*.
    [[nodiscard]] double at_most(double chance) const { return quantile(highs_, 1.0 - chance); }

private:
    static double quantile(const std::vector<double>& rising, double share);

    std::vector<double> middles_;  ///< by the count of replicates alone (Jeffreys); rising, as the others
    std::vector<double> lows_;     ///< on the sides on which a verdict does not err more often than it says
    std::vector<double> highs_;    ///< (Clopper & Pearson)
};

}  // namespace coupling::decades
