#pragma once

#include "forest/climate/change.hpp"
#include "forest/climate/series.hpp"

namespace coupling::plausible {

/// Means of a series over its years, as it is at the elevation of a forest.
struct ClimateAt {
    double latitude_deg = 0.0;  ///< north positive
    double elevation_m = 0.0;
    double mean_degc = 0.0;
    double january_degc = 0.0;
    double july_degc = 0.0;
};

/// Of the place of the series itself.
ClimateAt means_of(const forest::ClimateSeries& series, double latitude_deg);

/// Requires a series that knows its elevation.
ClimateAt climate_at(const forest::ClimateSeries& series, double latitude_deg, double elevation_m,
                     const forest::LapseRates& rates);

/// A rule of thumb for places of a latitude: 30 degC - 0.4 K a degree at the sea, 5.5 K/km upwards [choice].
double usual_mean_degc(double latitude_deg, double elevation_m);

/// More than 9 K from it [choice]: an elevation in feet, or a series of another place.
bool is_of_another_place(const ClimateAt& climate);

/// What a year of a place looks like, from which its half of the earth follows.
struct Hemisphere {
    double latitude_deg = 0.0;  ///< north positive
    double january = 0.0;       ///< means of temperature or sums of radiation, the same unit
    double july = 0.0;
    double clear = 0.0;      ///< difference that leaves no doubt, same unit
    double from_deg = 20.0;  ///< nearer to the equator rain makes the seasons
};

/// Whether the seasons contradict the latitude: a warm January north of the equator or a warm July south of
/// it.
bool seasons_contradict(const Hemisphere& at);

/// Of temperatures: 3 K leave no doubt [choice].
Hemisphere hemisphere_of(const ClimateAt& climate);

/// The species are trees of Europe, between 30 and 70 degrees north; a latitude outside looks like a slip
/// [choice].
bool is_far_from_species(double latitude_deg);

/// Mean of the months [-].
double mean_factor_on_rain(const forest::ClimateChange& change);
/// Below 0.5 or above 1.5 it looks like a change in percent or a difference [choice].
bool is_odd_factor_on_rain(double factor);

}  // namespace coupling::plausible
