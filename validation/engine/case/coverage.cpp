#include "validation/engine/case/coverage.hpp"

#include <algorithm>
#include <cmath>

#include "config/text/joined.hpp"
#include "coupling/inputs/parameters/parameter_draws.hpp"

namespace coupling::validation {
namespace {

constexpr double normal_quantile_95 = 1.6448536269514722;

/// Variance (n - 1) of a figure over the draws in which rocks give it; 0 of fewer than two.
double variance_over(std::span<const std::map<std::string, double>> draws, const std::string& quantity) {
    double count = 0.0;
    double mean = 0.0;
    double squares = 0.0;
    for (const auto& values : draws) {
        const auto found = values.find(quantity);
        if (found != values.end() && std::isfinite(found->second)) {
            count += 1.0;
            const double off = found->second - mean;
            mean += off / count;
            squares += off * (found->second - mean);
        }
    }
    return count > 1.0 ? squares / (count - 1.0) : 0.0;
}

}  // namespace

std::vector<rockfall::FallDraw> draws_for(const rockfall::FallLaw& law,
                                          const std::vector<rockfall::SurfaceType>& types,
                                          std::uint64_t seed) {
    constexpr std::uint64_t rocks = 16 * coverage_draws;
    return draw_parameters({shipped_parameter_widths()}, {types, std::vector<bool>(types.size(), true), true},
                           law, seed, rocks)
        .falls;
}

std::vector<Coverage> coverage_of(const std::vector<VerdictRow>& rows,
                                  const std::map<std::string, double>& deviations,
                                  std::span<const std::map<std::string, double>> draws) {
    std::vector<Coverage> coverage;
    for (const VerdictRow& row : rows) {
        const auto deviation = deviations.find(row.quantity);
        const std::optional<double> known = row.observed ? row.observed : row.published;
        if (!known || deviation == deviations.end() || !std::isfinite(deviation->second) ||
            !std::isfinite(row.default_value.value)) {
            continue;
        }
        const double of_rocks = normal_quantile_95 * deviation->second;
        const double of_all = normal_quantile_95 * std::sqrt(deviation->second * deviation->second +
                                                             variance_over(draws, row.quantity));
        const double off = std::abs(*known - row.default_value.value);
        coverage.push_back({row.quantity, *known, row.observed.has_value(), row.default_value.value, of_rocks,
                            of_all, off <= of_rocks, off <= of_all});
    }
    return coverage;
}

std::string in_words(const std::vector<Coverage>& coverage) {
    const auto count_of = [&](const auto& which) {
        return std::to_string(std::count_if(coverage.begin(), coverage.end(), which));
    };
    return config::joined(
        count_of([](const Coverage& one) { return one.in_rocks; }), " of ", std::to_string(coverage.size()),
        " known figures (", count_of([](const Coverage& one) { return one.observed; }),
        " observed, the others published) inside 90 % of rocks alone, ",
        count_of([](const Coverage& one) { return one.in_all; }), " inside 90 % of all that is not known");
}

}  // namespace coupling::validation
