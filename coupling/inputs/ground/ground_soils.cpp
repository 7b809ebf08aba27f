#include "coupling/inputs/ground/ground_soils.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "config/data/shipped_tables.hpp"
#include "config/math/elementary.hpp"
#include "config/text/joined.hpp"
#include "coupling/inputs/reading/declared_tables.hpp"
#include "coupling/inputs/scenario/terrain_settings.hpp"

namespace coupling {

/// A row of the table on its way to a soil: what its columns say, in their units.
struct GroundSoilRow {
    using Figure = std::optional<double>;
    std::string name;
    std::string like;
    Figure r_n, r_t, dr_slow, dr_fast, friction, dk_slow, dk_fast, angle_slow, angle_fast, limit, threshold;
    // What single parameters have of their own; else they share the columns above.
    Figure dr_n_slow, dr_n_fast, dr_t_slow, dr_t_fast;
    Figure angle_h_slow, angle_h_fast, angle_v_slow, angle_v_fast;
    Figure limit_r, limit_r_n, limit_r_t, limit_k, limit_angle, limit_angle_h, limit_angle_v;
};

namespace {

using config::joined;

using rockfall::Soil;

double radians(double angle_deg) {
    return config::Angle::from_degrees(angle_deg).in_radians();
}
double tangent(double angle_deg) {
    const config::SinCos of = config::sin_cos_of(radians(angle_deg));
    return of.sin / of.cos;
}

constexpr config::NumberRange restitution_bounds{0.0, rockfall::largest_restitution};
constexpr config::NumberRange percent_bounds{0.0, 100.0};
constexpr config::NumberRange angle_bounds{0.0, 90.0};
constexpr config::NumberRange limit_bounds{0.1, 100.0};

/// A figure of a soil: what all soils have, and what single parameters may have of their own.
struct SoilFigure {
    const char* name;
    std::optional<double> GroundSoilRow::*value;
    config::NumberRange range;
    bool is_needed;
    const char* meaning;
};
using SoilIn = GroundSoilRow;
// clang-format off
constexpr SoilFigure soil_figures[] = {
    {"r_n", &SoilIn::r_n, restitution_bounds, true, "normal restitution"},
    {"r_t", &SoilIn::r_t, restitution_bounds, true, "tangential restitution"},
    {"dr_slow_percent", &SoilIn::dr_slow, percent_bounds, true, "width of r_n and r_t at rest"},
    {"dr_fast_percent", &SoilIn::dr_fast, percent_bounds, true, "width of r_n and r_t from limit_mps on"},
    {"friction", &SoilIn::friction, {0.0, 5.0}, true, "friction k"},
    {"dk_slow_percent", &SoilIn::dk_slow, percent_bounds, true, "width of k at rest"},
    {"dk_fast_percent", &SoilIn::dk_fast, percent_bounds, true, "width of k from limit_mps on"},
    {"angle_slow_deg", &SoilIn::angle_slow, angle_bounds, true, "width of both turns at rest"},
    {"angle_fast_deg", &SoilIn::angle_fast, angle_bounds, true, "width of both turns from limit_mps on"},
    {"limit_mps", &SoilIn::limit, limit_bounds, true, "limit speed of all widths"},
    {"threshold_deg", &SoilIn::threshold, {0.0, 45.0}, true, "between a bounce and a slide"},
    {"dr_n_slow_percent", &SoilIn::dr_n_slow, percent_bounds, false, "of r_n alone"},
    {"dr_n_fast_percent", &SoilIn::dr_n_fast, percent_bounds, false, "of r_n alone"},
    {"dr_t_slow_percent", &SoilIn::dr_t_slow, percent_bounds, false, "of r_t alone"},
    {"dr_t_fast_percent", &SoilIn::dr_t_fast, percent_bounds, false, "of r_t alone"},
    {"angle_h_slow_deg", &SoilIn::angle_h_slow, angle_bounds, false, "of the horizontal turn alone"},
    {"angle_h_fast_deg", &SoilIn::angle_h_fast, angle_bounds, false, "of the horizontal turn alone"},
    {"angle_v_slow_deg", &SoilIn::angle_v_slow, angle_bounds, false, "of the vertical turn alone"},
    {"angle_v_fast_deg", &SoilIn::angle_v_fast, angle_bounds, false, "of the vertical turn alone"},
    {"limit_r_mps", &SoilIn::limit_r, limit_bounds, false, "of r_n and r_t"},
    {"limit_r_n_mps", &SoilIn::limit_r_n, limit_bounds, false, "of r_n alone"},
    {"limit_r_t_mps", &SoilIn::limit_r_t, limit_bounds, false, "of r_t alone"},
    {"limit_k_mps", &SoilIn::limit_k, limit_bounds, false, "of k"},
    {"limit_angle_mps", &SoilIn::limit_angle, limit_bounds, false, "of both turns"},
    {"limit_angle_h_mps", &SoilIn::limit_angle_h, limit_bounds, false, "of the horizontal turn alone"},
    {"limit_angle_v_mps", &SoilIn::limit_angle_v, limit_bounds, false, "of the vertical turn alone"},
};
// clang-format on

/// Requires all figures that soils need.
Soil soil_of(const GroundSoilRow& row) {
    const double limit_r = row.limit_r.value_or(*row.limit);
    const double limit_angle = row.limit_angle.value_or(*row.limit);
    return {row.name,
            {*row.r_n, *row.r_t},
            *row.friction,
            {0.01 * row.dr_n_slow.value_or(*row.dr_slow), 0.01 * row.dr_n_fast.value_or(*row.dr_fast),
             row.limit_r_n.value_or(limit_r)},
            {0.01 * row.dr_t_slow.value_or(*row.dr_slow), 0.01 * row.dr_t_fast.value_or(*row.dr_fast),
             row.limit_r_t.value_or(limit_r)},
            {0.01 * *row.dk_slow, 0.01 * *row.dk_fast, row.limit_k.value_or(*row.limit)},
            {radians(row.angle_h_slow.value_or(*row.angle_slow)),
             radians(row.angle_h_fast.value_or(*row.angle_fast)), row.limit_angle_h.value_or(limit_angle)},
            {radians(row.angle_v_slow.value_or(*row.angle_slow)),
             radians(row.angle_v_fast.value_or(*row.angle_fast)), row.limit_angle_v.value_or(limit_angle)},
            tangent(*row.threshold)};
}

const GroundSoilRow* find_soil(const std::vector<GroundSoilRow>& rows, const std::string& name) {
    const auto found =
        std::find_if(rows.begin(), rows.end(), [&](const GroundSoilRow& r) { return r.name == name; });
    return found == rows.end() ? nullptr : &*found;
}

std::string nearest_of(const std::string& name, const std::vector<std::string>& names) {
    const std::string nearest = config::nearest_word(name, names);
    return "a soil of `bannwald info pir3d_soils` or of terrain.soils" +
           (nearest.empty() ? "" : " (" + nearest + "?)");
}

/// Reads a table of soils. `known`: those that its column `like` may name.
std::vector<config::Read<GroundSoilRow>> read_soil_rows(const config::Table& table,
                                                        const std::vector<GroundSoilRow>& known,
                                                        config::RowProblems& wrong) {
    for (std::size_t row = 0; row < table.rows(); ++row) {
        for (const SoilFigure& figure : soil_figures) {
            if (figure.is_needed && !has_value(table, row, "like") && !has_value(table, row, figure.name)) {
                wrong.refuse(
                    row, table.has(figure.name) ? figure.name : "name",
                    joined("soil ", config::in_quotes(table.text(row, "name")), " without ", figure.name),
                    joined("a column ", figure.name, ", or a shipped soil in a column like"));
            }
        }
    }
    std::vector<config::Read<GroundSoilRow>> rows = ground_soil_columns().rows(table, wrong);
    for (config::Read<GroundSoilRow>& row : rows) {
        const GroundSoilRow* like = find_soil(known, row.like);
        if (like == nullptr && !row.like.empty()) {
            std::vector<std::string> names;
            for (const GroundSoilRow& k : known) {
                names.push_back(k.name);
            }
            wrong.refuse(row.row, "like", config::in_quotes(row.like), nearest_of(row.like, names));
        }
        for (const SoilFigure& figure : soil_figures) {
            if (like != nullptr && !(row.*figure.value)) {
                row.*figure.value = like->*figure.value;
            }
        }
    }
    return rows;
}

std::vector<GroundSoilRow> shipped_soil_rows() {
    const config::Table table = config::read_shipped_table("pir3d_soils.csv");
    config::RowProblems wrong{table};
    const auto rows = read_soil_rows(table, {}, wrong);
    wrong.throw_first();
    return {rows.begin(), rows.end()};
}

std::vector<Soil> soils_of(const std::vector<GroundSoilRow>& rows) {
    std::vector<Soil> soils;
    std::transform(rows.begin(), rows.end(), std::back_inserter(soils), soil_of);
    return soils;
}

}  // namespace

const config::Schema<GroundSoilRow>& ground_soil_columns() {
    // clang-format off
    static const config::Schema<GroundSoilRow> columns = [] {
        std::vector<config::ColumnOf<GroundSoilRow>> fields{
            {"name", &GroundSoilRow::name, "by which ground types name it", {.unique = true}},
            {"label", "for people", {.optional = true}},
            {"like", &GroundSoilRow::like, "a shipped soil, for what the row leaves out", {.optional = true}},
            {"source", "for people", {.optional = true}}};
        for (const SoilFigure& figure : soil_figures) {
            const bool is_plain = std::string_view{figure.name}.starts_with("r_");  // r_t is no mass in tonnes
            fields.push_back({figure.name, figure.value, figure.meaning, {.unit = is_plain ? "-" : "", .range = figure.range}});
        }
        return config::Schema<GroundSoilRow>{
            {.role = "soils", .setting = "terrain.soils", .row = "soil", .others_refused = true},
            std::move(fields)};
    }();
    // clang-format on
    return columns;
}

std::vector<Soil> shipped_ground_soils() {
    return soils_of(shipped_soil_rows());
}

std::vector<Soil> read_ground_soils(Reading& reading) {
    std::vector<GroundSoilRow> rows = shipped_soil_rows();
    if (const std::string& file = reading.terrain().soils; !file.empty()) {
        const config::Table table = table_of(ground_soil_columns(), file, reading);
        config::RowProblems wrong{table};
        const auto own = read_soil_rows(table, rows, wrong);
        wrong.throw_first();
        for (const config::Read<GroundSoilRow>& row : own) {
            if (find_soil(rows, row.name) != nullptr) {
                reading.note(
                    config::to_string(config::Problem{.place = table.place(row.row, "name"),
                                                      .found = "soil " + config::in_quotes(row.name) +
                                                               " replaces the shipped soil of that name"}));
                std::erase_if(rows, [&](const GroundSoilRow& shipped) { return shipped.name == row.name; });
            }
        }
        rows.insert(rows.begin(), own.begin(), own.end());
    }
    return soils_of(rows);
}

const Soil* nearest_soil(const rockfall::Restitution& restitution, const std::vector<Soil>& soils) {
    const auto distance = [&](const Soil& soil) {
        return std::hypot(soil.restitution.normal - restitution.normal,
                          soil.restitution.tangential - restitution.tangential);
    };
    const auto nearest = std::min_element(
        soils.begin(), soils.end(), [&](const Soil& a, const Soil& b) { return distance(a) < distance(b); });
    return nearest == soils.end() ? nullptr : &*nearest;
}

std::optional<Soil> named_soil(const config::Table& table, std::size_t row, const std::string& column,
                               const std::vector<Soil>& soils, config::Problems& problems) {
    const std::string& name = table.text(row, column);
    std::vector<std::string> names;
    for (const Soil& soil : soils) {
        if (soil.name == name) {
            return soil;
        }
        names.push_back(soil.name);
    }
    problems.add(config::ExitCode::data, table.place(row, column), "soil " + config::in_quotes(name),
                 nearest_of(name, names));
    return std::nullopt;
}

}  // namespace coupling
