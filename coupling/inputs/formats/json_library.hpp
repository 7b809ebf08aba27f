#pragma once

// The one place that includes the JSON library: it is long to compile.
#include <nlohmann/json.hpp>

namespace coupling {

using Json = nlohmann::ordered_json;

}  // namespace coupling
