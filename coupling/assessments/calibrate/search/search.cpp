#include "coupling/assessments/calibrate/search/search.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "config/random/distributions.hpp"
#include "coupling/assessments/calibrate/model/random.hpp"
#include "coupling/assessments/calibrate/search/rounds.hpp"
#include "coupling/assessments/calibrate/search/ruled_search.hpp"
#include "coupling/inputs/observed/distribution.hpp"

namespace coupling::calibrate {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
/// The share of a wave that lies within the tolerance of the next.
constexpr double nearer_share = 0.5;
/// Of the first wave, which covers everything.
constexpr double nearer_share_of_first = 0.2;

class Waves : public Rounds {
public:
    using Rounds::Rounds;

    void run() {
        if (state_.waves.empty()) {
            first_wave();
        }
        while (!state_.is_done) {
            next_wave();
        }
    }

private:
    void first_wave() {
        simulate_first();
        const Point nearest = nearest_of_first();
        state_.population = state_.first;
        for (Member& member : state_.population) {
            member.figures.clear();
        }
        finish_wave({.tolerance = infinite, .goal = 0.0, .tried = plan_.first_sets, .kept = plan_.first_sets},
                    nearest);
    }

    /// A wave is through: the scale at the sets as they are now.
    void finish_wave(Wave wave, const Point& centre) {
        state_.waves.push_back(wave);
        rescale(centre);
        state_.begun = {};
        state_.accepted.clear();
        if ((std::isfinite(wave.goal) && wave.tolerance <= wave.goal) || is_last()) {
            state_.is_done = true;
            state_.end = wave.tolerance <= wave.goal ? SearchEnd::close : SearchEnd::few_kept;
        }
        keep_(state_);
    }

    [[nodiscard]] double next_tolerance() const {
        std::vector<double> together;
        for (const Member& member : state_.population) {
            if (const double distance = state_.scale.together(member.distances); std::isfinite(distance)) {
                together.push_back(distance);
            }
        }
        const double share = std::min(
            1.0, std::max(state_.waves.size() == 1 ? nearer_share_of_first : nearer_share,
                          static_cast<double>(least_parents()) / static_cast<double>(together.size() + 1)));
        const double of_wave =
            together.empty() ? infinite : observed::Distribution{std::move(together)}.quantile(share);
        return std::max(state_.scale.at_90, of_wave);
    }

    void next_wave() {
        if (!std::isfinite(state_.scale.at_90)) {  // the sets in the middle show nothing of something seen
            end(SearchEnd::few_kept);
            return;
        }
        const auto number = static_cast<std::uint16_t>(state_.waves.size());
        if (state_.begun.tried == 0) {
            state_.begun.tolerance = next_tolerance();
            state_.begun.goal = state_.scale.at_90;
        }
        const double tolerance = state_.begun.tolerance;
        std::vector<Point> parents;
        std::vector<double> weights;
        for (const Member& member : state_.population) {
            if (is_within(member.distances, tolerance)) {
                parents.push_back(member.point);
                weights.push_back(member.weight);
            }
        }
        if (parents.size() < least_parents()) {
            end(SearchEnd::few_sets);
            return;
        }
        const Eigen::MatrixXd kernel = kernel_of(parents, weights);
        while (state_.accepted.size() < plan_.sets) {
            if (gives_up()) {
                return;
            }
            try_sets(number, parents, weights, kernel, tolerance);
            if (state_.accepted.size() < plan_.sets) {
                keep_(state_);
            }
        }
        weigh(parents, weights, kernel);
        state_.population = std::move(state_.accepted);
        Wave wave = state_.begun;
        wave.kept = state_.population.size();
        std::vector<Point> points;
        std::vector<double> own_weights;
        for (const Member& member : state_.population) {
            points.push_back(member.point);
            own_weights.push_back(member.weight);
        }
        finish_wave(wave, cloud_of(points, own_weights).mean);
    }

