#pragma once

#include <vector>

#include "coupling/assessments/decades/members/management.hpp"
#include "coupling/assessments/decades/members/records.hpp"
#include "coupling/assessments/decades/members/share_out.hpp"
#include "coupling/assessments/decades/tables/decade_tables.hpp"
#include "coupling/inputs/forest/forest_site.hpp"
#include "coupling/inputs/site.hpp"
#include "rockfall/obstacles/stem.hpp"

namespace coupling {
struct Scenario;
}

namespace coupling::decades {

/// All members of a run: by regime, climate, replicate.
std::vector<Member> members_of(const Scenario& scenario, const Names& names);

/// Names of the regimes with their rows, of the climates and species.
Names names_of(const Management& management, const ForestSite& forest);

/// Stems that rocks meet but no forest grows.
std::vector<rockfall::Stem> standing_stems(const ForestSite& forest);

/// Simulates all members of a scenario and keeps them in memory: for studies of many small runs. Nothing is
/// written. Throws Interrupted.
std::vector<MemberYears> simulate_whole(const Scenario& scenario, const Site& site,
                                        const Management& management, const Crew& crew);

}  // namespace coupling::decades
