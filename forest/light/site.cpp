#include "forest/light/site.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "forest/light/layers.hpp"

namespace forest {
namespace {

/// A zone whose direction falls flatter on the ground than this gives its light to the nearest zone that does
/// not.
constexpr double flattest_sine = 0.1;

int margin_of(const LightGround& ground, const LightSettings& settings) {
    return static_cast<int>(std::ceil(settings.reach_m / ground.elevation_m.frame.cell_width_m)) + 2;
}

/// Light of a zone at a place, summed over the samples that are seen.
struct ZoneSum {
    double towards_zone = 0.0;  ///< on a plane at right angles to the zone's direction
    double on_slope = 0.0;

    void add(const SkySample& sample, const Direction& zone, const Direction& normal) {
        towards_zone += sample.normal_per_flat * dot(sample.towards, zone);
        on_slope += sample.normal_per_flat * dot(sample.towards, normal);
    }

    /// Energy in the zone's direction that falls on the slope as its samples together do. Of a zone that is
    /// hidden in part the rest may come from steeper or flatter, within bounds.
    [[nodiscard]] float energy(const Direction& zone, const Direction& normal) const {
        const double same_on_slope = on_slope / dot(zone, normal);
        return static_cast<float>(std::clamp(same_on_slope, 0.5 * towards_zone, 2.0 * towards_zone));
    }
};

bool is_usable(const Direction& zone, const Direction& normal) {
    return dot(zone, normal) > flattest_sine;
}

/// The usable zone whose direction lies next to a sample's, or the number of zones.
std::size_t nearest_usable(const std::vector<Direction>& zones, const SkySample& sample,
                           const Direction& normal) {
    std::size_t nearest = zones.size();
    double best = -1.0;
    for (std::size_t zone = 0; zone < zones.size(); ++zone) {
        const double near = dot(zones[zone], sample.towards);
        if (near > best && is_usable(zones[zone], normal)) {
            best = near;
            nearest = zone;
        }
    }
    return nearest;
}

std::vector<float> diffuse_from(const Sky& sky, const Exposure& place) {
    const std::vector<Direction>& zones = sky.zones();
    std::vector<ZoneSum> sums(zones.size());
    for (const SkySample& sample : sky.diffuse()) {
        if (sees(place, sample)) {
            const bool own = is_usable(zones[sample.zone], place.normal);
            const std::size_t zone = own ? sample.zone : nearest_usable(zones, sample, place.normal);
            if (zone < zones.size()) {
                sums[zone].add(sample, zones[zone], place.normal);
            }
        }
    }
    std::vector<float> energies(zones.size(), 0.0F);
    for (std::size_t zone = 0; zone < zones.size(); ++zone) {
        if (is_usable(zones[zone], place.normal)) {
            energies[zone] = sums[zone].energy(zones[zone], place.normal);
        }
    }
    return energies;
}

/// Another beam of the same month in a usable zone, next to a sun, or the number of beams.
std::size_t nearest_beam(const Sky& sky, std::size_t beam, const SkySample& sun, const Direction& normal) {
    std::size_t nearest = sky.beams().size();
    double best = -1.0;
    for (std::size_t other = 0; other < sky.beams().size(); ++other) {
        const Direction& zone = sky.zones()[sky.beams()[other].zone];
        const double near = dot(zone, sun.towards);
        if (sky.beams()[other].month == sky.beams()[beam].month && near > best && is_usable(zone, normal)) {
            best = near;
            nearest = other;
        }
    }
    return nearest;
}

std::vector<float> beams_from(const Sky& sky, const Exposure& place) {
    const auto zone_of = [&](std::size_t beam) -> const Direction& {
        return sky.zones()[sky.beams()[beam].zone];
    };
    std::vector<ZoneSum> sums(sky.beams().size());
    for (std::size_t beam = 0; beam < sums.size(); ++beam) {
        for (const SkySample& sun : sky.suns_of(beam)) {
            if (sees(place, sun)) {
                const bool own = is_usable(zone_of(beam), place.normal);
                const std::size_t to = own ? beam : nearest_beam(sky, beam, sun, place.normal);
                if (to < sums.size()) {
                    sums[to].add(sun, zone_of(to), place.normal);
                }
            }
        }
    }
    std::vector<float> energies(sums.size(), 0.0F);
    for (std::size_t beam = 0; beam < sums.size(); ++beam) {
        if (is_usable(zone_of(beam), place.normal)) {
            energies[beam] = sums[beam].energy(zone_of(beam), place.normal);
        }
    }
    return energies;
}

}  // namespace

SkyView view_from(const Sky& sky, const Exposure& place) {
    SkyView view;
    view.diffuse = diffuse_from(sky, place);
    view.beam = beams_from(sky, place);
    for (const Direction& zone : sky.zones()) {
        view.on_ground.push_back(static_cast<float>(std::max(dot(zone, place.normal) / place.normal.z, 0.0)));
    }
    for (std::size_t sun = 0; sun < sky.june_suns().size(); ++sun) {
        const bool visible = sees(place, sky.june_suns()[sun]);
        view.june_suns |= static_cast<std::uint64_t>(visible ? 1 : 0) << sun;
    }
    return view;
}

LightSite::LightSite(Sky sky, const LightGround& ground, std::span<const Exposure> places,
                     const LightSettings& settings)
    : sky_{std::move(sky)},
      edges_{ground.edges},
      ground_{ground, margin_of(ground, settings)},
      points_{settings.ground_points > 1
                  ? static_cast<std::size_t>(settings.ground_points * settings.ground_points)
                  : 0} {
    assert(places.size() == 1 || places.size() == ground.elevation_m.frame.size());
    for (const Exposure& place : places) {
        views_.push_back(view_from(sky_, place));
    }
    // Rays may climb a slope of 45 degrees and still be in the canopy; the walk ends them where they leave
    // it.
    const double rise_m = canopy_height_m + settings.reach_m;
    const auto walk = [&](const Direction& towards, double x_m, double y_m) {
        return walk_towards(towards, x_m, y_m, ground_.column_m(), ground_.stride(), rise_m,
                            settings.reach_m);
    };
    first_beam_.assign(sky_.zones().size() + 1, sky_.beams().size());
    for (std::size_t beam = sky_.beams().size(); beam-- > 0;) {
        first_beam_[sky_.beams()[beam].zone] = beam;
    }
    for (std::size_t zone = sky_.zones().size(); zone-- > 0;) {
        first_beam_[zone] = std::min(first_beam_[zone], first_beam_[zone + 1]);
    }
    for (const Direction& zone : sky_.zones()) {
        walks_.push_back(walk(zone, 0.0, 0.0));
        for (std::size_t point = 0; point < points_; ++point) {
            const auto side = static_cast<std::size_t>(settings.ground_points);
            const auto place_m = [&](std::size_t i) {
                return ((static_cast<double>(i) + 0.5) / static_cast<double>(side) - 0.5) *
                       ground_.column_m();
            };
            ground_walks_.push_back(walk(zone, place_m(point % side), place_m(point / side)));
        }
    }
    for (const SkySample& sun : sky_.june_suns()) {
        june_walks_.push_back(walk(sun.towards, 0.0, 0.0));
    }
}

std::vector<Exposure> exposures_of(const LightGround& ground, std::span<const Horizon> horizons) {
    const std::size_t columns = ground.elevation_m.frame.size();
    assert(horizons.empty() || horizons.size() == 1 || horizons.size() == columns);
    const PaddedGround padded{ground, 1};
    std::vector<Exposure> places(columns);
    for (std::size_t column = 0; column < columns; ++column) {
        places[column].normal = padded.normal(column);
        if (!horizons.empty()) {
            places[column].horizon = horizons[horizons.size() == 1 ? 0 : column];
        }
    }
    return places;
}

}  // namespace forest
