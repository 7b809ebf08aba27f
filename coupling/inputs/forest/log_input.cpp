#include "coupling/inputs/forest/log_input.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "config/text/coordinates.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/forest/species_column.hpp"
#include "coupling/inputs/forest/species_table.hpp"
#include "coupling/inputs/plausible/cut_command.hpp"
#include "coupling/inputs/plausible/off_terrain.hpp"
#include "coupling/inputs/plausible/units.hpp"
#include "coupling/inputs/reading/declared_tables.hpp"
#include "coupling/inputs/reading/doubled_ids.hpp"
#include "coupling/inputs/scenario/tree_settings.hpp"

namespace coupling {
namespace {

using config::joined;

using config::above;
using LogField = config::ColumnOf<LogRow>;

constexpr double longest_log_m = 150.0;
constexpr config::NumberRange length_range_m{0.0, longest_log_m, above};
constexpr config::NumberRange diameter_range_cm{0.0, 500.0, above};

/// The log of a row, whose place is that of its ends or of one end and a direction.
rockfall::Log log_of(const LogRow& row, const LogForm& form, bool swap_axes) {
    rockfall::Log log = row;
    if (swap_axes) {
        std::swap(log.x1_m, log.y1_m);
        std::swap(log.x2_m, log.y2_m);
    }
    if (!form.by_ends) {
        const double azimuth = row.azimuth_deg * std::numbers::pi / 180.0;
        log.x2_m = log.x1_m + row.length_m * std::sin(azimuth);
        log.y2_m = log.y1_m + row.length_m * std::cos(azimuth);
    }
    if (form.one_diameter) {
        log.diameter2_cm = log.diameter1_cm;
    }
    return log;
}

std::vector<LogRecord> read_log_table(Reading& reading) {
    const config::Table table = reading.table("trees.logs", "logs", reading.trees().logs);
    const LogForm form{.by_ends = table.has("x1_m") || table.has("x2_m"),
                       .one_diameter = table.has("dbh_cm")};
    const config::Schema<LogRow> columns = log_columns(form);
    check_columns(table, columns, reading);
    plausible::check_log_units(table);
    const SpeciesTable known = SpeciesTable::shipped();
    config::RowProblems wrong{table};
    const SpeciesColumn species{table, lookup_in(known), wrong};
    std::vector<LogRecord> logs;
    for (const config::Read<LogRow>& row : columns.rows(table, wrong)) {
        rockfall::Log log = log_of(row, form, reading.trees().swap_logs_xy);
        const double length_m = std::hypot(log.x2_m - log.x1_m, log.y2_m - log.y1_m);
        if (form.by_ends && !length_range_m.contains(length_m)) {
            wrong.refuse(row.row, "x2_m", joined("a log of ", config::to_text(length_m), " m"),
                         joined("a length in ", config::to_string(length_range_m), " m"));
        }
        if (const auto kind = species.find(row.row)) {
            log.fracture_energy = known.all()[*kind].fracture_energy;
            logs.push_back(
                {row.id.empty() ? std::to_string(row.row + 1) : row.id, known.all()[*kind].code, log});
        }
    }
    wrong.throw_first();
    if (logs.empty()) {
        reading.warn({table.file()}, "no logs", "at least one, or no trees.logs");
    }
    warn_of_doubled_ids(logs, "log_id", "", table.file(), reading);
    return logs;
}

}  // namespace

config::Schema<LogRow> log_columns(const LogForm& form) {
    // clang-format off
    std::vector<LogField> fields{{"log_id", &LogRow::id, "number or name, for results; else the number of the row", {.optional = true}},
                                 {"species", "code or name"}};
    // clang-format on
    const auto add = [&](std::vector<LogField> more) {
        fields.insert(fields.end(), more.begin(), more.end());
    };
    if (form.by_ends) {
        // clang-format off
        add({{"x1_m", &LogRow::x1_m, "east, of one end"},
             {"y1_m", &LogRow::y1_m, "north"},
             {"x2_m", &LogRow::x2_m, "east, of the other end"},
             {"y2_m", &LogRow::y2_m, "north"}});
        // clang-format on
    } else {
        // clang-format off
        add({{"x_m", &LogRow::x1_m, "east, of one end"},
             {"y_m", &LogRow::y1_m, "north"},
             {"length_m", &LogRow::length_m, "in plan", {.range = length_range_m}},
             {"azimuth_deg", &LogRow::azimuth_deg, "clockwise from north", {.range = {-360.0, 360.0}}}});
        // clang-format on
    }
    if (form.one_diameter) {
        add({{"dbh_cm", &LogRow::diameter1_cm, "diameter of the whole log", {.range = diameter_range_cm}}});
    } else {
        // clang-format off
        add({{"diameter1_cm", &LogRow::diameter1_cm, "at the first end", {.range = diameter_range_cm}},
             {"diameter2_cm", &LogRow::diameter2_cm, "at the other end", {.range = diameter_range_cm}}});
        // clang-format on
    }
    // clang-format off
    add({{"clearance_m", &LogRow::clearance_m, "of the underside above the ground; empty: 0", {.range = {0.0, 20.0}, .optional = true}},
         {"strength", &LogRow::strength, "share of that of fresh wood; empty: 1", {.unit = "-", .range = {0.0, 1.0}, .optional = true}},
         {"anchored", &LogRow::supported, "yes: leans on stumps or trees, or is tied; empty: no", {.optional = true}}});
    // clang-format on
    return {{.role = "logs", .setting = "trees.logs", .row = "log"}, std::move(fields)};
}

std::optional<std::vector<LogRecord>> read_logs(Reading& reading) {
    if (reading.trees().logs.empty()) {
        return std::vector<LogRecord>{};
    }
    return reading.attempt([&] { return read_log_table(reading); });
}

std::vector<LogRecord> on_terrain(std::vector<LogRecord> logs, const rockfall::Terrain& terrain,
                                  Reading& reading) {
    const Eigen::Vector2d origin_m = terrain.origin_m();
    const auto is_on = [&](double x_m, double y_m) {
        return terrain.locate(x_m - origin_m.x(), y_m - origin_m.y()).has_value();
    };
    std::vector<config::Point2> places;
    for (const LogRecord& record : logs) {
        places.push_back({record.log.x1_m, record.log.y1_m});
    }
    const auto outside = std::stable_partition(logs.begin(), logs.end(), [&](const LogRecord& record) {
        return is_on(record.log.x1_m, record.log.y1_m) && is_on(record.log.x2_m, record.log.y2_m);
    });
    if (outside != logs.end()) {
        plausible::OffTerrain judged;  // field by field: g++ 12 takes a half-made temporary for uninitialised
        judged.place = {reading.shown(reading.trees().logs)};
        judged.singular = "log";
        judged.all = logs.size();
        judged.off = static_cast<std::size_t>(logs.end() - outside);
        judged.example =
            joined("log ", config::in_quotes(outside->id), " (x ", config::metres_in_words(outside->log.x1_m),
                   ", y ", config::metres_in_words(outside->log.y1_m), ")");
        judged.places = places;
        judged.swap_advice = reading.trees().swap_logs_xy
                                 ? "set trees.swap_logs_xy = no: the columns are right as they are"
                                 : "set trees.swap_logs_xy = yes, or exchange the columns of x and y";
        const plausible::Extent extent = plausible::extent_of(terrain);
        judged.cut = plausible::cut_command(reading, "logs", reading.trees().logs, extent);
        plausible::judge_off_terrain(judged, extent, reading);
        logs.erase(outside, logs.end());
    }
    return logs;
}

}  // namespace coupling
