#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "config/geometry/shape.hpp"
#include "config/table/schema.hpp"
#include "config/table/table.hpp"
#include "coupling/inputs/reading/reading.hpp"

namespace coupling {

/// What a row of trees.species_areas says.
struct SpeciesAreaRow {
    std::string species;
    config::Shape shape;
};
const config::Schema<SpeciesAreaRow>& species_area_columns();

/// The key of what is drawn for a tree at a place: by mm, so that places 16.8 km apart share numbers.
std::uint64_t key_of_place(double x_m, double y_m);

/// What a message expects instead of a name that is no species; "" for a species.
using ExpectedSpecies = std::function<std::string(const std::string& name)>;

/// The species of each row of a list that has none: drawn by the shares of trees.species_areas where an area
/// lies over the tree, the last one of several, and by those of trees.species elsewhere. Empty where neither
/// says anything. The place of a tree in mm keys its draw, so that it keeps its species whatever else the
/// list holds. Shares and names that are none throw InputError.
///
/// Requires x_m and y_m.
std::vector<std::string> species_of_tops(const config::Table& table, Reading& reading,
                                         const ExpectedSpecies& expected_instead);

}  // namespace coupling
