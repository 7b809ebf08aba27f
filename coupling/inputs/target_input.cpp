#include "coupling/inputs/target_input.hpp"

#include <algorithm>
#include <string>

#include "coupling/inputs/shape_input.hpp"

namespace coupling {

namespace {

rockfall::Target target_of(const config::Table& table, std::size_t row, const config::Shape& shape) {
    rockfall::Target target;
    target.id = table.text(row, "target_id");
    target.name = table.has("name") && !table.text(row, "name").empty() ? table.text(row, "name") : target.id;
    target.is_area = shape.kind == config::Shape::Kind::polygon;
    for (const auto& part : shape.parts) {
        std::vector<Eigen::Vector2d>& vertices = target.parts.emplace_back();
        for (const config::Point2& point : part) {
            vertices.emplace_back(point.x_m, point.y_m);
        }
    }
    return target;
}

void check_id(const config::Table& table, std::size_t row, const std::vector<rockfall::Target>& targets,
              config::Problems& problems) {
    const std::string& id = table.text(row, "target_id");
    const bool doubled =
        std::any_of(targets.begin(), targets.end(), [&](const rockfall::Target& t) { return t.id == id; });
    if (id.empty() || doubled) {
        problems.add(config::ExitCode::data, table.place(row, "target_id"),
                     id.empty() ? "no target_id" : "target_id " + config::in_quotes(id) + " a second time",
                     "one target_id for each target");
    }
}

std::vector<rockfall::Target> read_target_table(Reading& reading) {
    const config::Table table = reading.table("targets.file", "targets", reading.scenario().targets);
    config::Problems problems;
    table.require({"target_id", "wkt"}, problems);
    problems.throw_if_any();
    std::vector<rockfall::Target> targets;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        check_id(table, row, targets, problems);
        const auto shape =
            shape_of(table, row, {config::Shape::Kind::line, config::Shape::Kind::polygon}, problems);
        if (shape) {
            targets.push_back(target_of(table, row, *shape));
        }
    }
    if (table.rows() == 0) {
        reading.doubt({table.file()}, "no targets", "at least one, or no targets.file");
    }
    config::Problems shown;
    add_first(shown, problems, table.file());
    shown.throw_if_any();
    return targets;
}

/// How many of a target's vertices lie on the terrain, and how many there are.
std::pair<std::size_t, std::size_t> vertices_on_terrain(const rockfall::Target& target,
                                                        const rockfall::Terrain& terrain) {
    std::size_t on = 0;
    std::size_t all = 0;
    for (const auto& part : target.parts) {
        for (const Eigen::Vector2d& vertex : part) {
            ++all;
            on += terrain.locate(vertex.x(), vertex.y()) ? 1U : 0U;
        }
    }
    return {on, all};
}

}  // namespace

std::optional<std::vector<rockfall::Target>> read_targets(Reading& reading) {
    if (reading.scenario().targets.empty()) {
        return std::vector<rockfall::Target>{};
    }
    return reading.attempt([&] { return read_target_table(reading); });
}

std::vector<rockfall::Target> on_terrain(std::vector<rockfall::Target> targets,
                                         const rockfall::Terrain& terrain, Reading& reading) {
    for (rockfall::Target& target : targets) {
        for (auto& part : target.parts) {
            for (Eigen::Vector2d& vertex : part) {
                vertex -= terrain.origin_m();
            }
        }
        target = rockfall::with_bounds(std::move(target));
        const auto [on, all] = vertices_on_terrain(target, terrain);
        if (on == 0) {
            reading.refuse({reading.shown(reading.scenario().targets)},
                           "target " + config::in_quotes(target.id) + " with no vertex on the terrain",
                           "coordinates of the DEM: no rock can arrive there");
        } else if (on < all) {
            reading.doubt({reading.shown(reading.scenario().targets)},
                          "target " + config::in_quotes(target.id) + " with " + std::to_string(all - on) +
                              " of " + std::to_string(all) + " vertices" + " off the terrain",
                          "targets where rocks can be followed to");
        }
    }
    return targets;
}

}  // namespace coupling
