#pragma once

#include <cstdint>
#include <string>

#include "config/errors/input_error.hpp"
#include "config/options/options.hpp"

namespace coupling {

/// Which energy of the rocks in a cell is the intensity there.
enum class HazardEnergy : std::uint8_t { mean, p50, p90, p95, p98, p99, max };

/// How energy and frequency of rocks give a level: README.md of the hazard room has each rule with its
/// source.
enum class HazardRule : std::uint8_t {
    cadanav,  ///< return period at the place of rocks of each class of energy
    arrival,  ///< percentile of those that pass, return period of all that arrive
    release,  ///< percentile of those that pass, return period of the release
};

/// The settings of section [hazard].
struct HazardSettings {
    std::string blocks;                ///< CSV of block sizes by return period and zone; empty: none
    double return_period_years = 0.0;  ///< only this one of them; 0: all, and the hazard map from them
    HazardEnergy energy = HazardEnergy::p95;
    HazardRule rule = HazardRule::release;
    double least_reach_percent = 0.0;  ///< cells with a smaller reach probability are left out
    double smallest_zone_m2 = 400.0;   ///< smaller zones are part of what lies higher around them
    double reference_width_m = 10.0;   ///< square around a cell in which rocks count for it; 0: the cell
    std::string matrix;                ///< CSV of hazard levels; empty: the shipped one

    /// The width in which rocks count for a cell: the rule `release` needs none.
    [[nodiscard]] double counted_width_m() const {
        return rule == HazardRule::release ? 0.0 : reference_width_m;
    }
};

/// The settings of section [risk].
struct RiskSettings {
    bool assess = false;
    std::string curves{};               ///< CSV of lethality and damage by energy; empty: the shipped one
    double rocks_per_year = 0.0;        ///< over years: that really start on the whole slope
    double vehicle_length_m = 5.0;      ///< of roads whose target says none
    double passages_per_day = 2.0;      ///< of the one person whose risk on a road is given
    double prevented_death = 5e6;       ///< what it is worth to prevent one death, in `currency`
    double closure_days = 0.0;          ///< of a road for each rock that hits it
    double closure_cost_per_day = 0.0;  ///< in `currency`
    std::string currency = "CHF";
    std::string without{};          ///< folder of a finished hazard run without nets and works; empty: none
    double interest_percent = 2.0;  ///< a year, of the annual cost of nets and works
    double individual_goal = 1e-5;  ///< protection goal: highest individual risk a year
};

void declare(config::Options& options, RiskSettings& risk);

/// Days of closure without what a day costs, and the other way round: problems of the settings.
void check(const RiskSettings& risk, const config::Options& options, config::Problems& problems);

}  // namespace coupling
