#include "forest/light/sky.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "config/math/elementary.hpp"

namespace forest {
namespace {

constexpr int diffuse_bands = 45;          // of 2 degrees
constexpr int diffuse_sectors = 72;        // of 5 degrees
constexpr double largest_air_mass = 38.0;  // at the horizon (Kasten & Young 1989)
constexpr double half_hours_of_day = 48.0;
constexpr std::size_t june = 5;
constexpr std::size_t first_growing_month = 4;
constexpr std::size_t last_growing_month = 8;

/// Zones in bands of elevation from the horizon upwards, each band from the y axis clockwise.
struct Zoning {
    int bands;  ///< below the cap
    int sectors;
    double height_deg;
    double width_deg;

    explicit Zoning(const SkySettings& settings)
        : bands{std::max(1, static_cast<int>(std::ceil(75.0 / settings.zone_height.in_degrees() - 1e-9)))},
          sectors{std::max(1, static_cast<int>(std::lround(360.0 / settings.zone_width.in_degrees())))},
          height_deg{settings.zone_height.in_degrees()},
          width_deg{360.0 / sectors} {
        // A last band that reaches beyond 85 degrees needs no cap of its own.
        has_cap = bands * height_deg < 85.0;
    }
    bool has_cap;

    [[nodiscard]] std::size_t count() const {
        return static_cast<std::size_t>(bands * sectors + (has_cap ? 1 : 0));
    }
    [[nodiscard]] std::uint32_t zone_of(double sine, config::Angle azimuth) const {
        const double elevation_deg = 90.0 - arc_cosine(sine).in_degrees();
        const int band = static_cast<int>(elevation_deg / height_deg);
        if (band >= bands && has_cap) {
            return static_cast<std::uint32_t>(bands * sectors);
        }
        const int sector = std::min(static_cast<int>(azimuth.in_degrees() / width_deg), sectors - 1);
        return static_cast<std::uint32_t>(std::min(band, bands - 1) * sectors + sector);
    }
};

/// Share of the whole sky's flat energy that comes from below an elevation, standard overcast sky.
double overcast_share_below(double sine) {
    return 6.0 / 7.0 * sine * sine * (0.5 + 2.0 / 3.0 * sine);
}

/// From the axes of the earth (x east, y north) to those of the grid.
Direction in_grid(const Direction& towards, Turn y_axis) {
    return {towards.x * y_axis.cos - towards.y * y_axis.sin, towards.x * y_axis.sin + towards.y * y_axis.cos,
            towards.z};
}

/// The suns of the half hours of a month's middle day that stand high enough, with the shares of the beam
/// they bring.
std::vector<SkySample> suns_of_month(const SkySettings& settings, std::size_t month) {
    const Zoning zoning{settings};
    const Turn y_axis = turn_of(settings.y_axis_azimuth);
    const double lowest = turn_of(settings.lowest_sun).sin;
    std::vector<SkySample> suns;
    double sum = 0.0;
    for (int step = 0; step < static_cast<int>(half_hours_of_day); ++step) {
        const Direction sun = toward_sun(settings.latitude, mid_month_day[month], 0.5 * step + 0.25);
        if (sun.z <= lowest) {
            continue;
        }
        SkySample sample;
        sample.towards = in_grid(sun, y_axis);
        sample.azimuth = azimuth_of(sample.towards.x, sample.towards.y);
        sample.zone = zoning.zone_of(sun.z, sample.azimuth);
        const double air_mass = std::min(1.0 / sun.z, largest_air_mass);
        const double flat = sun.z * config::pow_of(settings.beam_transmission, air_mass);
        sample.normal_per_flat = flat / sun.z;
        sum += flat;
        suns.push_back(sample);
    }
    for (SkySample& sample : suns) {
        sample.normal_per_flat /= sum;
    }
    return suns;
}

void add(Direction& sum, const SkySample& sample, double energy) {
    const double weight = energy * sample.normal_per_flat;
    sum.x += weight * sample.towards.x;
    sum.y += weight * sample.towards.y;
    sum.z += weight * sample.towards.z;
}

}  // namespace

Sky::Sky(const SkySettings& settings, const MonthlyRadiation& usual) : zones_(Zoning{settings}.count()) {
    assert(settings.zone_height.in_degrees() > 0.0 && settings.zone_width.in_degrees() > 0.0);
    place_diffuse(settings);
    place_suns(settings);
    point_zones(usual);
}

void Sky::place_diffuse(const SkySettings& settings) {
    const Zoning zoning{settings};
    for (int band = 0; band < diffuse_bands; ++band) {
        const double low = turn_of(config::Angle::from_degrees(90.0 * band / diffuse_bands)).sin;
        const double high = turn_of(config::Angle::from_degrees(90.0 * (band + 1) / diffuse_bands)).sin;
        const double middle_deg = 90.0 * (band + 0.5) / diffuse_bands;
        const double flat = (overcast_share_below(high) - overcast_share_below(low)) / diffuse_sectors;
        for (int sector = 0; sector < diffuse_sectors; ++sector) {
            SkySample sample;
            sample.azimuth = config::Angle::from_degrees(360.0 * (sector + 0.5) / diffuse_sectors);
            sample.towards = direction_at(sample.azimuth, config::Angle::from_degrees(middle_deg));
            sample.zone = zoning.zone_of(sample.towards.z, sample.azimuth);
            sample.normal_per_flat = flat / sample.towards.z;
            diffuse_.push_back(sample);
        }
    }
}

void Sky::place_suns(const SkySettings& settings) {
    std::vector<std::vector<SkySample>> of_beam(zones_.size() * 12);
    for (std::size_t month = 0; month < 12; ++month) {
        for (const SkySample& sun : suns_of_month(settings, month)) {
            of_beam[sun.zone * 12 + month].push_back(sun);
        }
    }
    first_sun_.push_back(0);
    for (std::size_t beam = 0; beam < of_beam.size(); ++beam) {
        if (!of_beam[beam].empty()) {
            beams_.push_back({static_cast<std::uint32_t>(beam / 12), static_cast<std::uint32_t>(beam % 12)});
            suns_.insert(suns_.end(), of_beam[beam].begin(), of_beam[beam].end());
            first_sun_.push_back(suns_.size());
        }
    }
    june_suns_ = suns_of_month(settings, june);
}

void Sky::point_zones(const MonthlyRadiation& usual) {
    std::vector<Direction> sums(zones_.size(), Direction{0.0, 0.0, 0.0});
    double diffuse_mjpm2 = 1e-6;  // a sky without light still has directions
    for (std::size_t month = first_growing_month; month <= last_growing_month; ++month) {
        diffuse_mjpm2 += usual.diffuse_mjpm2[month];
    }
    for (const SkySample& sample : diffuse_) {
        add(sums[sample.zone], sample, diffuse_mjpm2);
    }
    for (std::size_t beam = 0; beam < beams_.size(); ++beam) {
        const std::size_t month = beams_[beam].month;
        if (month >= first_growing_month && month <= last_growing_month) {
            for (const SkySample& sun : suns_of(beam)) {
                add(sums[sun.zone], sun, usual.direct_mjpm2[month]);
            }
        }
    }
    for (std::size_t zone = 0; zone < zones_.size(); ++zone) {
        const double length = std::sqrt(dot(sums[zone], sums[zone]));
        zones_[zone] = {sums[zone].x / length, sums[zone].y / length, sums[zone].z / length};
    }
}

bool sees(const Exposure& place, const SkySample& sample) {
    return dot(place.normal, sample.towards) > place.least_cosine &&
           place.horizon.clears(sample.towards, sample.azimuth);
}

double SlopeRadiation::factor(std::size_t month) const {
    const double flat_mjpm2 = flat.direct_mjpm2[month] + flat.diffuse_mjpm2[month];
    const double slope_mjpm2 = slope.direct_mjpm2[month] + slope.diffuse_mjpm2[month];
    return flat_mjpm2 > 0.0 ? slope_mjpm2 / flat_mjpm2 : 1.0;
}

SlopeRadiation slope_radiation(const Sky& sky, const Exposure& place, const MonthlyRadiation& flat) {
    double of_the_sky = 0.0;
    for (const SkySample& sample : sky.diffuse()) {
        of_the_sky += sees(place, sample) ? sample.normal_per_flat * dot(place.normal, sample.towards) : 0.0;
    }
    std::array<double, 12> of_the_beam{};
    for (std::size_t beam = 0; beam < sky.beams().size(); ++beam) {
        for (const SkySample& sun : sky.suns_of(beam)) {
            of_the_beam[sky.beams()[beam].month] +=
                sees(place, sun) ? sun.normal_per_flat * dot(place.normal, sun.towards) : 0.0;
        }
    }
    SlopeRadiation radiation{.slope = {}, .flat = flat};
    for (std::size_t month = 0; month < 12; ++month) {
        radiation.slope.diffuse_mjpm2[month] = of_the_sky * flat.diffuse_mjpm2[month];
        radiation.slope.direct_mjpm2[month] = of_the_beam[month] * flat.direct_mjpm2[month];
    }
    return radiation;
}

}  // namespace forest
