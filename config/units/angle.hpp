#pragma once

#include <numbers>

namespace config {

/// An angle that cannot be read in the wrong unit.
class Angle {
public:
    constexpr Angle() = default;
    static constexpr Angle from_degrees(double degrees) { return Angle{degrees * std::numbers::pi / 180.0}; }
    static constexpr Angle from_radians(double radians) { return Angle{radians}; }
    [[nodiscard]] constexpr double in_degrees() const { return radians_ * 180.0 / std::numbers::pi; }
    [[nodiscard]] constexpr double in_radians() const { return radians_; }

private:
    constexpr explicit Angle(double radians) : radians_{radians} {}
    double radians_ = 0.0;
};

}  // namespace config
