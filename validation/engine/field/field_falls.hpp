#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "coupling/inputs/observed/events.hpp"
#include "coupling/inputs/observed/stops.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/inputs/site.hpp"
#include "validation/engine/case/comparison.hpp"
#include "validation/engine/field/first_impacts.hpp"

namespace coupling::validation {

/// A scenario of a field case, opened.
struct OpenedField {
    std::string model;  ///< name of its motion model
    std::unique_ptr<Scenario> scenario;
    Site site;

    [[nodiscard]] std::uint64_t rocks() const {
        return site.sources.empty() ? 0 : site.sources.back().first_rock + site.sources.back().rocks;
    }
};

/// How far one rock got and how fast it was.
struct RockWay {
    double straight_m = 0.0;  ///< from start to end, in space
    double max_speed_mps = 0.0;
};

/// What its rocks did, over the slope with its trees and logs where it has any.
struct FallenField {
    std::vector<observed::SimulatedStop> stops;
    std::vector<observed::EventComparison> events;  ///< beside what was observed
    std::vector<std::uint64_t> arrived{};           ///< rocks that reached each target
    std::vector<RockWay> ways{};                    ///< as `stops`
    FirstImpacts first_impacts{};                   ///< where they were asked for
};

/// Throws InputError where the scenario or its files are wrong. Its warnings are those of `bannwald check`.
OpenedField open_field(const std::filesystem::path& file, const std::vector<std::string>& overrides);

/// Throws Interrupted. `first_impacts`: whether those are wanted.
FallenField fall_field(const OpenedField& opened, const Work& work, bool first_impacts = false);

}  // namespace coupling::validation
