#include "coupling/inputs/places/target_input.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <string>
#include <utility>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/files/file_bytes.hpp"
#include "coupling/inputs/places/exposure_checks.hpp"
#include "coupling/inputs/places/target_exposure.hpp"
#include "coupling/inputs/plausible/beyond_terrain.hpp"
#include "coupling/inputs/plausible/cut_command.hpp"
#include "coupling/inputs/plausible/odd_targets.hpp"
#include "coupling/inputs/plausible/off_terrain.hpp"
#include "coupling/inputs/plausible/share_on_terrain.hpp"
#include "coupling/inputs/reading/declared_tables.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/inputs/scenario/target_settings.hpp"

namespace coupling {

namespace {

using config::joined;

rockfall::Target target_of(const TargetRow& row) {
    rockfall::Target target;
    target.id = row.id;
    target.name = row.name.empty() ? row.id : row.name;
    target.is_area = row.shape.kind == config::Shape::Kind::polygon;
    target.is_hit_by_side = true;
    for (const auto& part : row.shape.parts) {
        std::vector<Eigen::Vector2d>& vertices = target.parts.emplace_back();
        for (const config::Point2& point : part) {
            vertices.emplace_back(point.x_m, point.y_m);
        }
    }
    return target;
}

constexpr const char* exposure_columns[]{"vehicles_per_day", "speed_kmph", "persons_per_vehicle",
                                         "vehicle_length_m", "persons",    "hours_per_day",
                                         "house_value"};

/// Where a file says who and what is at the targets, only ids, names and places belong to the falls: with
/// other traffic the same rocks hit.
void leave_exposure_out_of_hash(const config::Table& table, Reading& reading) {
    const auto is_there = [&](const char* column) { return table.has(column); };
    if (std::none_of(std::begin(exposure_columns), std::end(exposure_columns), is_there)) {
        return;
    }
    std::string text;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        text += joined(table.text(row, "target_id"), "\n",
                       table.has("name") ? table.text(row, "name") : std::string{}, "\n",
                       table.text(row, "wkt"), "\n");
    }
    reading.use_part_of("targets", "places and names", hash_text(text));
}

GivenTargets read_target_tables(Reading& reading) {
    GivenTargets given;
    std::vector<rockfall::Target>& targets = given.targets;
    std::vector<config::Place>& places = given.places;
    std::vector<ExposedHouse> houses;
    for (const NamedTable& name : tables_in(reading.targets().file)) {
        const config::Table table = table_of(target_list_columns(), name.name, reading, name.id_opening);
        leave_exposure_out_of_hash(table, reading);
        const std::size_t before = targets.size();
        config::RowProblems wrong{table};
        const std::vector<config::Read<TargetRow>> rows = target_list_columns().rows(table, wrong);
        for (const config::Read<TargetRow>& row : rows) {
            const bool is_taken =
                std::any_of(targets.begin(), targets.begin() + static_cast<std::ptrdiff_t>(before),
                            [&](const rockfall::Target& other) { return other.id == row.id; });
            if (is_taken) {
                wrong.refuse(
                    row.row, "target_id",
                    joined("target_id ", config::in_quotes(row.id), " of another file of targets too"),
                    "one target_id for each target", "change it in one of the files");
            }
            targets.push_back(target_of(row));
            places.push_back(table.place(row.row, "wkt"));
            given.is_exposed.push_back(row.is_road() || row.is_house());
            if (row.is_house() && row.shape.kind == config::Shape::Kind::polygon) {
                houses.push_back({row.id, row.shape, places.back()});
            }
        }
        wrong.throw_first();
        if (reading.scenario().risk.assess) {
            judge_exposure(table, rows, reading);
        }
        if (table.rows() == 0) {
            reading.warn({table.file()}, "no targets", "at least one, or no targets.file");
        }
    }
    if (reading.scenario().risk.assess) {
        judge_doubled_houses(houses, reading);
    }
    return given;
}

config::Shape outline_of(const rockfall::Target& target) {
    config::Shape shape{target.is_area ? config::Shape::Kind::polygon : config::Shape::Kind::line, {}};
    for (const auto& part : target.parts) {
        std::vector<config::Point2>& points = shape.parts.emplace_back();
        for (const Eigen::Vector2d& vertex : part) {
            points.push_back({vertex.x(), vertex.y()});
        }
    }
    return shape;
}

/// Warns of a target of which a part lies off the terrain. Requires one that touches it, in absolute
/// coordinates.
void judge_part_off_terrain(const rockfall::Target& target, const config::Shape& shape,
                            const rockfall::Terrain& terrain, int samples, Reading& reading) {
    constexpr double least = 0.001;  // of a long road that touches the terrain between two samples
    const double share = std::max(least, plausible::on_terrain(shape, terrain, samples).share);
    const std::vector<config::Point2> corners = plausible::corners_of(shape);
    // Where ground is missing inside the stated extent, too, that is no choice of the user.
    const auto is_missing = [&](const config::Point2& corner) {
        const Eigen::Vector2d origin_m = terrain.origin_m();
        return plausible::outside_of_stated_extent({&corner, 1}, reading) == 0 &&
               !terrain.locate(corner.x_m - origin_m.x(), corner.y_m - origin_m.y());
    };
    if (share < 1.0 && plausible::outside_of_stated_extent(corners, reading) > 0 &&
        std::none_of(corners.begin(), corners.end(), is_missing)) {
        reading.note(joined(shown_tables(reading.targets().file, reading), ": target ",
                            config::in_quotes(target.name), " with ",
                            plausible::percent_in_words(1.0 - share),
                            target.is_area ? " of its area" : " of its length",
                            " outside of terrain.extent_m: no rock is counted there"));
    } else if (share < 1.0) {
        reading.warn({shown_tables(reading.targets().file, reading)},
                     joined("target ", config::in_quotes(target.name), " with ",
                            plausible::percent_in_words(1.0 - share),
                            target.is_area ? " of its area" : " of its length", " off the terrain"),
                     "targets where rocks can be followed to",
                     "take a larger terrain if that part matters: no rock is counted there");
    }
}

}  // namespace

