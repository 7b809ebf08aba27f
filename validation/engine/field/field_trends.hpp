#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "config/errors/input_error.hpp"
#include "config/table/table.hpp"
#include "validation/engine/case/comparison.hpp"
#include "validation/engine/field/field_falls.hpp"

namespace coupling::validation {

/// What one rock gives to a figure of a state.
struct WayFigure {
    const char* name;
    const char* label;
    const char* unit;
    double RockWay::*value;
};

/// `displacement_m` and `max_speed_mps`: means over the rocks of a state.
std::span<const WayFigure> way_figures();

/// An order of states in which a figure is expected to rise.
struct Trend {
    std::string name;
    const WayFigure* figure;
    std::vector<std::string> states;
    std::string source;
};

/// Rows of `trend`, `figure`, `states` (apart by blanks, smallest first), `source`. Collects unknown figures,
/// unknown states and trends of fewer than two states.
std::vector<Trend> read_trends(const config::Table& table, std::span<const std::string> states,
                               config::Problems& problems);

/// How the states of a trend follow each other.
struct TrendFound {
    std::vector<double> means;
    double steps_against = 0.0;  ///< steps that fall by more than their 95 % interval; not a number where a
                                 ///< state has fewer than two rocks
    double change_low = 0.0;     ///< lower end of the 95 % interval of the change from first to last
};

/// Requires two rocks or more in each state. Intervals are those of the difference of two means of
/// independent samples, 1.96 standard errors.
TrendFound find_trend(const Trend& trend,
                      const std::function<std::span<const RockWay>(const std::string&)>& ways_of);

/// `steps_against:TREND` and `change_low:TREND`, with a prefix.
void name_trend(const Trend& trend, const std::string& prefix, Comparison& comparison);
void take_trend(const Trend& trend, const std::string& prefix, const TrendFound& found, Outcome& outcome);

}  // namespace coupling::validation
