#include "coupling/assessments/decades/members/kept_member.hpp"

#include <algorithm>

#include "config/text/sha256.hpp"
#include "coupling/assessments/decades/members/judged_cuts.hpp"
#include "coupling/inputs/scenario/forest_settings.hpp"
#include "coupling/inputs/scenario/scenario.hpp"

namespace coupling::decades {
namespace {

bool is_among(const std::vector<int>& years, std::int32_t year) {
    return std::binary_search(years.begin(), years.end(), year);
}

/// Whether all wanted years up to the last one were kept.
bool has_all(const std::vector<int>& kept, const std::vector<int>& wanted, std::int32_t last) {
    return std::all_of(wanted.begin(), wanted.end(),
                       [&](int year) { return year > last || is_among(kept, year); });
}

template <class Row, class Keeps>
void leave(std::vector<Row>& rows, const Keeps& keeps) {
    rows.erase(std::remove_if(rows.begin(), rows.end(), [&](const Row& row) { return !keeps(row.year); }),
               rows.end());
}

}  // namespace

KeptYears kept_years_of(const Scenario& scenario) {
    return {static_cast<std::int32_t>(scenario.run.years),
            chosen_years(scenario.forest.tree_list_years, scenario.run.years),
            chosen_years(scenario.forest.map_years, scenario.run.years)};
}

std::string name_of_lists(const KeptYears& kept) {
    std::string text;
    for (const std::vector<int>* years : {&kept.tree_lists, &kept.maps}) {
        for (const int year : *years) {
            text += std::to_string(year) + ' ';
        }
        text += ';';
    }
    constexpr std::size_t digits = 8;
    return config::sha256_of(text).substr(0, digits);
}

bool can_go_on(const KeptYears& kept, const Scenario& scenario) {
    const KeptYears wanted = kept_years_of(scenario);
    const bool has_other_rocks =  // those of a last year, which are in sums over all years, too
        scenario.forest.rockfall_every > 0 && !is_rock_year(kept.last, scenario);
    return kept.last <= wanted.last && !has_other_rocks &&
           has_all(kept.tree_lists, wanted.tree_lists, kept.last) &&
           has_all(kept.maps, wanted.maps, kept.last);
}

void leave_what_is_wanted(KeptMember& member, const Scenario& scenario) {
    const KeptYears wanted = kept_years_of(scenario);
    const auto listed = [&](std::int32_t year) { return is_among(wanted.tree_lists, year); };
    const auto mapped = [&](std::int32_t year) { return is_among(wanted.maps, year); };
    MemberYears& years = member.years;
    leave(years.trees, listed);
    leave(years.dead_wood, listed);
    leave(years.paths, listed);
    leave(years.patches, mapped);
    leave(years.maps, mapped);
}

}  // namespace coupling::decades
