#include "coupling/assessments/calibrate/search/rounds.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "coupling/inputs/observed/distribution.hpp"

namespace coupling::calibrate {
namespace {

/// Sets whose samples make the self-distance.
constexpr std::size_t sets_of_scale = 20;

}  // namespace

void Rounds::simulate_first() {
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
}

const Point& Rounds::nearest_of_first() const {
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
        by_wave.medians.push_back(counts ? std::max({1e-9, simulator_.observations()[i].least_scale(),
                                                     observed::Distribution{std::move(finite)}.quantile(0.5)})
                                         : 0.0);
    }
    return std::min_element(state_.first.begin(), state_.first.end(),
                            [&](const Member& a, const Member& b) {
                                return by_wave.together(a.distances) < by_wave.together(b.distances);
                            })
        ->point;
}

std::vector<std::vector<double>> Rounds::rescale(const Point& centre) {
    const std::vector<Point> same(sets_of_scale, centre);
    const auto number = static_cast<std::uint16_t>(most_waves / 2 + state_.waves.size());
    std::vector<std::vector<Sample>> sets;
    std::vector<std::vector<double>> summaries;
    for (Shown& shown : simulator_.shown(same, number, plan_.rocks)) {
        sets.push_back(std::move(shown.samples));
        summaries.push_back(std::move(shown.summary));
    }
    state_.scale = self_distance(sets, witnessed(), simulator_.seed(), number);
    return summaries;
}

std::vector<Witnessed> Rounds::witnessed() const {
    std::vector<Witnessed> observed;
    for (const Observation& observation : simulator_.observations()) {
        observed.push_back(
            {observation.fit.size(), observation.witness, observation.least_scale(), observation.site});
    }
    return observed;
}

bool Rounds::is_within(const std::vector<double>& distances, double tolerance) const {
    const double together = state_.scale.together(distances);
    return std::isfinite(together) && together <= tolerance;
}

std::size_t Rounds::least_parents() const {
    return std::max<std::size_t>(20, 3 * simulator_.space().size());
}

void Rounds::end(SearchEnd end) {
    state_.is_done = true;
    state_.end = end;
    keep_(state_);
}

}  // namespace coupling::calibrate
