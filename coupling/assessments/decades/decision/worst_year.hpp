#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace coupling::decades {

/// Protection of a course at a target, as its replicates show it.
struct CourseYears {
    /// Of years with rocks after the start [percent], by replicate.
    std::vector<std::map<std::int32_t, double>> of_replicates;
    /// That the rocks alone leave to a year of a replicate [percent^2]; a year without: none.
    std::vector<std::map<std::int32_t, double>> rock_variances;
    /// Years with rocks in which the course may jump: the first ones after a cut, rising.
    std::vector<std::int32_t> breaks;
    /// Years in which a replicate lost stems to an event of its own, by replicate; none: no such years.
    std::vector<std::vector<std::int32_t>> events{};
};

/// The probability that a forest keeps a threshold in its worst year, as far as replicates tell it: values
/// that are equally likely.
class WorstYear {
public:
    struct Value {
        double middle;  ///< by the count of replicates alone (Jeffreys)
        double low;     ///< on the sides on which a verdict does not err more often than it says
        double high;    ///< (Clopper & Pearson)
    };
    explicit WorstYear(const std::vector<Value>& values);
    /// The value below which a share of them lies.
    [[nodiscard]] double at(double share) const { return quantile(middles_, share); }
    [[nodiscard]] double median() const { return at(0.5); }
    /// The probability is below this with at most that chance, for the verdict *yes*.
    [[nodiscard]] double at_least(double chance) const { return quantile(lows_, chance); }
    /// The probability is above this with at most that chance, for the verdict *no*.
    [[nodiscard]] double at_most(double chance) const { return quantile(highs_, 1.0 - chance); }

private:
    static double quantile(const std::vector<double>& rising, double share);

    std::vector<double> middles_;  ///< rising, as the others
    std::vector<double> lows_;
    std::vector<double> highs_;
};

/// Fewer replicates do not show their spread [choice].
inline constexpr std::size_t least_replicates_of_courses = 6;

/// The lowest of many years of which rocks show each with noise is lower than that of the forest, the more so
/// the fewer rocks fall. So the forest is told from its rocks by what differs between them: rocks of one year
/// say nothing of the next, while a forest stays what it is.
///
/// The course of a replicate is the mean course of all and a deviation of its own, behind the rocks, whose
/// variance is known. The mean course walks at random and may jump in `breaks`; a deviation has a part that
/// walks, free to jump in `events`, and one that fades (local level and autoregression; Durbin & Koopman
/// 2012, Time Series Analysis by State Space Methods, chapters 2 and 4). How far they walk and how fast they
/// fade is weighed by likelihood. Courses that what is known allows are drawn (backward sampling, Carter &
/// Kohn 1994, Biometrika 81:541); in each draw the replicates whose lowest year keeps the threshold are
/// counted, and the count says how sure the probability is (Jeffreys). No law is taken for how forests
/// differ: events make their lowest years anything but normal.
///
/// Nothing with fewer replicates than least_replicates_of_courses. Draws are fixed: the same course has the
/// same answer.
std::optional<WorstYear> worst_year(const CourseYears& course, double at_least_percent);

}  // namespace coupling::decades
