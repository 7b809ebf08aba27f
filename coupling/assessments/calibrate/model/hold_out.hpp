#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "coupling/inputs/scenario/calibrate_settings.hpp"

namespace coupling::calibrate {

/// Marks of those that are held out; of whole groups the same ones for all kinds.
class HoldOut {
public:
    /// Keeps a reference.
    HoldOut(const CalibrateSettings& settings, std::uint64_t seed) : settings_{settings}, seed_{seed} {}

    /// `kind`: for the random numbers. `groups`: of each observation.
    [[nodiscard]] std::vector<bool> of(std::uint16_t kind, const std::vector<std::string>& groups);
    [[nodiscard]] bool found_group() const { return found_group_; }

private:
    const CalibrateSettings& settings_;
    std::uint64_t seed_;
    bool found_group_ = false;
};

}  // namespace coupling::calibrate
