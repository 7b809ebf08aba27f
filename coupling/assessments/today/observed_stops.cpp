#include "coupling/assessments/today/observed_stops.hpp"

#include <array>
#include <charconv>
#include <string>
#include <string_view>

#include "config/text/joined.hpp"
#include "coupling/assessments/today/figures/static_layouts.hpp"
#include "coupling/inputs/tables/csv_row.hpp"
#include "coupling/results/figures/figures.hpp"

namespace coupling {

namespace {

using observed::StopComparison;
using observed::StopFigures;

constexpr std::array<std::string_view, 7> rock_columns_read{"cover",   "zone",    "x_start_m",  "y_start_m",
                                                            "x_end_m", "y_end_m", "stop_reason"};

template <class Number>
bool read_number(std::string_view text, Number& number) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc{} && end == text.data() + text.size();
}

void write_side(TableRows& row, const std::string& group, const char* side, const StopFigures& figures) {
    row.text(group.empty() ? "all" : group).text(side).whole(figures.rocks);
    row.number<2>(figures.mean_m).number<2>(figures.deviation_m);
    for (const double quantile_m : figures.quantiles_m) {
        row.number<2>(quantile_m);
    }
    row.number<2>(figures.longest_m).number<2>(figures.sideways_m).number<4>(figures.left_terrain);
}

Json json_side(const StopFigures& figures) {
    Json quantiles;
    for (std::size_t i = 0; i < figures.quantiles_m.size(); ++i) {
        const auto percent = static_cast<int>(100.0 * observed::quantile_shares[i] + 0.5);
        quantiles["p" + std::to_string(percent)] = json_number(figures.quantiles_m[i]);
    }
    return {{"rocks", figures.rocks},
            {"run_out_mean_m", json_number(figures.mean_m)},
            {"run_out_deviation_m", json_number(figures.deviation_m)},
            {"run_out_quantiles_m", quantiles},
            {"run_out_longest_m", json_number(figures.longest_m)},
            {"sideways_deviation_m", json_number(figures.sideways_m)},
            {"left_terrain_share", json_number(figures.left_terrain)}};
}

}  // namespace

std::vector<observed::SimulatedStop> simulated_stops(OwnRows& rocks, rockfall::Cover cover) {
    std::array<std::size_t, rock_columns_read.size()> places{};
    for (std::size_t i = 0; i < places.size(); ++i) {
        places[i] = rocks.column(rock_columns_read[i]);
    }
    std::vector<observed::SimulatedStop> stops;
    while (rocks.next()) {
        const auto field = [&](std::size_t wanted) { return rocks.fields()[places[wanted]]; };
        observed::SimulatedStop stop;
        if (!read_number(field(1), stop.zone) || !read_number(field(2), stop.start_m.x()) ||
            !read_number(field(3), stop.start_m.y()) || !read_number(field(4), stop.end_m.x()) ||
            !read_number(field(5), stop.end_m.y())) {
            rocks.refuse("a field that is no number");
        }
        if (field(0) == name_of(cover)) {
            stop.left_terrain = field(6) == name_of(rockfall::StopReason::left_terrain);
            stops.push_back(stop);
        }
    }
    return stops;
}

std::vector<StopComparison> compare_stops(const Site& site, rockfall::Cover cover,
                                          const StreamedTables& streamed) {
    if (site.observed_stops.empty()) {
        return {};
    }
    OwnRows rocks{streamed.folder / "rocks.csv", streamed.end_of("rocks.csv")};
    return observed::compare_stops(site.observed_stops, simulated_stops(rocks, cover));
}

void write_observed_stops(std::ostream& out, const std::vector<StopComparison>& comparisons) {
    TableRows row{out, static_layouts(), "observed_stops.csv"};
    for (const StopComparison& comparison : comparisons) {
        write_side(row, comparison.group, "observed", comparison.observed);
        row.empty().empty().empty();
        row.end();
        write_side(row, comparison.group, "simulated", comparison.simulated);
        row.number<4>(comparison.largest_distance).number<4>(comparison.distance_by_chance);
        row.number<3>(comparison.energy_distance_m);
        row.end();
    }
}

Json json_observed_stops(const std::vector<StopComparison>& comparisons) {
    Json list = Json::array();
    for (const StopComparison& comparison : comparisons) {
        list.push_back({{"group", comparison.group.empty() ? "all" : comparison.group},
                        {"observed", json_side(comparison.observed)},
                        {"simulated", json_side(comparison.simulated)},
                        {"kolmogorov_smirnov", json_number(comparison.largest_distance)},
                        {"kolmogorov_smirnov_by_chance", json_number(comparison.distance_by_chance)},
                        {"energy_distance_m", json_number(comparison.energy_distance_m)}});
    }
    return list;
}

}  // namespace coupling
