#include "rockfall/rock_mass/joint_sets.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "config/math/elementary.hpp"
#include "config/random/distributions.hpp"

namespace rockfall::rock_mass {

using Eigen::Vector3d;

namespace {

/// Sine and cosine of any angle; config's know right angles at most.
config::SinCos sin_cos_any(double angle_deg) {
    const double quarter = std::floor(angle_deg / 90.0);
    const config::SinCos rest = config::sin_cos_of((angle_deg - 90.0 * quarter) * std::numbers::pi / 180.0);
    switch (static_cast<int>(quarter - 4.0 * std::floor(quarter / 4.0))) {
        case 0:
            return rest;
        case 1:
            return {rest.cos, -rest.sin};
        case 2:
            return {-rest.sin, -rest.cos};
        default:
            return {-rest.cos, rest.sin};
    }
}

double drawn_spacing_m(const JointSet& set, config::RandomStream& draws) {
    const double mean = set.spacing_m, deviation = set.spacing_deviation_m;
    switch (set.law) {
        case SpacingLaw::uniform:
            return mean + deviation * std::sqrt(3.0) * (2.0 * draws.uniform() - 1.0);
        case SpacingLaw::exponential:
            return -mean * config::ln_of(1.0 - draws.uniform());
        case SpacingLaw::lognormal: {
            const double variance = config::ln_of(1.0 + deviation * deviation / (mean * mean));
            const double median = config::exp_of(config::ln_of(mean) - 0.5 * variance);
            // Never exactly 0, whose quantile is not finite.
            return config::lognormal(std::max(draws.uniform(), 1e-12), median, std::sqrt(variance));
        }
        case SpacingLaw::constant:
            break;
    }
    return mean;
}

bool is_large_enough(const ConvexCell& cell, double least_size_m) {
    return !cell.faces.empty() && size_m(cell) >= least_size_m;
}

}  // namespace

Vector3d JointSet::normal() const {
    const config::SinCos dip = sin_cos_any(dip_deg);
    const config::SinCos azimuth = sin_cos_any(dip_direction_deg);
    return {dip.sin * azimuth.sin, dip.sin * azimuth.cos, dip.cos};
}

std::vector<double> joint_places(const JointSet& set, double low_m, double high_m,
                                 config::RandomStream& draws) {
    // The first one lies anywhere within a spacing below.
    const double shortest_m = 1e-3 * set.spacing_m;
    std::vector<double> places;
    double at_m = low_m - draws.uniform() * set.spacing_m;
    while (at_m < high_m) {
        if (at_m > low_m) {
            places.push_back(at_m);
        }
        at_m += std::max(shortest_m, drawn_spacing_m(set, draws));
    }
    return places;
}

double expected_pieces(double volume_m3, std::span<const JointSet> sets, double least_size_m) {
    double meetings = 0.0;
    for (std::size_t i = 0; i < sets.size(); ++i) {
        for (std::size_t j = i + 1; j < sets.size(); ++j) {
            for (std::size_t k = j + 1; k < sets.size(); ++k) {
                const double apart = std::abs(sets[i].normal().dot(sets[j].normal().cross(sets[k].normal())));
                meetings += apart / (sets[i].spacing_m * sets[j].spacing_m * sets[k].spacing_m);
            }
        }
    }
    const double cubes = 1.0 / (least_size_m * least_size_m * least_size_m);
    return volume_m3 * std::min(meetings, cubes);
}

std::vector<ConvexCell> cut_by_joints(const ConvexCell& body, std::span<const JointSet> sets,
                                      double least_size_m, std::uint64_t seed) {
    std::vector<ConvexCell> cells{body};
    for (std::size_t s = 0; s < sets.size(); ++s) {
        config::RandomStream draws{{seed, 0, 0, s}, config::Purpose::block};
        const Vector3d normal = sets[s].normal();
        const Span1 extent = extent_along(body, normal);
        const std::vector<double> places = joint_places(sets[s], extent.low, extent.high, draws);
        std::vector<ConvexCell> cut;
        for (ConvexCell& cell : cells) {
            ConvexCell rest = std::move(cell);
            const Span1 here = extent_along(rest, normal);
            for (auto at = std::upper_bound(places.begin(), places.end(), here.low);
                 at != places.end() && *at < here.high; ++at) {
                ConvexCell below = part_below(rest, {normal, *at}, static_cast<int>(s));
                ConvexCell above = part_below(rest, {-normal, -*at}, static_cast<int>(s));
                if (is_large_enough(below, least_size_m) && is_large_enough(above, least_size_m)) {
                    cut.push_back(std::move(below));
                    rest = std::move(above);
                }
            }
            cut.push_back(std::move(rest));
        }
        cells = std::move(cut);
    }
    return cells;
}

}  // namespace rockfall::rock_mass
