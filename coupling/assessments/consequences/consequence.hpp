#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "coupling/assessments/consequences/risk_curves.hpp"
#include "coupling/inputs/places/target_exposure.hpp"
#include "coupling/inputs/scenario/hazard_settings.hpp"

namespace coupling::consequences {

/// What is counted at a target, each a year.
enum class Quantity : std::uint8_t {
    arrivals,         ///< blocks that hit it
    vehicles_hit,     ///< of a road
    individual_risk,  ///< chance of death of one person: who passes, or lives there
    deaths,           ///< expected
    damage,           ///< to the house, in risk.currency
    closure_days,     ///< of the road
    closure,          ///< of the road, in risk.currency
    money,            ///< deaths at risk.prevented_death, damage and closure
};
inline constexpr std::size_t quantities = 8;
constexpr std::size_t index_of(Quantity quantity) {
    return static_cast<std::size_t>(quantity);
}
using Quantities = std::array<double, quantities>;

/// What one block that hits does on average.
///
/// - a road: vehicles in its way (presence.hpp) x persons in each x lethality; the person of the individual
///   risk passes risk.passages_per_day times; risk.closure_days of closure.
/// - a house: persons x share of the day x lethality; value x damage.
Quantities consequence(const TargetExposure& exposure, const CurveClass& energy, double block_diameter_m,
                       const RiskSettings& settings);

/// Whether a target has what a quantity counts: persons, a value, traffic, and of closure settings of it.
/// Where it has not, nothing is known of the quantity there, and it is not 0.
bool has_what_counts(const TargetExposure& exposure, Quantity quantity, const RiskSettings& settings);

/// Whether any of several has.
bool any_has_what_counts(std::span<const TargetExposure> exposures, Quantity quantity,
                         const RiskSettings& settings);

}  // namespace coupling::consequences
