#include "coupling/assessments/decades/decision/worst_year.hpp"

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "config/random/distributions.hpp"
#include "config/random/quantiles.hpp"
#include "config/random/stream.hpp"

namespace coupling::decades {
namespace {

constexpr std::size_t draws = 1000;
/// Of a course before its first year with rocks [percent^2]: nothing is known.
constexpr double start_variance = 1e4;
/// Of a jump of the mean course in a year with a cut, and of a replicate with an event [percent^2]: any that
/// is seen [choice].
constexpr double jump_variance = 200.0;
constexpr double event_variance = 100.0;
/// Steps of the mean course in a year [percent^2], each weighed by its likelihood.
constexpr std::array step_variances{1e-3, 1e-2, 4e-2, 0.16, 0.6, 2.5, 10.0};

/// Years as arrays.
struct Years {
    std::vector<std::int32_t> year;
    std::vector<double> gap;  ///< to the year before; 0 of the first
    std::vector<bool> is_break;
    std::vector<double> mean;
    std::vector<double> known;               ///< replicates
    std::vector<std::vector<double>> off;    ///< [replicate][year], from the mean; NaN: not known
    std::vector<std::vector<double>> noise;  ///< [replicate][year], variance of the rocks
    std::vector<std::vector<bool>> events;   ///< [replicate][year]: it may jump of its own

