#pragma once

#include <span>
#include <string>
#include <vector>

#include "rockfall/tally/impact_log.hpp"
#include "validation/engine/case/comparison.hpp"

namespace coupling::validation {

/// How rocks rebound from the first ground that they hit, as somebody with a camera measures it: ratios of
/// the parts of velocity across and along the face, after and before the impact. A rock that stops there
/// counts with 0; one that hits nothing does not count.
struct FirstImpacts {
    std::vector<double> normal_ratios;      ///< normal restitution [-]
    std::vector<double> tangential_ratios;  ///< tangential restitution [-], of rocks that came along the face
    std::vector<double> angles_in_deg;      ///< below the face
    std::vector<double> speeds_in_mps;
};

FirstImpacts first_impacts_of(std::span<const rockfall::RockImpacts> rocks, rockfall::Cover cover);

/// Names `first_normal_ratio_mean:STATE`, `_p10`, `_p90`, the same of `first_tangential_ratio`,
/// `first_angle_in_deg:STATE` and `first_speed_in_mps:STATE` (means).
void name_first_impacts(const std::string& state, const std::string& meaning, Comparison& comparison);

/// Enters them. Figures of an empty sample are left out.
void take_first_impacts(const std::string& state, const FirstImpacts& impacts, Outcome& outcome);

}  // namespace coupling::validation
