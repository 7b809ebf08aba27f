#pragma once

#include <string>
#include <vector>

#include "coupling/inputs/site.hpp"

namespace coupling {
struct Scenario;
}

namespace coupling::report {

// Settings that decide a result, for the first screen of a page: each value is marked as a default or as set.

/// A value with the mark "set" where the scenario sets one of the keys, "preset" where rockfall.preset
/// changes one, "default" otherwise; without a mark where settings are not recorded. HTML; `value` is HTML.
std::string marked(const Scenario& scenario, const std::string& value, const std::vector<std::string>& keys);

/// How rocks start: height, speed and direction, or dropped; HTML with marks.
std::string start_of_rocks(const Scenario& scenario);
/// How far rocks may turn sideways at the start and at impacts; HTML with marks.
std::string spread_of_directions(const Scenario& scenario);

/// Entries of a `<dl class="facts">`: number, size and shape, density and start of the rocks, spread of their
/// directions, motion model, set of settings, random seed. `rocks`: their number in words; `sizes`: in place
/// of those of the sources; both HTML.
std::string deciding_facts(const Scenario& scenario, const std::vector<rockfall::ReleaseSource>& sources,
                           const std::string& rocks, const std::string& sizes = "");

/// Criteria of the field cases that a motion model meets, by what it is asked for: the row of the shipped
/// table.
std::string verdicts_on_page(std::string_view model);

}  // namespace coupling::report
