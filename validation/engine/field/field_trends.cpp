#include "validation/engine/field/field_trends.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "config/text/joined.hpp"
#include "config/text/words_of_list.hpp"
#include "coupling/inputs/observed/distribution.hpp"

namespace coupling::validation {
namespace {

using config::joined;

constexpr std::array figures_of_ways{
    WayFigure{"displacement_m", "straight way from start to end", "m", &RockWay::straight_m},
    WayFigure{"max_speed_mps", "largest speed", "m/s", &RockWay::max_speed_mps},
};

struct MeanOfWays {
    double mean;
    double squared_error;
};

MeanOfWays mean_of_ways(std::span<const RockWay> ways, const WayFigure& figure) {
    std::vector<double> values;
    for (const RockWay& way : ways) {
        values.push_back(way.*figure.value);
    }
    const observed::Distribution distribution{values};
    const double deviation = distribution.deviation();
    return {distribution.mean(), deviation * deviation / static_cast<double>(distribution.count())};
}

/// Half the 95 % interval of the difference of two means.
double half_interval(const MeanOfWays& a, const MeanOfWays& b) {
    constexpr double normal_quantile = 1.96;
    return normal_quantile * std::sqrt(a.squared_error + b.squared_error);
}

}  // namespace

std::span<const WayFigure> way_figures() {
    return figures_of_ways;
}

std::vector<Trend> read_trends(const config::Table& table, std::span<const std::string> states,
                               config::Problems& problems) {
    std::vector<Trend> trends;
    if (!table.require({"trend", "figure", "states", "source"}, problems)) {
        return trends;
    }
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const std::string& wanted = table.text(row, "figure");
        const auto figure = std::find_if(figures_of_ways.begin(), figures_of_ways.end(),
                                         [&](const WayFigure& f) { return wanted == f.name; });
        if (figure == figures_of_ways.end()) {
            problems.add(config::ExitCode::data, table.place(row, "figure"), config::in_quotes(wanted),
                         "displacement_m or max_speed_mps");
            continue;
        }
        Trend trend{table.text(row, "trend"), &*figure,
                    config::words_between_blanks(table.text(row, "states")), table.text(row, "source")};
        for (const std::string& state : trend.states) {
            if (std::find(states.begin(), states.end(), state) == states.end()) {
                problems.add(config::ExitCode::data, table.place(row, "states"), config::in_quotes(state),
                             "a state of the table of states");
            }
        }
        if (trend.states.size() < 2) {
            problems.add(config::ExitCode::data, table.place(row, "states"), "fewer than two states",
                         "two or more, in the order in which the figure rises");
        }
        trends.push_back(std::move(trend));
    }
    return trends;
}

TrendFound find_trend(const Trend& trend,
                      const std::function<std::span<const RockWay>(const std::string&)>& ways_of) {
    TrendFound found;
    std::vector<MeanOfWays> means;
    for (const std::string& state : trend.states) {
        means.push_back(mean_of_ways(ways_of(state), *trend.figure));
        found.means.push_back(means.back().mean);
        if (means.size() > 1) {
            const MeanOfWays& last = means[means.size() - 2];
            const double beyond = means.back().mean - last.mean + half_interval(last, means.back());
            found.steps_against +=
                std::isfinite(beyond) ? (beyond < 0.0 ? 1.0 : 0.0) : std::numeric_limits<double>::quiet_NaN();
        }
    }
    found.change_low = means.back().mean - means.front().mean - half_interval(means.front(), means.back());
    return found;
}

void name_trend(const Trend& trend, const std::string& prefix, Comparison& comparison) {
    const std::string after = prefix.empty() ? "" : joined(", ", prefix.substr(0, prefix.size() - 1));
    comparison.figures.push_back({.name = joined(prefix, "steps_against:", trend.name),
                                  .label = joined("steps against the trend, ", trend.name, after),
                                  .unit = "-",
                                  .measures = trend.figure->name});
    comparison.figures.push_back({.name = joined(prefix, "change_low:", trend.name),
                                  .label = joined("least change (95 %), ", trend.name, after),
                                  .unit = trend.figure->unit,
                                  .measures = trend.figure->name});
}

void take_trend(const Trend& trend, const std::string& prefix, const TrendFound& found, Outcome& outcome) {
    outcome.values[joined(prefix, "steps_against:", trend.name)] = found.steps_against;
    outcome.values[joined(prefix, "change_low:", trend.name)] = found.change_low;
}

}  // namespace coupling::validation
