#pragma once

#include <string>

#include "config/errors/warnings.hpp"
#include "config/table/table.hpp"

namespace coupling::validation::forest_cases {

/// Adds warnings about living trees of a plot that look like slips: single trees and swapped columns as
/// `bannwald run` doubts them (inputs/plausible/odd_trees.hpp), more than 100 m2/ha of basal area (girths),
/// and crowns that cover the plot more than 2.5 times (diameters for radii, or the base in their place)
/// [choice]. Reads dbh_cm, height_m and crown_radius_m where the table has them.
void warn_of_trees(const config::Table& trees, double area_ha, config::Warnings& warnings);

/// Adds a warning for a latitude outside 30 to 70 degrees. `place` says where it stands.
void warn_of_latitude(double latitude_deg, const config::Place& place, config::Warnings& warnings);

/// Adds a warning where a year has less than 1500 or more than 9000 MJ/m2 on level ground [choice]: daily
/// means, or another unit.
void warn_of_radiation(double yearly_mjpm2, const std::string& radiation_file, config::Warnings& warnings);

}  // namespace coupling::validation::forest_cases
