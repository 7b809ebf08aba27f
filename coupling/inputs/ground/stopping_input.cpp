#include "coupling/inputs/ground/stopping_input.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "config/table/schema.hpp"

namespace coupling {

struct StoppingRow {
    std::string name;
    long long code = 0;
    double diameter_m = 0.0;
    double probability = 0.0;
    double rolling_stops_per_m = 0.0;
};

namespace {

using Knot = StoppingRow;

rockfall::StopCurve curve_of(const std::vector<Knot>& knots, double Knot::*value) {
    std::vector<std::pair<double, double>> pairs;
    for (const Knot& knot : knots) {
        pairs.emplace_back(knot.diameter_m, knot.*value);
    }
    return rockfall::StopCurve{std::move(pairs)};
}

}  // namespace

const config::Schema<StoppingRow>& stopping_columns(bool by_code) {
    using R = StoppingRow;
    const auto columns_with = [](config::ColumnOf<R> key) {
        // clang-format off
        return config::Schema<R>{
            {.role = "stopping", .setting = "terrain.stopping", .row = "rate", .unique_together = {{key.name, "diameter_m"}}},
            {key,
             {"diameter_m", &R::diameter_m, "of the rock", {.range = {0.0, 20.0, config::above}}},
             {"p_stop", &R::probability, "stops at an impact", {.unit = "-", .range = {0.0, 1.0}}},
             {"rolling_stops_per_m", &R::rolling_stops_per_m, "rate while rolling, in all rows or none; else 0", {.unit = "1/m", .range = {0.0, 100.0}, .optional = true}}}};
        // clang-format on
    };
    // clang-format off
    static const config::Schema<R> codes =
        columns_with({"code", &R::code, "of terrain.surface_types", {.range = {0.0, 1e6}}});
    // clang-format on
    static const config::Schema<R> names = columns_with({"name", &R::name, "of a shipped ground type"});
    return by_code ? codes : names;
}

std::map<std::string, StoppingCurves> read_stopping_curves(const config::Table& table, const std::string& key,
                                                           config::Problems& problems) {
    const config::Schema<StoppingRow>& columns = stopping_columns(key == "code");
    const bool has_rolling = table.has("rolling_stops_per_m");
    std::map<std::string, std::vector<Knot>> all;
    for (const config::Read<StoppingRow>& row : columns.rows(table, problems)) {
        if (has_rolling && table.text(row.row, "rolling_stops_per_m").empty()) {
            // Between rows with a rate an empty one is no 0.
            table.number(row.row, "rolling_stops_per_m", {0.0, 100.0}, problems);
        }
        all[key == "code" ? std::to_string(row.code) : row.name].push_back(row);
    }
    std::map<std::string, StoppingCurves> curves;
    for (auto& [type, knots] : all) {
        std::sort(knots.begin(), knots.end(),
                  [](const Knot& a, const Knot& b) { return a.diameter_m < b.diameter_m; });
        curves[type] = {curve_of(knots, &Knot::probability), curve_of(knots, &Knot::rolling_stops_per_m),
                        has_rolling, knots.front().diameter_m, knots.back().diameter_m};
    }
    return curves;
}

}  // namespace coupling
