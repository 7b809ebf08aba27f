#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "config/geometry/shape.hpp"
#include "coupling/assessments/decades/members/management.hpp"
#include "coupling/exchange/regimes/planned_years.hpp"
#include "coupling/inputs/forest/forest_site.hpp"
#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/tables/table_layout.hpp"

namespace coupling::decades {

/// A piece of ground on which an intervention acts, as it is known before the run.
struct InterventionArea {
    std::size_t regime = 0;           ///< place in Management::regimes
    std::size_t intervention = 0;     ///< row of it
    std::uint32_t number = 0;         ///< of the strip, slit, polygon, corridor or stand
    int turn = 1;                     ///< of the entries that take turns, from 1
    std::optional<int> first_year{};  ///< of the run; nothing where conditions or earlier rows decide
    PlannedYears planned{};           ///< years of the run in which it has its turn
    double area_ha = 0.0;             ///< of forest on it
    bool at_the_start = false;        ///< a hole of a group cut where the forest of the start is ripest
    config::Shape shape;              ///< polygon; of a corridor a piece
};

/// All areas of all regimes, in their order. Slits, strips, polygons and corridors have their exact shape,
/// the whole forest and stands that of their patches. Where a group cut lies is decided by the forest of its
/// year: its holes are those that the forest of the start (first replicate) would get. The cuts on which
/// another row acts (where = cuts_of) are those of that row, and not repeated.
std::vector<InterventionArea> intervention_areas(const Management& management, const ForestSite& forest,
                                                 std::uint64_t seed);

/// The outline of patches as closed rings: outer ones and holes alike.
config::Shape outline_of(const forest::PatchGrid& grid, std::span<const forest::PatchId> patches);

/// The rings of a shape as MULTIPOLYGON; a ring within another is a hole of it.
std::string wkt_of(const config::Shape& shape);

TableLayout intervention_areas_layout();

/// Writes tables/intervention_areas.csv with the shapes as well-known text; nothing where no row has an area.
/// `start_calendar_year` is that of year 0 of the run.
std::vector<WrittenFile> write_intervention_areas(const std::filesystem::path& folder,
                                                  const Management& management,
                                                  std::span<const InterventionArea> areas,
                                                  int start_calendar_year);

}  // namespace coupling::decades
