#pragma once

#include <string>

namespace config {

/// A number with so many digits, as short as it can be: "0.00123", "1e-07", "12.5".
std::string with_digits(double value, int digits);

/// A number with so many decimals and no exponent: "46.80000000". Requires one below 1e20.
std::string with_decimals(double value, int decimals);

}  // namespace config
