#pragma once

#include <string>
#include <vector>

#include "coupling/results/figures/departures.hpp"

namespace coupling::report {

/// Rocks that left on one slope, under its name in a sentence (HTML).
struct DeparturesOfSlope {
    std::string slope;
    Departures departures;
};

/// For the first screen: the share of rocks that leave the terrain on each slope, by edge, and what it means
/// for the other figures. A paragraph of HTML.
std::string departures_line(const std::vector<DeparturesOfSlope>& slopes);

/// Behind a run-out: of which rocks it is, and its bound for all of them. `stopped`: their share [-].
std::string of_those_that_stop(double stopped, const std::string& bound_m);

}  // namespace coupling::report
