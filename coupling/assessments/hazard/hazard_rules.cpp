#include "coupling/assessments/hazard/hazard_rules.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <tuple>

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

HazardRule compared_with(HazardRule rule, bool with_percentiles) {
    if (rule != HazardRule::release) {
        return HazardRule::release;
    }
    return with_percentiles ? HazardRule::cadanav : HazardRule::arrival;
}

double arrival_return_period_years(double release_years, double per_release) {
    return per_release > 0.0 ? release_years / per_release : std::numeric_limits<double>::infinity();
}

RuledLevel level_of(HazardRule rule, const Matrix& matrix, double release_years, const RocksAtPlace& rocks) {
    RuledLevel found;
    if (!(rocks.per_release > 0.0)) {
        return found;
    }
    found.release_years = release_years;
    found.energy = rocks.energy;
    if (rule != HazardRule::cadanav) {
        found.intensity = matrix.intensity_of(rocks.energy.kj);
        found.years = rule == HazardRule::release
                          ? release_years
                          : arrival_return_period_years(release_years, rocks.per_release);
        found.level = matrix.at(found.intensity, matrix.frequency_of(found.years));
        return found;
    }
    assert(rocks.per_release_above.size() == matrix.intensities());
    for (std::size_t i = 0; i < matrix.intensities(); ++i) {
        if (!(rocks.per_release_above[i] > 0.0)) {
            continue;
        }
        const double years = arrival_return_period_years(release_years, rocks.per_release_above[i]);
        const Level level = matrix.at(i, matrix.frequency_of(years));
        if (i == 0 || level >= found.level) {
            found.level = level;
            found.intensity = i;
            found.years = years;
        }
    }
    return found;
}

namespace {

/// How well the energy of a level is supported, and where too few rocks support it, how high it is.
std::tuple<bool, std::uint64_t, double> support_of(const RuledLevel& level) {
    const bool is_few = level.energy.is_largest;
    return {!is_few, is_few ? level.energy.rocks : 0, is_few ? level.energy.kj : 0.0};
}

}  // namespace

const RuledLevel& higher(HazardRule rule, const RuledLevel& a, const RuledLevel& b) {
    if (a.is_free() || b.is_free()) {
        return a.is_free() ? b : a;
    }
    if (a.level != b.level) {
        return b.level > a.level ? b : a;
    }
    if (rule != HazardRule::release) {
        return b.years < a.years ? b : a;
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

double share_above(double energy_kj, std::span<const EnergyQuantile> quantiles) {
    assert(!quantiles.empty());
    if (energy_kj <= quantiles.front().energy_kj) {
        return 1.0;
    }
    for (std::size_t i = 1; i < quantiles.size(); ++i) {
        const EnergyQuantile& low = quantiles[i - 1];
        const EnergyQuantile& high = quantiles[i];
        if (energy_kj <= high.energy_kj) {
            const double along = (energy_kj - low.energy_kj) / (high.energy_kj - low.energy_kj);
            return 1.0 - low.share_below - along * (high.share_below - low.share_below);
        }
    }
    return 0.0;
}

}  // namespace coupling::hazard
