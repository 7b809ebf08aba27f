#include "coupling/assessments/calibrate/search/self_distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "coupling/assessments/calibrate/model/random.hpp"
#include "coupling/inputs/observed/distribution.hpp"

namespace coupling::calibrate {

double SelfDistance::at_site(const std::vector<double>& distances, std::uint32_t site) const {
    double sum = 0.0;
    double count = 0.0;
    for (std::size_t i = 0; i < medians.size(); ++i) {
        if (medians[i] > 0.0 && (sites.empty() || sites[i] == site)) {
            sum += distances[i] / medians[i];
            count += 1.0;
        }
    }
    return count > 0.0 ? sum / count : std::numeric_limits<double>::infinity();
}

double SelfDistance::together(const std::vector<double>& distances) const {
    if (sites.empty()) {
        return at_site(distances, 0);
    }
    double largest = 0.0;
    for (std::uint32_t site = 0; site <= sites.back(); ++site) {
        const double of_site = of_sites.empty() ? 1.0 : of_sites[site];
        largest = std::max(largest, at_site(distances, site) / of_site);
    }
    return largest;
}

std::vector<std::uint32_t> sites_of(const std::vector<Witnessed>& observed) {
    std::vector<std::uint32_t> sites;
    for (const Witnessed& one : observed) {
        sites.push_back(one.site);
    }
    return sites.empty() || sites.back() == 0 ? std::vector<std::uint32_t>{} : sites;
}

void scale_sites(SelfDistance& scale, const std::vector<std::vector<double>>& trials) {
    scale.of_sites.clear();
    if (scale.sites.empty()) {
        return;
    }
    for (std::uint32_t site = 0; site <= scale.sites.back(); ++site) {
        std::vector<double> of_site;
        for (const std::vector<double>& trial : trials) {
            if (const double distance = scale.at_site(trial, site); std::isfinite(distance)) {
                of_site.push_back(distance);
            }
        }
        const double at_90 =
            of_site.empty() ? 1.0 : observed::Distribution{std::move(of_site)}.quantile(0.90);
        scale.of_sites.push_back(std::max(1e-9, at_90));
    }
}

Sample drawn_from(const std::vector<const Sample*>& samples, std::size_t without, std::size_t points,
                  const std::function<double()>& uniform) {
    Sample pool{.is_plane = samples.front()->is_plane};
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (i != without) {
            pool.points.insert(pool.points.end(), samples[i]->points.begin(), samples[i]->points.end());
        }
    }
    Sample drawn{.is_plane = pool.is_plane};
    for (std::size_t i = 0; i < points && !pool.empty(); ++i) {
        // The first places of the pool are taken away one by one, then all may come again.
        const std::size_t first = i % pool.size();
        const auto left = static_cast<double>(pool.size() - first);
        const std::size_t at = std::min(pool.size() - 1, first + static_cast<std::size_t>(uniform() * left));
        std::swap(pool.points[first], pool.points[at]);
        drawn.points.push_back(pool.points[first]);
    }
    return drawn;
}

SelfDistance self_distance(const std::vector<std::vector<Sample>>& sets,
                           const std::vector<Witnessed>& observed, std::uint64_t seed, std::uint16_t wave) {
    constexpr std::size_t trials = 200;
    std::vector<std::vector<double>> distances(trials);  // by trial, by observation
    for (std::size_t trial = 0; trial < trials; ++trial) {
        const std::size_t set = trial % sets.size();
        for (std::size_t i = 0; i < observed.size(); ++i) {
            config::RandomStream stream =
                choices(seed, wave, Choice::trial, trial * most_witnesses + observed[i].witness);
            const auto uniform = [&] { return stream.uniform(); };
            std::vector<const Sample*> of_observation;
            for (const std::vector<Sample>& each : sets) {
                of_observation.push_back(&each[i]);
            }
            const std::size_t points = observed[i].points;
            if (points == 0) {
                distances[trial].push_back(0.0);
                continue;
            }
            const Sample one = drawn_from(of_observation, set, points, uniform);
            const Sample other = drawn_from({&sets[set][i]}, 1, points, uniform);
            distances[trial].push_back(energy_distance(one, other));
        }
    }
    SelfDistance scale;
    for (std::size_t i = 0; i < observed.size(); ++i) {
        std::vector<double> of_observation;
        for (const std::vector<double>& trial : distances) {
            if (std::isfinite(trial[i])) {
                of_observation.push_back(trial[i]);
            }
        }
        // An observation that the set hardly ever shows has no scale: its distance counts as it is.
        const double median =
            of_observation.empty() ? 1.0 : observed::Distribution{std::move(of_observation)}.quantile(0.5);
        scale.medians.push_back(observed[i].points == 0 ? 0.0
                                                        : std::max({median, observed[i].least_scale, 1e-9}));
    }
    scale.sites = sites_of(observed);
    scale_sites(scale, distances);
    std::vector<double> all;
    for (const std::vector<double>& trial : distances) {
        if (const double together = scale.together(trial); std::isfinite(together)) {
            all.push_back(together);
        }
    }
    if (all.empty()) {
        scale.at_90 = scale.at_95 = std::numeric_limits<double>::infinity();
    } else {
        const observed::Distribution together{std::move(all)};
        scale.at_90 = together.quantile(0.90);
        scale.at_95 = together.quantile(0.95);
    }
    return scale;
}

}  // namespace coupling::calibrate