const config::Schema<TargetRow>& target_list_columns() {
    using config::Shape;
    // clang-format off
    static const config::Schema<TargetRow> columns{
        {.role = "targets", .setting = "targets.file", .row = "target"},
        {{"target_id", &TargetRow::id, "in results", {.unique = true}},
         {"name", &TargetRow::name, "on pages and maps; empty: target_id", {.optional = true}},
         {"wkt", &TargetRow::shape, "a line or an area", {.shapes = {Shape::Kind::line, Shape::Kind::polygon}}},
         {"vehicles_per_day", &TargetRow::vehicles_per_day, "of a road, for risk.assess: in both directions", {.range = {0.0, 1e6}}},
         {"speed_kmph", &TargetRow::speed_kmph, "of them", {.unit = "km/h", .range = {0.0, 400.0, config::above}}},
         {"persons_per_vehicle", &TargetRow::persons_per_vehicle, "on average", {.range = {0.0, 1000.0}}},
         {"vehicle_length_m", &TargetRow::vehicle_length_m, "empty: risk.vehicle_length_m", {.range = {0.0, 400.0, config::above}}},
         {"persons", &TargetRow::persons, "of a house, for risk.assess: who live or work there", {.range = {0.0, 1e6}}},
         {"hours_per_day", &TargetRow::hours_per_day, "that each of them is there", {.unit = "h", .range = {0.0, 24.0}}},
         {"house_value", &TargetRow::house_value, "of the house, in risk.currency", {.range = {0.0, 1e12}}}}};
    // clang-format on
    return columns;
}

namespace {

/// Refuses what does not go together in a row.
void check_exposure(const config::Read<TargetRow>& row, double vehicle_length_m, config::RowProblems& wrong) {
    const auto given = [](const std::optional<double>& field) { return field.has_value(); };
    if (row.is_road() && row.is_house()) {
        wrong.refuse(row.row, "persons", "persons or house_value of a target with vehicles_per_day",
                     "a road or a house", "give a parking place or a station a target of its own");
    }
    if (row.is_road() != given(row.speed_kmph) || row.is_road() != given(row.persons_per_vehicle)) {
        wrong.refuse(row.row, "vehicles_per_day",
                     "only a part of vehicles_per_day, speed_kmph and persons_per_vehicle",
                     "all three of a road, or none");
    }
    if (given(row.persons) != given(row.hours_per_day)) {
        wrong.refuse(row.row, "persons", "only one of persons and hours_per_day", "both, or none");
    }
    if (!row.is_road() && given(row.vehicle_length_m)) {
        wrong.refuse(row.row, "vehicle_length_m", "vehicle_length_m without vehicles_per_day",
                     "a road, or no such field");
    }
    if (!row.is_road() || !given(row.speed_kmph)) {
        return;
    }
    constexpr double m_per_km = 1000.0;
    constexpr double hours_of_a_day = 24.0;
    const double length_m = row.vehicle_length_m.value_or(vehicle_length_m);
    const double most = hours_of_a_day * m_per_km * *row.speed_kmph / length_m;
    if (*row.vehicles_per_day > most) {
        wrong.refuse(row.row, "vehicles_per_day",
                     joined("vehicles_per_day ", config::to_text(*row.vehicles_per_day)),
                     joined("at most ", config::to_text(std::floor(most)), ": so many vehicles of ",
                            config::to_text(length_m), " m pass bumper to bumper at ",
                            config::to_text(*row.speed_kmph), " km/h"));
    }
}

}  // namespace

