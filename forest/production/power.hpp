#pragma once

#include "config/math/elementary.hpp"

namespace forest {

/// base^exponent for a base that may be 0: 0^0 is 1 and 0^p is 0, as Fortran and C have it for p > 0. A base
/// below 0 counts as 0. Same bits on every machine.
inline double power(double base, double exponent) {
    if (exponent == 0.0) {
        return 1.0;
    }
    return base > 0.0 ? config::pow_of(base, exponent) : 0.0;
}

}  // namespace forest
