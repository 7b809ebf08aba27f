#include "coupling/inputs/works/work_places.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "config/units/angle.hpp"
#include "coupling/inputs/ground/ground_names.hpp"
#include "coupling/inputs/nets/net_input.hpp"
#include "coupling/inputs/nets/net_lines.hpp"
#include "coupling/inputs/plausible/beyond_terrain.hpp"
#include "coupling/inputs/plausible/cut_command.hpp"
#include "coupling/inputs/plausible/share_on_terrain.hpp"
#include "coupling/inputs/reading/declared_tables.hpp"
#include "coupling/inputs/reading/reading.hpp"
#include "coupling/inputs/scenario/net_settings.hpp"
#include "rockfall/terrain/embankment.hpp"

namespace coupling {
namespace {

using config::joined;
using rockfall::EmbankmentFault;

std::string named(const WorkRecord& work) {
    return joined(name_of(work.kind), " ", config::in_quotes(work.name));
}

std::string place_in_words(const Eigen::Vector2d& place_m, const Eigen::Vector2d& origin_m) {
    return joined("x ", to_centimetres(place_m.x() + origin_m.x()), ", y ",
                  to_centimetres(place_m.y() + origin_m.y()));
}

rockfall::Embankment embankment_of(const WorkRecord& work) {
    const auto tangent = [](double degrees) {
        return std::tan(config::Angle::from_degrees(degrees).in_radians());
    };
    return {work.line_m, work.kind == WorkKind::dam ? work.height_m : -work.height_m, work.width_m,
            tangent(work.uphill_face_deg), tangent(work.downhill_face_deg)};
}

/// What is wrong with a dam or a ditch in its place.
config::Problem problem_of(const WorkRecord& work, const rockfall::EmbankmentProblem& found,
                           const Eigen::Vector2d& origin_m, config::Place place) {
    const bool is_dam = work.kind == WorkKind::dam;
    const std::string side = found.uphill ? "uphill" : "downhill";
    const std::string where = place_in_words(found.place_m, origin_m);
    const auto problem = [&](std::string what, std::string expected, std::string advice) {
        return config::Problem{config::ExitCode::data, std::move(place), std::move(what), std::move(expected),
                               std::move(advice)};
    };
    switch (found.fault) {
        case EmbankmentFault::off_terrain:
            return problem(joined(named(work), " leaves the terrain at ", where),
                           "a work that ends, with its faces, on the terrain",
                           "shorten it, or take a larger terrain");
        case EmbankmentFault::no_uphill:
            return problem(joined(named(work), " with two different faces on level ground"),
                           "an uphill side: ground that is higher on one side of the line",
                           "give both faces the same slope");
        case EmbankmentFault::edge_in_ground:
            return problem(
                joined("the ", side, is_dam ? " edge of the crown of " : " edge of the floor of ",
                       named(work), is_dam ? " lies below" : " lies above", " the ground at ", where),
                joined(is_dam ? "a crown above" : "a floor below", " the ground on both sides of the line"),
                is_dam ? "make it higher or its crown narrower, or move the line"
                       : "make it deeper or its floor narrower, or move the line");
        case EmbankmentFault::face_too_flat:
            return problem(joined("the ", side, " face of ", named(work), " meets no ground within ",
                                  config::to_text(rockfall::longest_face_m), " m at ", where),
                           "a face that is steeper than the slope",
                           joined("a steeper face (", side, "_face_deg), or a flatter place"));
        case EmbankmentFault::bend:
            break;
    }
    return problem(joined(named(work), " bends so much at ", where, " that its faces cross"),
                   "bends wider than its faces are long: they are long where the slope is nearly as steep",
                   "make its faces steeper, spread the bend over several corners, or draw two works");
}

/// The outline of an embankment with a strip above it, and where its sides end along it.
void take_counted_outline(WorkRecord& work, const rockfall::PlacedEmbankment& placed, double strip_m) {
    PlanLine& line = work.counted_m;
    line.clear();
    double length_m = 0.0;
    const auto go_to = [&](const Eigen::Vector2d& corner) {
        length_m += line.empty() ? 0.0 : (corner - line.back()).norm();
        line.push_back(corner);
    };
    const auto uphill = [&](const rockfall::CrossSection& section) {
        const Eigen::Vector2d across = (section[0] - section[3]).head<2>().normalized();
        return Eigen::Vector2d{section[0].head<2>() + strip_m * across};
    };
    const auto& sections = placed.sections;
    for (const rockfall::CrossSection& section : sections) {
        go_to(uphill(section));
    }
    work.side_ends_m[0] = length_m;
    go_to(sections.back()[3].head<2>());
    work.side_ends_m[1] = length_m;
    for (std::size_t i = sections.size() - 1; i-- > 0;) {
        go_to(sections[i][3].head<2>());
    }
    work.side_ends_m[2] = length_m;
    go_to(uphill(sections.front()));
    work.side_ends_m[3] = length_m;
}

/// A strip above it as wide as it is high; narrower where a bend leaves no room for that.
void count_at(WorkRecord& work, const rockfall::PlacedEmbankment& placed) {
    for (const double share : {1.0, 0.5, 0.25, 0.0}) {
        take_counted_outline(work, placed, share * work.height_m);
        if (!meets_itself(work.counted_m)) {
            return;
        }
    }
}

/// Whether the areas at which two works count rocks cross, or one lies in the other.
bool overlap(const WorkRecord& one, const WorkRecord& other) {
    rockfall::Target area_of_one;
    area_of_one.parts = {one.counted_m};
    area_of_one = rockfall::with_bounds(std::move(area_of_one));
    rockfall::Target area_of_other;
    area_of_other.parts = {other.counted_m};
    if (rockfall::is_inside(area_of_other, one.counted_m.front()) ||
        rockfall::is_inside(area_of_one, other.counted_m.front())) {
        return true;
    }
    for (std::size_t i = 0; i + 1 < other.counted_m.size(); ++i) {
        if (rockfall::first_crossing(area_of_one, other.counted_m[i], other.counted_m[i + 1])) {
            return true;
        }
    }
    return false;
}

/// Whether the line of a wall enters the area of a dam or a ditch.
bool crosses(const WorkRecord& wall, const WorkRecord& other) {
    if (other.counted_m.empty()) {
        return false;  // it is refused itself
    }
    rockfall::Target area;
    area.parts = {other.counted_m};
    area = rockfall::with_bounds(std::move(area));
    for (std::size_t i = 0; i + 1 < wall.line_m.size(); ++i) {
        if (rockfall::is_inside(area, wall.line_m[i]) ||
            rockfall::first_crossing(area, wall.line_m[i], wall.line_m[i + 1])) {
            return true;
        }
    }
    return false;
}

/// Whether a place where rocks start lies inside a work.
bool holds_source(const WorkRecord& work, const rockfall::ReleaseSource& source) {
    rockfall::Target area;
    area.parts = {work.counted_m};
    area = rockfall::with_bounds(std::move(area));
    const Eigen::Vector2d middle_m =
        source.outline ? source.outline->inner_m : Eigen::Vector2d{0.5 * (source.first_m + source.last_m)};
    if (rockfall::is_inside(area, middle_m)) {
        return true;
    }
    if (source.kind == rockfall::ReleaseSource::Kind::line) {
        return rockfall::first_crossing(area, source.first_m, source.last_m).has_value();
    }
    const Eigen::Vector2d& low = source.first_m;
    const Eigen::Vector2d& high = source.last_m;
    const std::array corners{low, Eigen::Vector2d{high.x(), low.y()}, high,
                             Eigen::Vector2d{low.x(), high.y()}};
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if (rockfall::first_crossing(area, corners[i], corners[(i + 1) % corners.size()])) {
            return true;
        }
    }
    const auto is_in_cell = [&](const Eigen::Vector2d& corner) {
        return (corner.array() >= low.array()).all() && (corner.array() <= high.array()).all();
    };
    return is_in_cell(work.counted_m.front());
}

/// Dams and ditches, one after the other; each must keep clear of those before it.
class EarthMover {
public:
    EarthMover(std::span<const rockfall::ReleaseSource> sources, rockfall::Terrain& terrain, Reading& reading)
        : sources_{sources}, terrain_{terrain}, reading_{reading} {}

