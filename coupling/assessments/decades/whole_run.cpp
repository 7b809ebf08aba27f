#include "coupling/assessments/decades/whole_run.hpp"

#include <algorithm>
#include <optional>

#include "coupling/assessments/decades/members/simulate.hpp"
#include "coupling/exchange/stems_and_logs.hpp"
#include "coupling/inputs/scenario/scenario.hpp"

namespace coupling::decades {

std::vector<Member> members_of(const Scenario& scenario, const Names& names) {
    std::vector<Member> members;
    for (std::uint32_t regime = 0; regime < names.regimes.size(); ++regime) {
        for (std::uint32_t climate = 0; climate < names.climates.size(); ++climate) {
            for (std::uint32_t replicate = 0; replicate < scenario.forest.replicates; ++replicate) {
                members.push_back({.regime = regime, .replicate = replicate, .climate = climate});
            }
        }
    }
    return members;
}

std::vector<rockfall::Stem> standing_stems(const ForestSite& forest) {
    std::vector<rockfall::Stem> stems;
    for (const TreeRecord& tree : forest.obstacles) {
        if (tree.stem.dbh_cm >= least_obstacle_cm) {
            stems.push_back(tree.stem);
        }
    }
    return stems;
}

Names names_of(const Management& management, const ForestSite& forest) {
    Names names{{}, {}, forest.species.table, {}};
    for (const SiteClimate& climate : forest.climates) {
        names.climates.push_back(climate.name);
    }
    for (const Regime& regime : management.regimes) {
        names.regimes.push_back(regime.name());
        names.interventions.emplace_back();
        for (const Intervention& row : regime.interventions()) {
            names.interventions.back().emplace_back(row.name, name_of(row.treatment));
        }
    }
    return names;
}

std::vector<MemberYears> simulate_whole(const Scenario& scenario, const Site& site,
                                        const Management& management, const Crew& crew) {
    std::optional<exchange::YearlyRockfall> rocks;
    if (scenario.forest.rockfall_every > 0) {
        rocks.emplace(scenario, site, site.forest->species.fracture_energy, standing_stems(*site.forest));
    }
    const auto at_a_time = static_cast<std::size_t>(crew.threads);
    Starts starts{2 * at_a_time};  // those of the members before may still be at work
    const Decades decades{scenario, *site.forest, management, rocks ? &*rocks : nullptr,
                          nullptr,  nullptr,      &starts};
    const std::vector<Member> members = members_of(scenario, names_of(management, *site.forest));
    const std::vector<Member> ordered = in_order_of_starts(members, at_a_time);
    std::vector<MemberYears> years(members.size());
    share_out(
        crew,
        {RankGroup::Work::members, "simulating years", members.size(), members.size() * scenario.run.years},
        [&](std::size_t i, int threads, const std::function<void()>& year_done) {
            const auto place = std::find(members.begin(), members.end(), ordered[i]) - members.begin();
            years[static_cast<std::size_t>(place)] = simulate(decades, ordered[i], threads, year_done);
        });
    return years;
}

}  // namespace coupling::decades
