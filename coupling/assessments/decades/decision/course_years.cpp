#include "coupling/assessments/decades/decision/course_years.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <iterator>
#include <set>

#include "coupling/assessments/decades/members/judged_cuts.hpp"

namespace coupling::decades {
namespace {

/// What may let the protection of a replicate jump: cuts, and the years in which it lost much to an event.
struct Jumps {
    std::set<std::int32_t> cuts, events;
};

Jumps jumps_of(const Names& names, const MemberYears& member) {
    constexpr double much = 0.02;  ///< of the wood that stands [choice]
    constexpr std::array causes{forest::Cause::wind, forest::Cause::snow, forest::Cause::beetle,
                                forest::Cause::rock, forest::Cause::drought};
    Jumps jumps;
    for (const HarvestRow& row : member.harvest) {
        const std::string& treatment = names.interventions[member.member.regime][row.intervention].second;
        if (row.stems > 0.0 && is_cut(treatment)) {
            jumps.cuts.insert(row.year);
        }
    }
    std::map<std::int32_t, double> standing_m3pha;
    for (const StandRow& row : member.stands) {
        if (row.unit == all && row.species == all) {
            standing_m3pha[row.year] = row.figures.volume_m3pha;
        }
    }
    std::map<std::int32_t, double> lost_m3pha;
    for (const LossRow& row : member.losses) {
        if (std::find(causes.begin(), causes.end(), row.cause) != causes.end()) {
            lost_m3pha[row.year] += row.loss.volume_m3pha;
        }
    }
    for (const auto& [year, lost] : lost_m3pha) {
        if (lost > much * standing_m3pha[year]) {
            jumps.events.insert(year);
        }
    }
    return jumps;
}

/// By year [percent^2].
std::map<std::int32_t, double> rock_variances_of(const MemberYears& member, std::uint32_t target) {
    constexpr std::int32_t around = 5;  ///< years to each side: a forest does not change much [choice]
    std::map<std::int32_t, double> variances;
    for (const TargetRow& row : member.targets) {
        const auto bare = static_cast<double>(row.paired.bare());
        if (row.target != target || bare == 0.0) {
            continue;
        }
        double arrive = 1.0;
        double pass = 0.5;
        for (const TargetRow& other : member.targets) {
            if (other.target == target && std::abs(other.year - row.year) <= around) {
                arrive += static_cast<double>(other.paired.bare());
                pass += static_cast<double>(other.paired.forest());
            }
        }
        const double share = std::min(1.0, pass / arrive);
        variances[row.year] = 1e4 * share * (1.0 - share) / bare;
    }
    return variances;
}

}  // namespace

CourseYears course_years(const Series& protection, std::size_t course, std::uint32_t target,
                         const Names& names, std::span<const MemberYears> members) {
    CourseYears years{.of_replicates = protection.values[course], .rock_variances = {}, .breaks = {}};
    years.rock_variances.resize(years.of_replicates.size());
    for (auto& replicate : years.of_replicates) {
        std::erase_if(replicate, [](const auto& each) { return each.first <= 0; });
    }
    std::vector<Jumps> jumps(years.of_replicates.size());
    std::map<std::int32_t, std::size_t> cuts;
    for (const MemberYears& member : members) {
        if (names.course_of(member.member) == course && member.member.replicate < jumps.size()) {
            jumps[member.member.replicate] = jumps_of(names, member);
            years.rock_variances[member.member.replicate] = rock_variances_of(member, target);
            for (const std::int32_t year : jumps[member.member.replicate].cuts) {
                ++cuts[year];
            }
        }
    }
    for (const auto& [year, replicates] : cuts) {
        if (2 * replicates > jumps.size()) {
            years.breaks.push_back(year);
        }
    }
    for (Jumps& own : jumps) {
        std::set_difference(own.cuts.begin(), own.cuts.end(), years.breaks.begin(), years.breaks.end(),
                            std::inserter(own.events, own.events.end()));
        years.events.emplace_back(own.events.begin(), own.events.end());
    }
    return years;
}

}  // namespace coupling::decades
