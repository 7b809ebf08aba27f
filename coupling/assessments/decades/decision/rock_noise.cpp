#include "coupling/assessments/decades/decision/rock_noise.hpp"

#include <algorithm>
#include <cmath>

namespace coupling::decades {

std::map<std::int32_t, double> rock_variances(const Names& names, std::span<const MemberYears> members,
                                              std::size_t course, std::uint32_t target) {
    /// A 95 % interval reaches so many deviations to each side.
    constexpr double deviations = 1.96;
    std::map<std::int32_t, double> sums;
    std::map<std::int32_t, double> counts;
    for (const MemberYears& member : members) {
        if (names.course_of(member.member) != course) {
            continue;
        }
        for (const TargetRow& row : member.targets) {
            const auto effect = row.target == target ? protection_effect(row.paired) : std::nullopt;
            if (effect && effect->interval.low <= effect->interval.high) {
                const double half_percent = 50.0 * (effect->interval.high - effect->interval.low);
                sums[row.year] += half_percent * half_percent / (deviations * deviations);
                counts[row.year] += 1.0;
            }
        }
    }
    for (auto& [year, sum] : sums) {
        sum /= counts[year];
    }
    return sums;
}

void take_noise_out(std::span<double> values, double noise_variance) {
    if (values.size() < 2 || !(noise_variance > 0.0)) {
        return;
    }
    double mean = 0.0;
    for (const double value : values) {
        mean += value / static_cast<double>(values.size());
    }
    double variance = 0.0;
    for (const double value : values) {
        variance += (value - mean) * (value - mean) / static_cast<double>(values.size() - 1);
    }
    if (!(variance > 0.0)) {
        return;
    }
    const double left = std::sqrt(std::max(0.0, variance - noise_variance) / variance);
    for (double& value : values) {
        value = mean + left * (value - mean);
    }
}

std::vector<std::map<std::int32_t, double>> without_rock_noise(
    std::vector<std::map<std::int32_t, double>> of_replicates,
    const std::map<std::int32_t, double>& variances) {
    for (const auto& [year, variance] : variances) {
        std::vector<double> values;
        for (const auto& replicate : of_replicates) {
            if (const auto found = replicate.find(year); found != replicate.end()) {
                values.push_back(found->second);
            }
        }
        take_noise_out(values, variance);
        auto next = values.begin();
        for (auto& replicate : of_replicates) {
            if (const auto found = replicate.find(year); found != replicate.end()) {
                found->second = *next++;
            }
        }
    }
    return of_replicates;
}

}  // namespace coupling::decades
