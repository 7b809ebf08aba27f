#pragma once

#include <string>

namespace config {

/// A coordinate or an extent for people [m]: rounded to the millimetre, without an exponent below 2^53.
/// Files keep all digits (`to_text`).
std::string metres_in_words(double value_m);
/// "500000, 300000.5": a place for people, each coordinate as above.
std::string place_in_words(double x_m, double y_m);

}  // namespace config
