#include "coupling/assessments/decades/decision/course_law.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

namespace coupling::decades {
namespace {

/// Of a jump of the mean course in a year with a cut [percent^2]: any that is seen [choice].
constexpr double jump_variance = 200.0;
/// Steps of the mean course in a year [percent^2], each weighed by its likelihood.
constexpr std::array step_variances{1e-3, 1e-2, 4e-2, 0.16, 0.6, 2.5, 10.0};

DatedYears years_of(const CourseYears& course) {
    std::map<std::int32_t, std::pair<double, double>> sums;
    for (const auto& replicate : course.of_replicates) {
        for (const auto& [year, percent] : replicate) {
            sums[year].first += percent;
            sums[year].second += 1.0;
        }
    }
    DatedYears years;
    for (const auto& [year, sum] : sums) {
        const auto [total, count] = sum;
        const bool is_first = years.year.empty();
        const auto next_break =
            is_first ? course.breaks.end()
                     : std::upper_bound(course.breaks.begin(), course.breaks.end(), years.year.back());
        years.is_break.push_back(next_break != course.breaks.end() && *next_break <= year);
        years.gap.push_back(is_first ? 0.0 : year - years.year.back());
        years.year.push_back(year);
        years.mean.push_back(total / count);
        years.known.push_back(count);
    }
    for (std::size_t r = 0; r < course.of_replicates.size(); ++r) {
        const auto& replicate = course.of_replicates[r];
        if (replicate.empty()) {
            continue;
        }
        std::vector<bool> events(years.size());
        for (std::size_t i = 1; i < years.size() && r < course.events.size(); ++i) {
            events[i] = std::any_of(
                course.events[r].begin(), course.events[r].end(),
                [&](std::int32_t event) { return event > years.year[i - 1] && event <= years.year[i]; });
        }
        years.replicates.push_back(r);
        years.events.push_back(std::move(events));
        std::vector<double> noise;
        for (const std::int32_t year : years.year) {
            constexpr double least_variance = 1e-4;
            const bool is_known = r < course.rock_variances.size() && course.rock_variances[r].contains(year);
            noise.push_back(is_known ? std::max(least_variance, course.rock_variances[r].at(year))
                                     : least_variance);
        }
        years.noise.push_back(std::move(noise));
        std::vector<double> off(years.size(), std::nan(""));
        for (std::size_t i = 0; i < years.size(); ++i) {
            if (const auto found = replicate.find(years.year[i]); found != replicate.end()) {
                off[i] = found->second - years.mean[i];
            }
        }
        years.off.push_back(std::move(off));
    }
    return years;
}

/// Variances of the steps into each year, for one of the step variances.
std::vector<double> steps_of(const DatedYears& years, double step_variance) {
    std::vector<double> steps;
    for (std::size_t i = 0; i < years.size(); ++i) {
        steps.push_back(years.is_break[i] ? jump_variance : step_variance * years.gap[i]);
    }
    return steps;
}

std::vector<Moves> some_moves() {
    std::vector<Moves> all;
    for (const double step : {1e-3, 4e-2, 0.16, 0.6, 2.5, 10.0}) {
        all.push_back({step, 0.0, 0.0});
        for (const double fades : {0.3, 1.0, 3.0, 9.0, 27.0}) {
            for (const double rho : {0.3, 0.7, 0.9}) {
                all.push_back({step, fades, rho});
            }
        }
    }
    return all;
}

/// The deviations of all replicates under one law.
std::vector<DeviationFilter> filters_of(const DatedYears& years, const Moves& moves) {
    std::vector<DeviationFilter> filters;
    for (std::size_t r = 0; r < years.off.size(); ++r) {
        std::vector<bool> is_known;
        for (const double value : years.off[r]) {
            is_known.push_back(!std::isnan(value));
        }
        filters.emplace_back(is_known, years.noise[r], years.gap, years.events[r], moves);
    }
    return filters;
}

/// How likely each step variance is, from log likelihoods.
config::DiscreteDistribution by_likelihood(std::vector<double> log_likelihoods) {
    const double most = *std::max_element(log_likelihoods.begin(), log_likelihoods.end());
    for (double& each : log_likelihoods) {
        each = std::exp(each - most);
    }
    return config::DiscreteDistribution{log_likelihoods};
}

}  // namespace

CourseLaw::CourseLaw(const CourseYears& course) : years_{years_of(course)} {
    if (years_.size() == 0) {
        return;
    }
    std::vector<double> noise_of_mean(years_.size(), 0.0);
    for (std::size_t i = 0; i < years_.size(); ++i) {
        for (std::size_t r = 0; r < years_.off.size(); ++r) {
            noise_of_mean[i] +=
                std::isnan(years_.off[r][i]) ? 0.0 : years_.noise[r][i] / (years_.known[i] * years_.known[i]);
        }
    }
    std::vector<double> mean_likelihoods;
    for (const double step : step_variances) {
        mean_walks_.push_back(filtered(years_.mean, noise_of_mean, steps_of(years_, step), start_variance));
        mean_likelihoods.push_back(mean_walks_.back().log_likelihood);
    }
    std::vector<double> likelihoods;
    for (const Moves& moves : some_moves()) {
        filters_.push_back(filters_of(years_, moves));
        double sum = 0.0;
        for (std::size_t r = 0; r < years_.off.size(); ++r) {
            sum += filters_.back()[r].log_likelihood(years_.off[r]);
        }
        likelihoods.push_back(sum);
    }
    step_of_mean_ = by_likelihood(std::move(mean_likelihoods));
    moves_ = by_likelihood(std::move(likelihoods));
}

std::vector<std::vector<double>> CourseLaw::drawn(std::size_t draw) const {
    Numbers of_group{draw / draws_of_group + 1};
    Numbers numbers{draws + draw + 1};
    const std::vector<double> mean = decades::drawn(mean_walks_[step_of_mean_(of_group.uniform())], of_group);
    const std::vector<DeviationFilter>& deviations = filters_[moves_(of_group.uniform())];
    std::vector<std::vector<double>> courses;
    for (std::size_t r = 0; r < years_.off.size(); ++r) {
        std::vector<double> around = years_.off[r];
        for (std::size_t year = 0; year < years_.size(); ++year) {
            around[year] += years_.mean[year] - mean[year];
        }
        courses.push_back(deviations[r].drawn(around, numbers));
        for (std::size_t year = 0; year < years_.size(); ++year) {
            courses.back()[year] += mean[year];
        }
    }
    return courses;
}

}  // namespace coupling::decades
