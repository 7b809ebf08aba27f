#include "coupling/inputs/works/work_input.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "config/text/coordinates.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "config/units/constants.hpp"
#include "coupling/inputs/files/file_bytes.hpp"
#include "coupling/inputs/nets/net_lines.hpp"
#include "coupling/inputs/reading/declared_tables.hpp"
#include "coupling/inputs/reading/reading.hpp"
#include "coupling/inputs/scenario/net_settings.hpp"
#include "coupling/inputs/tables/needed_columns.hpp"

namespace coupling {

using config::above;
using config::joined;

const char* name_of(WorkKind kind) {
    constexpr std::array<const char*, work_kinds> names{"dam", "ditch", "wall", "gallery"};
    return names[static_cast<std::size_t>(kind)];
}

namespace {

constexpr config::NumberRange work_height_m{0.0, 50.0, above};
constexpr config::NumberRange work_width_m{0.3, 100.0};
/// A flatter face is a part of the slope, a steeper one a wall of its own kind.
constexpr config::NumberRange face_deg{10.0, 85.0};
constexpr double shortest_work_m = 0.1;

/// What a kind of work has: the columns that it needs, and those that mean nothing to it.
struct KindRules {
    bool has_height;
    bool has_section;   ///< width and faces, surface
    bool has_capacity;  ///< may be empty: holds everything
};

constexpr std::array<KindRules, work_kinds> rules_of_kinds{
    KindRules{true, true, false}, KindRules{true, true, false}, KindRules{true, false, true},
    KindRules{false, false, true}};

KindRules rules_of(WorkKind kind) {
    return rules_of_kinds[static_cast<std::size_t>(kind)];
}

/// Takes a figure that a kind of work needs, and refuses one that it cannot have.
void take_figure(const std::optional<double>& given, bool is_needed, const char* column,
                 const config::Read<ListedWork>& row, double& to, config::RowProblems& wrong) {
    if (given && is_needed) {
        to = *given;
    } else if (is_needed) {
        wrong.refuse(row.row, column, joined(name_of(row.kind), " without ", column),
                     joined(column, " of each ", name_of(row.kind)));
    } else if (given) {
        wrong.refuse(row.row, column, joined(column, " of a ", name_of(row.kind)), "an empty field",
                     row.kind == WorkKind::gallery
                         ? "the roof is the ground of the terrain; change it there where it lies higher"
                         : "leave it empty, or choose another kind");
    }
}

void take_figures(const config::Read<ListedWork>& row, WorkRecord& work, config::RowProblems& wrong) {
    const KindRules rules = rules_of(row.kind);
    take_figure(row.height_m, rules.has_height, "height_m", row, work.height_m, wrong);
    take_figure(row.width_m, rules.has_section, "width_m", row, work.width_m, wrong);
    take_figure(row.uphill_face_deg, rules.has_section, "uphill_face_deg", row, work.uphill_face_deg, wrong);
    take_figure(row.downhill_face_deg, rules.has_section, "downhill_face_deg", row, work.downhill_face_deg,
                wrong);
    if (row.capacity_kj && rules.has_capacity) {
        work.capacity_j = config::j_per_kj * *row.capacity_kj;
    } else if (row.capacity_kj) {
        wrong.refuse(row.row, "capacity_kj", joined("capacity_kj of a ", name_of(row.kind)), "an empty field",
                     "what a dam or a ditch holds follows from its shape");
    }
    if (row.cost.investment.has_value() != row.cost.life_years.has_value()) {
        wrong.refuse(
            row.row, row.cost.investment ? "life_years" : "investment",
            row.cost.investment ? "an investment without life_years" : "life_years without an investment",
            "both, or none of them");
    }
}

void take_shape(const config::Read<ListedWork>& row, WorkRecord& work, config::RowProblems& wrong) {
    const bool is_area = row.shape.kind == config::Shape::Kind::polygon;
    if (is_area != (row.kind == WorkKind::gallery)) {
        wrong.refuse(row.row, "wkt", joined(is_area ? "a polygon of a " : "a line of a ", name_of(row.kind)),
                     is_area ? "a line along its axis" : "the area of its roof");
        return;
    }
    if (row.shape.parts.size() != 1) {
        wrong.refuse(row.row, "wkt", "a roof with holes", "a polygon without holes");
        return;
    }
    double length_m = 0.0;
    for (const config::Point2& point : row.shape.parts.front()) {
        const Eigen::Vector2d corner{point.x_m, point.y_m};
        if (work.line_m.empty() || corner != work.line_m.back()) {
            length_m += work.line_m.empty() ? 0.0 : (corner - work.line_m.back()).norm();
            work.line_m.push_back(corner);
        }
    }
    if (is_area && !work.line_m.empty() && work.line_m.front() != work.line_m.back()) {
        length_m += (work.line_m.front() - work.line_m.back()).norm();
        work.line_m.push_back(work.line_m.front());
    }
    if (length_m < shortest_work_m) {
        wrong.refuse(row.row, "wkt", joined("a work of length ", config::metres_in_words(length_m), " m"),
                     joined("at least ", config::to_text(shortest_work_m), " m"),
                     "check whether its corners are metres, not degrees or kilometres");
    } else if (meets_itself(work.line_m)) {
        wrong.refuse(
            row.row, "wkt",
            joined(name_of(row.kind), " ", config::in_quotes(row.name), " crosses or touches itself"),
            "a line that does not");
    } else if (!is_area && work.line_m.front() == work.line_m.back() && row.kind != WorkKind::wall) {
        wrong.refuse(row.row, "wkt",
                     joined(name_of(row.kind), " ", config::in_quotes(row.name), " around a closed line"),
                     "a line with two ends", "draw it as two works");
    }
}

/// Warns of dams higher and ditches deeper than are built against rocks. Most dams are lower than 10 m and
/// some are higher (Lambert and Bourrier 2013, second hand); twice that looks like a slip [choice].
void judge_heights(std::span<const WorkRecord> works, std::span<const std::size_t> rows,
                   const config::Table& table, Reading& reading) {
    constexpr double highest_work_m = 20.0;
    for (std::size_t i = 0; i < works.size(); ++i) {
        const WorkRecord& work = works[i];
        if (is_of_earth(work.kind) && work.height_m > highest_work_m) {
            reading.warn(table.place(rows[i], "height_m"),
                         joined("a ", name_of(work.kind), " of ", config::to_text(work.height_m), " m"),
                         "a height or depth in metres: most dams against rocks are lower than 10 m",
                         "check the unit of the column height_m, and the volume that check prints",
                         config::Effect::answer);
        }
    }
}

/// Costs stay out of the hash of the falls: with other costs the same rocks fall.
std::string text_of_falls(const config::Table& table) {
    std::string text;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        for (const char* column : {"name", "kind", "height_m", "width_m", "uphill_face_deg",
                                   "downhill_face_deg", "capacity_kj", "surface", "wkt"}) {
            text += joined(table.has(column) ? table.text(row, column) : std::string{}, "\n");
        }
    }
    return text;
}

}  // namespace

