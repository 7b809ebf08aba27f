#include "coupling/assessments/collapse/source_body.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>

#include "config/table/shape_field.hpp"
#include "config/text/joined.hpp"
#include "coupling/inputs/formats/mesh_file.hpp"

namespace coupling::collapse {
namespace {

using config::joined;
using Eigen::Vector3d;
using rockfall::rock_mass::Facet;

std::array<Vector3d, 3> corners_of(const rockfall::Terrain& terrain, const rockfall::Triangle& triangle) {
    std::array<Vector3d, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
        const rockfall::Vertex& v = terrain.vertices()[triangle.corners[k]];
        corners[k] = {v.x_m, v.y_m, v.z_m};
    }
    return corners;
}

/// Triangles of the terrain over a box in plan, lowered.
void add_ground(const rockfall::Terrain& terrain, const Vector3d& low_m, const Vector3d& high_m,
                double lowered_m, std::vector<Facet>& border) {
    for (const rockfall::Triangle& triangle : terrain.triangles()) {
        const auto corners = corners_of(terrain, triangle);
        const Vector3d low = corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]);
        const Vector3d high = corners[0].cwiseMax(corners[1]).cwiseMax(corners[2]);
        if (low.x() <= high_m.x() && high.x() >= low_m.x() && low.y() <= high_m.y() &&
            high.y() >= low_m.y()) {
            Facet facet;
            for (const Vector3d& corner : corners) {
                facet.corners_m.push_back(corner - lowered_m * Vector3d::UnitZ());
            }
            border.push_back(std::move(facet));
        }
    }
}

void grow(SourceBody& body, const Vector3d& point_m) {
    body.low_m = body.low_m.cwiseMin(point_m);
    body.high_m = body.high_m.cwiseMax(point_m);
}

SourceBody empty_body() {
    SourceBody body;
    body.low_m = Vector3d::Constant(std::numeric_limits<double>::infinity());
    body.high_m = -body.low_m;
    return body;
}

/// Heights of the box of a body from the ground below its outline.
void take_heights(const rockfall::Terrain& terrain, double depth_m, SourceBody& body) {
    body.low_m.z() = std::numeric_limits<double>::infinity();
    body.high_m.z() = -body.low_m.z();
    std::vector<Facet> ground;
    add_ground(terrain, body.low_m, body.high_m, 0.0, ground);
    for (const Facet& facet : ground) {
        for (const Vector3d& corner : facet.corners_m) {
            body.low_m.z() = std::min(body.low_m.z(), corner.z() - depth_m);
            body.high_m.z() = std::max(body.high_m.z(), corner.z());
        }
    }
}

SourceBody below_polygons(const CollapseScenario& scenario, const rockfall::Terrain& terrain,
                          Reading& reading) {
    const config::Table table = reading.table("collapse.source", "collapse_source", scenario.settings.source);
    config::Problems problems;
    table.require({"wkt"}, problems);
    problems.throw_if_any();
    auto outline = std::make_shared<config::Shape>();
    outline->kind = config::Shape::Kind::polygon;
    SourceBody body = empty_body();
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const auto shape = shape_of(table, row, {config::Shape::Kind::polygon}, problems);
        for (const auto& ring : shape ? shape->parts : std::vector<std::vector<config::Point2>>{}) {
            auto& moved = outline->parts.emplace_back();
            for (const config::Point2& point : ring) {
                moved.push_back({point.x_m - terrain.origin_m().x(), point.y_m - terrain.origin_m().y()});
                grow(body, {moved.back().x_m, moved.back().y_m, 0.0});
                if (!terrain.height_m(moved.back().x_m, moved.back().y_m)) {
                    problems.add(config::ExitCode::data, table.place(row, "wkt"),
                                 joined("a corner at ", std::to_string(point.x_m), ", ",
                                        std::to_string(point.y_m), " off the terrain"),
                                 "polygons on the terrain");
                    break;
                }
            }
        }
    }
    if (outline->parts.empty()) {
        problems.add(config::ExitCode::data, {table.file()}, "no polygon", "at least one");
    }
    problems.throw_if_any();
    const double depth_m = scenario.settings.depth_m;
    take_heights(terrain, depth_m, body);
    add_ground(terrain, body.low_m, body.high_m, 0.0, body.body.border);
    add_ground(terrain, body.low_m, body.high_m, depth_m, body.body.border);
    for (const auto& ring : outline->parts) {
        for (std::size_t k = 0; k + 1 < ring.size(); ++k) {
            const double low = body.low_m.z() - 1.0, high = body.high_m.z() + 1.0;
            body.body.border.push_back({{{ring[k].x_m, ring[k].y_m, low},
                                         {ring[k + 1].x_m, ring[k + 1].y_m, low},
                                         {ring[k + 1].x_m, ring[k + 1].y_m, high},
                                         {ring[k].x_m, ring[k].y_m, high}}});
        }
    }
    body.body.contains = [outline, &terrain, depth_m](const Vector3d& p) {
        const auto height = terrain.height_m(p.x(), p.y());
        return height && p.z() < *height && p.z() > *height - depth_m &&
               config::point_in_polygon(*outline, {p.x(), p.y()});
    };
    return body;
}

