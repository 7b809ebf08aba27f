#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "config/geometry/shape.hpp"

namespace coupling {

/// A rock that was seen at a target. What was not measured is missing.
struct ObservedPassage {
    std::uint32_t target = 0;                ///< its place in the list of targets
    std::optional<double> speed_mps;         ///< at the first arrival
    std::optional<double> height_m;          ///< of the underside above the ground, vertical
    std::optional<double> energy_kj;         ///< translation and rotation
    std::optional<double> translational_kj;  ///< translation alone
    std::string group;                       ///< such as the block; "" without
};

/// An impact that was seen, speeds and angles against the face of the ground.
struct ObservedImpact {
    std::optional<int> ground;            ///< code of the ground type; none: any
    std::optional<double> speed_in_mps;   ///< before it
    std::optional<double> speed_out_mps;  ///< after it; 0 where the rock stayed
    std::optional<double> angle_in_deg;   ///< below the face
    std::optional<double> angle_out_deg;  ///< above the face
    std::string group;
    std::optional<Eigen::Vector2d> at_m{};  ///< in the coordinates of the input files
    std::string track{};                    ///< of one rock: its impacts in their order; "" without a place
};

/// A stem that was searched for wounds.
struct ObservedTree {
    Eigen::Vector2d at_m = Eigen::Vector2d::Zero();  ///< in the coordinates of the input files
    std::optional<double> dbh_cm;
    std::uint64_t scars = 0;
    std::size_t line = 0;  ///< of the file
};

/// A wound that a rock left on a stem.
struct ObservedScar {
    double height_m = 0.0;                ///< of its middle above the ground
    std::optional<Eigen::Vector2d> at_m;  ///< in the coordinates of the input files
    std::optional<double> dbh_cm;
    std::string group;
};

/// What was seen of an event beside the stops.
struct ObservedEvents {
    std::vector<ObservedPassage> passages;
    std::vector<ObservedImpact> impacts;
    std::uint64_t rocks = 0;               ///< that were released; 0: unknown
    std::vector<ObservedScar> scars{};     ///< for calibration alone
    std::vector<config::Shape> window{};   ///< polygons where stops were looked for; none: everywhere
    std::vector<ObservedTree> trees{};     ///< for calibration alone
    std::vector<config::Shape> outline{};  ///< polygons around the blocks, for calibration alone

    /// Neither passages nor impacts.
    [[nodiscard]] bool empty() const { return passages.empty() && impacts.empty(); }
};

}  // namespace coupling