const config::Schema<ListedWork>& work_columns() {
    const auto cost = [](auto member) {
        return [member](ListedWork & row) -> auto& {
            return row.cost.*member;
        };
    };
    // clang-format off
    static const config::Schema<ListedWork> columns{
        {.role = "works", .setting = "works.file", .row = "work", .no_rows = "at least one, or no works.file"},
        {{"name", &ListedWork::name, "in results", {.unique = true}},
         {"kind", &ListedWork::kind, "dam and ditch change the ground, a wall holds rocks, a gallery covers a road", {.words = {"dam", "ditch", "wall", "gallery"}}},
         {"height_m", &ListedWork::height_m, "of the crown of a dam or the top of a wall above the ground at the line; depth of a ditch there; empty: gallery", {.range = work_height_m}},
         {"width_m", &ListedWork::width_m, "of the crown of a dam or the floor of a ditch", {.range = work_width_m}},
         {"uphill_face_deg", &ListedWork::uphill_face_deg, "slope of the uphill face of a dam or a ditch, 33.7: 2 to 3", {.unit = "deg", .range = face_deg}},
         {"downhill_face_deg", &ListedWork::downhill_face_deg, "slope of the downhill face of a dam or a ditch", {.unit = "deg", .range = face_deg}},
         {"capacity_kj", &ListedWork::capacity_kj, "energy that a wall or the roof of a gallery takes at most; empty: any", {.range = {0.0, 1e6, above}}},
         {"surface", "ground type of crown and faces, by code or name; empty: that of the ground below", {.optional = true}},
         {"investment", cost(&BarrierCost::investment), "what it costs to build, in risk.currency", {.range = {0.0, 1e12}}},
         {"life_years", cost(&BarrierCost::life_years), "how long it stands", {.unit = "yr", .range = {1.0, 1000.0}}},
         {"maintenance_percent", cost(&BarrierCost::maintenance_percent), "what it costs a year, of the investment; empty: 0", {.unit = "%", .range = {0.0, 100.0}, .optional = true}},
         {"wkt", &ListedWork::shape, "the axis of a dam, ditch or wall; the area of the roof of a gallery", {.shapes = {config::Shape::Kind::line, config::Shape::Kind::polygon}, .single = true}}}};
    // clang-format on
    return columns;
}

