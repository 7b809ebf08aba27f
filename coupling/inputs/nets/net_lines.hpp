#pragma once

#include <Eigen/Core>
#include <cmath>
#include <string>
#include <vector>

#include "config/text/numbers.hpp"

namespace coupling {

using PlanLine = std::vector<Eigen::Vector2d>;

/// Length in plan.
inline double plan_length_m(const PlanLine& line) {
    double length_m = 0.0;
    for (std::size_t i = 1; i < line.size(); ++i) {
        length_m += (line[i] - line[i - 1]).norm();
    }
    return length_m;
}

/// Whether a line crosses, touches or folds back onto itself; it may close. Such a line has no order along
/// it.
bool meets_itself(const PlanLine& line);

/// How far one line runs along another: over what length in plan it lies no farther than `within_m` beside
/// it. Stretches of up to `least_m` do not count: lines that cross share a few times `within_m`.
double shared_length_m(const PlanLine& line, const PlanLine& other, double within_m, double least_m);

/// The length over which two nets stand in one place, 0 where they do not.
///
/// A rock meets them there at once, and where it breaks one of them it starts again on the line of the other,
/// on neither side of it. Nets that cross or touch in a point do stand apart: no rock meets a point.
/// One place is what lies within a micrometre for more than a millimetre, or within a centimetre for more
/// than ten: nets are found on chords, beside which a sliding rock may start again by about that much
/// [choice].
double length_in_one_place_m(const PlanLine& line, const PlanLine& other);

/// A length or coordinate as messages show it, to the centimetre.
inline std::string to_centimetres(double length_m) {
    constexpr double cm_per_m = 100.0;
    return config::to_text(std::round(cm_per_m * length_m) / cm_per_m);
}

}  // namespace coupling
