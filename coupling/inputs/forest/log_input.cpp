#include "coupling/inputs/forest/log_input.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "config/options/values.hpp"
#include "config/text/coordinates.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/forest/species_column.hpp"
#include "coupling/inputs/forest/species_table.hpp"
#include "coupling/inputs/plausible/off_terrain.hpp"
#include "coupling/inputs/plausible/units.hpp"
#include "rockfall/obstacles/log.hpp"

namespace coupling {
namespace {

using config::joined;
using config::NumberRange;

constexpr double longest_log_m = 150.0;
constexpr NumberRange diameter_range_cm{.low = 0.0, .high = 500.0, .low_excluded = true};
constexpr NumberRange length_range_m{.low = 0.0, .high = longest_log_m, .low_excluded = true};
constexpr NumberRange clearance_range_m{.low = 0.0, .high = 20.0};
constexpr NumberRange log_strength_range{.low = 0.0, .high = 1.0};

/// A log list with the fields of its rows; what is wrong becomes a problem.
class LogTable {
public:
    LogTable(const config::Table& table, config::Problems& problems, bool swap_axes)
        : table_{table},
          problems_{problems},
          swap_axes_{swap_axes},
          by_ends_{table.has("x1_m") || table.has("x2_m")},
          one_diameter_{table.has("dbh_cm")} {}

    [[nodiscard]] bool has_columns() const {
        std::vector<std::string> wanted{"species"};
        for (const char* column : by_ends_ ? std::vector{"x1_m", "y1_m", "x2_m", "y2_m"}
                                           : std::vector{"x_m", "y_m", "length_m", "azimuth_deg"}) {
            wanted.emplace_back(column);
        }
        for (const char* column :
             one_diameter_ ? std::vector{"dbh_cm"} : std::vector{"diameter1_cm", "diameter2_cm"}) {
            wanted.emplace_back(column);
        }
        return table_.require(wanted, problems_);
    }

    [[nodiscard]] std::optional<rockfall::Log> log_of(std::size_t row) const {
        const std::size_t problems_before = problems_.list().size();
        rockfall::Log log;
        by_ends_ ? take_ends(row, log) : take_direction(row, log);
        log.diameter1_cm = number(row, one_diameter_ ? "dbh_cm" : "diameter1_cm", diameter_range_cm);
        log.diameter2_cm = one_diameter_ ? log.diameter1_cm : number(row, "diameter2_cm", diameter_range_cm);
        log.clearance_m = given(row, "clearance_m") ? number(row, "clearance_m", clearance_range_m) : 0.0;
        log.strength = given(row, "strength") ? number(row, "strength", log_strength_range) : 1.0;
        log.supported = given(row, "anchored") && flag(row, "anchored");
        return problems_.list().size() == problems_before ? std::optional{log} : std::nullopt;
    }

    [[nodiscard]] std::string id_of(std::size_t row) const {
        return given(row, "log_id") ? table_.text(row, "log_id") : std::to_string(row + 1);
    }

private:
    [[nodiscard]] bool given(std::size_t row, const char* column) const {
        return table_.has(column) && !table_.text(row, column).empty();
    }
    [[nodiscard]] double number(std::size_t row, const char* column, const NumberRange& range) const {
        return table_.number(row, column, range, problems_).value_or(0.0);
    }
    [[nodiscard]] bool flag(std::size_t row, const char* column) const {
        const auto value = config::flag_in(table_.text(row, column));
        if (!value) {
            problems_.add(config::ExitCode::data, table_.place(row, column),
                          joined(column, " ", config::in_quotes(table_.text(row, column))), "yes or no");
        }
        return value.value_or(false);
    }
    void take_ends(std::size_t row, rockfall::Log& log) const {
        const std::size_t problems_before = problems_.list().size();
        log.x1_m = number(row, swap_axes_ ? "y1_m" : "x1_m", {});
        log.y1_m = number(row, swap_axes_ ? "x1_m" : "y1_m", {});
        log.x2_m = number(row, swap_axes_ ? "y2_m" : "x2_m", {});
        log.y2_m = number(row, swap_axes_ ? "x2_m" : "y2_m", {});
        const double length_m = std::hypot(log.x2_m - log.x1_m, log.y2_m - log.y1_m);
        if (problems_.list().size() == problems_before && !length_range_m.contains(length_m)) {
            problems_.add(config::ExitCode::data, table_.place(row, "x2_m"),
                          joined("a log of ", config::to_text(length_m), " m"),
                          joined("a length in ", config::to_string(length_range_m), " m"));
        }
    }
    void take_direction(std::size_t row, rockfall::Log& log) const {
        const double length_m = number(row, "length_m", length_range_m);
        const double azimuth =
            number(row, "azimuth_deg", {.low = -360.0, .high = 360.0}) * std::numbers::pi / 180.0;
        log.x1_m = number(row, swap_axes_ ? "y_m" : "x_m", {});
        log.y1_m = number(row, swap_axes_ ? "x_m" : "y_m", {});
        log.x2_m = log.x1_m + length_m * std::sin(azimuth);
        log.y2_m = log.y1_m + length_m * std::cos(azimuth);
    }

