#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "config/random/distributions.hpp"
#include "coupling/assessments/decades/decision/state_space.hpp"

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

/// Years of a course as arrays.
struct DatedYears {
    std::vector<std::int32_t> year;
    std::vector<double> gap;  ///< to the year before; 0 of the first
    std::vector<bool> is_break;
    std::vector<double> mean;
    std::vector<double> known;               ///< replicates
    std::vector<std::size_t> replicates;     ///< that know a year, rising
    std::vector<std::vector<double>> off;    ///< [replicate][year], from the mean; NaN: not known
    std::vector<std::vector<double>> noise;  ///< [replicate][year], variance of the rocks
    std::vector<std::vector<bool>> events;   ///< [replicate][year]: it may jump of its own

    [[nodiscard]] std::size_t size() const { return year.size(); }
};

/// The forest behind its rocks: courses of protection that what the rocks show allows.
///
/// The lowest of many years of which rocks show each with noise is lower than that of the forest, the more so
/// the fewer rocks fall. The two differ over the years: the noise of one year says nothing of the
/// next, while a forest stays what it is.
///
/// The course of a replicate is the mean course of all and a deviation of its own, behind the rocks, whose
/// variance is known. The mean course walks at random and may jump in `breaks`; a deviation has a part that
/// walks, free to jump in `events`, and one that fades (local level and autoregression; Durbin & Koopman
/// 2012, Time Series Analysis by State Space Methods, chapters 2 and 4). How far they walk and how fast they
/// fade is weighed by likelihood. Courses that what is known allows are drawn (backward sampling, Carter &
/// Kohn 1994, Biometrika 81:541).
class CourseLaw {
public:
    /// From so many draws come the figures of a decision. Those of a group share how courses move and the
    /// mean course, and each draws the deviations of its replicates.
    static constexpr std::size_t draws = 1000;
    static constexpr std::size_t draws_of_group = 8;
    static constexpr std::size_t groups = draws / draws_of_group;

    explicit CourseLaw(const CourseYears& course);
    /// That any replicate shows, rising.
    [[nodiscard]] std::span<const std::int32_t> years() const { return years_.year; }
    /// That show a year, rising.
    [[nodiscard]] std::span<const std::size_t> replicates() const { return years_.replicates; }
    /// Protection [percent] of each of `replicates` in each of `years`, as the draw of this number has it:
    /// the same number, the same courses.
    [[nodiscard]] std::vector<std::vector<double>> drawn(std::size_t draw) const;

private:
    static constexpr std::array one_choice{1.0};

    DatedYears years_;
    std::vector<Walk> mean_walks_;                       ///< by step
    std::vector<std::vector<DeviationFilter>> filters_;  ///< [moves][replicate]
    config::DiscreteDistribution step_of_mean_{one_choice};
    config::DiscreteDistribution moves_{one_choice};
};

}  // namespace coupling::decades
