#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "config/text/joined.hpp"
#include "coupling/exchange/regimes/regime.hpp"

namespace coupling {
namespace {

using config::joined;

constexpr int years_looked_at = 500;

bool thins(const Intervention& i) {
    return i.treatment == Treatment::thin_below || i.treatment == Treatment::thin_density ||
           i.treatment == Treatment::thin_crop_trees || i.treatment == Treatment::thin_to_basal_area ||
           i.treatment == Treatment::thin_to_stems;
}

/// Whether two interventions on the same ground in the same year contradict each other.
bool contradict(const Intervention& a, const Intervention& b) {
    if (a.treatment == Treatment::fell_list || b.treatment == Treatment::fell_list) {
        return a.treatment == b.treatment && a.trees == b.trees;  // named trees go with the upper row
    }
    if (a.order && b.order && *a.order != *b.order) {
        return false;  // the user says which comes first
    }
    if (a.cuts() && b.cuts()) {
        const bool both_ends = (thins(a) && b.treatment == Treatment::target_diameter) ||
                               (thins(b) && a.treatment == Treatment::target_diameter);
        return !both_ends;
    }
    if ((thins(a) && b.plants()) || (thins(b) && a.plants())) {
        return true;
    }
    if (a.treatment != b.treatment) {
        return false;
    }
    return !a.plants() || std::any_of(a.species.begin(), a.species.end(), [&](forest::SpeciesId species) {
        return std::find(b.species.begin(), b.species.end(), species) != b.species.end();
    });
}

/// When and where the calendar alone brings interventions.
class Calendar {
public:
    explicit Calendar(const Regime& regime) : regime_{regime} {}

    /// Nothing where conditions decide.
    [[nodiscard]] std::optional<int> turn(std::size_t intervention, int year) const {
        const Intervention& row = regime_.interventions()[intervention];
        if (row.has_condition()) {
            return std::nullopt;
        }
        const auto followed = regime_.predecessor_of(intervention);
        return followed ? turn(*followed, year - row.after_years) : turn_of(row, year);
    }

    /// Patches of an intervention's areas that have their turn.
    const std::vector<forest::PatchId>& patches(std::size_t intervention, int turn) {
        auto [found, is_new] = patches_.try_emplace({intervention, turn});
        if (is_new) {
            const int entries = regime_.interventions()[intervention].ground.entries;
            for (const Area& area : regime_.areas_of(intervention)) {
                if (area.order % entries == turn) {
                    found->second.insert(found->second.end(), area.patches.begin(), area.patches.end());
                }
            }
            std::sort(found->second.begin(), found->second.end());
        }
        return found->second;
    }

private:
    const Regime& regime_;
    std::map<std::pair<std::size_t, int>, std::vector<forest::PatchId>> patches_;
};

bool share_any(const std::vector<forest::PatchId>& a, const std::vector<forest::PatchId>& b) {
    auto x = a.begin();
    auto y = b.begin();
    while (x != a.end() && y != b.end()) {
        if (*x == *y) {
            return true;
        }
        *x < *y ? ++x : ++y;
    }
    return false;
}

/// A row that follows another must come before that returns to the same area.
void find_followers_too_late(const Regime& regime, config::Problems& problems) {
    for (std::size_t i = 0; i < regime.interventions().size(); ++i) {
        const auto followed = regime.predecessor_of(i);
        if (!followed || regime.cuts_of(i)) {
            continue;  // cuts are new areas each time
        }
        const Intervention& row = regime.interventions()[i];
        const Intervention& first = regime.interventions()[*followed];
        const int cycle_years = first.every_years.value_or(0) * first.ground.entries;
        if (cycle_years > 0 && row.after_years >= cycle_years) {
            problems.add(
                config::ExitCode::data, row.place,
                joined("after_years = ", std::to_string(row.after_years), ": ", first.name,
                       " is back on the same area after ", std::to_string(cycle_years), " years"),
                joined("fewer years", first.leaves_ground()
                                          ? joined(", or where = cuts_of:", first.name,
                                                   " instead of `after`, which follows each time by itself")
                                          : std::string{}));
        }
    }
}

/// Trees are marked before it is known where others cut and salvage in the year.
void find_followers_too_early(const Regime& regime, config::Problems& problems) {
    for (std::size_t i = 0; i < regime.interventions().size(); ++i) {
        const Intervention& row = regime.interventions()[i];
        const auto source = regime.cuts_of(i);
        if (!source || regime.predecessor_of(i) != source || row.after_years > 0 || !row.leaves_ground()) {
            continue;
        }
        const Intervention& first = regime.interventions()[*source];
        if (row.cuts() || first.treatment == Treatment::salvage) {
            problems.add(
                config::ExitCode::data, row.place,
                joined("after_years = 0: ", row.name, " on the ground of ", first.name, " in the same year"),
                "1 or more for a row that cuts or salvages: that ground is known after the trees "
                "of the year are marked");
        }
    }
}

}  // namespace

void find_contradictions(const Regime& regime, config::Problems& problems) {
    find_followers_too_late(regime, problems);
    find_followers_too_early(regime, problems);
    Calendar calendar{regime};
    const std::vector<Intervention>& rows = regime.interventions();
    std::set<std::pair<std::size_t, std::size_t>> found;
    for (int year = 0; year < years_looked_at; ++year) {
        for (std::size_t b = 0; b < rows.size(); ++b) {
            const std::optional<int> turn_b = calendar.turn(b, year);
            for (std::size_t a = 0; turn_b && a < b; ++a) {
                const std::optional<int> turn_a = calendar.turn(a, year);
                if (!turn_a || found.contains({a, b}) || !contradict(rows[a], rows[b]) ||
                    !share_any(calendar.patches(a, *turn_a), calendar.patches(b, *turn_b))) {
                    continue;
                }
                found.insert({a, b});
                problems.add(
                    config::ExitCode::data, rows[b].place,
                    joined(rows[a].name, " (line ", std::to_string(rows[a].place.line), ") and ",
                           rows[b].name, " on the same ground in year ", std::to_string(year)),
                    "different years or different ground, or numbers in `order` that say which comes first");
            }
        }
    }
}

}  // namespace coupling
