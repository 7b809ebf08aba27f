#include "coupling/inputs/forest/stand_input.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/plausible/beyond_terrain.hpp"
#include "coupling/inputs/plausible/cut_command.hpp"
#include "coupling/inputs/plausible/odd_trees.hpp"
#include "coupling/inputs/reading/declared_tables.hpp"
#include "coupling/inputs/scenario/forest_settings.hpp"
#include "forest/stand/allometry.hpp"
#include "forest/start/height_curve.hpp"

namespace coupling {

struct StandPolygonRow {
    std::uint32_t stand = 0;
    config::Shape shape;
};

struct StandRecordRow : forest::SpeciesRecord {
    std::uint32_t stand = 0;
    forest::Structure structure = forest::Structure::even_aged;
};

namespace {

using config::ExitCode;
using config::joined;
using forest::Structure;

constexpr double highest_stand = 4e9;
constexpr double largest_contradiction = 0.1;

void check_numbers(const config::Raster<double>& map, const std::string& file) {
    for (std::size_t cell = 0; cell < map.values.size(); ++cell) {
        const double number = map.values[cell];
        if (!std::isnan(number) && (number < 0.0 || number > highest_stand || std::floor(number) != number)) {
            config::fail(
                ExitCode::data, {file},
                joined("stand number ", config::to_text(number), " in ", cell_in_words(map.frame, cell)),
                "whole numbers, 0 where there is no forest",
                "correct the map, such as by rounding it (gdal_calc, raster calculator)");
        }
    }
}

StandCover read_map(Reading& reading) {
    const ForestSettings& s = reading.forest();
    StandCover cover;
    if (!s.stand_map.empty()) {
        cover.file = reading.shown(s.stand_map);
        cover.map = reading.grid("stands.map", "stands", s.stand_map);
        check_numbers(*cover.map, cover.file);
        return cover;
    }
    if (s.stand_polygons.empty()) {
        cover.is_chosen = s.stand_number > 0;
        cover.everywhere = cover.is_chosen ? static_cast<std::uint32_t>(s.stand_number) : 1;
        return cover;
    }
    cover.file = reading.shown(s.stand_polygons);
    for (config::Read<StandPolygonRow>& row : rows_of(stand_polygon_columns(), s.stand_polygons, reading)) {
        cover.areas.push_back({std::move(row.shape), static_cast<double>(row.stand)});
    }
    return cover;
}

/// The numbers that the map has, without 0.
std::set<std::uint32_t> numbers_of(const StandCover& cover) {
    std::set<std::uint32_t> numbers;
    numbers.insert(cover.everywhere);
    for (const config::CodedPolygon& area : cover.areas) {
        numbers.insert(static_cast<std::uint32_t>(area.code));
    }
    if (cover.map) {
        for (const double number : cover.map->values) {
            if (!std::isnan(number)) {
                numbers.insert(static_cast<std::uint32_t>(number));
            }
        }
    }
    numbers.erase(0);
    return numbers;
}

std::string contradiction_in(const forest::SpeciesRecord& record) {
    if (!record.stems_pha || !record.basal_area_m2pha || !record.mean_dbh_cm) {
        return "";
    }
    const double follows_m2pha = *record.stems_pha * forest::basal_area_m2(*record.mean_dbh_cm);
    if (std::abs(follows_m2pha - *record.basal_area_m2pha) <=
        largest_contradiction * std::max(follows_m2pha, *record.basal_area_m2pha)) {
        return "";
    }
    return joined("stems_pha ", config::to_text(*record.stems_pha), " with mean_dbh_cm ",
                  config::to_text(*record.mean_dbh_cm), " make ",
                  config::to_text(std::round(10.0 * follows_m2pha) / 10.0), " m2/ha, not basal_area_m2pha ",
                  config::to_text(*record.basal_area_m2pha));
}

/// Puts the rows of records into stands.
class RecordReader {
public:
    RecordReader(const config::Table& table, const ForestSpecies& species)
        : table_{table}, species_{species}, wrong_{table} {}

