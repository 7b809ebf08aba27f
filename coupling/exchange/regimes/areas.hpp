#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "config/errors/input_error.hpp"
#include "config/geometry/shape.hpp"
#include "config/table/table.hpp"
#include "coupling/exchange/regimes/intervention.hpp"
#include "forest/stand/patch.hpp"

namespace coupling {

/// The polygons or lines of a file that a regime names. Throws config::InputError.
using ShapesOf = std::function<std::vector<config::Shape>(const std::string& file, config::Shape::Kind kind)>;

/// The shapes of a kind in the column `wkt` of a table, in its order. Throws one InputError (data) for all
/// that are of another.
std::vector<config::Shape> shapes_in(const config::Table& table, config::Shape::Kind kind);

/// A piece of forest that is treated as one.
struct Area {
    std::uint32_t number = 0;  ///< of the strip, slit, polygon from 0, or of the management unit
    int order = 0;             ///< area `order` has its turn in entry `order` % entries
    forest::TreatmentArea place{};
    double area_ha = 0.0;                    ///< > 0, of forest on it
    std::vector<forest::PatchId> patches{};  ///< whose middles lie on it, rising
    friend bool operator==(const Area&, const Area&) = default;
};

/// The areas of a ground in a forest; those without forest are left out. Adds a problem at `place` for stands
/// that are not in the stand map, slits that lie on each other, polygons that cannot be had, and where
/// nothing is left. The cuts of another row are not known before they are made: no area, no problem.
std::vector<Area> areas_of(const Ground& ground, const forest::PatchGrid& grid, const ShapesOf& shapes_of,
                           const config::Place& place, config::Problems& problems);

}  // namespace coupling