    [[nodiscard]] std::size_t size() const { return year.size(); }
};

Years years_of(const CourseYears& course) {
    std::map<std::int32_t, std::pair<double, double>> sums;
    for (const auto& replicate : course.of_replicates) {
        for (const auto& [year, percent] : replicate) {
            sums[year].first += percent;
            sums[year].second += 1.0;
        }
    }
    Years years;
    for (const auto& [year, sum] : sums) {
        const auto [total, count] = sum;
        if (count < 2.0) {
            continue;
        }
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

/// A course that walks at random behind noise, filtered forwards.
struct Walk {
    double log_likelihood = 0.0;
    std::vector<double> level, level_variance, predicted_variance;
};

/// Variances of the steps into each year, for one of the step variances.
std::vector<double> steps_of(const Years& years, double step_variance, bool may_jump) {
    std::vector<double> steps;
    for (std::size_t i = 0; i < years.size(); ++i) {
        steps.push_back(may_jump && years.is_break[i] ? jump_variance : step_variance * years.gap[i]);
    }
    return steps;
}

/// `values`: NaN where none is known. `start`: variance of the course around 0 before anything is known.
Walk filtered(const std::vector<double>& values, const std::vector<double>& noise,
              const std::vector<double>& steps, double start) {
    Walk walk;
    double level = 0.0;
    double variance = start;
    for (std::size_t i = 0; i < values.size(); ++i) {
        variance += steps[i];
        walk.predicted_variance.push_back(variance);
        if (!std::isnan(values[i])) {
            const double sum = variance + noise[i];
            const double error = values[i] - level;
            walk.log_likelihood -= 0.5 * (std::log(sum) + error * error / sum);
            level += variance / sum * error;
            variance *= noise[i] / sum;
        }
        walk.level.push_back(level);
        walk.level_variance.push_back(variance);
    }
    return walk;
}

/// Uniform and standard normal numbers, one after the other.
class Numbers {
public:
    explicit Numbers(std::uint64_t id) : stream_{{0, 0, 0, id}, config::Purpose::parameter} {}
    double normal() { return config::normal(uniform(), 0.0, 1.0); }
    double uniform() { return stream_.uniform(); }

private:
    config::RandomStream stream_;
};

/// A course that what is known allows: backward sampling.
std::vector<double> drawn(const Walk& walk, Numbers& numbers) {
    std::vector<double> level(walk.level.size());
    level.back() = walk.level.back() + std::sqrt(walk.level_variance.back()) * numbers.normal();
    for (std::size_t i = level.size() - 1; i-- > 0;) {
        const double share = walk.predicted_variance[i + 1] > 0.0
                                 ? walk.level_variance[i] / walk.predicted_variance[i + 1]
                                 : 0.0;
        level[i] = walk.level[i] + share * (level[i + 1] - walk.level[i]) +
                   std::sqrt(std::max(0.0, walk.level_variance[i] * (1.0 - share))) * numbers.normal();
    }
    return level;
}

/// How the deviation of a replicate from the mean course moves: a part that walks, and one that fades.
struct Moves {
    double step_variance = 0.0;  ///< of the walk, in a year
    double fades = 0.0;          ///< variance of the part that fades
    double rho = 0.0;            ///< its correlation a year
};

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

/// Both parts of a deviation behind the noise of the rocks: what a Kalman filter and backward sampling need
/// beside the values themselves, worked out once.
class DeviationFilter {
public:
    /// `is_known`: whether a year has a value. `events`: years in which the part that walks may jump.
    DeviationFilter(const std::vector<bool>& is_known, const std::vector<double>& noise,
                    const std::vector<double>& gaps, const std::vector<bool>& events, const Moves& moves) {
        Eigen::Matrix2d covariance = Eigen::Vector2d{start_variance, moves.fades}.asDiagonal();
        for (std::size_t i = 0; i < gaps.size(); ++i) {
            Step step;
            if (i > 0) {
                step.left = std::pow(moves.rho, gaps[i]);
                const Eigen::Matrix2d transition = Eigen::Vector2d{1.0, step.left}.asDiagonal();
                const Eigen::Matrix2d before = covariance;
                covariance = transition * covariance * transition;
                covariance(0, 0) += events[i] ? event_variance : moves.step_variance * gaps[i];
                covariance(1, 1) += moves.fades * (1.0 - step.left * step.left);
                Eigen::Matrix2d predicted = covariance;
                predicted.diagonal().array() += 1e-9;  // the part that fades may be nothing
                steps_.back().back = before * transition * predicted.inverse();
                const Eigen::Matrix2d rest = before - steps_.back().back * transition * before;
                steps_.back().scatter = factor_of(rest);
            }
            step.is_known = is_known[i];
            if (step.is_known) {
                const Eigen::Vector2d with =
                    covariance.rowwise().sum();  // with what is seen: the sum of both
                step.variance = with.sum() + noise[i];
                step.gain = with / step.variance;
                covariance -= with * with.transpose() / step.variance;
            }
            steps_.push_back(step);
        }
        steps_.back().scatter = factor_of(covariance);
    }

    [[nodiscard]] double log_likelihood(const std::vector<double>& values) const {
        double sum = 0.0;
        Eigen::Vector2d state = Eigen::Vector2d::Zero();
        for (std::size_t i = 0; i < steps_.size(); ++i) {
            const Step& step = steps_[i];
            state.y() *= i > 0 ? step.left : 1.0;
            if (step.is_known) {
                const double error = values[i] - state.sum();
                sum -= 0.5 * (std::log(step.variance) + error * error / step.variance);
                state += step.gain * error;
            }
        }
        return sum;
    }
    /// A deviation that the values allow.
    [[nodiscard]] std::vector<double> drawn(const std::vector<double>& values, Numbers& numbers) const {
        std::vector<Eigen::Vector2d> states;
        Eigen::Vector2d state = Eigen::Vector2d::Zero();
        for (std::size_t i = 0; i < steps_.size(); ++i) {
            const Step& step = steps_[i];
            state.y() *= i > 0 ? step.left : 1.0;
            if (step.is_known) {
                state += step.gain * (values[i] - state.sum());
            }
            states.push_back(state);
        }
        std::vector<double> sums(steps_.size());
        for (std::size_t i = steps_.size(); i-- > 0;) {
            const Step& step = steps_[i];
            if (i + 1 < steps_.size()) {
                const Eigen::Vector2d ahead{states[i].x(), steps_[i + 1].left * states[i].y()};
                states[i] += step.back * (state - ahead);
            }
            state = states[i] + step.scatter * Eigen::Vector2d{numbers.normal(), numbers.normal()};
            sums[i] = state.sum();
        }
        return sums;
    }

private:
    struct Step {
        double left = 1.0;  ///< of the part that fades, since the year before
        bool is_known = false;
        double variance = 1.0;  ///< of what is seen, before it is seen
        Eigen::Vector2d gain = Eigen::Vector2d::Zero();
        Eigen::Matrix2d back = Eigen::Matrix2d::Zero();     ///< what the next year says of this one
        Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();  ///< a root of the covariance that is left then
    };
    /// Lower triangle; the covariance may be singular.
    static Eigen::Matrix2d factor_of(const Eigen::Matrix2d& covariance) {
        const double a = std::sqrt(std::max(0.0, covariance(0, 0)));
        const double b = a > 0.0 ? 0.5 * (covariance(1, 0) + covariance(0, 1)) / a : 0.0;
        Eigen::Matrix2d factor;
        factor << a, 0.0, b, std::sqrt(std::max(0.0, covariance(1, 1) - b * b));
        return factor;
    }

    std::vector<Step> steps_;
};

/// The deviations of all replicates under one law.
std::vector<DeviationFilter> filters_of(const Years& years, const Moves& moves) {
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

/// What so many of so many replicates tell: a draw of Beta(k + 1/2, n - k + 1/2) (Jeffreys 1946), and with
/// the same numbers of Beta(k, n - k + 1) and Beta(k + 1, n - k), whose quantiles are the exact bounds
/// (Clopper & Pearson 1934).
WorstYear::Value probability_of(std::size_t kept, std::size_t replicates, Numbers& numbers) {
    const double of_yes = numbers.uniform();
    const double of_no = numbers.uniform();
    const auto beta = [&](double a, double b) {
        if (a == 0.0 || b == 0.0) {
            return a == 0.0 ? 0.0 : 1.0;
        }
        const double yes = config::gamma_quantile(a, of_yes);
        return yes / (yes + config::gamma_quantile(b, of_no));
    };
    const auto k = static_cast<double>(kept);
    const auto rest = static_cast<double>(replicates - kept);
    return {beta(k + 0.5, rest + 0.5), beta(k, rest + 1.0), beta(k + 1.0, rest)};
}

}  // namespace

WorstYear::WorstYear(const std::vector<Value>& values) {
    for (const Value& value : values) {
        middles_.push_back(value.middle);
        lows_.push_back(value.low);
        highs_.push_back(value.high);
    }
    for (std::vector<double>* list : {&middles_, &lows_, &highs_}) {
        std::sort(list->begin(), list->end());
    }
}

double WorstYear::quantile(const std::vector<double>& rising, double share) {
    const double place = share * static_cast<double>(rising.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, rising.size() - 1);
    return rising[below] + (place - static_cast<double>(below)) * (rising[above] - rising[below]);
}

std::optional<WorstYear> worst_year(const CourseYears& course, double at_least_percent) {
    const Years years = years_of(course);
    if (years.size() == 0 || years.off.size() < least_replicates_of_courses) {
        return std::nullopt;
    }
    std::vector<double> noise_of_mean(years.size(), 0.0);
    for (std::size_t i = 0; i < years.size(); ++i) {
        for (std::size_t r = 0; r < years.off.size(); ++r) {
            noise_of_mean[i] +=
                std::isnan(years.off[r][i]) ? 0.0 : years.noise[r][i] / (years.known[i] * years.known[i]);
        }
    }
    std::vector<Walk> mean_walks;
    std::vector<double> mean_likelihoods;
    for (const double step : step_variances) {
        mean_walks.push_back(
            filtered(years.mean, noise_of_mean, steps_of(years, step, true), start_variance));
        mean_likelihoods.push_back(mean_walks.back().log_likelihood);
    }
    std::vector<std::vector<DeviationFilter>> filters;  ///< [law][replicate]
    std::vector<double> likelihoods;
    for (const Moves& moves : some_moves()) {
        filters.push_back(filters_of(years, moves));
        double sum = 0.0;
        for (std::size_t r = 0; r < years.off.size(); ++r) {
            sum += filters.back()[r].log_likelihood(years.off[r]);
        }
        likelihoods.push_back(sum);
    }
    const config::DiscreteDistribution step_of_mean = by_likelihood(std::move(mean_likelihoods));
    const config::DiscreteDistribution law_of_replicates = by_likelihood(std::move(likelihoods));
    std::vector<WorstYear::Value> values;
    for (std::size_t i = 0; i < draws; ++i) {
        Numbers numbers{i + 1};
        const std::vector<double> mean = drawn(mean_walks[step_of_mean(numbers.uniform())], numbers);
        const std::vector<DeviationFilter>& law = filters[law_of_replicates(numbers.uniform())];
        std::size_t kept = 0;
        for (std::size_t r = 0; r < years.off.size(); ++r) {
            std::vector<double> around = years.off[r];
            for (std::size_t year = 0; year < years.size(); ++year) {
                around[year] += years.mean[year] - mean[year];
            }
            const std::vector<double> own = law[r].drawn(around, numbers);
            bool keeps = true;
            for (std::size_t year = 0; keeps && year < years.size(); ++year) {
                keeps = mean[year] + own[year] >= at_least_percent;
            }
            kept += keeps ? 1 : 0;
        }
        values.push_back(probability_of(kept, years.off.size(), numbers));
    }
    return WorstYear{values};
}

}  // namespace coupling::decades
