#pragma once

#include <set>
#include <span>
#include <string>

#include "coupling/inputs/site.hpp"

namespace coupling {

struct Scenario;

/// Everything that falls depend on, as text: settings but for those of `beside`, inputs, version.
std::string text_of_settings(const Scenario& scenario, std::span<const InputFile> inputs,
                             const std::set<std::string>& beside = {});

/// Names a run by everything its results depend on. 16 hexadecimal digits.
std::string settings_hash(const Scenario& scenario, std::span<const InputFile> inputs);

}  // namespace coupling
