#include "coupling/inputs/forest/stand_input.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/places/shape_input.hpp"
#include "coupling/inputs/plausible/odd_trees.hpp"
#include "coupling/inputs/reading/passed_over_columns.hpp"
#include "forest/stand/allometry.hpp"
#include "forest/start/height_curve.hpp"

namespace coupling {
namespace {

using config::ExitCode;
using config::joined;
using forest::Structure;

constexpr double highest_stand = 4e9;
constexpr double largest_contradiction = 0.1;

constexpr std::array<std::pair<std::string_view, Structure>, 4> structures{
    {{"even_aged", Structure::even_aged},
     {"two_layered", Structure::two_layered},
     {"plenter", Structure::plenter},
     {"groups", Structure::groups}}};

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
    const ForestSettings& s = reading.scenario().forest;
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
    const config::Table table = reading.table("stands.polygons", "stands", s.stand_polygons);
    cover.file = table.file();
    config::Problems problems;
    table.require({"stand", "wkt"}, problems);
    problems.throw_if_any();
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const auto stand = table.whole(row, "stand", {0.0, highest_stand}, problems);
        auto shape = shape_of(table, row, {config::Shape::Kind::polygon}, problems);
        if (stand && shape) {
            cover.areas.push_back({std::move(*shape), static_cast<double>(*stand)});
        }
    }
    config::Problems shown;
    add_first(shown, problems, table.file());
    shown.throw_if_any();
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

/// The mean diameter that a complete record has or that follows from it; 0 without stems.
double mean_dbh_cm(const forest::SpeciesRecord& record) {
    if (record.stems_pha && record.basal_area_m2pha) {
        return *record.stems_pha > 0.0
                   ? std::sqrt(*record.basal_area_m2pha / *record.stems_pha / forest::basal_area_m2(1.0))
                   : 0.0;
    }
    return *record.mean_dbh_cm;
}

/// Reads the rows of records into stands.
class RecordReader {
public:
    RecordReader(const config::Table& table, const ForestSpecies& species, const SpeciesLookup& lookup)
        : table_{table}, species_{species}, column_{table, lookup} {}

    void read(std::size_t row) {
        const std::size_t before = problems_.list().size();
        const auto stand = table_.whole(row, "stand", {1.0, highest_stand}, problems_);
        const auto species = column_.find(row);
        forest::SpeciesRecord record;
        record.stems_pha = stems_pha(row);
        record.basal_area_m2pha = optional(row, "basal_area_m2pha", {0.0, 200.0});
        record.mean_dbh_cm = optional(row, "mean_dbh_cm", {forest::smallest_tree_cm, 500.0});
        record.mean_height_m =
            optional(row, "mean_height_m", {.low = 1.5, .high = 100.0, .low_excluded = true});
        record.age_years = optional(row, "age_years", {0.0, 2000.0});
        const Structure structure = structure_of(row);
        if (!stand || !species || problems_.list().size() > before) {
            return;
        }
        record.species = forest::SpeciesId{static_cast<std::uint16_t>(*species)};
        if (is_sound(record, row)) {
            enter(static_cast<std::uint32_t>(*stand), record, structure, row);
        }
    }

    std::map<std::uint32_t, InventoriedStand> finish(Reading& reading) {
        config::Problems shown;
        column_.refuse_unknown(shown);
        add_first(shown, problems_, table_.file());
        shown.throw_if_any();
        warn_of_stand_ins(column_, species_, table_.file(), reading);
        return std::move(stands_);
    }

private:
    /// A count in all but name: 1.200 may be one stem or more than a thousand. 412.345 is no thousands: no
    /// forest has as many stems.
    std::optional<double> stems_pha(std::size_t row) {
        const auto plain = table_.has("stems_pha") ? config::without_separators(table_.text(row, "stems_pha"))
                                                   : std::nullopt;
        if (plain && config::parse_number(*plain).value_or(0.0) < 1e5) {
            problems_.add(ExitCode::data, table_.place(row, "stems_pha"),
                          joined("stems_pha ", config::in_quotes(table_.text(row, "stems_pha"))),
                          "a number without separators of thousands",
                          joined("write ", *plain, ", or with fewer decimals if the point is one"));
            return std::nullopt;
        }
        return optional(row, "stems_pha", {0.0, 1e6});
    }

    std::optional<double> optional(std::size_t row, const std::string& column,
                                   const config::NumberRange& range) {
        return table_.has(column) && !table_.text(row, column).empty()
                   ? table_.number(row, column, range, problems_)
                   : std::nullopt;
    }

    Structure structure_of(std::size_t row) {
        const std::string word = table_.has("structure") ? table_.text(row, "structure") : "";
        const auto found = std::find_if(structures.begin(), structures.end(),
                                        [&](const auto& entry) { return entry.first == word; });
        if (found == structures.end() && !word.empty()) {
            problems_.add(ExitCode::data, table_.place(row, "structure"),
                          joined("structure ", config::in_quotes(word)),
                          "even_aged, two_layered, plenter or groups",
                          "write one of them, or leave the field empty for even_aged");
        }
        return found == structures.end() ? Structure::even_aged : found->second;
    }

