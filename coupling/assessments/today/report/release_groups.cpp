#include <algorithm>
#include <optional>
#include <vector>

#include "config/text/joined.hpp"
#include "coupling/assessments/today/report/arrival_rows.hpp"
#include "coupling/assessments/today/report/sections.hpp"
#include "coupling/results/figures/most_reached.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::report {
namespace {

using config::joined;

std::string name_of_zone(const ReleaseGroup& group) {
    return page_text("Zone {zone}", {{"zone", std::to_string(group.zone)}});
}

std::string name_of_size(const ReleaseGroup& group) {
    return group.smallest_m == group.largest_m ? joined(tick_text(group.smallest_m), " m")
                                               : page_text("{diameter_low_m} to {diameter_high_m} m",
                                                           {{"diameter_low_m", tick_text(group.smallest_m)},
                                                            {"diameter_high_m", tick_text(group.largest_m)}});
}

/// Rows that the page has for each target; the tables have all [choice].
constexpr std::size_t most_groups_shown = 10;

/// The groups of which most rocks come to a target over the bare slope, in their own order.
std::vector<const ReleaseGroup*> groups_that_matter(const std::vector<ReleaseGroup>& groups,
                                                    std::size_t target) {
    std::vector<const ReleaseGroup*> shown;
    for (const ReleaseGroup& group : groups) {
        shown.push_back(&group);
    }
    if (shown.size() > most_groups_shown) {
        std::stable_sort(shown.begin(), shown.end(), [target](const ReleaseGroup* a, const ReleaseGroup* b) {
            constexpr std::size_t bare = index_of(rockfall::Cover::bare);
            return a->targets[target].by_cover[bare].reached > b->targets[target].by_cover[bare].reached;
        });
        shown.resize(most_groups_shown);
        std::sort(shown.begin(), shown.end());
    }
    return shown;
}

/// The fields of group_rows.html: for each target the arrivals of its groups, the rocks released first.
std::vector<PageFields> rows_by_target(const RunResults& results, const std::vector<ReleaseGroup>& groups,
                                       std::string (*name)(const ReleaseGroup&)) {
    std::vector<PageFields> targets;
    for (const std::size_t target : most_reached(results.tally.targets, most_targets_shown)) {
        const rockfall::Target& of = results.site.targets[target];
        std::vector<PageFields> rows;
        for (const ReleaseGroup* group : groups_that_matter(groups, target)) {
            rows.push_back(arrival_cells(group->targets[target], group->released));
            rows.back().push_back({"group", name(*group)});
            rows.back().push_back({"released", grouped(group->released)});
        }
        targets.push_back({{"several_targets", results.site.targets.size() > 1},
                           {"target", of.name.empty() ? of.id : of.name},
                           {"groups", rows}});
    }
    return targets;
}

}  // namespace

PageFields release_groups(const RunResults& results) {
    const std::vector<ReleaseGroup>& zones = results.breakdown.zones;
    const std::vector<ReleaseGroup>& sizes = results.breakdown.sizes;
    std::optional<PageFields> some_shown, some_targets, by_zone, by_size;
    if (results.site.targets.size() > most_targets_shown) {
        some_targets = {{"charted", std::to_string(most_targets_shown)},
                        {"targets", grouped(results.site.targets.size())}};
    }
    if (zones.size() > most_groups_shown) {
        some_shown = {{"shown", std::to_string(most_groups_shown)}, {"zones", grouped(zones.size())}};
    }
    if (zones.size() > 1) {
        by_zone = {{"some_shown", some_shown},
                   {"some_targets", some_targets},
                   {"group_targets", rows_by_target(results, zones, name_of_zone)}};
    }
    if (!sizes.empty()) {
        by_size = PageFields{{"some_targets", some_targets},
                             {"group_targets", rows_by_target(results, sizes, name_of_size)}};
    }
    return {{"by_zone", by_zone}, {"by_size", by_size}};
}

}  // namespace coupling::report
