#include "coupling/results/report/scene.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "config/text/joined.hpp"
#include "coupling/inputs/picture/ground_picture.hpp"
#include "coupling/page_scripts/json_text.hpp"
#include "coupling/results/figures/colours.hpp"
#include "coupling/results/report/map/energy_classes.hpp"
#include "coupling/results/report/scene_mass.hpp"
#include "coupling/results/templates/page_template.hpp"
#include "coupling/results/text/markup.hpp"
#include "rockfall/solids/shapes.hpp"

namespace coupling::report {
namespace {

using config::joined;
using page_scripts::json_array;
using page_scripts::json_packed;
using page_scripts::JsonObject;

constexpr int most_heights_a_side = 256;
/// Of all stands together: a page must stay readable for a browser.
constexpr std::size_t most_trees = 400'000;
constexpr std::size_t most_logs = 60'000;
constexpr std::size_t most_path_corners = 100'000;
constexpr std::size_t most_paths_with_blocks = 60;
constexpr double full = 65'535.0;
/// Room above the highest ground for flying rocks.
constexpr double headroom_m = 200.0;

/// Values between two ends as whole numbers from 0 to 65 534; 65 535 stands for none.
class Steps {
public:
    Steps(double low, double high) : low_{low}, step_{(std::max(high, low + 1e-6) - low) / (full - 1.0)} {}
    [[nodiscard]] std::uint16_t of(double value) const {
        return static_cast<std::uint16_t>(
            std::isnan(value) ? full : std::clamp(std::round((value - low_) / step_), 0.0, full - 1.0));
    }
    [[nodiscard]] std::string json() const {
        return JsonObject{}.number("low", low_).number("step", step_).json();
    }

private:
    double low_;
    double step_;
};

/// Coordinates count from the south-western corner of the ground, heights from its lowest place.
struct SceneBox {
    config::GridFrame frame;
    double low_m;
    Steps x;
    Steps y;
    Steps z;
};

SceneBox box_of(const config::Raster<double>& heights) {
    double low = INFINITY;
    double high = -INFINITY;
    for (const double height : heights.values) {
        if (!std::isnan(height)) {
            low = std::min(low, height);
            high = std::max(high, height);
        }
    }
    low = std::isfinite(low) ? low : 0.0;
    high = std::isfinite(high) ? high : 0.0;
    const config::GridFrame& frame = heights.frame;
    return {frame, low, Steps{0.0, frame.x_east_m() - frame.x_west_m},
            Steps{0.0, frame.y_north_m() - frame.y_south_m}, Steps{0.0, high - low + headroom_m}};
}

/// The height in the middle of each block of cells.
std::string ground_json(const config::Raster<double>& heights, const SceneBox& box) {
    const config::GridFrame& frame = heights.frame;
    const int block = (std::max(frame.columns, frame.rows) + most_heights_a_side - 1) / most_heights_a_side;
    const int columns = (frame.columns + block - 1) / block;
    const int rows = (frame.rows + block - 1) / block;
    std::vector<std::uint16_t> z;
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const config::Cell cell{std::min(column * block + block / 2, frame.columns - 1),
                                    std::min(row * block + block / 2, frame.rows - 1)};
            z.push_back(box.z.of(heights.at(cell) - box.low_m));
        }
    }
    return JsonObject{}
        .number("columns", columns)
        .number("rows", rows)
        .number("block", block)
        .number("cell_width_m", frame.cell_width_m)
        .number("cell_height_m", frame.cell_height_m)
        .number("width_m", frame.x_east_m() - frame.x_west_m)
        .number("height_m", frame.y_north_m() - frame.y_south_m)
        .number("low_m", box.low_m)
        .add("z", json_packed(z))
        .json();
}

/// Where the picture of the maps lies, in widths and heights of the ground from its north-western corner; its
/// bytes stand in the maps.
std::string picture_json(const GroundPicture& picture, const config::GridFrame& ground) {
    const double width_m = ground.x_east_m() - ground.x_west_m;
    const double height_m = ground.y_north_m() - ground.y_south_m;
    const config::GridFrame& frame = picture.frame;
    return JsonObject{}
        .number("west", (frame.x_west_m - ground.x_west_m) / width_m)
        .number("north", (ground.y_north_m() - frame.y_north_m()) / height_m)
        .number("width", (frame.x_east_m() - frame.x_west_m) / width_m)
        .number("height", (frame.y_north_m() - frame.y_south_m) / height_m)
        .json();
}

