#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "coupling/assessments/vary/study/plan.hpp"
#include "coupling/results/figures/figures.hpp"

namespace coupling::vary {

/// A target under one combination.
struct TargetOutcome {
    std::string id;
    std::string name;
    ArrivalFigures bare;
    ArrivalFigures forest;                       ///< empty without forest
    std::optional<ProtectionEffect> protection;  ///< nothing without forest or without arrivals
    bool too_few = false;                        ///< rocks that arrive, to speak of protection

    /// What the study is about: what the forest stops, else the share of rocks that arrive. NaN if unknown.
    [[nodiscard]] double answer(bool with_forest) const;
};

/// All of the run of one combination.
struct Outcome {
    Combination combination;
    bool with_forest = false;
    std::uint64_t rocks = 0;
    double run_out_mean_m = 0.0;  ///< of the rocks that stop, through the forest where there is one
    Share left_terrain;           ///< on the same slope
    std::vector<TargetOutcome> targets;
};

}  // namespace coupling::vary
