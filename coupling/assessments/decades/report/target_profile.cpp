#include "coupling/assessments/decades/report/target_profile.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "config/text/joined.hpp"
#include "coupling/assessments/decades/report/series.hpp"
#include "coupling/results/figures/stop_causes.hpp"
#include "coupling/results/report/html_table.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"
#include "coupling/results/text/phrases.hpp"

namespace coupling::decades {
namespace {

using config::joined;
using report::escaped;
using report::fixed;

const Series* find(std::span<const Series> all_series, const std::string& quantity) {
    const auto found = std::find_if(all_series.begin(), all_series.end(), [&](const Series& series) {
        return series.target.empty() && series.quantity == quantity;
    });
    return found == all_series.end() ? nullptr : &*found;
}

std::string title_of(const Names& names, std::size_t course) {
    return escaped(look_of(names, course).title());
}

std::string cell_of(const Series& series, std::size_t course, std::int32_t year, int decimals) {
    const auto value = over_replicates(series, course, year);
    if (!value) {
        return "–";
    }
    const Band& band = value->band;
    return band.has_interval() ? joined(fixed(band.mean, decimals), " <small>(", fixed(band.low, decimals),
                                        " – ", fixed(band.high, decimals), ")</small>")
                               : fixed(band.mean, decimals);
}

/// The first, the middle and the last of some years.
std::vector<std::int32_t> three_of(const std::vector<std::int32_t>& years) {
    std::vector<std::int32_t> chosen;
    for (const std::int32_t year : {years.front(), years[years.size() / 2], years.back()}) {
        if (chosen.empty() || chosen.back() != year) {
            chosen.push_back(year);
        }
    }
    return chosen;
}

/// "on the whole area", "on 40 % of the area", "nowhere".
std::string where_met(const Series& met, std::size_t course, std::int32_t year) {
    const auto value = over_replicates(met, course, year);
    const double percent = value ? value->band.mean : 0.0;
    if (percent >= 99.95) {
        return report::page_text("on the whole area");
    }
    return percent < 0.05 ? report::page_text("nowhere")
                          : report::page_text("on {percent} % of the area",
                                              {{"percent", fixed(percent, percent < 10.0 ? 1 : 0)}});
}

std::string profile_in_words(const Names& names, const Series& met, const forest::TargetProfile& profile,
                             double mean_block_m) {
    std::string html = joined(
        "<p>", report::page_text(
                   "Rocks of {mean_block_m} m on average ask for at least {profile_least_stems_pha} stems a "
                   "hectare from {profile_dbh_from_cm} cm on (better {profile_ideal_stems_pha}), and for no "
                   "gap along the fall line above {profile_longest_gap_m} m.",
                   {{"mean_block_m", fixed(mean_block_m, 2)},
                    {"profile_least_stems_pha", fixed(profile.least_stems_pha, 0)},
                    {"profile_dbh_from_cm", fixed(profile.dbh_from_cm, 0)},
                    {"profile_ideal_stems_pha", fixed(profile.ideal_stems_pha, 0)},
                    {"profile_longest_gap_m", fixed(profile.longest_gap_m, 0)}}));
    html += joined(" <small>", escaped(report::in_page_language(profile.source)), ".</small></p>\n");
    const std::vector<std::int32_t> years = three_of(years_of(met));
    for (std::size_t course = 0; course < names.courses(); ++course) {
        if (splits_charts(names) && names.climate_of(course) > 0) {
            continue;
        }
        std::vector<std::string> places;
        for (const std::int32_t year : years) {
            places.push_back(
                report::page_text("<b>{where}</b> in year {year}",
                                  {{"where", where_met(met, course, year)}, {"year", std::to_string(year)}}));
        }
        html += joined("<p class=\"answer\">",
                       report::page_text(
                           "<b>{course}</b>. Stands meet this {places}.",
                           {{"course", title_of(names, course)}, {"places", report::join_with_and(places)}}),
                       "</p>\n");
    }
    return splits_charts(names) ? joined(html, other_climates()) : html;
}

/// Rows of a figure, one a course.
void add_rows(report::HtmlTable& table, const Names& names, const Series& series, const std::string& name,
              const std::vector<std::int32_t>& years, int decimals) {
    table.group(name);
    for (std::size_t course = 0; course < names.courses(); ++course) {
        std::vector<std::string> cells{title_of(names, course)};
        for (const std::int32_t year : years) {
            cells.push_back(cell_of(series, course, year, decimals));
        }
        table.row(cells);
    }
}

std::vector<std::string> head_of(const std::string& first, const std::vector<std::int32_t>& years) {
    std::vector<std::string> head{first};
    for (const std::int32_t year : years) {
        head.push_back(report::page_text("year {year}", {{"year", std::to_string(year)}}));
    }
    return head;
}

std::string table_of_stands(const Names& names, std::span<const Series> all_series) {
    const Series* longest = find(all_series, "gap_max_m");
    const std::vector<std::int32_t> years = three_of(years_of(*longest));
    const bool one = std::all_of(longest->values.begin(), longest->values.end(),
                                 [](const auto& replicates) { return replicates.size() <= 1; });
    report::HtmlTable table{
        report::join_sentences(
            {report::page_text(one ? "One replicate: no intervals."
                                   : "Mean of the replicates, in brackets its 90 % interval."),
             report::page_text(
                 "A gap is a line of patches of 10 m without a stem of 12 cm; its length is that "
                 "along the ground.")}),
        head_of(report::page_text("Stands"), years)};
    if (const Series* met = find(all_series, "target_profile_met_percent")) {
        add_rows(table, names, *met, report::page_text("Forest in stands that meet the target profile, %"),
                 years, 0);
    }
    add_rows(table, names, *longest, report::page_text("Longest gap along the fall line, m"), years, 0);
    add_rows(table, names, *find(all_series, "gap_95_m"),
             report::page_text("95th percentile of gap length, m"), years, 0);
    return table.html();
}

std::string table_of_causes(const Names& names, std::span<const Series> all_series) {
    const Series* trees = find(all_series, "stopped_by_tree_percent");
    if (trees == nullptr) {
        return "";
    }
    const std::vector<std::int32_t> all_years = years_of(*trees);
    std::vector<std::int32_t> years{all_years.front()};
    if (all_years.size() > 1) {
        years.push_back(all_years.back());
    }
    report::HtmlTable table{
        report::page_text("What ended the fall of the rocks through the forest, percent of all rocks."),
        head_of(report::page_text("Rocks"), years)};
    constexpr std::array<const char*, stop_causes> in_words{
        "Stopped by a tree, %",     "Stopped by a log, %", "Held by a net, %",
        "Stopped by the ground, %", "Left the terrain, %", "Given up after too many impacts, %"};
    for (std::size_t cause = 0; cause < stop_causes; ++cause) {
        const auto kind = static_cast<StopCause>(cause);
        const bool stops = kind < StopCause::left_terrain;
        const Series* series =
            find(all_series, joined(stops ? "stopped_by_" : "", name_of(kind), "_percent"));
        if (series == nullptr) {
            continue;
        }
        const auto happened = [&](std::size_t course) {
            return std::any_of(years.begin(), years.end(), [&](std::int32_t year) {
                const auto value = over_replicates(*series, course, year);
                return value && value->band.high > 0.0;
            });
        };
        bool any = stops && kind != StopCause::net;
        for (std::size_t course = 0; course < names.courses(); ++course) {
            any = any || happened(course);
        }
        if (any) {
            add_rows(table, names, *series, report::page_text(in_words[cause]), years, 1);
        }
    }
    return table.html();
}

}  // namespace

std::string stands_against_rocks(const Names& names, std::span<const Series> all_series,
                                 const std::optional<forest::TargetProfile>& profile, double mean_block_m) {
    std::string html = "<section class=\"card\">";
    const Series* met = find(all_series, "target_profile_met_percent");
    if (profile && met != nullptr) {
        html += profile_in_words(names, *met, *profile, mean_block_m);
    } else {
        html += joined(
            "<p>",
            report::page_text(
                "Rocks of {mean_block_m} m on average are larger than any that the target profiles speak of.",
                {{"mean_block_m", fixed(mean_block_m, 2)}}),
            "</p>\n");
    }
    html += table_of_stands(names, all_series);
    html += table_of_causes(names, all_series);
    return joined(html, "</section>\n");
}

}  // namespace coupling::decades
