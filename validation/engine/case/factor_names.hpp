#pragma once

#include <string>

#include "validation/engine/case/case_result.hpp"

namespace coupling::validation {

/// A setting or figure of factors for people, with its unit: "mean DBH, cm", "protection effect"; an unknown
/// one as it is.
std::string factor_name(const std::string& key);
/// With its value: "mean DBH 20 cm", "200 stems/ha".
std::string factor_at(const std::string& key, const std::string& value);
/// "protection effect rises with stems/ha", as the literature has it.
std::string direction_name(const DirectionRow& row);

}  // namespace coupling::validation
