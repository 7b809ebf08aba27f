#include "coupling/assessments/decades/idle_interventions.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"

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

std::vector<std::string> unfelled_trees(const Names& names, const Management& management,
                                        std::span<const MemberYears> members, std::int32_t years) {
    std::vector<std::string> sentences;
    for (std::size_t regime = 0; regime < management.regimes.size(); ++regime) {
        const auto& rows = management.regimes[regime].interventions();
        for (std::size_t row = 0; row < rows.size(); ++row) {
            const auto listed = static_cast<double>(
                std::count_if(rows[row].listed.begin(), rows[row].listed.end(),
                              [&](const ListedTree& tree) { return tree.year <= years; }));
            double felled = 0.0;
            double count = 0.0;
            for (const MemberYears& member : members) {
                if (member.member.regime == regime) {
                    count += 1.0;
                    for (const HarvestRow& work : member.harvest) {
                        felled += work.intervention == row ? work.stems : 0.0;
                    }
                }
            }
            if (count > 0.0 && felled < listed * count) {
                sentences.push_back(
                    joined("regime ", names.regimes[regime], ": ", rows[row].name, " felled ",
                           config::to_text(std::round(10.0 * felled / count) / 10.0), " of ",
                           config::to_text(listed),
                           " listed trees, mean of the replicates; the others had died or were cut before"));
            }
        }
    }
    return sentences;
}

}  // namespace coupling::decades