template <class Items, class Write>
std::string list_of(const Items& items, const Write& write) {
    std::vector<std::string> texts;
    for (const auto& item : items) {
        texts.push_back(write(item));
    }
    return json_array(texts);
}

/// The longest of the logs.
std::vector<SceneLog> longest(const std::vector<SceneLog>& logs, std::size_t most) {
    std::vector<SceneLog> kept = logs;
    if (kept.size() > most) {
        std::stable_sort(kept.begin(), kept.end(),
                         [](const SceneLog& a, const SceneLog& b) { return a.length_m > b.length_m; });
        kept.resize(most);
    }
    return kept;
}

/// Paths evenly chosen from their list until they have about so many corners; at least one if there is any.
std::vector<const ScenePath*> even_choice(const std::vector<ScenePath>& paths, std::size_t most_corners) {
    std::size_t corners = 0;
    for (const ScenePath& path : paths) {
        corners += path.size();
    }
    const std::size_t kept = corners <= most_corners
                                 ? paths.size()
                                 : std::max<std::size_t>(1, paths.size() * most_corners / corners);
    std::vector<const ScenePath*> chosen;
    for (std::size_t i = 0; i < kept; ++i) {
        chosen.push_back(&paths[i * paths.size() / kept]);
    }
    return chosen;
}

/// Both ends of each log, thick one first.
std::vector<std::uint16_t> log_ends(const std::vector<SceneLog>& logs, const SceneBox& box) {
    std::vector<std::uint16_t> ends;
    for (const SceneLog& log : logs) {
        for (const double along_m : {0.0, log.length_m}) {
            ends.push_back(box.x.of(log.x_m + along_m * std::cos(log.direction_rad) - box.frame.x_west_m));
            ends.push_back(box.y.of(log.y_m + along_m * std::sin(log.direction_rad) - box.frame.y_south_m));
        }
    }
    return ends;
}

/// What the whole numbers of times are steps of: the last rest is at the end.
double time_step_s(const Scene& scene) {
    double last_s = 0.0;
    for (const rockfall::PathRecord* path : scene.paths) {
        for (const rockfall::PathPoint& point : path->points) {
            last_s = std::max(last_s, static_cast<double>(point.time_s));
        }
    }
    return last_s / (full - 1.0);
}

/// When a rock was at each corner.
std::string times_json(const rockfall::PathRecord& path, double step_s) {
    std::vector<std::uint16_t> times;
    for (const rockfall::PathPoint& point : path.points) {
        times.push_back(static_cast<std::uint16_t>(std::round(static_cast<double>(point.time_s) / step_s)));
    }
    return json_packed(times);
}

/// Corners and the energy class at each.
JsonObject path_object(std::span<const rockfall::PathPoint> path, const SceneBox& box,
                       const Eigen::Vector2d& origin_m) {
    std::vector<std::uint16_t> points;
    std::vector<std::uint8_t> classes;
    for (const rockfall::PathPoint& point : path) {
        points.push_back(box.x.of(point.position_m.x() + origin_m.x() - box.frame.x_west_m));
        points.push_back(box.y.of(point.position_m.y() + origin_m.y() - box.frame.y_south_m));
        points.push_back(box.z.of(point.position_m.z() - box.low_m));
        classes.push_back(
            static_cast<std::uint8_t>(energy_class(static_cast<double>(point.energy_j) / 1000.0)));
    }
    JsonObject object;
    object.add("points", json_packed(points)).add("classes", json_packed(classes));
    return object;
}

bool has_attitude(const rockfall::PathPoint& point) {
    return std::any_of(point.attitude.begin(), point.attitude.end(), [](float part) { return part != 0.0F; });
}

/// The paths along which blocks are drawn: evenly chosen of those of blocks.
std::set<const rockfall::PathRecord*> paths_with_blocks(const Scene& scene) {
    std::vector<const rockfall::PathRecord*> of_blocks;
    for (const rockfall::PathRecord* path : scene.paths) {
        if (!path->points.empty() && std::all_of(path->points.begin(), path->points.end(), has_attitude)) {
            of_blocks.push_back(path);
        }
    }
    std::set<const rockfall::PathRecord*> chosen;
    const std::size_t kept = std::min(of_blocks.size(), most_paths_with_blocks);
    for (std::size_t i = 0; i < kept; ++i) {
        chosen.insert(of_blocks[i * of_blocks.size() / kept]);
    }
    return chosen;
}

