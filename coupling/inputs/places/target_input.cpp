#include "coupling/inputs/places/target_input.hpp"

#include <algorithm>
#include <string>

#include "config/text/joined.hpp"
#include "coupling/inputs/plausible/odd_targets.hpp"
#include "coupling/inputs/plausible/off_terrain.hpp"
#include "coupling/inputs/plausible/share_on_terrain.hpp"
#include "coupling/inputs/reading/declared_tables.hpp"
#include "coupling/inputs/scenario/target_settings.hpp"

namespace coupling {

struct TargetRow {
    std::string id;
    std::string name;
    config::Shape shape;
};

namespace {

using config::joined;

rockfall::Target target_of(const TargetRow& row) {
    rockfall::Target target;
    target.id = row.id;
    target.name = row.name.empty() ? row.id : row.name;
    target.is_area = row.shape.kind == config::Shape::Kind::polygon;
    for (const auto& part : row.shape.parts) {
        std::vector<Eigen::Vector2d>& vertices = target.parts.emplace_back();
        for (const config::Point2& point : part) {
            vertices.emplace_back(point.x_m, point.y_m);
        }
    }
    return target;
}

std::vector<rockfall::Target> read_target_tables(Reading& reading) {
    std::vector<rockfall::Target> targets;
    std::vector<config::Place> places;
    for (const NamedTable& name : tables_in(reading.targets().file)) {
        const config::Table table = table_of(target_list_columns(), name.name, reading, name.id_opening);
        const std::size_t before = targets.size();
        config::RowProblems wrong{table};
        for (const config::Read<TargetRow>& row : target_list_columns().rows(table, wrong)) {
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
        }
        wrong.throw_first();
        if (table.rows() == 0) {
            reading.warn({table.file()}, "no targets", "at least one, or no targets.file");
        }
    }
    plausible::judge_shapes_of_targets(targets, places, reading);
    return targets;
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

/// Refuses a target wholly off the terrain; warns of one that is partly off it. Requires absolute
/// coordinates.
void judge_target(const rockfall::Target& target, const rockfall::Terrain& terrain,
                  const plausible::Extent& extent, int samples, Reading& reading) {
    const config::Shape shape = outline_of(target);
    const plausible::OnTerrain found = plausible::on_terrain(shape, terrain, samples);
    if (found.share >= 1.0) {
        return;
    }
    const config::Place place{shown_tables(reading.targets().file, reading)};
    const std::string name = joined("target ", config::in_quotes(target.id));
    if (found.share > 0.0) {
        reading.warn(place,
                     joined(name, " with ", plausible::percent_in_words(1.0 - found.share),
                            target.is_area ? " of its area" : " of its length", " off the terrain"),
                     "targets where rocks can be followed to",
                     "take a larger terrain if that part matters: no rock is counted there");
        return;
    }
    std::vector<config::Point2> vertices;
    for (const auto& part : shape.parts) {
        vertices.insert(vertices.end(), part.begin(), part.end());
    }
    const plausible::OffCause cause =
        plausible::cause_off_terrain(extent, vertices, "exchange x and y in the shapes");
    reading.refuse(place,
                   joined(name, " outside the terrain: ", cause.reason, "; the target spans ",
                          plausible::in_words(plausible::extent_of(vertices)), ", the terrain ",
                          plausible::in_words(extent)),
                   "targets on the terrain: no rock can arrive elsewhere", cause.advice);
}

}  // namespace

const config::Schema<TargetRow>& target_list_columns() {
    using config::Shape;
    // clang-format off
    static const config::Schema<TargetRow> columns{
        {.role = "targets", .setting = "targets.file", .row = "target"},
        {{"target_id", &TargetRow::id, "in results", {.unique = true}},
         {"name", &TargetRow::name, "on pages and maps; empty: target_id", {.optional = true}},
         {"wkt", &TargetRow::shape, "a line or an area", {.shapes = {Shape::Kind::line, Shape::Kind::polygon}}}}};
    // clang-format on
    return columns;
}

std::optional<std::vector<rockfall::Target>> read_targets(Reading& reading) {
    if (reading.targets().file.empty()) {
        return std::vector<rockfall::Target>{};
    }
    return reading.attempt([&] { return read_target_tables(reading); });
}

std::vector<rockfall::Target> on_terrain(std::vector<rockfall::Target> targets,
                                         const rockfall::Terrain& terrain, Reading& reading) {
    const plausible::Extent extent = plausible::extent_of(terrain);
    for (rockfall::Target& target : targets) {
        judge_target(target, terrain, extent, plausible::samples_a_side(targets.size()), reading);
        for (auto& part : target.parts) {
            for (Eigen::Vector2d& vertex : part) {
                vertex -= terrain.origin_m();
            }
        }
        target = rockfall::with_bounds(std::move(target));
    }
    return targets;
}

}  // namespace coupling
