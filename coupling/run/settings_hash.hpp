#pragma once

#include <span>
#include <string>

#include "coupling/inputs/site.hpp"

namespace coupling {

struct Scenario;

/// Names a run by everything its results depend on: settings, inputs, version. 16 hexadecimal digits.
std::string settings_hash(const Scenario& scenario, std::span<const InputFile> inputs);

}  // namespace coupling