/// The block of a path, and how it is turned at each corner.
void add_block(JsonObject& object, const rockfall::PathRecord& path) {
    std::vector<std::uint16_t> attitudes;
    for (const rockfall::PathPoint& point : path.points) {
        for (const float part : point.attitude) {
            attitudes.push_back(static_cast<std::uint16_t>(std::clamp(
                std::round((static_cast<double>(part) + 1.0) / 2.0 * (full - 1.0)), 0.0, full - 1.0)));
        }
    }
    std::vector<Eigen::Vector3d> points;
    for (const Eigen::Vector3f& vertex_m : path.shape_m) {
        points.push_back(vertex_m.cast<double>());
    }
    const double diameter_m = static_cast<double>(path.diameter_m);
    const rockfall::solids::Hull hull =
        points.empty() ? rockfall::solids::ellipsoid({diameter_m, diameter_m, diameter_m}, 1)
                       : rockfall::solids::convex_hull(points);
    std::vector<double> vertices;
    for (const Eigen::Vector3d& vertex_m : hull.vertices_m) {
        for (const double part_m : vertex_m) {
            vertices.push_back(std::round(1e4 * part_m) / 1e4);
        }
    }
    std::vector<double> faces;
    for (const rockfall::solids::Face& face : hull.faces) {
        for (std::size_t k = 1; k + 1 < face.corners.size(); ++k) {
            for (const std::uint32_t corner : {face.corners[0], face.corners[k], face.corners[k + 1]}) {
                faces.push_back(static_cast<double>(corner));
            }
        }
    }
    object.number("diameter_m", diameter_m)
        .add("attitudes", json_packed(attitudes))
        .add("shape", JsonObject{}
                          .add("vertices", page_scripts::json_numbers(vertices))
                          .add("faces", page_scripts::json_numbers(faces))
                          .json());
}

/// `stands`: how many share what may be drawn.
std::string stand_json(const SceneStand& stand, const SceneBox& box, const Eigen::Vector2d& origin_m,
                       std::size_t stands) {
    if (stand.same_as) {
        return JsonObject{}
            .text("regime", stand.regime)
            .number("year", stand.year)
            .number("same_as", static_cast<double>(*stand.same_as))
            .json();
    }
    const std::size_t most = most_trees / stands;
    const std::vector<SceneLog> logs = longest(stand.logs, most_logs / stands);
    const std::vector<const ScenePath*> paths = even_choice(stand.paths, most_path_corners / stands);
    std::vector<const SceneTree*> shown;
    for (const SceneTree& tree : stand.trees) {
        shown.push_back(&tree);
    }
    if (shown.size() > most) {
        std::stable_sort(shown.begin(), shown.end(),
                         [](const SceneTree* a, const SceneTree* b) { return a->dbh_cm > b->dbh_cm; });
        shown.resize(most);
    }
    std::vector<std::uint16_t> x;
    std::vector<std::uint16_t> y;
    std::vector<std::uint16_t> dbh_mm;
    std::vector<std::uint16_t> height_cm;
    std::vector<std::uint16_t> base_cm;
    std::vector<std::uint16_t> radius_cm;
    std::vector<std::uint8_t> kind;
    const auto whole = [](double value) {
        return static_cast<std::uint16_t>(std::clamp(std::round(value), 0.0, full - 1.0));
    };
    for (const SceneTree* tree : shown) {
        x.push_back(box.x.of(tree->x_m - box.frame.x_west_m));
        y.push_back(box.y.of(tree->y_m - box.frame.y_south_m));
        dbh_mm.push_back(whole(10.0 * tree->dbh_cm));
        height_cm.push_back(whole(100.0 * tree->height_m));
        base_cm.push_back(whole(100.0 * tree->crown_base_m));
        radius_cm.push_back(whole(100.0 * tree->crown_radius_m));
        kind.push_back(static_cast<std::uint8_t>(4 * (tree->species % 64) + static_cast<int>(tree->state)));
    }
    return JsonObject{}
        .text("regime", stand.regime)
        .number("year", stand.year)
        .number("trees", static_cast<double>(shown.size()))
        .number("left_out", static_cast<double>(stand.trees.size() - shown.size()))
        .add("x", json_packed(x))
        .add("y", json_packed(y))
        .add("dbh_mm", json_packed(dbh_mm))
        .add("height_cm", json_packed(height_cm))
        .add("base_cm", json_packed(base_cm))
        .add("radius_cm", json_packed(radius_cm))
        .add("kind", json_packed(kind))
        .add("logs", json_packed(log_ends(logs, box)))
        .number("drawn_logs", static_cast<double>(logs.size()))
        .number("all_logs", static_cast<double>(stand.logs.size()))
        .number("all_paths", static_cast<double>(stand.paths.size()))
        .add(
            "paths",
            list_of(paths,
                    [&](const ScenePath* path) {
                        return path_object(*path, box, origin_m).text("cover", name_of(Cover::forest)).json();
                    }))
        .json();
}

