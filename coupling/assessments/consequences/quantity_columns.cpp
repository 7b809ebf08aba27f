#include "coupling/assessments/consequences/quantity_columns.hpp"

#include <cmath>

namespace coupling::consequences {

double six_digits(double value) {
    if (!std::isfinite(value) || value == 0.0) {
        return value;
    }
    constexpr double ten = 10.0;
    const double shift = 5.0 - std::floor(std::log10(std::abs(value)));
    return shift >= 0.0 ? std::round(value * std::pow(ten, shift)) / std::pow(ten, shift)
                        : std::round(value / std::pow(ten, -shift)) * std::pow(ten, -shift);
}

}  // namespace coupling::consequences