    void move_earth(WorkRecord& work, std::uint32_t surface, const config::Place& place) {
        const rockfall::EmbankmentResult result = rockfall::place(embankment_of(work), terrain_);
        if (result.problem) {
            reading_.problems().add(problem_of(work, *result.problem, terrain_.origin_m(), place));
            return;
        }
        const rockfall::PlacedEmbankment& placed = *result.placed;
        work.outline_m = placed.outline_m;
        work.volume_m3 = placed.volume_m3;
        work.ground_m2 = placed.area_m2;
        if (meets_itself(work.outline_m)) {
            reading_.refuse(place, joined(named(work), " whose faces cross each other"),
                            "a line that keeps clear of itself by the width of its faces", "draw two works");
            return;
        }
        count_at(work, placed);
        for (const WorkRecord& other : moved_) {
            if (overlap(work, other)) {
                reading_.refuse(
                    place, joined(named(work), " overlaps ", named(other)),
                    "works that keep clear of each other with their faces and the strips above them",
                    "move one of them, or make its faces steeper");
                return;
            }
        }
        if (std::any_of(sources_.begin(), sources_.end(),
                        [&](const rockfall::ReleaseSource& source) { return holds_source(work, source); })) {
            reading_.refuse(place, joined("rocks start inside or close above ", named(work)),
                            "works beside the places where rocks start", "move the work or the source");
            return;
        }
        terrain_ = rockfall::with_embankment(terrain_, placed, surface);
        moved_.push_back(work);
    }

private:
    std::span<const rockfall::ReleaseSource> sources_;
    rockfall::Terrain& terrain_;
    Reading& reading_;
    std::vector<WorkRecord> moved_;
};

config::Shape shape_of(const WorkRecord& work) {
    config::Shape shape{
        work.kind == WorkKind::gallery ? config::Shape::Kind::polygon : config::Shape::Kind::line, {{}}};
    for (const Eigen::Vector2d& corner : work.line_m) {
        shape.parts.front().push_back({corner.x(), corner.y()});
    }
    return shape;
}

/// Leaves out what lies wholly beyond the terrain.
GivenWorks on_terrain_alone(GivenWorks given, const rockfall::Terrain& terrain, Reading& reading) {
    const std::string& file = reading.works().file;
    if (given.works.empty()) {
        return given;
    }
    const plausible::Extent extent = plausible::extent_of(terrain);
    plausible::ThingsOnTerrain things{{shown_tables(file, reading)},
                                      "work",
                                      {},
                                      "works wholly on the terrain",
                                      "exchange x and y in the lines",
                                      plausible::cut_command_of_first(reading, "works", file, extent)};
    GivenWorks kept;
    for (std::size_t i = 0; i < given.works.size(); ++i) {
        const config::Shape shape = shape_of(given.works[i]);
        const bool is_beyond = !plausible::touches_terrain(shape, terrain, extent);
        things.things.push_back({given.works[i].name, shape.parts.front(), is_beyond, given.places[i]});
        if (!is_beyond) {
            kept.works.push_back(std::move(given.works[i]));
            kept.places.push_back(std::move(given.places[i]));
            kept.rows.push_back(given.rows[i]);
        }
    }
    kept.tables = std::move(given.tables);
    plausible::judge_beyond_terrain(things, extent, reading);
    return kept;
}

/// The place of the ground of each work in `types`, from 1; 0: none named.
std::vector<std::uint32_t> grounds_of(const GivenWorks& given, std::vector<rockfall::SurfaceType>& types,
                                      Reading& reading) {
    std::vector<std::uint32_t> grounds(given.works.size(), 0);
    GroundNames names{types, std::nullopt, *reading.settings().options};
    for (std::size_t i = 0; i < given.works.size(); ++i) {
        const config::Table& table = given.tables[given.rows[i].table];
        if (table.has("surface") && !table.text(given.rows[i].row, "surface").empty()) {
            const auto place = names.place_of(table, given.rows[i].row, "wkt", reading.problems());
            grounds[i] = place ? *place + 1U : 0U;
        }
    }
    types = std::move(names).list();
    return grounds;
}

/// Where the line of a wall or the edge of a roof has no ground below it.
void check_line(const WorkRecord& work, const rockfall::Terrain& terrain, const config::Place& place,
                Reading& reading) {
    rockfall::Net line;
    line.line_m = work.line_m;
    if (const auto off = first_place_off_ground(line, terrain)) {
        reading.refuse(
            place, joined(named(work), " leaves the terrain at ", place_in_words(*off, terrain.origin_m())),
            "a work wholly on the terrain", "shorten it, or take a larger terrain");
    }
}

/// Whether an area lies below a roof, or reaches under it.
bool reaches_under(const rockfall::Target& target, const std::vector<Eigen::Vector2d>& ring_m) {
    const rockfall::Roof roof{ring_m, 0.0};
    for (const auto& part : target.parts) {
        for (const Eigen::Vector2d& vertex : part) {
            if (is_below(roof, vertex)) {
                return true;
            }
        }
    }
    for (std::size_t i = 0; i + 1 < ring_m.size(); ++i) {
        if (rockfall::first_crossing(target, ring_m[i], ring_m[i + 1]) ||
            (target.is_area && rockfall::is_inside(target, ring_m[i]))) {
            return true;
        }
    }
    return false;
}

}  // namespace

