#pragma once

#include "validation/engine/case/case_result.hpp"

namespace coupling::validation::testing {

/// A forested slope with everything a case can have, filled by hand: of its three criteria strict misses one,
/// default none, and moving a choice turns one of default.
CaseResult forested_case();
/// A slope with one figure and nothing else.
CaseResult bare_case();

}  // namespace coupling::validation::testing