std::string target_json(const rockfall::Target& target, const SceneBox& box,
                        const Eigen::Vector2d& origin_m) {
    std::vector<std::string> parts;
    for (const std::vector<Eigen::Vector2d>& part : target.parts) {
        std::vector<double> numbers;
        for (const Eigen::Vector2d& vertex : part) {
            numbers.push_back(vertex.x() + origin_m.x() - box.frame.x_west_m);
            numbers.push_back(vertex.y() + origin_m.y() - box.frame.y_south_m);
        }
        parts.push_back(page_scripts::json_numbers(numbers));
    }
    return JsonObject{}
        .text("name", target.name.empty() ? target.id : target.name)
        .flag("area", target.is_area)
        .add("parts", json_array(parts))
        .json();
}

std::string json_of(const Scene& scene) {
    const SceneBox box = box_of(scene.heights);
    const auto different = std::count_if(scene.stands.begin(), scene.stands.end(),
                                         [](const SceneStand& stand) { return !stand.same_as; });
    const auto stands = static_cast<std::size_t>(std::max<std::ptrdiff_t>(1, different));
    std::vector<std::string> classes;
    for (std::size_t i = 0; i < energy_class_colours.size(); ++i) {
        classes.push_back(energy_class_name(i));
    }
    const double step_s = time_step_s(scene);
    JsonObject whole;
    if (step_s > 0.0) {
        whole.number("time_step_s", step_s);
    }
    if (scene.mass != nullptr) {
        whole.add("mass", mass_json(*scene.mass, box.frame.x_west_m, box.frame.y_south_m, box.low_m));
    }
    return whole.add("ground", ground_json(scene.heights, box))
        .add("x", box.x.json())
        .add("y", box.y.json())
        .add("z", box.z.json())
        .add("species", list_of(scene.species,
                                [](const SceneSpecies& species) {
                                    return JsonObject{}
                                        .text("name", species.name)
                                        .text("colour", species.colour)
                                        .flag("conifer", species.conifer)
                                        .json();
                                }))
        .add("classes",
             list_of(classes, [](const std::string& name) { return page_scripts::json_string(name); }))
        .add("stands",
             list_of(scene.stands,
                     [&](const SceneStand& stand) { return stand_json(stand, box, scene.origin_m, stands); }))
        .add("paths", list_of(scene.paths,
                              [&, with_block = paths_with_blocks(scene)](const rockfall::PathRecord* path) {
                                  JsonObject object = path_object(path->points, box, scene.origin_m);
                                  object.text("cover", name_of(path->cover));
                                  if (step_s > 0.0) {
                                      object.add("times", times_json(*path, step_s));
                                  }
                                  if (with_block.contains(path)) {
                                      add_block(object, *path);
                                  }
                                  return object.json();
                              }))
        .add("picture", scene.picture == nullptr ? "null" : picture_json(*scene.picture, box.frame))
        .add("targets", list_of(scene.targets,
                                [&](const rockfall::Target& target) {
                                    return target_json(target, box, scene.origin_m);
                                }))
        .json();
}

}  // namespace

std::string scene_figure(const Scene& scene, const std::string& instead) {
    return filled_template("scene.html", {{"instead", instead}, {"numbers", json_of(scene)}});
}

}  // namespace coupling::report
