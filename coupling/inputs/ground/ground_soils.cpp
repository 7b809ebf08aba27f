#include "coupling/inputs/ground/ground_soils.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "config/data/shipped_tables.hpp"
#include "config/math/elementary.hpp"
#include "coupling/inputs/tables/meant_columns.hpp"

namespace coupling {
namespace {

using rockfall::Soil;

double radians(double angle_deg) {
    return config::Angle::from_degrees(angle_deg).in_radians();
}
double tangent(double angle_deg) {
    const config::SinCos of = config::sin_cos_of(radians(angle_deg));
    return of.sin / of.cos;
}

/// A row of the table on its way to a soil: what its columns say, in their units.
struct SoilRow {
    double r_n, r_t, dr_slow, dr_fast, friction, dk_slow, dk_fast, angle_slow, angle_fast, limit, threshold;
    // What single parameters have of their own; else they share the columns above.
    std::optional<double> dr_n_slow, dr_n_fast, dr_t_slow, dr_t_fast;
    std::optional<double> angle_h_slow, angle_h_fast, angle_v_slow, angle_v_fast;
    std::optional<double> limit_r, limit_r_n, limit_r_t, limit_k, limit_angle, limit_angle_h, limit_angle_v;
};

constexpr config::NumberRange restitution_bounds{.low = 0.0, .high = rockfall::largest_restitution};
constexpr config::NumberRange percent_bounds{.low = 0.0, .high = 100.0};
constexpr config::NumberRange angle_bounds{.low = 0.0, .high = 90.0};
constexpr config::NumberRange limit_bounds{.low = 0.1, .high = 100.0};

struct SoilColumn {
    const char* name;
    double SoilRow::*value;
    config::NumberRange range;
};
constexpr SoilColumn soil_columns[] = {
    {"r_n", &SoilRow::r_n, restitution_bounds},
    {"r_t", &SoilRow::r_t, restitution_bounds},
    {"dr_slow_percent", &SoilRow::dr_slow, percent_bounds},
    {"dr_fast_percent", &SoilRow::dr_fast, percent_bounds},
    {"friction", &SoilRow::friction, {.low = 0.0, .high = 5.0}},
    {"dk_slow_percent", &SoilRow::dk_slow, percent_bounds},
    {"dk_fast_percent", &SoilRow::dk_fast, percent_bounds},
    {"angle_slow_deg", &SoilRow::angle_slow, angle_bounds},
    {"angle_fast_deg", &SoilRow::angle_fast, angle_bounds},
    {"limit_mps", &SoilRow::limit, limit_bounds},
    {"threshold_deg", &SoilRow::threshold, {.low = 0.0, .high = 45.0}},
};

/// A column that a table may leave out.
struct OwnColumn {
    const char* name;
    std::optional<double> SoilRow::*value;
    config::NumberRange range;
};
constexpr OwnColumn own_columns[] = {
    {"dr_n_slow_percent", &SoilRow::dr_n_slow, percent_bounds},
    {"dr_n_fast_percent", &SoilRow::dr_n_fast, percent_bounds},
    {"dr_t_slow_percent", &SoilRow::dr_t_slow, percent_bounds},
    {"dr_t_fast_percent", &SoilRow::dr_t_fast, percent_bounds},
    {"angle_h_slow_deg", &SoilRow::angle_h_slow, angle_bounds},
    {"angle_h_fast_deg", &SoilRow::angle_h_fast, angle_bounds},
    {"angle_v_slow_deg", &SoilRow::angle_v_slow, angle_bounds},
    {"angle_v_fast_deg", &SoilRow::angle_v_fast, angle_bounds},
    {"limit_r_mps", &SoilRow::limit_r, limit_bounds},
    {"limit_r_n_mps", &SoilRow::limit_r_n, limit_bounds},
    {"limit_r_t_mps", &SoilRow::limit_r_t, limit_bounds},
    {"limit_k_mps", &SoilRow::limit_k, limit_bounds},
    {"limit_angle_mps", &SoilRow::limit_angle, limit_bounds},
    {"limit_angle_h_mps", &SoilRow::limit_angle_h, limit_bounds},
    {"limit_angle_v_mps", &SoilRow::limit_angle_v, limit_bounds},
};

struct NamedSoilRow {
    std::string name;
    SoilRow row;
};

Soil soil_of(const NamedSoilRow& named) {
    const SoilRow& row = named.row;
    const double limit_r = row.limit_r.value_or(row.limit);
    const double limit_angle = row.limit_angle.value_or(row.limit);
    return {named.name,
            {row.r_n, row.r_t},
            row.friction,
            {0.01 * row.dr_n_slow.value_or(row.dr_slow), 0.01 * row.dr_n_fast.value_or(row.dr_fast),
             row.limit_r_n.value_or(limit_r)},
            {0.01 * row.dr_t_slow.value_or(row.dr_slow), 0.01 * row.dr_t_fast.value_or(row.dr_fast),
             row.limit_r_t.value_or(limit_r)},
            {0.01 * row.dk_slow, 0.01 * row.dk_fast, row.limit_k.value_or(row.limit)},
            {radians(row.angle_h_slow.value_or(row.angle_slow)),
             radians(row.angle_h_fast.value_or(row.angle_fast)), row.limit_angle_h.value_or(limit_angle)},
            {radians(row.angle_v_slow.value_or(row.angle_slow)),
             radians(row.angle_v_fast.value_or(row.angle_fast)), row.limit_angle_v.value_or(limit_angle)},
            tangent(row.threshold)};
}

/// Columns that mean nothing here change no figure, which must not stay unsaid.
void refuse_unknown_columns(const config::Table& table, config::Problems& problems) {
    std::vector<std::string> known{"name", "label", "like", "source"};
    for (const SoilColumn& column : soil_columns) {
        known.emplace_back(column.name);
    }
    for (const OwnColumn& column : own_columns) {
        known.emplace_back(column.name);
    }
    for (const std::string& column : table.columns_beside(known)) {
        const std::string meant = meant_column(column, known);
        problems.add(config::ExitCode::data, {table.file()},
                     "column " + config::in_quotes(column) + ", which has no meaning",
                     "columns of `bannwald info pir3d_soils`, or widths and limits of one parameter" +
                         (meant.empty() ? "" : " (" + meant + "?)"),
                     "correct its name, or remove it; coupling/inputs/README.md lists all");
    }
}

const NamedSoilRow* find_soil(const std::vector<NamedSoilRow>& rows, const std::string& name) {
    const auto found =
        std::find_if(rows.begin(), rows.end(), [&](const NamedSoilRow& r) { return r.name == name; });
    return found == rows.end() ? nullptr : &*found;
}

std::string nearest_of(const std::string& name, const std::vector<std::string>& names) {
    const std::string nearest = config::nearest_word(name, names);
    return "a soil of `bannwald info pir3d_soils` or of terrain.soils" +
           (nearest.empty() ? "" : " (" + nearest + "?)");
}

/// Reads a table of soils. `known`: those that its column `like` may name.
std::vector<NamedSoilRow> read_soil_rows(const config::Table& table, const std::vector<NamedSoilRow>& known,
                                         config::Problems& problems) {
    std::vector<NamedSoilRow> rows;
    for (std::size_t i = 0; i < table.rows(); ++i) {
        NamedSoilRow row{table.text(i, "name"), {}};
        if (row.name.empty() || find_soil(rows, row.name) != nullptr) {
            problems.add(
                config::ExitCode::data, table.place(i, "name"),
                row.name.empty() ? "no name" : "soil " + config::in_quotes(row.name) + " a second time",
                "each soil once, by name");
        }
        const NamedSoilRow* like = nullptr;
        if (has_value(table, i, "like")) {
            like = find_soil(known, table.text(i, "like"));
            if (like == nullptr) {
                std::vector<std::string> names;
                for (const NamedSoilRow& k : known) {
                    names.push_back(k.name);
                }
                problems.add(config::ExitCode::data, table.place(i, "like"),
                             config::in_quotes(table.text(i, "like")),
                             nearest_of(table.text(i, "like"), names));
                continue;
            }
        }
        for (const SoilColumn& column : soil_columns) {
            if (like != nullptr && !has_value(table, i, column.name)) {
                row.row.*column.value = like->row.*column.value;
            } else if (table.has(column.name)) {
                row.row.*column.value = table.number(i, column.name, column.range, problems).value_or(1.0);
            } else {
                problems.add(config::ExitCode::data, table.place(i, "name"),
                             "soil " + config::in_quotes(row.name) + " without " + column.name,
                             std::string{"a column "} + column.name + ", or a shipped soil in a column like");
            }
        }
        for (const OwnColumn& column : own_columns) {
            if (has_value(table, i, column.name)) {
                row.row.*column.value = table.number(i, column.name, column.range, problems);
            } else if (like != nullptr) {
                row.row.*column.value = like->row.*column.value;
            }
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

std::vector<NamedSoilRow> shipped_soil_rows() {
    std::istringstream in{std::string{config::shipped_table("pir3d_soils.csv")}};
    config::Problems problems;
    std::vector<NamedSoilRow> rows = read_soil_rows(config::Table::read(in, "pir3d_soils.csv"), {}, problems);
    problems.throw_if_any();
    return rows;
}

std::vector<Soil> soils_of(const std::vector<NamedSoilRow>& rows) {
    std::vector<Soil> soils;
    std::transform(rows.begin(), rows.end(), std::back_inserter(soils), soil_of);
    return soils;
}

}  // namespace

std::vector<Soil> shipped_ground_soils() {
    return soils_of(shipped_soil_rows());
}

std::vector<Soil> read_ground_soils(Reading& reading) {
    std::vector<NamedSoilRow> rows = shipped_soil_rows();
    if (const std::string& file = reading.scenario().soils; !file.empty()) {
        const config::Table table = reading.table("terrain.soils", "soils", file);
        config::Problems problems;
        table.require({"name"}, problems);
        problems.throw_if_any();
        refuse_unknown_columns(table, problems);
        std::vector<NamedSoilRow> own = read_soil_rows(table, rows, problems);
        config::Problems shown;
        add_first(shown, problems, table.file());
        shown.throw_if_any();
        for (std::size_t i = 0; i < own.size(); ++i) {
            if (find_soil(rows, own[i].name) != nullptr) {
                reading.note(
                    config::to_string(config::Problem{.place = table.place(i, "name"),
                                                      .found = "soil " + config::in_quotes(own[i].name) +
                                                               " replaces the shipped soil of that name"}));
            }
        }
        std::erase_if(rows, [&](const NamedSoilRow& row) { return find_soil(own, row.name) != nullptr; });
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
