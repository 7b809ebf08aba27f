#pragma once

#include <span>
#include <string>

namespace coupling {
struct Scenario;
}

namespace coupling::validation::years {

/// Laws of the forest that are not the defaults of a run in some scenario: who reads the verdicts should know
/// them.
std::string changed_laws(std::span<const Scenario* const> scenarios);

}  // namespace coupling::validation::years