    bool is_sound(const forest::SpeciesRecord& record, std::size_t row) {
        const std::string missing = forest::missing_in(record);
        const std::string contradiction = contradiction_in(record);
        if (!missing.empty() || !contradiction.empty()) {
            problems_.add(
                ExitCode::data, table_.place(row, "stand"), missing.empty() ? contradiction : missing,
                missing.empty() ? "two of the three, or three that agree within 10 %"
                                : "two of stems_pha, basal_area_m2pha and mean_dbh_cm",
                missing.empty() ? "correct one of them, or leave it empty" : "add what was measured");
            return false;
        }
        const forest::Species& kind = species_.table[record.species];
        const double dbh_cm = mean_dbh_cm(record);
        const bool has_trees = dbh_cm > 0.0;
        const double basal_area_m2pha = record.basal_area_m2pha
                                            ? *record.basal_area_m2pha
                                            : *record.stems_pha * forest::basal_area_m2(dbh_cm);
        if (basal_area_m2pha > 200.0) {
            problems_.add(ExitCode::data, table_.place(row, "stand"),
                          joined("stems and mean diameter that make ",
                                 config::to_text(std::round(basal_area_m2pha)), " m2/ha"),
                          "at most 200 m2/ha", "check the units: stems per hectare, diameters in cm");
            return false;
        }
        if (has_trees && (dbh_cm < forest::smallest_tree_cm || dbh_cm >= kind.height_growth.max_dbh_cm)) {
            problems_.add(
                ExitCode::data, table_.place(row, "stand"),
                joined("a mean diameter of ", config::to_text(std::round(10.0 * dbh_cm) / 10.0), " cm"),
                joined("at least 1 cm and less than the greatest of ", kind.latin_name, ", ",
                       config::to_text(kind.height_growth.max_dbh_cm), " cm"),
                "check the unit (cm) and the species");
            return false;
        }
        const double greatest_m = forest::greatest_recorded_height_m(kind.height_growth);
        if (record.mean_height_m.value_or(0.0) > greatest_m) {
            problems_.add(ExitCode::data, table_.place(row, "mean_height_m"),
                          joined("mean_height_m ", config::to_text(*record.mean_height_m)),
                          joined("at most the greatest height of ", kind.latin_name, ", ",
                                 config::to_text(greatest_m), " m"),
                          "check the unit (m) and the species");
            return false;
        }
        return true;
    }

    void enter(std::uint32_t number, const forest::SpeciesRecord& record, Structure structure,
               std::size_t row) {
        const auto [stand, is_new] = stands_.try_emplace(number);
        if (is_new) {
            stand->second.structure = structure;
            stand->second.place = table_.place(row, "stand");
        } else if (stand->second.structure != structure) {
            problems_.add(
                ExitCode::data, table_.place(row, "structure"),
                joined("another structure of stand ", std::to_string(number), " than in its first row"),
                "one structure for each stand", "write the same in all rows of the stand");
        }
        stand->second.species.push_back(record);
    }

    const config::Table& table_;
    const ForestSpecies& species_;
    SpeciesColumn column_;
    config::Problems problems_;
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

std::optional<std::map<std::uint32_t, InventoriedStand>> read_records(const ForestSpecies& species,
                                                                      Reading& reading) {
    const std::string& name = reading.scenario().forest.stand_records;
    return reading.attempt([&] {
        const config::Table table = reading.table("stands.records", "stand_records", name);
        config::Problems problems;
        table.require({"stand", "species"}, problems);
        problems.throw_if_any();
        warn_of_columns(table,
                        {"stand", "species", "stems_pha", "basal_area_m2pha", "mean_dbh_cm", "mean_height_m",
                         "age_years", "structure"},
                        reading);
        doubt_odd_means(table, reading);
        const SpeciesLookup lookup = species.lookup();
        RecordReader reader{table, species, lookup};
        for (std::size_t row = 0; row < table.rows(); ++row) {
            reader.read(row);
        }
        return reader.finish(reading);
    });
}

std::vector<forest::StandRecord> place_records(std::map<std::uint32_t, InventoriedStand> records,
                                               const forest::PatchGrid& grid, const StandCover& cover,
                                               Reading& reading) {
    const ForestSettings& settings = reading.scenario().forest;
    const std::string file =
        reading.shown(settings.stand_records.empty() ? settings.dbh_classes : settings.stand_records);
    const std::set<std::uint32_t> on_map = numbers_of(cover);
    for (const std::uint32_t number : on_map) {
        if (!records.contains(number)) {
            reading.refuse({file}, joined("no record of stand ", std::to_string(number)),
                           "one for each stand of the map; stems_pha 0 where there are no trees");
        }
    }
    std::map<std::uint32_t, forest::StandRecord> stands;
    for (std::uint32_t i = 0; i < grid.size(); ++i) {
        stands[grid.patches()[i].management_unit].patches.push_back(forest::PatchId{i});
    }
    std::vector<forest::StandRecord> placed;
    for (auto& [number, record] : records) {
        if (!on_map.contains(number)) {
            if (cover.is_chosen) {
                continue;  // another stand of the table
            }
            reading.refuse(record.place, joined("stand ", std::to_string(number), " which is not on the map"),
                           cover.file.empty() ? "stand 1, as there is no map of stands"
                                              : joined("a stand of ", cover.file));
        } else if (const auto stand = stands.find(number); stand != stands.end()) {
            stand->second.species = std::move(record.species);
            stand->second.structure = record.structure;
            placed.push_back(std::move(stand->second));
        }
    }
    return placed;
}

void warn_of_stands_without_patch(const StandCover& cover, const forest::PatchGrid& grid, Reading& reading) {
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
