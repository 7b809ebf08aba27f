#include <algorithm>
#include <vector>

#include "config/text/joined.hpp"
#include "coupling/assessments/today/report/arrival_rows.hpp"
#include "coupling/assessments/today/report/sections.hpp"
#include "coupling/results/report/html_table.hpp"
#include "coupling/results/text/join_texts.hpp"
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

/// A table of groups: for each target its arrivals, the rocks released first.
std::string table_of_groups(const RunResults& results, const std::vector<ReleaseGroup>& groups,
                            const std::string& first, const std::string& caption,
                            std::string (*name)(const ReleaseGroup&)) {
    std::vector<std::string> heads = arrival_heads(first, results.with_forest);
    heads.insert(heads.begin() + 1, page_text("released"));
    HtmlTable table{caption, heads};
    for (std::size_t target = 0; target < results.site.targets.size(); ++target) {
        const rockfall::Target& of = results.site.targets[target];
        if (results.site.targets.size() > 1) {
            table.group(escaped(of.name.empty() ? of.id : of.name));
        }
        for (const ReleaseGroup* group : groups_that_matter(groups, target)) {
            std::vector<std::string> cells{name(*group), grouped(group->released)};
            add_arrival_cells(cells, group->targets[target], group->released, results.with_forest);
            table.row(cells);
        }
    }
    return joined("<section class=\"card\">", table.html(), "</section>\n");
}

}  // namespace

std::string release_groups(const RunResults& results) {
    const Breakdown& breakdown = results.breakdown;
    std::string html;
    if (breakdown.zones.size() > 1) {
        std::string caption = page_text(
            "Rocks that arrive by the zone in which they break off, in brackets per 1000 released there; "
            "energies in kJ: 95th percentile / largest. A dash: too few rocks.");
        if (breakdown.zones.size() > most_groups_shown) {
            caption = join_sentences(
                {caption,
                 page_text("Shown: for each target the {shown} of {zones} zones from which most rocks arrive "
                           "without forest; all stand in tables/by_zone.csv.",
                           {{"shown", std::to_string(most_groups_shown)},
                            {"zones", grouped(breakdown.zones.size())}})});
        }
        html += joined("<h2>", page_text("By source zone"), "</h2>\n",
                       table_of_groups(results, breakdown.zones, page_text("Zone"), caption, name_of_zone));
    }
    if (!breakdown.sizes.empty()) {
        html +=
            joined("<h2>", page_text("By block size"), "</h2>\n",
                   table_of_groups(
                       results, breakdown.sizes, page_text("Diameter"),
                       page_text("Rocks that arrive by their diameter, in brackets per 1000 released of that "
                                 "size; energies in kJ: 95th percentile / largest. A dash: too few rocks."),
                       name_of_size));
    }
    return html;
}

}  // namespace coupling::report