/// Refuses a surface in which an edge has not exactly one face on each side.
void check_closed(const std::vector<std::array<std::uint32_t, 3>>& faces, const std::vector<Vector3d>& points,
                  const std::string& file, const Eigen::Vector2d& origin) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> balance;
    for (const auto& face : faces) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = face[k], b = face[(k + 1) % 3];
            balance[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
        }
    }
    std::size_t open = 0;
    std::string where;
    for (const auto& [edge, sum] : balance) {
        if (sum != 0) {
            if (open++ == 0) {
                const Vector3d& p = points[edge.first];
                where = joined(std::to_string(p.x() + origin.x()), ", ", std::to_string(p.y() + origin.y()),
                               ", ", std::to_string(p.z()));
            }
        }
    }
    if (open > 0) {
        config::fail(config::ExitCode::data, {file},
                     joined("an open surface: ", std::to_string(open), " of ", std::to_string(balance.size()),
                            " edges have no face on one side, the first at ", where),
                     "a closed surface whose faces all look outwards",
                     "close the holes in the program that made it");
    }
}

/// Whether a ray upwards leaves a closed surface an odd number of times.
bool is_in_mesh(const std::vector<std::array<Vector3d, 3>>& faces, const Vector3d& point) {
    // A ray that meets an edge counts twice or not at all: it leans a little to keep clear of round
    // coordinates.
    const Vector3d ray = Vector3d{1.234567e-3, 2.345678e-3, 1.0};
    bool inside = false;
    for (const auto& [a, b, c] : faces) {
        const Vector3d normal = (b - a).cross(c - a);
        const double across = normal.dot(ray);
        if (across == 0.0) {
            continue;
        }
        const double way = normal.dot(a - point) / across;
        const Vector3d hit = point + way * ray;
        const bool in_face = normal.dot((b - a).cross(hit - a)) >= 0.0 &&
                             normal.dot((c - b).cross(hit - b)) >= 0.0 &&
                             normal.dot((a - c).cross(hit - c)) >= 0.0;
        inside = inside != (way > 0.0 && in_face);
    }
    return inside;
}

SourceBody in_mesh(const CollapseScenario& scenario, const rockfall::Terrain& terrain, Reading& reading) {
    const std::string file = reading.shown(scenario.settings.mesh);
    const FileBytes bytes = reading.open("collapse.mesh", "collapse_mesh", scenario.settings.mesh,
                                         "a closed surface, PLY or STL");
    const meshes::MeshFile mesh = meshes::read_mesh_file(bytes.text(), file);
    // Points at one place are one point: STL has three of its own for each face.
    std::map<std::array<double, 3>, std::uint32_t> numbers;
    std::vector<Vector3d> points;
    std::vector<std::uint32_t> now;
    for (const Vector3d& given : mesh.points_m) {
        const auto [at, is_new] = numbers.try_emplace({given.x(), given.y(), given.z()}, points.size());
        if (is_new) {
            points.push_back(given - Vector3d{terrain.origin_m().x(), terrain.origin_m().y(), 0.0});
        }
        now.push_back(at->second);
    }
    std::vector<std::array<std::uint32_t, 3>> faces;
    for (const auto& face : mesh.faces) {
        faces.push_back({now[face[0]], now[face[1]], now[face[2]]});
    }
    check_closed(faces, points, file, terrain.origin_m());
    if (faces.size() < 4) {
        config::fail(config::ExitCode::data, {file}, joined(std::to_string(faces.size()), " faces"),
                     "a closed surface of at least four faces");
    }
    SourceBody body = empty_body();
    auto corners = std::make_shared<std::vector<std::array<Vector3d, 3>>>();
    double highest_over_ground_m = -std::numeric_limits<double>::infinity();
    for (const auto& face : faces) {
        corners->push_back({points[face[0]], points[face[1]], points[face[2]]});
        body.body.border.push_back({{points[face[0]], points[face[1]], points[face[2]]}});
        for (const std::uint32_t k : face) {
            grow(body, points[k]);
            const auto ground = terrain.height_m(points[k].x(), points[k].y());
            if (!ground) {
                config::fail(config::ExitCode::data, {file}, "a surface that reaches off the terrain",
                             "a body within the terrain");
            }
            highest_over_ground_m = std::max(highest_over_ground_m, points[k].z() - *ground);
        }
    }
    if (highest_over_ground_m < -scenario.settings.least_block_m) {
        config::fail(config::ExitCode::data, {file},
                     joined("a body under the terrain: its highest point lies ",
                            std::to_string(-highest_over_ground_m), " m below the ground"),
                     "a body that reaches the surface: nothing could leave this one",
                     "check heights and units of mesh and terrain");
    }
    add_ground(terrain, body.low_m, body.high_m, 0.0, body.body.border);
    body.body.contains = [corners, &terrain](const Vector3d& p) {
        const auto height = terrain.height_m(p.x(), p.y());
        return height && p.z() < *height && is_in_mesh(*corners, p);
    };
    return body;
}

}  // namespace

SourceBody read_source(const CollapseScenario& scenario, const rockfall::Terrain& terrain, Reading& reading) {
    return scenario.settings.mesh.empty() ? below_polygons(scenario, terrain, reading)
                                          : in_mesh(scenario, terrain, reading);
}

}  // namespace coupling::collapse
