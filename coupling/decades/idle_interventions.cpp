#include "coupling/decades/idle_interventions.hpp"

#include <cstddef>

#include "config/text/joined.hpp"

namespace coupling::decades {
namespace {

using config::joined;

struct Activity {
    bool was_due = false;
    bool did_something = false;
};

}  // namespace

std::vector<std::string> idle_interventions(const Names& names, std::span<const MemberYears> members) {
    std::vector<std::vector<Activity>> activity;
    for (const auto& rows : names.interventions) {
        activity.emplace_back(rows.size());
    }
    for (const MemberYears& member : members) {
        for (const HarvestRow& row : member.harvest) {
            Activity& seen = activity[member.member.regime][row.intervention];
            seen.was_due = true;
            seen.did_something = seen.did_something || !row.found_nothing;
        }
    }
    std::vector<std::string> sentences;
    for (std::size_t regime = 0; regime < activity.size(); ++regime) {
        std::string never_due;
        std::string found_nothing;
        for (std::size_t row = 0; row < activity[regime].size(); ++row) {
            const Activity& seen = activity[regime][row];
            std::string* list = !seen.was_due ? &never_due : !seen.did_something ? &found_nothing : nullptr;
            if (list != nullptr) {
                *list += joined(list->empty() ? "" : ", ", names.interventions[regime][row].first);
            }
        }
        if (!never_due.empty()) {
            sentences.push_back(joined("regime ", names.regimes[regime], ": ", never_due,
                                       " never came due in the years of the run; look at its years, ages and "
                                       "conditions"));
        }
        if (!found_nothing.empty()) {
            sentences.push_back(joined("regime ", names.regimes[regime], ": ", found_nothing,
                                       " came due and never found anything to do; look at its area and "
                                       "limits"));
        }
    }
    return sentences;
}

}  // namespace coupling::decades
