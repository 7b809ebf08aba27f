#pragma once

#include <utility>
#include <vector>

#include "rockfall/laws/losses.hpp"

namespace rockfall {

class ShapeLaw;

/// Standard deviation of the logarithm of the elongation of rock fragments [choice].
inline constexpr double usual_elongation_scatter = 0.25;

/// Longest side of a rock by its shortest [-]: of one shape or several, scattered ln-normally, at least 1.
class ElongationLaw {
public:
    ElongationLaw();  ///< of rock fragments whose shape is not known
    /// Requires a median >= 1 and a standard deviation of the logarithm >= 0.
    ElongationLaw(double median, double log_deviation);
    /// Of given shapes by their shares; sides that are scattered independently.
    explicit ElongationLaw(const ShapeLaw& shapes);

    /// `u` on [0, 1) chooses the shape, `z` is a standard normal deviate.
    [[nodiscard]] double at(double u, double z) const;

private:
    std::vector<std::pair<double, double>> medians_;  ///< (share up to it, median)
    double log_deviation_;
};

}  // namespace rockfall
