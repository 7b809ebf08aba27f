#include "coupling/inputs/ground/stopping_input.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace coupling {

namespace {

struct Knot {
    double diameter_m;
    double probability;
    double rolling_stops_per_m;
};

std::optional<std::string> key_of(const config::Table& table, std::size_t row, const std::string& key,
                                  config::Problems& problems) {
    if (key != "code") {
        return table.text(row, key);
    }
    const auto code = table.whole(row, key, {.low = 0.0, .high = 1e6}, problems);
    return code ? std::optional{std::to_string(*code)} : std::nullopt;
}

rockfall::StopCurve curve_of(const std::vector<Knot>& knots, double Knot::*value) {
    std::vector<std::pair<double, double>> pairs;
    for (const Knot& knot : knots) {
        pairs.emplace_back(knot.diameter_m, knot.*value);
    }
    return rockfall::StopCurve{std::move(pairs)};
}

}  // namespace

std::map<std::string, StoppingCurves> read_stopping_curves(const config::Table& table, const std::string& key,
                                                           config::Problems& problems) {
    if (!table.require({key, "diameter_m", "p_stop"}, problems)) {
        return {};
    }
    const bool has_rolling = table.has("rolling_stops_per_m");
    std::map<std::string, std::vector<Knot>> all;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const auto type = key_of(table, row, key, problems);
        const auto diameter_m =
            table.number(row, "diameter_m", {.low = 0.0, .high = 20.0, .low_excluded = true}, problems);
        const auto probability = table.number(row, "p_stop", {.low = 0.0, .high = 1.0}, problems);
        const auto rolling =
            has_rolling ? table.number(row, "rolling_stops_per_m", {.low = 0.0, .high = 100.0}, problems)
                        : std::optional{0.0};
        if (!type || !diameter_m || !probability || !rolling) {
            continue;
        }
        std::vector<Knot>& knots = all[*type];
        if (std::any_of(knots.begin(), knots.end(),
                        [&](const Knot& knot) { return knot.diameter_m == *diameter_m; })) {
            problems.add(
                config::ExitCode::data, table.place(row, "diameter_m"),
                "diameter " + table.text(row, "diameter_m") + " a second time for " + key + ' ' + *type,
                "each diameter once");
            continue;
        }
        knots.push_back({*diameter_m, *probability, *rolling});
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