    std::map<std::uint32_t, InventoriedStand> all(Reading& reading) {
        const SpeciesColumn column{table_, species_.lookup(), wrong_};
        for (config::Read<StandRecordRow>& row : stand_record_columns().rows(table_, wrong_)) {
            const auto species = column.find(row.row);
            row.species = forest::SpeciesId{static_cast<std::uint16_t>(species.value_or(0))};
            if (species && is_count(row.row) && is_sound(row, row.row)) {
                enter(row);
            }
        }
        wrong_.throw_first();
        warn_of_stand_ins(column, species_, table_.file(), reading);
        return std::move(stands_);
    }

private:
    /// stems_pha is a count in all but name: 1.200 may be one stem or more than a thousand. 412.345 is no
    /// thousands: no forest has as many stems.
    bool is_count(std::size_t row) {
        const auto plain = table_.has("stems_pha") ? config::without_separators(table_.text(row, "stems_pha"))
                                                   : std::nullopt;
        if (!plain || config::parse_number(*plain).value_or(0.0) >= 1e5) {
            return true;
        }
        return refuse(row, "stems_pha",
                      joined("stems_pha ", config::in_quotes(table_.text(row, "stems_pha"))),
                      "a number without separators of thousands",
                      joined("write ", *plain, ", or with fewer decimals if the point is one"));
    }

    bool refuse(std::size_t row, const char* column, std::string found, std::string expected,
                std::string advice) {
        wrong_.refuse(row, column, std::move(found), std::move(expected), std::move(advice));
        return false;
    }

    bool is_sound(const forest::SpeciesRecord& record, std::size_t row) {
        const std::string missing = forest::missing_in(record);
        const std::string contradiction = contradiction_in(record);
        if (!missing.empty() || !contradiction.empty()) {
            return refuse(
                row, "stand", missing.empty() ? contradiction : missing,
                missing.empty() ? "two of the three, or three that agree within 10 %"
                                : "two of stems_pha, basal_area_m2pha and mean_dbh_cm",
                missing.empty() ? "correct one of them, or leave it empty" : "add what was measured");
        }
        const forest::Species& kind = species_.table[record.species];
        const double dbh_cm = mean_dbh_cm(record);
        const bool has_trees = dbh_cm > 0.0;
        const double basal_area_m2pha = record.basal_area_m2pha
                                            ? *record.basal_area_m2pha
                                            : *record.stems_pha * forest::basal_area_m2(dbh_cm);
        if (basal_area_m2pha > 200.0) {
            return refuse(row, "stand",
                          joined("stems and mean diameter that make ",
                                 config::to_text(std::round(basal_area_m2pha)), " m2/ha"),
                          "at most 200 m2/ha", "check the units: stems per hectare, diameters in cm");
        }
        if (has_trees && (dbh_cm < forest::smallest_tree_cm || dbh_cm >= kind.height_growth.max_dbh_cm)) {
            return refuse(
                row, "stand",
                joined("a mean diameter of ", config::to_text(std::round(10.0 * dbh_cm) / 10.0), " cm"),
                joined("at least 1 cm and less than the greatest of ", kind.latin_name, ", ",
                       config::to_text(kind.height_growth.max_dbh_cm), " cm"),
                "check the unit (cm) and the species");
        }
        const double greatest_m = forest::greatest_recorded_height_m(kind.height_growth);
        if (record.mean_height_m.value_or(0.0) > greatest_m) {
            return refuse(row, "mean_height_m",
                          joined("mean_height_m ", config::to_text(*record.mean_height_m)),
                          joined("at most the greatest height of ", kind.latin_name, ", ",
                                 config::to_text(greatest_m), " m"),
                          "check the unit (m) and the species");
        }
        return true;
    }

    void enter(const config::Read<StandRecordRow>& row) {
        const auto [stand, is_new] = stands_.try_emplace(row.stand);
        if (is_new) {
            stand->second.structure = row.structure;
            stand->second.place = table_.place(row.row, "stand");
        } else if (stand->second.structure != row.structure) {
            refuse(row.row, "structure",
                   joined("another structure of stand ", std::to_string(row.stand), " than in its first row"),
                   "one structure for each stand", "write the same in all rows of the stand");
        }
        stand->second.species.push_back(row);
    }

