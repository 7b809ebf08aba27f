#include "coupling/exchange/regimes/due.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "forest/inventory/tables.hpp"
#include "forest/protection/gaps.hpp"
#include "forest/stand/allometry.hpp"
#include "forest/treatment/selection.hpp"

namespace coupling {

namespace {

std::optional<int> last_visit(const RegimeState& state, std::size_t intervention, std::uint32_t area) {
    for (const RegimeState::Visit& visit : state.visits) {
        if (visit.intervention == intervention && visit.area == area) {
            return visit.year;
        }
    }
    return std::nullopt;
}

std::optional<int> last_clearing(const RegimeState& state, std::size_t ground, std::uint32_t area) {
    for (const RegimeState::Clearing& clearing : state.clearings) {
        if (clearing.ground == ground && clearing.area == area) {
            return clearing.year;
        }
    }
    return std::nullopt;
}

std::optional<int> cleared(const Regime& regime, const RegimeState& state, std::size_t intervention,
                           const Area& area) {
    const auto cleared_in = last_clearing(state, regime.ground_of(intervention), area.number);
    if (!cleared_in && regime.cuts_of(intervention)) {
        return state.cuts[area.number].year;
    }
    return cleared_in;
}

/// Judges one year.
class Judge {
public:
    Judge(const Regime& regime, int year, const forest::Stand& stand, const forest::SpeciesTable& species,
          const RegimeState& state)
        : regime_{regime}, year_{year}, stand_{stand}, species_{species}, state_{state} {}

    [[nodiscard]] bool is_due(std::size_t intervention, const Area& area) const {
        return comes(intervention, area) && conditions_hold(intervention, area);
    }

private:
    /// By the calendar, or so many years after the row it follows.
    [[nodiscard]] bool comes(std::size_t intervention, const Area& area) const {
        const Intervention& row = regime_.interventions()[intervention];
        if (const auto followed = regime_.predecessor_of(intervention)) {
            const auto visited = visit_of(*followed, intervention, area);
            return visited && year_ - *visited == row.after_years && year_ <= row.last_year.value_or(year_);
        }
        const std::optional<int> turn = turn_of(row, year_);
        if (!turn || area.order % row.ground.entries != *turn) {
            return false;
        }
        // With a condition but without a calendar: once until the area is cleared.
        const auto visited = last_visit(state_, intervention, area.number);
        return row.every_years || !visited ||
               *visited <= cleared(regime_, state_, intervention, area).value_or(*visited - 1);
    }

    /// When the row that another follows was on an area: this year too if it is due there. A row that cut is
    /// where its cuts are.
    [[nodiscard]] std::optional<int> visit_of(std::size_t followed, std::size_t follower,
                                              const Area& area) const {
        if (regime_.cuts_of(follower) == followed) {
            return state_.cuts[area.number].year;
        }
        return regime_.interventions()[follower].after_years == 0 && is_due(followed, area)
                   ? year_
                   : last_visit(state_, followed, area.number);
    }

    [[nodiscard]] bool conditions_hold(std::size_t intervention, const Area& area) const {
        const Intervention& row = regime_.interventions()[intervention];
        if (!row.has_condition()) {
            return true;
        }
        const std::vector<std::size_t> places = forest::trees_in(stand_, area.place);
        if (row.from_age_years || row.to_age_years) {
            const double age = age_of(regime_, year_, stand_, state_, intervention, area, places);
            if (age < row.from_age_years.value_or(age) || age >= row.to_age_years.value_or(age + 1.0)) {
                return false;
            }
        }
        if (row.from_relative_density &&
            forest::relative_density(stand_, species_, places, area.area_ha) < *row.from_relative_density) {
            return false;
        }
        if (row.from_damage_m3pha && damage_m3pha(area) < *row.from_damage_m3pha) {
            return false;
        }
        if (row.from_gap_m || row.to_gap_m) {
            const double longest_m = longest_gap_m(area);
            if (longest_m < row.from_gap_m.value_or(longest_m) ||
                longest_m > row.to_gap_m.value_or(longest_m)) {
                return false;
            }
        }
        if (!row.from_dominant_height_m && !row.from_basal_area_m2pha) {
            return true;
        }
        std::vector<forest::Tree> trees;
        for (const std::size_t place : places) {
            trees.push_back(stand_.trees()[place]);
        }
        const forest::StandFigures figures = forest::figures_of(trees, species_, area.area_ha);
        return figures.dominant_height_m >= row.from_dominant_height_m.value_or(0.0) &&
               figures.basal_area_m2pha >= row.from_basal_area_m2pha.value_or(0.0);
    }

    /// Stem wood of trees that wind, snow and beetles took from an area this year.
    [[nodiscard]] double damage_m3pha(const Area& area) const {
        double sum_m3 = 0.0;
        for (const auto& [tree, cause] : stand_.deaths()) {
            const bool is_damage = cause == forest::Cause::wind || cause == forest::Cause::snow ||
                                   cause == forest::Cause::beetle;
            if (is_damage && forest::belongs(area.place, stand_.grid(), tree.x_m, tree.y_m)) {
                sum_m3 += tree.stems * forest::stem_volume_m3(species_[tree.species].allometry, tree.dbh_cm,
                                                              tree.height_m);
            }
        }
        return sum_m3 / area.area_ha;
    }

