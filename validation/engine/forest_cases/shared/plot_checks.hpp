#pragma once

#include <string>

#include "config/errors/warnings.hpp"
#include "config/table/table.hpp"
#include "coupling/inputs/plausible/climate_at.hpp"

namespace coupling::validation::forest_cases {

/// A rectangle from 0 to these sides [m].
struct PlotSides {
    double x_m = 0.0;
    double y_m = 0.0;
};

/// Adds a warning for rows of a table that share x_m and y_m with an earlier row. Requires numbers in both.
void warn_of_shared_places(const config::Table& table, config::Warnings& warnings);

/// Adds a warning for a plot of twenty trees or more that reaches a quarter of its side or more beyond the
/// outermost of them. `sides_file` is the table with the sides. Requires numbers in x_m and y_m.
void warn_of_empty_edges(const config::Table& trees, PlotSides sides, const std::string& sides_file,
                         config::Warnings& warnings);

/// Adds a problem at `latitude`, the place of `field` ("latitude_deg -47.5"), where the seasons of
/// `series_file` contradict it.
void check_hemisphere(const plausible::Hemisphere& at, const config::Place& latitude,
                      const std::string& field, const std::string& series_file, config::Problems& problems);

}  // namespace coupling::validation::forest_cases
