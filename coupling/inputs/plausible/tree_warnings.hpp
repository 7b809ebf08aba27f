#pragma once

#include "config/table/table.hpp"
#include "coupling/inputs/reading/reading.hpp"

namespace coupling::plausible {

/// Says which rows of a list of trees look wrong, where the first stands and what the likely cause is:
/// warnings of odd_trees() and unlike_trees(), and a refusal where many trees are impossible.
void judge_odd_trees(const config::Table& table, Reading& reading);

}  // namespace coupling::plausible
