#pragma once

#include "rockfall/slope/slope.hpp"

namespace rockfall {

/// How readily the ground stops one rock. It changes only with the surface, as a rock keeps its size.
class SurfaceStops {
public:
    explicit SurfaceStops(double rock_diameter_m) : diameter_m_{rock_diameter_m} {}

    /// Probability that an impact stops the rock [-].
    double probability(const SurfaceType& surface) {
        if (&surface != probability_of_) {
            probability_of_ = &surface;
            probability_ = surface.stopping.at(diameter_m_);
        }
        return probability_;
    }

    /// Rate at which the rolling rock is caught [1/m].
    double rolling_rate(const SurfaceType& surface) {
        if (&surface != rate_of_) {
            rate_of_ = &surface;
            rate_ = surface.rolling_stops_per_m.at(diameter_m_);
        }
        return rate_;
    }

private:
    double diameter_m_;
    const SurfaceType* probability_of_ = nullptr;
    double probability_ = 0.0;
    const SurfaceType* rate_of_ = nullptr;
    double rate_ = 0.0;
};

}  // namespace rockfall
