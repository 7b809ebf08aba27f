#pragma once

#include <string>

#include "coupling/results/report/chart.hpp"

namespace coupling::report {

/// An axis for shares in percent from 0 on. Where all values lie above 60 %, and so close together at its
/// upper end, it begins at a round number a little below the smallest and says so in its title.
Axis percent_axis(std::string title, double least, double most);

}  // namespace coupling::report
