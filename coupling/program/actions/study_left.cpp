#include "coupling/program/actions/study_left.hpp"

#include <cstdint>
#include <set>
#include <string>

#include "coupling/assessments/decades/members/member_keys.hpp"
#include "coupling/assessments/decades/members/parts.hpp"
#include "coupling/assessments/decades/whole_run.hpp"
#include "coupling/program/actions/listing.hpp"
#include "coupling/run/output_folder.hpp"
#include "coupling/run/run_request.hpp"

namespace coupling {

StudySize study_left(const std::filesystem::path& out, const Scenario& scenario, const Site& site,
                     const decades::Management& management) {
    const decades::MemberKeys keys{scenario, site, management};
    RunRequest run;
    run.out = out;
    const decades::Parts parts{OutputFolder::parts_of(output_folder_of(run, scenario)), "", &keys};
    StudySize study;
    std::set<std::uint32_t> replicates;
    for (const decades::Member& member :
         decades::members_of(scenario, decades::names_of(management, *site.forest))) {
        ++study.members;
        const auto kept = static_cast<std::uint64_t>(parts.kept_years(member));
        if (kept < scenario.run.years) {
            ++study.missing;
            study.begun += kept > 0 ? 1 : 0;
            study.missing_years += scenario.run.years - kept;
            replicates.insert(member.replicate);
        }
    }
    study.missing_replicates = replicates.size();
    return study;
}

void say_what_is_left(const Scenario& scenario, const StudySize& study, std::ostream& out) {
    const std::size_t whole = study.members - study.missing;
    if (whole + study.begun == 0) {
        return;
    }
    std::string left = whole > 0 || study.begun == 0 ? std::to_string(whole) : "";
    if (study.begun > 0) {
        left += (left.empty() ? "" : " and ") + std::to_string(study.begun) + " in part";
    }
    say(out, "members",
        std::to_string(study.members) + ", of which an earlier run has left " + left +
            " in the folder of results; " + std::to_string(study.missing) + " to simulate, " +
            std::to_string(study.missing_years) + " of " +
            counted(study.members * scenario.run.years, "member-year") + " (run with --overwrite)");
}

}  // namespace coupling