    const config::Table& table_;
    config::Problems& problems_;
    bool swap_axes_;
    bool by_ends_;
    bool one_diameter_;
};

void warn_of_doubled_ids(const std::vector<LogRecord>& logs, const std::string& file, Reading& reading) {
    std::set<std::string> seen;
    std::set<std::string> doubled;
    for (const LogRecord& log : logs) {
        if (!seen.insert(log.id).second) {
            doubled.insert(log.id);
        }
    }
    if (!doubled.empty()) {
        reading.warn({file},
                     joined(counted(doubled.size(), "log_id"), " used more than once, such as ",
                            config::in_quotes(*doubled.begin())),
                     "one log_id for each log", "", config::Effect::detail);
    }
}

std::vector<LogRecord> read_log_table(Reading& reading) {
    const config::Table table = reading.table("trees.logs", "logs", reading.scenario().logs);
    config::Problems problems;
    const LogTable rows{table, problems, reading.scenario().swap_log_axes};
    if (!rows.has_columns()) {
        problems.throw_if_any();
    }
    plausible::check_log_units(table);
    const SpeciesTable known = SpeciesTable::shipped();
    const SpeciesLookup lookup = lookup_in(known);
    SpeciesColumn column{table, lookup};
    std::vector<LogRecord> logs;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        auto log = rows.log_of(row);
        const auto species = column.find(row);
        if (log && species) {
            const Species& kind = known.all()[*species];
            log->fracture_energy = kind.fracture_energy;
            logs.push_back({rows.id_of(row), kind.code, *log});
        }
    }
    config::Problems shown;
    column.refuse_unknown(shown);
    add_first(shown, problems, table.file());
    shown.throw_if_any();
    if (logs.empty()) {
        reading.warn({table.file()}, "no logs", "at least one, or no trees.logs");
    }
    warn_of_doubled_ids(logs, table.file(), reading);
    return logs;
}

}  // namespace

std::optional<std::vector<LogRecord>> read_logs(Reading& reading) {
    if (reading.scenario().logs.empty()) {
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
        judged.place = {reading.shown(reading.scenario().logs)};
        judged.singular = "log";
        judged.all = logs.size();
        judged.off = static_cast<std::size_t>(logs.end() - outside);
        judged.example =
            joined("log ", config::in_quotes(outside->id), " (x ", config::metres_in_words(outside->log.x1_m),
                   ", y ", config::metres_in_words(outside->log.y1_m), ")");
        judged.places = places;
        judged.swap_advice = reading.scenario().swap_log_axes
                                 ? "set trees.swap_logs_xy = no: the columns are right as they are"
                                 : "set trees.swap_logs_xy = yes, or exchange the columns of x and y";
        plausible::judge_off_terrain(judged, plausible::extent_of(terrain), reading);
        logs.erase(outside, logs.end());
    }
    return logs;
}

}  // namespace coupling
