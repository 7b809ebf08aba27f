#include "coupling/assessments/hazard/target_ranks.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <vector>

namespace coupling::hazard {
namespace {

/// Of each target whether people are there: as [risk] knows it, else lines are roads and railways.
std::vector<bool> have_people(const HazardResults& results) {
    std::vector<bool> people;
    for (const rockfall::Target& target : results.site.targets) {
        people.push_back(!target.is_area);
    }
    if (results.risk) {
        for (const risk::TargetRisk& exposed : results.risk->targets) {
            people[exposed.target] = exposed.exposure.persons.value_or(0.0) > 0.0 ||
                                     exposed.exposure.vehicles_per_day.value_or(0.0) > 0.0;
        }
    }
    return people;
}

}  // namespace

std::vector<std::size_t> ranked_targets(const HazardResults& results) {
    const std::vector<bool> people = have_people(results);
    // First the slope as it is: with forest where there is one.
    const auto place = [&](std::size_t target) {
        const TargetHazard& now = results.slopes.front().targets[target];
        const TargetHazard& bare = results.slopes.back().targets[target];
        return std::tuple{now.ruled.level, static_cast<bool>(people[target]), now.hits_per_year,
                          bare.ruled.level, bare.hits_per_year};
    };
    std::vector<std::size_t> hit;
    for (std::size_t i = 0; i < results.site.targets.size(); ++i) {
        if (std::any_of(results.slopes.begin(), results.slopes.end(),
                        [&](const SlopeHazard& slope) { return slope.targets[i].rocks > 0; })) {
            hit.push_back(i);
        }
    }
    std::stable_sort(hit.begin(), hit.end(),
                     [&](std::size_t a, std::size_t b) { return place(a) > place(b); });
    return hit;
}

std::vector<std::size_t> listed_targets(const HazardResults& results, std::size_t most,
                                        std::size_t most_of_all) {
    const std::vector<std::size_t> ranked = ranked_targets(results);
    const std::size_t all = results.site.targets.size();
    std::vector<std::size_t> listed;
    std::vector<bool> stands(all, false);
    const auto add_some = [&](const std::vector<std::size_t>& from, std::size_t limit, const auto& wanted) {
        for (const std::size_t target : from) {
            if (listed.size() < limit && !stands[target] && wanted(target)) {
                stands[target] = true;
                listed.push_back(target);
            }
        }
    };
    std::vector<std::size_t> in_order(all);
    std::iota(in_order.begin(), in_order.end(), std::size_t{0});
    const auto any = [](std::size_t) { return true; };
    const auto is_line = [&](std::size_t target) { return !results.site.targets[target].is_area; };
    const auto forest_changes = [&](std::size_t target) {
        return results.slopes.front().targets[target].ruled.level !=
               results.slopes.back().targets[target].ruled.level;
    };
    add_some(ranked, most, any);
    add_some(in_order, most, any);
    add_some(ranked, all, is_line);
    add_some(in_order, all, is_line);
    add_some(ranked, most_of_all, forest_changes);
    return listed;
}

std::vector<std::size_t> first_targets(const HazardResults& results, std::size_t most) {
    std::vector<std::size_t> first = listed_targets(results, most, most);
    first.resize(std::min(first.size(), most));
    return first;
}

}  // namespace coupling::hazard
