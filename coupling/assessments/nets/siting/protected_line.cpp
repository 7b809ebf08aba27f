#include "coupling/assessments/nets/siting/protected_line.hpp"

#include <algorithm>
#include <cmath>

#include "config/table/shape_field.hpp"
#include "config/text/coordinates.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/assessments/nets/figures/net_try.hpp"
#include "coupling/inputs/nets/net_input.hpp"
#include "coupling/inputs/nets/net_lines.hpp"
#include "coupling/inputs/plausible/beyond_terrain.hpp"
#include "coupling/inputs/plausible/share_on_terrain.hpp"
#include "coupling/inputs/tables/prepare.hpp"

namespace coupling::siting {
namespace {

using config::joined;

constexpr double m_per_km = 1000.0;
constexpr double shortest_line_m = 1.0;
/// Lines are cut into stretches of ten metres over their whole length; a longer one is a slip [choice].
constexpr double longest_line_m = 100.0 * m_per_km;
/// So far apart lie the places at which a line is looked at for ground below it.
constexpr double look_step_m = 1.0;

std::string name_in(const config::Table& table, std::size_t row) {
    for (const char* column : {"name", "target_id"}) {
        if (table.has(column) && !table.text(row, column).empty()) {
            return table.text(row, column);
        }
    }
    return joined("line ", std::to_string(row + 1));
}

/// Share of the length of a line, looked at every metre, with ground below it [0, 1].
double share_on_ground(const std::vector<Eigen::Vector2d>& line_m, const rockfall::Terrain& terrain) {
    double all = 0.0;
    double on = 0.0;
    for (std::size_t i = 0; i + 1 < line_m.size(); ++i) {
        const Eigen::Vector2d way_m = line_m[i + 1] - line_m[i];
        const int steps = std::max(1, static_cast<int>(std::ceil(way_m.norm() / look_step_m)));
        for (int k = 0; k < steps; ++k) {
            const Eigen::Vector2d place = line_m[i] + (k + 0.5) / steps * way_m;
            all += way_m.norm() / steps;
            on += terrain.locate(place.x(), place.y()) ? way_m.norm() / steps : 0.0;
        }
    }
    return all > 0.0 ? on / all : 0.0;
}

/// The corners of a line of the terrain, in coordinates of its file.
std::vector<config::Point2> corners_in_file(const ProtectedLine& line, const rockfall::Terrain& terrain) {
    std::vector<config::Point2> corners;
    for (const Eigen::Vector2d& corner : line.line_m) {
        corners.push_back({corner.x() + terrain.origin_m().x(), corner.y() + terrain.origin_m().y()});
    }
    return corners;
}

}  // namespace

double length_m(const std::vector<Eigen::Vector2d>& line_m) {
    return plan_length_m(line_m);
}

std::vector<Eigen::Vector2d> piece_of(const std::vector<Eigen::Vector2d>& line_m, double from_m,
                                      double to_m) {
    const std::size_t last = line_m.size() - 1;
    const auto place_at = [&](double along_m) -> Eigen::Vector2d {
        double before_m = 0.0;
        for (std::size_t i = 0; i < last; ++i) {
            const double side_m = (line_m[i + 1] - line_m[i]).norm();
            if (along_m <= before_m + side_m || i + 1 == last) {
                return line_m[i] + (along_m - before_m) / side_m * (line_m[i + 1] - line_m[i]);
            }
            before_m += side_m;
        }
        return line_m[last];
    };
    std::vector<Eigen::Vector2d> piece{place_at(from_m)};
    double along_m = 0.0;
    for (std::size_t i = 1; i <= last; ++i) {
        along_m += (line_m[i] - line_m[i - 1]).norm();
        constexpr double apart_m = 1e-6;
        if (i < last && along_m > from_m + apart_m && along_m < to_m - apart_m) {
            piece.push_back(line_m[i]);
        }
    }
    piece.push_back(place_at(to_m));
    return piece;
}

std::vector<ProtectedLine> lines_of(const config::Table& table, std::vector<std::string>& remarks) {
    config::Problems problems;
    table.require({"wkt"}, problems);
    problems.throw_if_any();
    std::vector<ProtectedLine> lines;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const std::string name = name_in(table, row);
        const auto shape =
            shape_of(table, row, {config::Shape::Kind::line, config::Shape::Kind::polygon}, problems);
        if (!shape) {
            continue;
        }
        if (shape->kind == config::Shape::Kind::polygon) {
            remarks.push_back(joined(name,
                                     ": an area, left out: nets are sited for lines; draw one along "
                                     "its side towards the slope"));
            continue;
        }
        for (std::size_t part = 0; part < shape->parts.size(); ++part) {
            ProtectedLine line{
                shape->parts.size() == 1 ? name : joined(name, ", part ", std::to_string(part + 1)), {}};
            for (const config::Point2& point : shape->parts[part]) {
                const Eigen::Vector2d corner{point.x_m, point.y_m};
                if (line.line_m.empty() || corner != line.line_m.back()) {
                    line.line_m.push_back(corner);
                }
            }
            if (length_m(line.line_m) < shortest_line_m) {
                problems.add(config::ExitCode::data, table.place(row, "wkt"),
                             joined("line ", config::in_quotes(line.name), " of length ",
                                    config::metres_in_words(length_m(line.line_m)), " m"),
                             joined("at least ", config::to_text(shortest_line_m), " m"));
                continue;
            }
            if (length_m(line.line_m) > longest_line_m) {
                problems.add(config::ExitCode::data, table.place(row, "wkt"),
                             joined("line ", config::in_quotes(line.name), " of length ",
                                    config::to_text(std::round(length_m(line.line_m) / m_per_km)), " km"),
                             "at most 100 km",
                             "correct the coordinates, or cut the line at the edge of the terrain");
                continue;
            }
            lines.push_back(std::move(line));
        }
    }
    if (lines.empty() && problems.empty()) {
        problems.add(config::ExitCode::data, {table.file()}, "no lines",
                     "at least one line to protect, such as a road");
    }
    problems.throw_if_any();
    return lines;
}

