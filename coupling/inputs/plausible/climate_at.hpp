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

/// Requires a series that knows its elevation.
ClimateAt climate_at(const forest::ClimateSeries& series, double latitude_deg, double elevation_m,
                     const forest::LapseRates& rates);

/// What places of a latitude usually have: 30 degC - 0.4 K a degree at the sea, 5.5 K/km upwards [choice];
/// from 30 to 60 degrees Europe lies within 4 K of it.
double usual_mean_degc(double latitude_deg, double elevation_m);

/// More than 9 K from it [choice]: an elevation in feet, or a series of another place.
bool is_of_another_place(const ClimateAt& climate);

/// Whether January is warmer than July by more than 3 K, from 20 degrees of latitude on. Requires a latitude
/// north of the equator.
bool has_seasons_of_other_half(const ClimateAt& climate);

/// The species are trees of Europe, between 30 and 70 degrees north; a latitude outside looks like a slip
/// [choice].
bool is_far_from_species(double latitude_deg);

/// Mean of the months [-].
double mean_factor_on_rain(const forest::ClimateChange& change);
/// Below 0.5 or above 1.5 it looks like a change in percent or a difference [choice].
bool is_odd_factor_on_rain(double factor);

}  // namespace coupling::plausible
