#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "coupling/inputs/observed/observed_events.hpp"
#include "coupling/inputs/observed/stops.hpp"

namespace coupling::observed {

/// A simulated rock at its first arrival at a target.
struct SimulatedPassage {
    std::uint32_t target = 0;
    double speed_mps = 0.0;
    double height_m = 0.0;
    double energy_kj = 0.0;
    double translational_kj = 0.0;
};

/// A simulated impact that ends a flight, against the face of the terrain.
struct SimulatedImpact {
    int ground = 0;
    double speed_in_mps = 0.0;
    double speed_out_mps = 0.0;  ///< 0 where it stops there
    double angle_in_deg = 0.0;
    double angle_out_deg = 0.0;
};

/// One quantity of a sample in figures.
struct SampleFigures {
    std::size_t count = 0;
    double mean = 0.0;
    double deviation = 0.0;  ///< n - 1; NaN of one value, and of shares
    std::array<double, quantile_shares.size()> quantiles{};
    double largest = 0.0;
};

/// A quantity of passages or impacts, observed beside simulated.
struct EventComparison {
    enum class Kind : std::uint8_t { passage, impact };

    Kind kind = Kind::passage;
    std::string place{};     ///< the target; "" of impacts
    std::string group{};     ///< "" of all
    std::string quantity{};  ///< "speed_mps", ..., "passing_share", "speed_ratio"
    std::string unit{};
    SampleFigures observed{};
    SampleFigures simulated{};
    double largest_distance = 0.0;    ///< Kolmogorov-Smirnov; NaN of shares
    double distance_by_chance = 0.0;  ///< that 5 % of equal distributions exceed; NaN of shares
    double energy_distance = 0.0;     ///< in the unit of the quantity; NaN of shares

    /// "passage.speed_mps:road" and so on: how criteria and tables name it.
    [[nodiscard]] std::string name() const;
};

/// Target by target: the share of rocks that pass (where the number of released rocks is known), then each
/// quantity that was measured, of all and by group. `names`: ids of the targets. `rocks`: that fell.
std::vector<EventComparison> compare_passages(const ObservedEvents& observed,
                                              std::span<const SimulatedPassage> simulated,
                                              std::span<const std::string> names, std::uint64_t rocks);

/// Speeds, ratio of speeds and angles, of all impacts and by group. Impacts whose ground is known are held
/// against simulated ones on the same grounds. Angles and speeds after the impact leave out rocks that stay.
std::vector<EventComparison> compare_impacts(std::span<const ObservedImpact> observed,
                                             std::span<const SimulatedImpact> simulated);

}  // namespace coupling::observed