GivenLines read_lines(const std::filesystem::path& file, const RunTerrain& run,
                      std::vector<std::string>& remarks) {
    std::vector<std::string> of_reading;
    TableOnRun given_table = table_on(run, file, "a table or layer of lines", of_reading);
    config::Table& table = given_table.table;
    GivenLines given;
    if (table.has("height_m") || table.has("capacity_kj")) {
        given.nets = nets_on(file, run, Standing::each_alone, remarks);
        for (const NetRecord& record : given.nets) {
            given.lines.push_back({record.name, record.net.line_m});
        }
        return given;
    }
    remarks.insert(remarks.end(), of_reading.begin(), of_reading.end());
    tables::add_remarks(tables::prepare(table, "targets", given_table.has_own_shapes), remarks);
    const rockfall::Terrain& terrain = run.terrain;
    given.lines = lines_of(table, remarks);
    tables::add_remarks(tables::findings_of_use(*table.use()), remarks);
    plausible::ThingsOnTerrain things{
        {file.string()}, "line", {}, "lines on the terrain of the run", "exchange x and y in the lines", ""};
    std::vector<ProtectedLine> kept;
    for (ProtectedLine& line : given.lines) {
        for (Eigen::Vector2d& corner : line.line_m) {
            corner -= terrain.origin_m();
        }
        const double share = share_on_ground(line.line_m, terrain);
        things.things.push_back({line.name, corners_in_file(line, terrain), share <= 0.0, things.place});
        if (share <= 0.0) {
            continue;
        }
        if (share < 1.0) {
            remarks.push_back(joined("warning: ", plausible::percent_in_words(1.0 - share), " of the line ",
                                     config::in_quotes(line.name),
                                     " lies off the terrain, where no rock can be followed to"));
        }
        kept.push_back(std::move(line));
    }
    given.lines = std::move(kept);
    config::Problems problems;
    plausible::BeyondTerrain beyond = plausible::beyond_terrain(things, plausible::extent_of(terrain));
    if (beyond.problem) {
        problems.add(*std::move(beyond.problem));
    }
    if (!beyond.note.empty()) {
        remarks.push_back(std::move(beyond.note));
    }
    problems.throw_if_any();
    return given;
}

}  // namespace coupling::siting
