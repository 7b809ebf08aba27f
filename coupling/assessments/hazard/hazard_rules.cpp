#include "coupling/assessments/hazard/hazard_rules.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <tuple>
#include <utility>

namespace coupling::hazard {

const char* rule_name(HazardRule rule) {
    switch (rule) {
        case HazardRule::cadanav:
            return "cadanav";
        case HazardRule::arrival:
            return "arrival";
        case HazardRule::release:
            break;
    }
    return "release";
}

const char* statistic_name(const EnergyOfRocks& energy) {
    return energy.rocks == 0 ? "" : energy.is_largest ? "largest" : "hazard.energy";
}

HazardRule compared_with(HazardRule rule) {
    return rule == HazardRule::release ? HazardRule::cadanav : HazardRule::release;
}

double arrival_return_period_years(double release_years, double per_release) {
    return per_release > 0.0 ? release_years / per_release : std::numeric_limits<double>::infinity();
}

namespace {

/// How well the energy of a level is supported, and where too few rocks support it, how high it is.
std::tuple<bool, std::uint64_t, double> support_of(const RuledLevel& level) {
    const bool is_few = level.energy.is_largest;
    return {!is_few, is_few ? level.energy.rocks : 0, is_few ? level.energy.kj : 0.0};
}

/// Simulated rocks with the energies of a class and above; 0 where they are not counted.
double rocks_from(const RocksAtPlace& rocks, std::size_t intensity) {
    return rocks.rocks_above.empty() ? 0.0 : rocks.rocks_above[intensity];
}

/// Each return period by itself.
RuledLevel highest_of_release(const Matrix& matrix, std::span<const PeriodAtPlace> periods) {
    RuledLevel highest;
    for (const auto& [release_years, rocks] : periods) {
        if (rocks.per_release > 0.0) {
            const std::size_t intensity = matrix.intensity_of(rocks.energy.kj);
            highest = higher(highest, {.level = matrix.at(intensity, matrix.frequency_of(release_years)),
                                       .intensity = intensity,
                                       .years = release_years,
                                       .release_years = release_years,
                                       .energy = rocks.energy,
                                       .rocks = rocks_from(rocks, 0)});
        }
    }
    return highest;
}

/// How often rocks of a class of energy and above arrive of one return period [1/year].
double arriving_per_year(HazardRule rule, const Matrix& matrix, const PeriodAtPlace& period,
                         std::size_t intensity) {
    const RocksAtPlace& rocks = period.rocks;
    if (!(rocks.per_release > 0.0)) {
        return 0.0;
    }
    if (rule == HazardRule::cadanav) {
        assert(rocks.per_release_above.size() == matrix.intensities());
        return rocks.per_release_above[intensity] / period.release_years;
    }
    return matrix.intensity_of(rocks.energy.kj) >= intensity ? rocks.per_release / period.release_years : 0.0;
}

/// What rounding of sums and of maps, which hold 32 bits, may add to a return period that ends a class.
constexpr double rounding_of_years = 1e-6;

}  // namespace

RuledLevel level_of(HazardRule rule, const Matrix& matrix, std::span<const PeriodAtPlace> periods) {
    if (rule == HazardRule::release) {
        return highest_of_release(matrix, periods);
    }
    RuledLevel found;
    for (std::size_t i = 0; i < matrix.intensities(); ++i) {
        double all_per_year = 0.0;
        double rocks = 0.0;
        std::pair<bool, double> most_per_year{};  // one whose energy lies in the class itself goes first
        const PeriodAtPlace* most = nullptr;
        for (const PeriodAtPlace& period : periods) {
            const double here = arriving_per_year(rule, matrix, period, i);
            if (!(here > 0.0)) {
                continue;
            }
            all_per_year += here;
            rocks += rocks_from(period.rocks, rule == HazardRule::cadanav ? i : 0);
            const bool is_of_class =
                rule == HazardRule::arrival && matrix.intensity_of(period.rocks.energy.kj) == i;
            if (most == nullptr || std::pair{is_of_class, here} > most_per_year) {
                most_per_year = {is_of_class, here};
                most = &period;
            }
        }
        if (most == nullptr) {
            continue;
        }
        const double years = 1.0 / all_per_year;
        const Level level = matrix.at(i, matrix.frequency_of((1.0 - rounding_of_years) * years));
        if (found.is_free() || level >= found.level) {
            found = {level, i, years, most->release_years, most->rocks.energy, rocks};
        }
    }
    return found;
}

const RuledLevel& higher(const RuledLevel& a, const RuledLevel& b) {
    if (a.is_free() || b.is_free()) {
        return a.is_free() ? b : a;
    }
    if (a.level != b.level) {
        return b.level > a.level ? b : a;
    }
    if (support_of(a) != support_of(b)) {
        return support_of(b) > support_of(a) ? b : a;
    }
    return b.release_years < a.release_years ? b : a;
}

int steps_between(Level from, Level to) {
    return static_cast<int>(to) - static_cast<int>(from);
}

std::vector<LevelSteps> level_differences(std::span<const Level> ruled, std::span<const Level> compared) {
    assert(ruled.size() == compared.size());
    std::vector<LevelSteps> differences;
    for (std::size_t i = 0; i < ruled.size(); ++i) {
        const int steps = steps_between(ruled[i], compared[i]);
        if (steps == 0) {
            continue;
        }
        const auto known = std::find_if(differences.begin(), differences.end(),
                                        [&](const LevelSteps& other) { return other.steps == steps; });
        LevelSteps& here = known != differences.end() ? *known : differences.emplace_back(LevelSteps{steps});
        here.places.push_back(i);
    }
    std::sort(differences.begin(), differences.end(), [](const LevelSteps& a, const LevelSteps& b) {
        return std::tuple{-std::abs(a.steps), a.steps} < std::tuple{-std::abs(b.steps), b.steps};
    });
    return differences;
}

}  // namespace coupling::hazard
