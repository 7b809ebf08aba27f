#pragma once

#include <string>

#include "coupling/assessments/hazard/hazard_results.hpp"

namespace coupling::hazard {

/// The hazard matrix of a page as SVG: rows from the strongest class down, columns from the most frequent on,
/// as guidelines draw it; below them the return periods of the run.
std::string matrix_drawing(const HazardResults& results);

}  // namespace coupling::hazard
