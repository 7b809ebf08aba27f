#include "coupling/assessments/decades/decision/judged_years.hpp"

#include <algorithm>
#include <set>

#include "config/text/joined.hpp"

namespace coupling::decades {

std::vector<std::int32_t> unjudged_cuts(const Names& names, std::span<const MemberYears> members,
                                        std::size_t regime, std::span<const std::int32_t> rock_years) {
    std::set<std::int32_t> years;
    for (const MemberYears& member : members) {
        for (const HarvestRow& row : member.harvest) {
            if (member.member.regime == regime && row.stems > 0.0 &&
                is_cut(names.interventions[regime][row.intervention].second) &&
                !is_judged(row.year, rock_years)) {
                years.insert(row.year);
            }
        }
    }
    return {years.begin(), years.end()};
}

std::string years_in_words(const std::vector<std::int32_t>& years) {
    constexpr std::size_t most = 3;
    std::string text;
    for (std::size_t i = 0; i < std::min(most, years.size()); ++i) {
        text += config::joined(i == 0 ? "" : ", ", std::to_string(years[i]));
    }
    return years.size() > most ? config::joined(text, ", …") : text;
}

}  // namespace coupling::decades
