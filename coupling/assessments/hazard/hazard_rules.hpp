#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "coupling/assessments/hazard/hazard_matrix.hpp"
#include "coupling/inputs/scenario/hazard_settings.hpp"

namespace coupling::hazard {

/// "cadanav", "arrival" or "release", as in hazard.rule.
const char* rule_name(HazardRule rule);
/// The rule that a page sets beside another one: that of the release; beside it cadanav.
HazardRule compared_with(HazardRule rule);

/// The energy of rocks at a place, and what it rests on.
struct EnergyOfRocks {
    double kj = std::numeric_limits<double>::quiet_NaN();  ///< hazard.energy; or that of the largest rock
    std::uint64_t rocks = 0;                               ///< of which it is; 0: not counted, as in cells
    bool is_largest = false;  ///< the percentile needs more rocks: it is the largest of these
};

/// "hazard.energy" or "largest"; "" of no rocks.
const char* statistic_name(const EnergyOfRocks& energy);

/// Rocks of one return period at a place: a cell, a road, a house.
struct RocksAtPlace {
    double per_release = 0.0;               ///< how many arrive each time that each zone releases one [-]
    std::vector<double> per_release_above;  ///< by class of energy: those of its lower end and above [-]
    EnergyOfRocks energy{};                 ///< of those that arrive
    /// By class of energy: simulated rocks of its lower end and above, in cells about; empty: not counted.
    std::vector<double> rocks_above{};
};

/// The rocks of one return period at a place, and how often they are released.
struct PeriodAtPlace {
    double release_years = 0.0;
    RocksAtPlace rocks{};
};

/// Fewer rocks may give a level by chance alone [choice]: of five none would have come with 0.7 % (Poisson),
/// and all five on the same one of two equal slopes with 3 %.
inline constexpr double least_rocks_of_level = 5.0;

/// A level and what gives it.
struct RuledLevel {
    Level level = Level::none;
    std::size_t intensity = 0;                               ///< number of the class, from 0
    double years = std::numeric_limits<double>::infinity();  ///< return period that the matrix was asked
    /// Of the rocks that give it; of several return periods of the one that brings most of them, by `arrival`
    /// of those whose energy lies in the class.
    double release_years = std::numeric_limits<double>::infinity();
    EnergyOfRocks energy{};  ///< of the rocks of that return period
    double rocks = 0.0;      ///< simulated ones that give it, of all return periods; 0: not counted

    /// So few that another simulation of as many may show none.
    [[nodiscard]] bool rests_on_chance() const { return rocks > 0.0 && rocks < least_rocks_of_level; }

    /// None arrives.
    [[nodiscard]] bool is_free() const { return !(release_years < std::numeric_limits<double>::infinity()); }
};

/// Mean time between two arrivals of rocks of which `per_release` arrive for each release: frequencies
/// multiply, so that periods are divided. Infinite where none arrives.
double arrival_return_period_years(double release_years, double per_release);

/// The level that the rocks of all return periods give a place; `none` where none of them arrives.
///
/// By `cadanav` and `arrival` the frequencies of the return periods are added up in each class of energy, so
/// that it is the same whether rocks stand as one scenario or as several that share its frequency; of classes
/// that give the same level the highest stands. By `cadanav` rocks count in the classes of their energies, by
/// `arrival` all rocks of a return period in that of hazard.energy and those below. By `release` each return
/// period is judged by itself, and the highest level counts.
RuledLevel level_of(HazardRule rule, const Matrix& matrix, std::span<const PeriodAtPlace> periods);

/// The one of `release` that counts: the higher level; of equal ones that whose energy is known, before one
/// with too few rocks for hazard.energy; of two with too few that of more rocks, then that of more energy;
/// else that of the shorter return period.
const RuledLevel& higher(const RuledLevel& a, const RuledLevel& b);

/// From a level up to another one: below 0 where that is lower.
int steps_between(Level from, Level to);

/// Places whose level by the rule that a map is compared with differs by the same number of steps.
struct LevelSteps {
    int steps = 0;                      ///< of the compared level above that of hazard.rule; never 0
    std::vector<std::size_t> places{};  ///< as in the levels
};

/// Where two rules give other levels, the largest difference first, of equal ones the lower level first.
/// Requires as many levels by the one as by the other.
std::vector<LevelSteps> level_differences(std::span<const Level> ruled, std::span<const Level> compared);

}  // namespace coupling::hazard