GivenWorks works_of(const config::Table& table, GivenWorks given) {
    config::Problems missing;
    require_columns(table, work_columns(), missing);
    missing.throw_if_any();
    config::RowProblems wrong{table};
    const auto before = static_cast<std::ptrdiff_t>(given.works.size());
    const std::size_t number = given.tables.size();
    for (const config::Read<ListedWork>& row : work_columns().rows(table, wrong)) {
        if (std::any_of(given.works.begin(), given.works.begin() + before,
                        [&](const WorkRecord& other) { return other.name == row.name; })) {
            wrong.refuse(row.row, "name",
                         joined("work ", config::in_quotes(row.name), " of another file of works too"),
                         "one name for each work", "change it in one of the files");
        }
        WorkRecord work;
        work.name = row.name;
        work.kind = row.kind;
        work.cost = row.cost;
        take_figures(row, work, wrong);
        take_shape(row, work, wrong);
        if (table.has("surface") && !table.text(row.row, "surface").empty() &&
            !rules_of(row.kind).has_section) {
            wrong.refuse(row.row, "surface", joined("surface of a ", name_of(row.kind)), "an empty field");
        }
        given.works.push_back(std::move(work));
        given.places.push_back(table.place(row.row, "wkt"));
        given.rows.push_back({number, row.row});
    }
    wrong.throw_first();
    given.tables.push_back(table);
    return given;
}

std::optional<GivenWorks> read_works(Reading& reading) {
    const std::string& file = reading.works().file;
    if (file.empty()) {
        return GivenWorks{};
    }
    return reading.attempt([&] {
        GivenWorks given;
        std::string of_falls;
        for (const NamedTable& name : tables_in(file)) {
            const config::Table table = table_of(work_columns(), name.name, reading, name.id_opening);
            const std::size_t before = given.works.size();
            given = works_of(table, std::move(given));
            std::vector<std::size_t> rows;
            for (std::size_t i = before; i < given.rows.size(); ++i) {
                rows.push_back(given.rows[i].row);
            }
            judge_heights(std::span{given.works}.subspan(before), rows, table, reading);
            of_falls += text_of_falls(table);
        }
        reading.use_part_of("works", "all but costs", hash_text(of_falls));
        return given;
    });
}

}  // namespace coupling
