#include "coupling/exchange/regimes/planned_years.hpp"

#include <algorithm>
#include <utility>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"

namespace coupling {
namespace {

using config::joined;

std::string conditions_of(const Intervention& row) {
    const std::pair<const char*, const std::optional<double>&> all[] = {
        {"from_age_years", row.from_age_years},
        {"to_age_years", row.to_age_years},
        {"from_dominant_height_m", row.from_dominant_height_m},
        {"from_basal_area_m2pha", row.from_basal_area_m2pha},
        {"from_relative_density", row.from_relative_density},
        {"from_damage_m3pha", row.from_damage_m3pha},
        {"from_gap_m", row.from_gap_m},
        {"to_gap_m", row.to_gap_m}};
    std::string text;
    for (const auto& [column, value] : all) {
        if (value) {
            text += joined(text.empty() ? "" : ", ", column, " = ", config::to_text(*value));
        }
    }
    return text;
}

/// Whether it is known before the run when others find something to follow.
bool is_known(const PlannedYears& first, const Intervention& row, bool on_its_ground) {
    return first.condition.empty() && !first.after &&
           !(on_its_ground && row.treatment == Treatment::salvage);  // it finds wood or not
}

}  // namespace

PlannedYears planned_years(const Regime& regime, std::size_t row, std::optional<int> turn, int last_year) {
    const Intervention& intervention = regime.interventions()[row];
    PlannedYears planned{.condition = conditions_of(intervention)};
    const int last = std::min(last_year, intervention.last_year.value_or(last_year));
    if (const auto followed = regime.predecessor_of(row)) {
        const PlannedYears first = planned_years(regime, *followed, turn, last_year);
        if (!is_known(first, regime.interventions()[*followed], regime.cuts_of(row) == followed)) {
            planned.after = followed;
            return planned;
        }
        for (const int year : first.years) {
            if (year + intervention.after_years <= last) {
                planned.years.push_back(year + intervention.after_years);
            }
        }
        return planned;
    }
    planned.once = !planned.condition.empty() && !intervention.every_years;
    for (int year = 0; year <= last; ++year) {
        const std::optional<int> its_turn = turn_of(intervention, year);
        if (its_turn && (!turn || *its_turn == *turn)) {
            planned.years.push_back(year);
        }
    }
    return planned;
}

}  // namespace coupling
