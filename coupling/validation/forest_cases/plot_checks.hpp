#pragma once

#include <string>
#include <vector>

#include "config/errors/warnings.hpp"
#include "config/table/table.hpp"

namespace coupling::validation::forest_cases {

/// A rectangle from 0 to these sides [m].
struct PlotSides {
    double x_m = 0.0;
    double y_m = 0.0;
};

/// Adds warnings for rows of a table with x_m and y_m that share a place with an earlier row, and, from
/// twenty rows on, for a plot that reaches a quarter of its side or more beyond the outermost of them.
/// `what` is one of the rows ("tree"), `sides_file` the table with the sides. Requires numbers in both
/// columns.
void warn_of_places(const config::Table& table, const std::string& what, PlotSides sides,
                    const std::string& sides_file, config::Warnings& warnings);

/// What a year of a place looks like to tell its half of the earth.
struct Hemisphere {
    double latitude_deg = 0.0;  ///< north positive
    double january = 0.0;       ///< means of temperature or sums of radiation, the same unit
    double july = 0.0;
    double clear = 0.0;  ///< difference that leaves no doubt, same unit
};

/// Whether the seasons contradict the latitude: a warm January north of the equator or a warm July south of
/// it, from 20 degrees on.
bool seasons_contradict(const Hemisphere& at);

/// Adds a problem at `latitude` where the seasons of `series_file` contradict it.
void check_hemisphere(const Hemisphere& at, const config::Place& latitude, const std::string& column,
                      const std::string& series_file, config::Problems& problems);

}  // namespace coupling::validation::forest_cases
