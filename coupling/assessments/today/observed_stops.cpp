#include "coupling/assessments/today/observed_stops.hpp"

#include <array>
#include <charconv>
#include <string>
#include <string_view>

#include "config/text/joined.hpp"
#include "coupling/results/tables/figure_columns.hpp"

namespace coupling {

namespace {

using config::joined;
using observed::StopComparison;
using observed::StopFigures;

constexpr std::array<std::string_view, 7> rock_columns_read{"cover",   "zone",    "x_start_m",  "y_start_m",
                                                            "x_end_m", "y_end_m", "stop_reason"};

template <class Number>
bool read_number(std::string_view text, Number& number) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc{} && end == text.data() + text.size();
}

/// One side of a comparison.
struct SideRow {
    const StopComparison& of;
    bool observed;
};

TableOf<SideRow> stop_table() {
    constexpr const char* as_row_says = "as the row says";
    const auto run_out = [](const char* name, const std::string& of, auto value) {
        return ColumnsOf<StopFigures>{name, 2, joined(of, " of the plan distance from release to stop"),
                                      as_row_says, value};
    };
    const auto quantile = [&](const char* name, const std::string& of, std::size_t number) {
        return run_out(name, of, [number](const StopFigures& f) { return f.quantiles_m[number]; });
    };
    return {
        "observed_stops.csv",
        "Where rocks were seen to stop beside where the simulated ones do.",
        "a group of stops, observed or simulated",
        {{"group", "column group of the observed stops; all: every stop", "input observed.stops",
          [](const auto& row) { return row.of.group.empty() ? "all" : row.of.group; }},
         {"side", "observed or simulated", "definition",
          [](const auto& row) { return row.observed ? "observed" : "simulated"; }},
         {ColumnsOf<StopFigures>{
              {"rocks", "stops", from_counting, &StopFigures::rocks},
              run_out("run_out_mean_m", "mean", &StopFigures::mean_m),
              run_out("run_out_deviation_m", "standard deviation (n - 1)", &StopFigures::deviation_m),
              quantile("run_out_p10_m", "10 % quantile", 0),
              quantile("run_out_p25_m", "25 % quantile", 1),
              quantile("run_out_p50_m", "median", 2),
              quantile("run_out_p75_m", "75 % quantile", 3),
              quantile("run_out_p90_m", "90 % quantile", 4),
              run_out("run_out_longest_m", "largest value", &StopFigures::longest_m),
              {"sideways_deviation_m", 2,
               "standard deviation of the distance from the axis, which leads from the mean release to the "
               "mean observed stop",
               as_row_says, &StopFigures::sideways_m},
              {"left_terrain_share", 4, "share that left the terrain: their run-out ends there",
               &StopFigures::left_terrain}},
          [](const auto& row) { return &(row.observed ? row.of.observed : row.of.simulated); }},
         {ColumnsOf<StopComparison>{
              {"ks", 4, "largest distance between the distributions of run-out (Kolmogorov-Smirnov)",
               "both distributions", &StopComparison::largest_distance},
              {"ks_by_chance", 4, "what 5 % of samples of one distribution exceed", "Smirnov 1948",
               &StopComparison::distance_by_chance},
              {"energy_distance_m", 3, "2 E|X - Y| - E|X - X'| - E|Y - Y'| of the run-outs",
               "Szekely & Rizzo 2013", &StopComparison::energy_distance_m}},
          [](const auto& row) { return row.observed ? nullptr : &row.of; }}}};
}

Json json_side(const StopFigures& figures) {
    Json quantiles;
    for (std::size_t i = 0; i < figures.quantiles_m.size(); ++i) {
        const auto below_percent = static_cast<int>(100.0 * observed::quantile_shares[i] + 0.5);
        quantiles["p" + std::to_string(below_percent)] = json_number(figures.quantiles_m[i]);
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

TableLayout observed_stops_layout() {
    return stop_table();
}

WrittenFile write_observed_stops(const std::filesystem::path& folder,
                                 const std::vector<StopComparison>& comparisons) {
    return stop_table().write(folder, [&](auto& rows) {
        for (const StopComparison& comparison : comparisons) {
            rows.add({comparison, true});
            rows.add({comparison, false});
        }
    });
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
