#include "coupling/assessments/calibrate/search/search.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "config/random/distributions.hpp"
#include "coupling/assessments/calibrate/model/random.hpp"
#include "coupling/inputs/observed/distribution.hpp"

namespace coupling::calibrate {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
/// Candidates between two states from which a search can go on.
constexpr std::uint64_t sets_at_once = 256;
/// Sets whose samples make the self-distance.
constexpr std::size_t sets_of_scale = 20;
/// Below this share of kept sets a wave is given up, once it has tried so many.
constexpr double least_kept = 0.005;
constexpr std::uint64_t tried_before_giving_up = 2'000;
/// The share of a wave that lies within the tolerance of the next.
constexpr double nearer_share = 0.5;
/// Of the first wave, which covers everything.
constexpr double nearer_share_of_first = 0.2;

class Waves {
public:
    Waves(const Simulator& simulator, const SearchPlan& plan, SearchState& state,
          const std::function<void(const SearchState&)>& keep,
          const std::function<void(std::uint64_t)>& moved)
        : simulator_{simulator}, plan_{plan}, state_{state}, keep_{keep}, moved_{moved} {}

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
        const std::vector<Point> points =
            simulator_.space().spread(simulator_.seed(), static_cast<std::size_t>(plan_.first_sets));
        while (state_.first.size() < points.size()) {
            const std::size_t done = state_.first.size();
            const std::size_t next = std::min<std::size_t>(sets_at_once, points.size() - done);
            simulator_.show(
                std::span{points}.subspan(done, next), 0, static_cast<std::uint32_t>(done), plan_.rocks,
                [&](std::size_t i, Shown& shown) {
                    state_.first.push_back({points[done + i], 1.0 / static_cast<double>(points.size()),
                                            shown.distances, shown.summary, shown.figures});
                    moved_(1);
                });
            if (state_.first.size() < points.size()) {
                keep_(state_);
            }
        }
        // No scale is known yet: each observation counts by its median in this wave.
        SelfDistance by_wave;
        by_wave.sites = sites_of(witnessed());
        for (std::size_t i = 0; i < simulator_.observations().size(); ++i) {
            std::vector<double> finite;
            for (const Member& member : state_.first) {
                if (std::isfinite(member.distances[i])) {
                    finite.push_back(member.distances[i]);
                }
            }
            const bool counts = !simulator_.observations()[i].fit.empty() && !finite.empty();
            by_wave.medians.push_back(
                counts ? std::max({1e-9, simulator_.observations()[i].least_scale(),
                                   observed::Distribution{std::move(finite)}.quantile(0.5)})
                       : 0.0);
        }
        const auto nearest =
            std::min_element(state_.first.begin(), state_.first.end(), [&](const Member& a, const Member& b) {
                return by_wave.together(a.distances) < by_wave.together(b.distances);
            });
        state_.population = state_.first;
        for (Member& member : state_.population) {
            member.figures.clear();
        }
        finish_wave({.tolerance = infinite, .goal = 0.0, .tried = plan_.first_sets, .kept = plan_.first_sets},
                    nearest->point);
    }

    /// A wave is through: the scale at the sets as they are now.
    void finish_wave(Wave wave, const Point& centre) {
        state_.waves.push_back(wave);
        const std::vector<Point> same(sets_of_scale, centre);
        const auto number = static_cast<std::uint16_t>(most_waves / 2 + state_.waves.size());
        std::vector<std::vector<Sample>> sets;
        for (Shown& shown : simulator_.shown(same, number, plan_.rocks)) {
            sets.push_back(std::move(shown.samples));
        }
        state_.scale = self_distance(sets, witnessed(), simulator_.seed(), number);
        state_.begun = {};
        state_.accepted.clear();
        const bool is_last = state_.waves.size() + 1 >= most_waves / 2;
        if ((std::isfinite(wave.goal) && wave.tolerance <= wave.goal) || is_last) {
            state_.is_done = true;
            state_.end = wave.tolerance <= wave.goal ? SearchEnd::close : SearchEnd::few_kept;
        }
        keep_(state_);
    }

    [[nodiscard]] std::vector<Witnessed> witnessed() const {
        std::vector<Witnessed> observed;
        for (const Observation& observation : simulator_.observations()) {
            observed.push_back(
                {observation.fit.size(), observation.witness, observation.least_scale(), observation.site});
        }
        return observed;
    }

    /// A set that shows nothing of what was seen is never near.
    [[nodiscard]] bool is_within(const std::vector<double>& distances, double tolerance) const {
        const double together = state_.scale.together(distances);
        return std::isfinite(together) && together <= tolerance;
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

    /// So many that their covariance means something.
    [[nodiscard]] std::size_t least_parents() const {
        return std::max<std::size_t>(20, 3 * simulator_.space().size());
    }

    /// Ends the search with what it has.
    void end_without_goal(SearchEnd end) {
        state_.is_done = true;
        state_.end = end;
        keep_(state_);
    }

    void next_wave() {
        if (!std::isfinite(state_.scale.at_90)) {  // the sets in the middle show nothing of something seen
            end_without_goal(SearchEnd::few_kept);
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
            end_without_goal(SearchEnd::few_sets);
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

    const Simulator& simulator_;
    const SearchPlan& plan_;
    SearchState& state_;
    const std::function<void(const SearchState&)>& keep_;
    const std::function<void(std::uint64_t)>& moved_;
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
    Waves{simulator, plan, state, keep, moved}.run();
}

}  // namespace coupling::calibrate
