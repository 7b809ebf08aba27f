#include "config/text/coordinates.hpp"

#include <cmath>

#include "config/text/numbers.hpp"

namespace config {

std::string metres_in_words(double value_m) {
    constexpr double mm_per_m = 1000.0;
    constexpr double most_mm = 0x1p53;  // beyond, a double holds no millimetres
    const double value_mm = std::round(mm_per_m * value_m);
    return std::abs(value_mm) < most_mm ? to_text(value_mm / mm_per_m + 0.0) : to_text(value_m);
}

std::string place_in_words(double x_m, double y_m) {
    return metres_in_words(x_m).append(", ").append(metres_in_words(y_m));
}

}  // namespace config
