#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "coupling/assessments/decades/members/records.hpp"
#include "coupling/assessments/decades/tables/comparison.hpp"

namespace coupling::decades {

/// The variance that the rocks alone leave to the protection of a year in one replicate [percent^2], by year:
/// mean over the replicates of a course. Years whose interval is not known are missing.
std::map<std::int32_t, double> rock_variances(const Names& names, std::span<const MemberYears> members,
                                              std::size_t course, std::uint32_t target);

/// Values of several replicates without noise of a known variance: drawn towards their mean so far that their
/// variance is what is left of it (constrained empirical Bayes, Louis 1984, J. Am. Stat. Assoc. 79:393). So
/// extremes over years are those of the forest and not those of its rocks. The mean stays. One value stays
/// as it is.
void take_noise_out(std::span<double> values, double noise_variance);

/// Protection of the replicates of a course, year by year, without the noise of the rocks.
std::vector<std::map<std::int32_t, double>> without_rock_noise(
    std::vector<std::map<std::int32_t, double>> of_replicates,
    const std::map<std::int32_t, double>& variances);

}  // namespace coupling::decades
