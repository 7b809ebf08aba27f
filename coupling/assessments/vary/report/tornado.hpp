#pragma once

#include <string>
#include <vector>

#include "coupling/assessments/vary/study/outcomes.hpp"

namespace coupling::vary::report {

/// A setting that was moved alone, and how far the answer moved with it.
struct Sway {
    std::string setting;
    std::string low_value;   ///< of the setting, where the answer is lowest
    std::string high_value;  ///< where it is highest
    double low = 0.0;        ///< the answer there; that of the scenario counts, too
    double high = 0.0;

    [[nodiscard]] double width() const { return high - low; }
};

/// The answer of a run; NaN where it is unknown.
struct Answer {
    Combination combination;
    double value = 0.0;
};

/// The settings that move the answer, the widest first; the answer of the scenario stands first. Empty where
/// that is unknown.
std::vector<Sway> sways_of(const std::vector<Factor>& factors, const std::vector<Answer>& answers);

/// The chart as inline SVG: a bar a setting, a line at the answer of the scenario.
std::string tornado(const std::vector<Sway>& sways, double answer, const std::string& axis_title);

}  // namespace coupling::vary::report
