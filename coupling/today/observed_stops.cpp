#include "coupling/today/observed_stops.hpp"

#include <array>
#include <charconv>
#include <fstream>
#include <string>
#include <string_view>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "coupling/results/csv_row.hpp"
#include "coupling/results/figures.hpp"
#include "coupling/today/static_layouts.hpp"

namespace coupling {

namespace {

using observed::StopComparison;
using observed::StopFigures;

/// Where the fields stand that a stop is made of, by the names of their columns.
class RockColumns {
public:
    RockColumns() {
        const TableLayout& layout = layout_of(static_layouts(), "rocks.csv");
        for (std::size_t i = 0; i < layout.columns.size(); ++i) {
            for (std::size_t wanted = 0; wanted < names.size(); ++wanted) {
                if (layout.columns[i].name == names[wanted]) {
                    places_[wanted] = i;
                }
            }
        }
        columns_ = layout.columns.size();
    }

    /// The wanted fields of a line; nothing if it has another number of fields than the table.
    [[nodiscard]] bool take(std::string_view line, std::array<std::string_view, 7>& wanted) const {
        std::size_t field = 0;
        for (std::size_t begin = 0; begin <= line.size(); ++field) {
            const std::size_t end = std::min(line.find(',', begin), line.size());
            for (std::size_t i = 0; i < places_.size(); ++i) {
                if (places_[i] == field) {
                    wanted[i] = line.substr(begin, end - begin);
                }
            }
            begin = end + 1;
        }
        return field == columns_;
    }

private:
    static constexpr std::array<std::string_view, 7> names{"cover",   "zone",    "x_start_m",  "y_start_m",
                                                           "x_end_m", "y_end_m", "stop_reason"};
    std::array<std::size_t, 7> places_{};
    std::size_t columns_ = 0;
};

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

std::vector<observed::SimulatedStop> simulated_stops(const std::filesystem::path& rocks_csv,
                                                     rockfall::Cover cover) {
    const RockColumns columns;
    std::ifstream in{rocks_csv};
    std::string line;
    const bool has_head = std::getline(in, line).good();
    std::vector<observed::SimulatedStop> stops;
    std::array<std::string_view, 7> fields;
    for (std::size_t number = 2; std::getline(in, line); ++number) {
        observed::SimulatedStop stop;
        if (!columns.take(line, fields) || !read_number(fields[1], stop.zone) ||
            !read_number(fields[2], stop.start_m.x()) || !read_number(fields[3], stop.start_m.y()) ||
            !read_number(fields[4], stop.end_m.x()) || !read_number(fields[5], stop.end_m.y())) {
            config::fail(config::ExitCode::file, {rocks_csv.string(), number, 1}, "a damaged row",
                         "a row that this run wrote", "run again with --overwrite");
        }
        if (fields[0] == name_of(cover)) {
            stop.left_terrain = fields[6] == name_of(rockfall::StopReason::left_terrain);
            stops.push_back(stop);
        }
    }
    if (in.bad() || !has_head) {
        config::fail(config::ExitCode::file, {rocks_csv.string()}, "a table that cannot be read",
                     "the rocks of this run");
    }
    return stops;
}

std::vector<StopComparison> compare_stops(const Site& site, rockfall::Cover cover,
                                          const std::filesystem::path& rows) {
    if (site.observed_stops.empty()) {
        return {};
    }
    return observed::compare_stops(site.observed_stops, simulated_stops(rows / "rocks.csv", cover));
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
