#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "config/units/angle.hpp"
#include "forest/light/direction.hpp"
#include "forest/light/horizon.hpp"
#include "forest/light/sun.hpp"

namespace forest {

/// How the sky is cut up.
struct SkySettings {
    config::Angle latitude;        ///< [-90, 90] degrees
    config::Angle y_axis_azimuth;  ///< where the grid's y axis points, clockwise from true north
    config::Angle zone_height = config::Angle::from_degrees(20.0);  ///< (0, 90] degrees of elevation
    config::Angle zone_width = config::Angle::from_degrees(45.0);   ///< (0, 360] degrees of azimuth
    config::Angle lowest_sun = config::Angle::from_degrees(5.0);    ///< the beam of a lower sun is left out
    double beam_transmission =
        0.65;  ///< (0, 1] share of the beam that one vertical atmosphere lets through [choice]
};

/// A small part of the sky that light comes from.
struct SkySample {
    Direction towards;
    config::Angle azimuth;  ///< clockwise from the grid's y axis
    std::uint32_t zone = 0;
    double normal_per_flat = 0;  ///< energy on a plane at right angles to the ray per energy of the whole sky
                                 ///< (diffuse), of the month's beam (sun), on the flat [-]
};

/// Where the beam of a month passes a zone.
struct ZoneOfMonth {
    std::uint32_t zone = 0;
    std::uint32_t month = 0;  ///< 0 = January
};

/// The sky above a site, cut into zones with one direction each; does not change with the weather.
///
/// Diffuse light is that of the standard overcast sky, radiance proportional to 1 + 2 sin(elevation) (Moon &
/// Spencer 1942). The beam of a month is spread over the half hours of its middle day with weight sin b *
/// transmission^(1 / sin b), b the elevation of the sun [choice]. Both are merged into zones; the cap above
/// the last band that begins below 75 degrees is one zone. The direction of a zone is the mean of its light
/// from May to September.
///
/// A grid that does not point north only turns the sun: the sky of a grid is the same from all sides.
class Sky {
public:
    Sky(const SkySettings& settings, const MonthlyRadiation& usual);

    [[nodiscard]] const std::vector<Direction>& zones() const { return zones_; }
    [[nodiscard]] const std::vector<SkySample>& diffuse() const { return diffuse_; }

    /// Where the beam passes in the course of the year, by zone and then by month; zones without sun do not
    /// occur.
    [[nodiscard]] const std::vector<ZoneOfMonth>& beams() const { return beams_; }
    /// Suns that belong to each entry of beams().
    [[nodiscard]] std::span<const SkySample> suns_of(std::size_t beam) const {
        return {suns_.data() + first_sun_[beam], suns_.data() + first_sun_[beam + 1]};
    }

    /// Where the sun stands in the half hours of a mid-June day, at most 64 of them.
    [[nodiscard]] const std::vector<SkySample>& june_suns() const { return june_suns_; }

private:
    void place_diffuse(const SkySettings& settings);
    void place_suns(const SkySettings& settings);
    void point_zones(const MonthlyRadiation& usual);

    std::vector<Direction> zones_;
    std::vector<SkySample> diffuse_;
    std::vector<ZoneOfMonth> beams_;
    std::vector<SkySample> suns_;
    std::vector<std::size_t> first_sun_;
    std::vector<SkySample> june_suns_;
};

/// A place on the ground as light sees it.
struct Exposure {
    Direction normal;  ///< of the ground
    Horizon horizon;   ///< of the terrain around
    double least_cosine =
        0.0;  ///< light that falls flatter on the ground than with this cosine of incidence is left out
};

/// Whether light from there reaches open ground.
[[nodiscard]] bool sees(const Exposure& place, const SkySample& sample);

/// Energy that reaches a slope without trees, and the flat without horizon, in each month [MJ/m2 of its own
/// surface].
struct SlopeRadiation {
    MonthlyRadiation slope;
    MonthlyRadiation flat;

    /// Global radiation of the slope divided by that of the flat [-], what the water balance takes; 1 in a
    /// month without light.
    [[nodiscard]] double factor(std::size_t month) const;
};

[[nodiscard]] SlopeRadiation slope_radiation(const Sky& sky, const Exposure& place,
                                             const MonthlyRadiation& flat);

}  // namespace forest