    /// Of the gaps along the fall line that touch an area, each with its whole length.
    [[nodiscard]] double longest_gap_m(const Area& area) const {
        const forest::PatchGrid& grid = stand_.grid();
        const std::vector<char> open = forest::open_patches(grid, stand_.trees());
        const std::vector<forest::Gap> gaps = forest::gaps_along_fall_line(grid, open);
        const forest::Patch* first = grid.patches().data();
        return forest::figures_of(grid, open, gaps,
                                  [&](const forest::Patch& patch) {
                                      const forest::PatchId id{static_cast<std::uint32_t>(&patch - first)};
                                      return std::binary_search(area.patches.begin(), area.patches.end(), id);
                                  })
            .max_m;
    }

    const Regime& regime_;
    int year_;
    const forest::Stand& stand_;
    const forest::SpeciesTable& species_;
    const RegimeState& state_;
};

/// Whether a row is looked at then.
bool comes_in(const Regime& regime, std::size_t intervention, DueRows rows) {
    const Intervention& row = regime.interventions()[intervention];
    const auto source = regime.cuts_of(intervention);
    switch (rows) {
        case DueRows::all:
            return true;
        case DueRows::before_marking:
            return !source || row.cuts();
        case DueRows::after_marking:
            return source && !row.cuts();
        case DueRows::after_salvage:
            return source && !row.leaves_ground() &&
                   regime.interventions()[*source].treatment == Treatment::salvage;
    }
    return false;
}

/// Sets the year of an entry with this key, in order.
template <class Item, class Key>
void put(std::vector<Item>& items, const Item& item, Key key) {
    const auto at = std::lower_bound(items.begin(), items.end(), item,
                                     [&](const Item& a, const Item& b) { return key(a) < key(b); });
    if (at != items.end() && key(*at) == key(item)) {
        at->year = item.year;
    } else {
        items.insert(at, item);
    }
}

}  // namespace

double age_of(const forest::Stand& stand, std::span<const std::size_t> trees, double area_ha,
              std::optional<int> years_since_clearing) {
    if (years_since_clearing) {
        return *years_since_clearing;
    }
    std::vector<std::size_t> order{trees.begin(), trees.end()};
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return stand.trees()[a].dbh_cm > stand.trees()[b].dbh_cm;
    });
    constexpr double dominant_pha = 100.0;
    const double wanted = std::max(1.0, dominant_pha * area_ha);
    double stems = 0.0;
    double years = 0.0;
    for (const std::size_t place : order) {
        const forest::Tree& tree = stand.trees()[place];
        const double counted = std::min<double>(tree.stems, wanted - stems);
        stems += counted;
        years += counted * tree.age_years;
        if (stems >= wanted) {
            break;
        }
    }
    return stems > 0.0 ? years / stems : 0.0;
}

double age_of(const Regime& regime, int year, const forest::Stand& stand, const RegimeState& state,
              std::size_t intervention, const Area& area, std::span<const std::size_t> trees) {
    const auto cleared_in = cleared(regime, state, intervention, area);
    return age_of(stand, trees, area.area_ha, cleared_in ? std::optional{year - *cleared_in} : std::nullopt);
}

const Area& area_at(const Regime& regime, const RegimeState& state, std::size_t intervention,
                    std::size_t place) {
    return regime.cuts_of(intervention) ? state.cuts[place].area : regime.areas_of(intervention)[place];
}

std::vector<Due> due_in(const Regime& regime, int year, const forest::Stand& stand,
                        const forest::SpeciesTable& species, const RegimeState& state, DueRows rows) {
    const Judge judge{regime, year, stand, species, state};
    std::vector<Due> due;
    for (std::size_t i = 0; i < regime.interventions().size(); ++i) {
        if (!comes_in(regime, i, rows)) {
            continue;
        }
        const auto source = regime.cuts_of(i);
        const std::size_t places = source ? state.cuts.size() : regime.areas_of(i).size();
        Due row{i, {}};
        for (std::size_t a = 0; a < places; ++a) {
            const bool is_its_own =
                !source || (state.cuts[a].intervention == *source &&
                            (rows != DueRows::after_salvage || state.cuts[a].year == year));
            if (is_its_own && judge.is_due(i, area_at(regime, state, i, a))) {
                row.areas.push_back(a);
            }
        }
        if (!row.areas.empty()) {
            due.push_back(std::move(row));
        }
    }
    return due;
}

void remember(const Regime& regime, int year, const std::vector<Due>& done, RegimeState& state) {
    for (const Due& row : done) {
        const auto intervention = static_cast<std::uint32_t>(row.intervention);
        const auto ground = static_cast<std::uint32_t>(regime.ground_of(row.intervention));
        for (const std::size_t place : row.areas) {
            const std::uint32_t area = area_at(regime, state, row.intervention, place).number;
            put(state.visits, {intervention, area, year}, [](const RegimeState::Visit& v) {
                return std::pair{v.intervention, v.area};
            });
            if (regime.interventions()[row.intervention].treatment == Treatment::clear_cut) {
                put(state.clearings, {ground, area, year}, [](const RegimeState::Clearing& c) {
                    return std::pair{c.ground, c.area};
                });
            }
        }
    }
}

}  // namespace coupling
