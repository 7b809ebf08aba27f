#pragma once

#include "validation/engine/case/case_result.hpp"
#include "validation/engine/kinds/validation_case.hpp"

namespace coupling::validation {

/// How a case is worked through; none of it changes the outcome.
struct ValidateRequest {
    int threads = 1;
    bool quiet = true;   ///< no progress line
    bool draws = false;  ///< whether observed figures are held against bands of what is not known, too
};

/// Lets the rocks of a case fall under every variant and every moved choice and holds the figures against
/// its criteria; a case of the forest is computed once. A case of factors is handed on to
/// validate_factors().
CaseResult validate(const ValidationCase& of, const ValidateRequest& request);

}  // namespace coupling::validation
