#pragma once

#include <functional>
#include <optional>

#include "coupling/assessments/decades/members/bare_falls.hpp"
#include "coupling/assessments/decades/members/kept_member.hpp"
#include "coupling/assessments/decades/members/management.hpp"
#include "coupling/assessments/decades/members/parts.hpp"
#include "coupling/assessments/decades/members/records.hpp"
#include "coupling/assessments/decades/members/starts.hpp"
#include "coupling/exchange/yearly_rockfall.hpp"
#include "coupling/inputs/forest/forest_site.hpp"

namespace coupling {
struct Scenario;
}

namespace coupling::decades {

/// What all members of a run share and none of them changes.
struct Decades {
    const Scenario& scenario;
    const ForestSite& forest;
    const Management& management;
    const exchange::YearlyRockfall* rocks = nullptr;  ///< nullptr: no rockfall
    /// Where their falls over the bare slope lie; nullptr: each member lets them fall itself.
    const YearBlocks* blocks = nullptr;
    const Parts* parts = nullptr;
    Starts* starts = nullptr;  ///< that members share; nullptr: each makes its own
};

/// Lives through all years of a member.
///
/// Year 0 is the start: what stands is written down, rocks fall through it, and the regime does what it wants
/// done at once. Each year after: the forest grows, people do what is due, and in years with rockfall the
/// rocks fall through what then stands; the forest stands still while they do. Depends on the member and the
/// scenario alone, not on `threads`. Calls `year_done` after each year, which may throw to end the work.
MemberYears simulate(const Decades& decades, Member member, int threads,
                     const std::function<void()>& year_done);

/// The same with what a longer run goes on from. `begun`: the first years of this member, as a shorter run
/// has left them (Parts::begun); nothing: from the start. The result but `taken_over` is the same either way.
KeptMember simulate_on(const Decades& decades, Member member, std::optional<KeptMember> begun, int threads,
                       const std::function<void()>& year_done);

}  // namespace coupling::decades