    const config::Table& table_;
    const ForestSpecies& species_;
    config::RowProblems wrong_;
    std::map<std::uint32_t, InventoriedStand> stands_;
};

void doubt_odd_means(const config::Table& table, Reading& reading) {
    const std::vector<std::size_t> lines = plausible::odd_mean_trees(table);
    if (!lines.empty()) {
        reading.warn({table.file(), lines.front()},
                     joined(counted(lines.size(), "stand record"),
                            " with a mean tree that is less than 15 or more than 100 (thin trees: 120) "
                            "times as high as thick"),
                     "mean trees 40 to 100 times as high as thick, thin ones up to 120",
                     "check mean_dbh_cm (cm) and mean_height_m (m): are the columns swapped?");
    }
}

}  // namespace

double mean_dbh_cm(const forest::SpeciesRecord& record) {
    if (record.stems_pha && record.basal_area_m2pha) {
        return *record.stems_pha > 0.0
                   ? std::sqrt(*record.basal_area_m2pha / *record.stems_pha / forest::basal_area_m2(1.0))
                   : 0.0;
    }
    return *record.mean_dbh_cm;
}

const config::Schema<StandPolygonRow>& stand_polygon_columns() {
    // clang-format off
    static const config::Schema<StandPolygonRow> columns{
        {.role = "stands", .setting = "stands.polygons", .row = "stand"},
        {{"stand", &StandPolygonRow::stand, "its number; 0: no forest", {.range = {0.0, stand_numbers.high}}},
         {"wkt", &StandPolygonRow::shape, "its area; later rows lie on top", {.shapes = {config::Shape::Kind::polygon}}}}};
    // clang-format on
    return columns;
}

const config::Schema<StandRecordRow>& stand_record_columns() {
    using config::above;
    using R = StandRecordRow;
    // clang-format off
    static const config::Schema<R> columns{
        {.role = "stand_records", .setting = "stands.records", .row = "species of a stand"},
        {{"stand", &R::stand, "its number on the map", {.range = stand_numbers}},
         {"species", "code or name"},
         {"stems_pha", &R::stems_pha, "two of this and the next two", {.range = {0.0, 1e6}}},
         {"basal_area_m2pha", &R::basal_area_m2pha, "of the species", {.range = {0.0, 200.0}}},
         {"mean_dbh_cm", &R::mean_dbh_cm, "quadratic mean", {.range = {forest::smallest_tree_cm, 500.0}}},
         {"mean_height_m", &R::mean_height_m, "of the mean tree", {.range = {1.5, 100.0, above}}},
         {"age_years", &R::age_years, "mean", {.range = {0.0, 2000.0}}},
         {"structure", &R::structure, "the same in all rows of a stand; empty: even_aged", {.optional = true, .words = {"even_aged", "two_layered", "plenter", "groups"}, .advice = "write one of them, or leave the field empty for even_aged"}}}};
    // clang-format on
    return columns;
}

std::uint32_t StandCover::at(double x_m, double y_m) const {
    if (everywhere > 0) {
        return everywhere;
    }
    if (map) {
        const config::Cell cell = map->frame.cell_at(x_m, y_m);
        const double number = map->frame.contains(cell) ? map->at(cell) : 0.0;
        return std::isnan(number) ? 0 : static_cast<std::uint32_t>(number);
    }
    const auto on_top = std::find_if(areas.rbegin(), areas.rend(), [&](const config::CodedPolygon& area) {
        return config::point_in_polygon(area.polygon, {x_m, y_m});
    });
    return on_top == areas.rend() ? 0 : static_cast<std::uint32_t>(on_top->code);
}

std::optional<StandCover> read_stand_cover(Reading& reading) {
    return reading.attempt([&] { return read_map(reading); });
}

std::optional<StandCover> cover_on_heights(std::optional<StandCover> cover, const config::GridFrame& heights,
                                           Reading& reading) {
    if (!cover || cover->areas.empty()) {
        return cover;
    }
    const std::string& setting = reading.forest().stand_polygons;
    std::vector<std::string> names;
    for (const config::CodedPolygon& area : cover->areas) {
        names.push_back(config::to_text(area.code));
    }
    cover->beyond = numbers_of(*cover);
    const std::size_t problems_before = reading.problems().list().size();
    const plausible::Extent extent = plausible::extent_of(heights);
    plausible::take_out_areas_beyond(cover->areas, std::move(names),
                                     {{cover->file},
                                      "stand",
                                      {},
                                      "stands on the terrain",
                                      "exchange x and y in the shapes",
                                      plausible::cut_command(reading, "stands", setting, extent)},
                                     extent, reading);
    for (const std::uint32_t number : numbers_of(*cover)) {
        cover->beyond.erase(number);
    }
    return reading.problems().list().size() > problems_before ? std::nullopt : cover;
}

std::optional<std::map<std::uint32_t, InventoriedStand>> read_records(const ForestSpecies& species,
                                                                      Reading& reading) {
    const std::string& name = reading.forest().stand_records;
    return reading.attempt([&] {
        const config::Table table = table_of(stand_record_columns(), name, reading);
        doubt_odd_means(table, reading);
        return RecordReader{table, species}.all(reading);
    });
}

std::vector<forest::StandRecord> place_records(std::map<std::uint32_t, InventoriedStand> records,
                                               const forest::PatchGrid& grid, const StandCover& cover,
                                               Reading& reading) {
    const ForestSettings& settings = reading.forest();
    const std::string file =
        reading.shown(settings.stand_records.empty() ? settings.dbh_classes : settings.stand_records);
    const std::set<std::uint32_t> on_map = numbers_of(cover);
    bool is_missing = cover.file.empty();  // without a map any other stand is a mistake
    for (const std::uint32_t number : on_map) {
        if (!records.contains(number)) {
            is_missing = true;
            reading.refuse({file}, joined("no record of stand ", std::to_string(number)),
                           "one for each stand of the map; stems_pha 0 where there are no trees");
        }
    }
    std::map<std::uint32_t, forest::StandRecord> stands;
    for (std::uint32_t i = 0; i < grid.size(); ++i) {
        stands[grid.patches()[i].management_unit].patches.push_back(forest::PatchId{i});
    }
    std::vector<forest::StandRecord> placed;
    StandsOffTheMap off;
    for (auto& [number, record] : records) {
        if (!on_map.contains(number)) {
            if (cover.is_chosen || cover.beyond.contains(number)) {
                continue;  // another stand of the table, or one that is noted already
            }
            if (is_missing) {
                reading.refuse(record.place,
                               joined("stand ", std::to_string(number), " which is not on the map"),
                               cover.file.empty() ? "stand 1, as there is no map of stands"
                                                  : joined("a stand of ", cover.file));
            } else {
                off.leave_out(number, record.place);
            }
        } else if (const auto stand = stands.find(number); stand != stands.end()) {
            stand->second.species = std::move(record.species);
            stand->second.structure = record.structure;
            placed.push_back(std::move(stand->second));
        }
    }
    off.report(file, records.size(), reading);
    return placed;
}

void StandsOffTheMap::leave_out(std::uint32_t stand, config::Place at) {
    stands_.try_emplace(stand, std::move(at));
}

void StandsOffTheMap::report(const std::string& file, std::size_t used, Reading& reading) const {
    if (stands_.empty()) {
        return;
    }
    const auto& [first, place] = *stands_.begin();
    if (used == 0) {
        reading.refuse(place, joined("stand ", std::to_string(first), " which has no forest cell"),
                       "a stand of the map, or all");
    } else {
        reading.note(joined(file, ": ", counted(stands_.size(), "stand"),
                            " without forest on the map left out, such as stand ", std::to_string(first)));
    }
}

namespace {

/// The share of the cells with a stand that lie on no patch [0, 1]; 0 without a map.
double share_without_patch(const StandCover& cover, const forest::PatchGrid& grid) {
    std::size_t cells = 0;
    std::size_t without = 0;
    for (std::size_t i = 0; cover.map && i < cover.map->values.size(); ++i) {
        if (cover.map->values[i] > 0.0) {
            const config::GridFrame& frame = cover.map->frame;
            const config::Cell cell = frame.cell_of(i);
            ++cells;
            without += grid.at(frame.x_centre_m(cell.column), frame.y_centre_m(cell.row)) ? 0U : 1U;
        }
    }
    return cells == 0 ? 0.0 : static_cast<double>(without) / static_cast<double>(cells);
}

}  // namespace

void warn_of_stands_without_patch(const StandCover& cover, const forest::PatchGrid& grid, Reading& reading) {
    constexpr double many = 0.2;  // [choice]; a rim of some cells is usual
    const double lost = share_without_patch(cover, grid);
    if (lost > many) {
        reading.warn({cover.file},
                     joined(std::to_string(std::lround(100.0 * lost)),
                            " % of the area of the stands without a forest cell on the terrain"),
                     "stands on the terrain that hold the centre of a cell of 10 m");
    }
    std::set<std::uint32_t> without = numbers_of(cover);
    for (const forest::Patch& patch : grid.patches()) {
        without.erase(patch.management_unit);
    }
    if (!without.empty()) {
        reading.warn(
            {cover.file},
            joined(counted(without.size(), "stand"), " without a forest cell on the terrain, such as ",
                   std::to_string(*without.begin())),
            "stands on the terrain that hold the centre of a cell of 10 m");
    }
}

}  // namespace coupling
