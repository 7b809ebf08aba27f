#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "coupling/assessments/decades/members/records.hpp"
#include "coupling/exchange/regimes/apply.hpp"
#include "forest/stand/stand.hpp"

namespace coupling {
struct Scenario;
}

namespace coupling::decades {

/// Of which years a member kept what: decides whether a longer run can go on from it.
struct KeptYears {
    std::int32_t last = 0;        ///< the last simulated year
    std::vector<int> tree_lists;  ///< years with lists of trees, dead wood and paths, rising
    std::vector<int> maps;        ///< years with patches and cells, rising
    friend bool operator==(const KeptYears&, const KeptYears&) = default;
};

/// A member after its last year: a longer run goes on from here.
struct MemberEnd {
    forest::StandImage stand;
    RegimeState regime;
};

/// All that is kept of a member.
struct KeptMember {
    KeptYears kept;
    std::int32_t taken_over = 0;  ///< of its years, those that an earlier run had simulated
    MemberYears years;
    MemberEnd end;
};

/// What each member of a run keeps.
KeptYears kept_years_of(const Scenario& scenario);

/// 8 hexadecimal digits: runs that differ in their lists and maps alone keep parts side by side.
std::string name_of_lists(const KeptYears& kept);

/// Whether a run of at least as many years, and else of the same content (member_keys.hpp), may take over
/// what was kept: all lists and maps that it wants of these years are there, and rocks fell in the last one
/// not only because it was the last.
bool can_go_on(const KeptYears& kept, const Scenario& scenario);

/// Leaves the lists and maps that a run of `scenario` writes of the years that were kept. Requires can_go_on.
void leave_what_is_wanted(KeptMember& member, const Scenario& scenario);

}  // namespace coupling::decades