std::vector<WorkRecord> place_works(GivenWorks given, std::span<const rockfall::ReleaseSource> sources,
                                    std::vector<rockfall::SurfaceType>& types, rockfall::Terrain& terrain,
                                    Reading& reading) {
    given = on_terrain_alone(std::move(given), terrain, reading);
    const std::vector<std::uint32_t> grounds = grounds_of(given, types, reading);
    const Eigen::Vector2d origin_m = terrain.origin_m();
    EarthMover mover{sources, terrain, reading};
    for (std::size_t i = 0; i < given.works.size(); ++i) {
        WorkRecord& work = given.works[i];
        for (Eigen::Vector2d& corner : work.line_m) {
            corner -= origin_m;
        }
        if (is_of_earth(work.kind)) {
            mover.move_earth(work, grounds[i], given.places[i]);
            continue;
        }
        check_line(work, terrain, given.places[i], reading);
        if (work.kind == WorkKind::gallery) {
            work.outline_m = work.line_m;
            work.counted_m = work.line_m;
            if (std::any_of(sources.begin(), sources.end(), [&](const rockfall::ReleaseSource& source) {
                    return holds_source(work, source);
                })) {
                reading.refuse(given.places[i], joined("rocks start on the roof of ", named(work)),
                               "a roof below the places where rocks start", "move the roof or the source");
            }
        }
    }
    for (std::size_t i = 0; i < given.works.size(); ++i) {
        for (const WorkRecord& other : given.works) {
            if (given.works[i].kind == WorkKind::wall && is_of_earth(other.kind) &&
                crosses(given.works[i], other)) {
                reading.refuse(
                    given.places[i], joined(named(given.works[i]), " stands on ", named(other)),
                    "works that keep clear of each other with their faces and the strips above them",
                    "move one of them");
            }
        }
    }
    return std::move(given.works);
}

