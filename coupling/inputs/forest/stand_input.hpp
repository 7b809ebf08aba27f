#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "config/geometry/shape.hpp"
#include "config/table/schema.hpp"
#include "coupling/inputs/forest/forest_species.hpp"
#include "coupling/inputs/reading/reading.hpp"
#include "forest/start/starting_stand.hpp"

namespace coupling {

/// Which stand grows where, as read: a grid, or polygons of which later ones lie on top, or one
/// stand everywhere.
struct StandCover {
    std::optional<config::Raster<double>> map;
    std::vector<config::CodedPolygon> areas;
    std::uint32_t everywhere = 0;      ///< above 0: this stand, without a map
    bool is_chosen = false;            ///< by stands.number, among those of the records
    std::string file;                  ///< in messages
    std::set<std::uint32_t> beyond{};  ///< stands of polygons that all lie beyond the terrain

    /// Number of the stand at a place; 0: no forest.
    [[nodiscard]] std::uint32_t at(double x_m, double y_m) const;
};

/// Numbers of stands in tables.
inline constexpr config::NumberRange stand_numbers{1.0, 4e9};

/// Stands of a table that have no forest on the map: a table of a district serves for one slope of it.
class StandsOffTheMap {
public:
    /// `at`: of the row.
    void leave_out(std::uint32_t stand, config::Place at);
    /// Says how many stands of `file` were left out. Where no row is left (`used` is 0) the first is refused.
    void report(const std::string& file, std::size_t used, Reading& reading) const;

private:
    std::map<std::uint32_t, config::Place> stands_;  ///< with their first rows
};

/// The stand of a row, 0 for `all`; nothing for one that is none of those with forest, `known`.
template <class Known>
std::optional<std::uint32_t> stand_called(const std::string& text, std::size_t row, const Known& known,
                                          const config::Table& table, config::RowProblems& wrong,
                                          StandsOffTheMap& off) {
    if (text == "all") {
        return 0;
    }
    const auto number =
        static_cast<std::uint32_t>(table.whole(row, "stand", stand_numbers, wrong).value_or(0));
    if (number > 0 && !known.contains(number)) {
        off.leave_out(number, table.place(row, "stand"));
        return std::nullopt;
    }
    return number;
}

struct StandPolygonRow;
struct StandRecordRow;
const config::Schema<StandPolygonRow>& stand_polygon_columns();
const config::Schema<StandRecordRow>& stand_record_columns();

std::optional<StandCover> read_stand_cover(Reading& reading);

/// The cover without the polygons beyond the heights, which are noted; nothing where all lie beyond them,
/// which is refused.
std::optional<StandCover> cover_on_heights(std::optional<StandCover> cover, const config::GridFrame& heights,
                                           Reading& reading);

/// A stand of an inventory, without its place.
struct InventoriedStand {
    std::vector<forest::SpeciesRecord> species;
    forest::Structure structure = forest::Structure::even_aged;
    config::Place place;  ///< of its first row
};

/// The mean diameter that a complete record (forest::missing_in) has or that follows from it; 0 without
/// stems.
double mean_dbh_cm(const forest::SpeciesRecord& record);

/// The records by stand number. Refuses rows that lack or contradict something: stems, basal area and mean
/// diameter that differ by more than 10 % [choice].
std::optional<std::map<std::uint32_t, InventoriedStand>> read_records(const ForestSpecies& species,
                                                                      Reading& reading);

/// Gives each record the patches of its stand. Refuses stands without a record, and then records without a
/// stand on the map, too; else these are left out with a note.
std::vector<forest::StandRecord> place_records(std::map<std::uint32_t, InventoriedStand> records,
                                               const forest::PatchGrid& grid, const StandCover& cover,
                                               Reading& reading);

/// Tells of stands on the map that have no patch.
void warn_of_stands_without_patch(const StandCover& cover, const forest::PatchGrid& grid, Reading& reading);

}  // namespace coupling
