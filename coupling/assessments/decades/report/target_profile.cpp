#include "coupling/assessments/decades/report/target_profile.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "config/text/joined.hpp"
#include "coupling/assessments/decades/report/figure_cells.hpp"
#include "coupling/assessments/decades/report/series.hpp"
#include "coupling/results/figures/stop_causes.hpp"
#include "coupling/results/text/element.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"
#include "coupling/results/text/phrases.hpp"

namespace coupling::decades {
namespace {

using config::joined;
using report::fixed;
using report::PageFields;

const Series* find_series(std::span<const Series> all_series, const std::string& quantity) {
    const auto found = std::find_if(all_series.begin(), all_series.end(), [&](const Series& series) {
        return series.target.empty() && series.quantity == quantity;
    });
    return found == all_series.end() ? nullptr : &*found;
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

/// "nowhere in year 0, on 62 % of the area in year 5 and ...". HTML.
std::string places_in_words(const Series& met, std::size_t course) {
    std::vector<std::string> places;
    for (const std::int32_t year : three_of(years_of(met))) {
        const std::string where = report::element("b", {}, where_met(met, course, year));
        places.push_back(
            report::page_text("{where} in year {year}", {{"where", where}, {"year", std::to_string(year)}}));
    }
    return report::join_with_and(places);
}

PageFields profile_fields(const Names& names, const Series& met, const forest::TargetProfile& profile) {
    std::vector<PageFields> courses;
    for (std::size_t course = 0; course < names.courses(); ++course) {
        if (!splits_charts(names) || names.climate_of(course) == 0) {
            courses.push_back(
                {{"course", look_of(names, course).title()}, {"places_html", places_in_words(met, course)}});
        }
    }
    return {{"profile_least_stems_pha", fixed(profile.least_stems_pha, 0)},
            {"profile_dbh_from_cm", fixed(profile.dbh_from_cm, 0)},
            {"profile_ideal_stems_pha", fixed(profile.ideal_stems_pha, 0)},
            {"profile_longest_gap_m", fixed(profile.longest_gap_m, 0)},
            {"source", report::in_page_language(profile.source)},
            {"courses", courses},
            {"splits_climates", splits_charts(names)}};
}

PageFields years_table(const std::vector<std::int32_t>& years, std::vector<PageFields> figures) {
    return {{"years", heads_of(years)},
            {"grouped", true},
            {"columns", std::to_string(years.size() + 1)},
            {"figures", std::move(figures)}};
}

PageFields stands_table(const Names& names, std::span<const Series> all_series) {
    const Series& longest = *find_series(all_series, "gap_max_m");
    const std::vector<std::int32_t> years = three_of(years_of(longest));
    std::vector<PageFields> figures;
    if (const Series* met = find_series(all_series, "target_profile_met_percent")) {
        figures.push_back(figure_over_years(
            names, *met, report::page_text("Forest in stands that meet the target profile, %"), years, 0));
    }
    figures.push_back(
        figure_over_years(names, longest, report::page_text("Longest gap along the fall line, m"), years, 0));
    figures.push_back(figure_over_years(names, *find_series(all_series, "gap_95_m"),
                                        report::page_text("95th percentile of gap length, m"), years, 0));
    return years_table(years, std::move(figures));
}

/// What ended the falls; nothing where no rock falls through the forest.
std::optional<PageFields> stop_causes_over_years(const Names& names, std::span<const Series> all_series) {
    const Series* trees = find_series(all_series, "stopped_by_tree_percent");
    if (trees == nullptr) {
        return std::nullopt;
    }
    const std::vector<std::int32_t> all_years = years_of(*trees);
    std::vector<std::int32_t> years{all_years.front()};
    if (all_years.size() > 1) {
        years.push_back(all_years.back());
    }
    std::vector<PageFields> figures;
    constexpr std::array<const char*, stop_causes> in_words{
        "Stopped by a tree, %",     "Stopped by a log, %", "Held by a net, %",
        "Stopped by the ground, %", "Left the terrain, %", "Given up after too many impacts, %"};
    for (std::size_t cause = 0; cause < stop_causes; ++cause) {
        const auto kind = static_cast<StopCause>(cause);
        const bool stops = kind < StopCause::left_terrain;
        const Series* series =
            find_series(all_series, joined(stops ? "stopped_by_" : "", name_of(kind), "_percent"));
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
            figures.push_back(
                figure_over_years(names, *series, report::page_text(in_words[cause]), years, 1));
        }
    }
    return years_table(years, std::move(figures));
}

}  // namespace

std::string stands_against_rocks(const Names& names, std::span<const Series> all_series,
                                 const std::optional<forest::TargetProfile>& profile, double mean_block_m) {
    const Series* met = find_series(all_series, "target_profile_met_percent");
    const auto& replicates = find_series(all_series, "gap_max_m")->values;
    PageFields fields = stands_table(names, all_series);
    fields.insert(
        fields.end(),
        {{"mean_block_m", fixed(mean_block_m, 2)},
         {"profile",
          profile && met != nullptr ? std::optional{profile_fields(names, *met, *profile)} : std::nullopt},
         {"one_replicate", std::all_of(replicates.begin(), replicates.end(),
                                       [](const auto& of_course) { return of_course.size() <= 1; })},
         {"causes", stop_causes_over_years(names, all_series)}});
    return report::filled_template("target_profile.html", fields);
}

}  // namespace coupling::decades