    /// Ends the search with what the last finished wave has.
    bool gives_up() {
        const auto kept = static_cast<double>(state_.accepted.size());
        const bool few = state_.begun.tried >= tried_before_giving_up &&
                         kept < least_kept * static_cast<double>(state_.begun.tried);
        const bool spent = state_.tried() >= plan_.most_sets;
        if (!few && !spent) {
            return false;
        }
        state_.is_done = true;
        state_.end = few ? SearchEnd::few_kept : SearchEnd::budget;
        state_.begun.kept = state_.accepted.size();
        keep_(state_);
        return true;
    }

    /// Lower triangle of twice the covariance, a little wider so that it never collapses.
    [[nodiscard]] static Eigen::MatrixXd kernel_of(const std::vector<Point>& points,
                                                   const std::vector<double>& weights) {
        Eigen::MatrixXd covariance = 2.0 * cloud_of(points, weights).covariance;
        covariance.diagonal().array() += 1e-4;
        return covariance.llt().matrixL();
    }

    void try_sets(std::uint16_t number, const std::vector<Point>& parents, const std::vector<double>& weights,
                  const Eigen::MatrixXd& kernel, double tolerance) {
        const config::DiscreteDistribution parent{weights};
        const auto first = static_cast<std::uint32_t>(state_.begun.tried);
        const std::uint64_t count =
            std::min(sets_at_once, std::max<std::uint64_t>(1, plan_.most_sets - state_.tried()));
        std::vector<Point> points;
        for (std::uint64_t i = 0; i < count; ++i) {
            config::RandomStream stream = choices(simulator_.seed(), number, Choice::proposal, first + i);
            Point point;
            do {
                point = parents[parent(stream.uniform())];
                Point step(point.size());
                for (double& each : step) {
                    each = config::normal(stream.uniform(), 0.0, 1.0);
                }
                point += kernel * step;
            } while (!Space::holds(point));
            points.push_back(std::move(point));
        }
        simulator_.show(points, number, first, plan_.rocks, [&](std::size_t i, Shown& shown) {
            moved_(1);
            if (state_.accepted.size() == plan_.sets) {
                return;  // judged in the order of their numbers: the wave is full
            }
            ++state_.begun.tried;
            if (is_within(shown.distances, tolerance)) {
                state_.accepted.push_back({points[i], 0.0, shown.distances, shown.summary, {}});
            }
        });
    }

    /// Weights by what was known before over the density from which the sets were drawn.
    void weigh(const std::vector<Point>& parents, const std::vector<double>& weights,
               const Eigen::MatrixXd& kernel) {
        const double all = std::accumulate(weights.begin(), weights.end(), 0.0);
        double sum = 0.0;
        for (Member& member : state_.accepted) {
            double density = 0.0;
            for (std::size_t i = 0; i < parents.size(); ++i) {
                const Point off = kernel.triangularView<Eigen::Lower>().solve(member.point - parents[i]);
                density += weights[i] / all * std::exp(-0.5 * off.squaredNorm());
            }
            member.weight = std::exp(Space::log_density(member.point)) / density;
            sum += member.weight;
        }
        for (Member& member : state_.accepted) {
            member.weight /= sum;
        }
    }
};

}  // namespace

std::uint64_t SearchState::tried() const {
    std::uint64_t sum = waves.empty() ? first.size() : begun.tried;
    for (const Wave& wave : waves) {
        sum += wave.tried;
    }
    return sum;
}

void search(const Simulator& simulator, const SearchPlan& plan, SearchState& state,
            const std::function<void(const SearchState&)>& keep,
            const std::function<void(std::uint64_t sets)>& moved) {
    if (plan.emulates) {
        ruled_search(simulator, plan, state, keep, moved);
    } else {
        Waves{simulator, plan, state, keep, moved}.run();
    }
}

}  // namespace coupling::calibrate