void put_under_roofs(std::span<const WorkRecord> works, std::vector<rockfall::Target>& targets,
                     Reading& reading) {
    for (const WorkRecord& work : works) {
        if (work.kind != WorkKind::gallery) {
            continue;
        }
        bool covers_some = false;
        for (rockfall::Target& target : targets) {
            if (!reaches_under(target, work.outline_m)) {
                continue;
            }
            if (target.is_area) {
                reading.warn({shown_tables(reading.works().file, reading)},
                             joined("gallery ", config::in_quotes(work.name), " over the area of target ",
                                    config::in_quotes(target.id)),
                             "a road: galleries cover lines, and rocks enter this area as without it");
                continue;
            }
            covers_some = true;
            target.roofs.push_back({work.outline_m, work.capacity_j});
        }
        if (!covers_some) {
            reading.warn({shown_tables(reading.works().file, reading)},
                         joined("gallery ", config::in_quotes(work.name), " over no line of targets.file"),
                         "a roof over a road: it changes nothing else");
        }
    }
}

void clear_ground_of(std::span<const WorkRecord> works, std::vector<TreeRecord>& trees,
                     std::vector<LogRecord>& logs, const Eigen::Vector2d& origin_m, Reading& reading) {
    std::vector<rockfall::Roof> areas;
    for (const WorkRecord& work : works) {
        if (is_of_earth(work.kind)) {
            areas.push_back({work.outline_m, 0.0});
        }
    }
    const auto is_covered = [&](double x_m, double y_m) {
        return std::any_of(areas.begin(), areas.end(), [&](const rockfall::Roof& area) {
            return is_below(area, Eigen::Vector2d{x_m, y_m} - origin_m);
        });
    };
    const std::size_t felled = std::erase_if(
        trees, [&](const TreeRecord& tree) { return is_covered(tree.stem.x_m, tree.stem.y_m); });
    const std::size_t removed = std::erase_if(logs, [&](const LogRecord& record) {
        return is_covered(0.5 * (record.log.x1_m + record.log.x2_m),
                          0.5 * (record.log.y1_m + record.log.y2_m));
    });
    if (felled + removed > 0) {
        reading.note(joined("trees and logs where dams and ditches are, left out: ", std::to_string(felled),
                            " trees, ", std::to_string(removed), " logs"));
    }
}

}  // namespace coupling