std::vector<ExposedTarget> read_exposed_targets(Reading& reading, double vehicle_length_m) {
    std::vector<ExposedTarget> exposed;
    for (const NamedTable& name : tables_in(reading.targets().file)) {
        const config::Table table = table_of(target_list_columns(), name.name, reading, name.id_opening);
        config::RowProblems wrong{table};
        for (const config::Read<TargetRow>& row : target_list_columns().rows(table, wrong)) {
            check_exposure(row, vehicle_length_m, wrong);
            if (row.is_road() || row.is_house()) {
                exposed.push_back({row.id, row});
            }
        }
        wrong.throw_first();
    }
    if (exposed.empty()) {
        config::fail(config::ExitCode::data, {shown_tables(reading.targets().file, reading)},
                     "no target with vehicles_per_day, persons or house_value beside risk.assess",
                     "columns that say who and what is at a road or a house",
                     "`bannwald info inputs targets` lists them");
    }
    return exposed;
}

std::optional<GivenTargets> read_targets(Reading& reading) {
    if (reading.targets().file.empty()) {
        return GivenTargets{};
    }
    return reading.attempt([&] { return read_target_tables(reading); });
}

std::vector<rockfall::Target> on_terrain(GivenTargets given, const rockfall::Terrain& terrain,
                                         Reading& reading) {
    const std::string& file = reading.targets().file;
    const plausible::Extent extent = plausible::extent_of(terrain);
    plausible::ThingsOnTerrain things{{shown_tables(file, reading)},
                                      "target",
                                      {},
                                      "targets on the terrain: no rock can arrive elsewhere",
                                      "exchange x and y in the shapes",
                                      plausible::cut_command_of_first(reading, "targets", file, extent)};
    GivenTargets kept;
    std::vector<config::Shape> shapes;
    // A list may be that of a commune, and most of it far from this slope.
    constexpr double close_m = 100.0;  // [choice]
    const plausible::Extent near{extent.west_m - close_m, extent.east_m + close_m, extent.south_m - close_m,
                                 extent.north_m + close_m};
    std::vector<std::string> exposed_close_beyond;
    struct OfFile {
        std::size_t all = 0;
        std::size_t beyond = 0;
    };
    std::map<std::string, OfFile> files;
    for (std::size_t i = 0; i < given.targets.size(); ++i) {
        config::Shape shape = outline_of(given.targets[i]);
        const bool is_beyond = !plausible::touches_terrain(shape, terrain, extent);
        things.things.push_back({given.targets[i].id, plausible::corners_of(shape), is_beyond, things.place});
        OfFile& of_file = files[given.places[i].file];
        ++of_file.all;
        of_file.beyond += is_beyond ? 1U : 0U;
        const std::vector<config::Point2>& corners = things.things.back().corners;
        if (is_beyond && given.is_exposed[i] && near.overlaps(plausible::extent_of(corners)) &&
            plausible::outside_of_stated_extent(corners, reading) == 0) {
            exposed_close_beyond.push_back(given.targets[i].id);
        }
        if (!is_beyond) {
            kept.targets.push_back(std::move(given.targets[i]));
            kept.places.push_back(std::move(given.places[i]));
            shapes.push_back(std::move(shape));
        }
    }
    if (reading.scenario().risk.assess && !kept.targets.empty()) {
        judge_exposed_beyond(exposed_close_beyond, things.place, reading);
    }
    for (const auto& [name, of_file] : files) {
        if (of_file.beyond == of_file.all && !kept.targets.empty()) {
            reading.warn({name}, joined(counted(of_file.all, "target"), ", all of them beyond the terrain"),
                         "targets on the terrain in each file",
                         "check its coordinate system: nothing of this file is counted",
                         config::Effect::answer);
        }
    }
    const std::vector<std::size_t> slivers = plausible::slivers_of(kept.targets, kept.places, reading);
    for (auto sliver = slivers.rbegin(); sliver != slivers.rend(); ++sliver) {
        const auto place = static_cast<std::ptrdiff_t>(*sliver);
        kept.targets.erase(kept.targets.begin() + place);
        kept.places.erase(kept.places.begin() + place);
        shapes.erase(shapes.begin() + place);
    }
    plausible::judge_shapes_of_targets(kept.targets, kept.places, reading);
    const int samples = plausible::samples_a_side(kept.targets.size());
    for (std::size_t i = 0; i < kept.targets.size(); ++i) {
        rockfall::Target& target = kept.targets[i];
        judge_part_off_terrain(target, shapes[i], terrain, samples, reading);
        for (auto& part : target.parts) {
            for (Eigen::Vector2d& vertex : part) {
                vertex -= terrain.origin_m();
            }
        }
        target = rockfall::with_bounds(std::move(target));
    }
    plausible::judge_beyond_terrain(things, extent, reading);
    return std::move(kept.targets);
}

}  // namespace coupling
