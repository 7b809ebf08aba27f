#include "coupling/assessments/decades/tables/departures_over_years.hpp"

#include "coupling/results/figures/unreached.hpp"

namespace coupling::decades {

Departures departures_over_years(std::span<const MemberYears> members, Cover cover,
                                 const rockfall::Terrain& terrain) {
    std::uint64_t rocks = 0;
    std::map<rockfall::RimPart, std::uint64_t> left_over;
    for (const MemberYears& member : members) {
        for (const SlopeRow& slope : member.slopes) {
            rocks += slope.cover == cover ? slope.figures.rocks : 0;
        }
        for (const DepartureRow& row : member.departures) {
            if (row.cover == cover) {
                left_over[row.part] += row.rocks;
            }
        }
    }
    return departures_of(rocks, left_over, terrain);
}

rockfall::FallFigures fall_figures_over_years(std::span<const MemberYears> members,
                                              const rockfall::Terrain& terrain) {
    rockfall::FallFigures falls;
    for (const MemberYears& member : members) {
        for (const SlopeRow& slope : member.slopes) {
            if (slope.cover == Cover::bare && slope.figures.max_speed_mps.max > falls.largest_speed_mps) {
                falls.largest_speed_mps = slope.figures.max_speed_mps.max;
            }
        }
    }
    falls.left_share = departures_over_years(members, Cover::bare, terrain).share();
    return falls;
}

void warn_of_unreached_targets(const Site& site, std::span<const MemberYears> members, const Departures& bare,
                               config::Warnings& warnings) {
    if (bare.rocks == 0) {
        return;
    }
    std::vector<char> reached(site.targets.size(), 0);
    for (const MemberYears& member : members) {
        for (const TargetRow& row : member.targets) {
            if (row.paired.bare() + row.paired.forest() > 0) {
                reached[row.target] = 1;
            }
        }
    }
    const double highest_m = highest_source_m(site);
    std::vector<Unreached> unreached;
    for (std::size_t i = 0; i < site.targets.size(); ++i) {
        const rockfall::Target& target = site.targets[i];
        if (reached[i] == 0) {
            unreached.push_back({"target", target.name.empty() ? target.id : target.name,
                                 lies_above(highest_m, site.slope.terrain, target.parts), std::nullopt});
        }
    }
    warn_of_unreached(
        unreached, bare,
        unreached.size() < site.targets.size() ? StopsBefore::is_usual : StopsBefore::ends_the_answer,
        warnings);
}

}  // namespace coupling::decades
