#include "coupling/assessments/hazard/unreached_hazard.hpp"

#include <cstdint>
#include <optional>
#include <vector>

#include "coupling/assessments/hazard/target_ranks.hpp"
#include "coupling/results/figures/unreached.hpp"

namespace coupling::hazard {

void warn_of_unreached(const HazardResults& results, config::Warnings& warnings) {
    const Site& site = results.site;
    std::vector<char> is_reached(site.targets.size(), 0);
    for (const std::size_t target : ranked_targets(results)) {
        is_reached[target] = 1;
    }
    const double highest_m = highest_source_m(site);
    std::vector<Unreached> unreached;
    for (std::size_t i = 0; i < site.targets.size(); ++i) {
        const rockfall::Target& target = site.targets[i];
        if (is_reached[i] == 0) {
            unreached.push_back({"target", target.name.empty() ? target.id : target.name,
                                 lies_above(highest_m, site.slope.terrain, target.parts), std::nullopt,
                                 lowest_ground_m(site.slope.terrain, target.parts)});
        }
    }
    const Departures& bare = leaves_most(results.periods, Cover::bare).departures[index_of(Cover::bare)];
    std::vector<Holder> holders;
    std::uint64_t rocks = 0;
    for (const FinishedPeriod& period : results.periods) {
        rocks += period.rocks;
    }
    for (const bool is_net : {true, false}) {
        const std::size_t count = is_net ? site.nets.size() : site.works.size();
        for (std::size_t i = 0; i < count; ++i) {
            holders.push_back({is_net ? site.nets[i].name : site.works[i].name, 0,
                               highest_ground_m(site.slope.terrain,
                                                is_net ? site.nets[i].net.line_m : site.works[i].line_m)});
            for (const PeriodBarrier& barrier : results.barriers) {
                const auto held = barrier.outcomes.find("held");
                if (barrier.is_net == is_net && barrier.number == i && barrier.cover == Cover::bare &&
                    held != barrier.outcomes.end()) {
                    holders.back().rocks += held->second;
                }
            }
        }
    }
    warn_of_unreached(
        unreached, bare,
        unreached.size() < site.targets.size() ? StopsBefore::is_usual : StopsBefore::ends_the_answer,
        warnings, holders, rocks);
}

}  // namespace coupling::hazard
