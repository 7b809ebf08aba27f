#pragma once

#include <string>
#include <vector>

#include "coupling/assessments/decades/decision/decision.hpp"

namespace coupling::decades {

/// The answer in sentences over all climates and targets, without markup: the cheapest regime that keeps what
/// is asked for, or that none is known to, and what would decide it.
std::vector<std::string> verdict(const Names& names, const Decision& decision);

}  // namespace coupling::decades
