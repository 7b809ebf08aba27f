#include "coupling/decades/report/protection.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "coupling/decades/arrivals.hpp"
#include "coupling/decades/report/regime_chart.hpp"
#include "coupling/decades/report/series.hpp"
#include "coupling/results/few_rocks.hpp"
#include "coupling/results/joined.hpp"
#include "coupling/results/report/html_table.hpp"
#include "coupling/results/report/markup.hpp"

namespace coupling::decades {
namespace {

using report::fixed;

/// A line cannot leave the chart downwards: below 0 it is drawn at 0.
std::string charts_of(const Names& names, const Series& series, const std::string& title,
                      const std::string& axis, const std::string& caption, bool may_begin_above_0) {
    const std::vector<std::int32_t> years = years_of(series);
    std::vector<RegimeCurve> curves;
    for (std::size_t course = 0; course < names.courses(); ++course) {
        const CourseLook look = look_of(names, course);
        RegimeCurve curve{look.line, names.climate_of(course), look.title_in_chart(), look.letter};
        for (const std::int32_t year : years) {
            if (const auto v = over_replicates(series, course, year)) {
                const auto x = static_cast<double>(year);
                curve.means.push_back({x, std::max(0.0, v->band.mean)});
                if (v->replicates > 1) {
                    curve.ranges.push_back({x, std::max(0.0, v->band.low), std::max(0.0, v->band.high)});
                }
            }
        }
        if (!curve.means.empty()) {
            curves.push_back(std::move(curve));
        }
    }
    return regime_charts({.title = title,
                          .y_title = axis,
                          .years = static_cast<std::size_t>(years.back()),
                          .climates = splits_charts(names) ? names.climates : std::vector<std::string>{},
                          .may_begin_above_0 = may_begin_above_0},
                         curves, caption);
}

std::string in_words(const std::optional<OverReplicates>& v) {
    if (!v) {
        return "–";
    }
    const Band& band = v->band;
    return v->replicates > 1 ? joined(fixed(band.mean, 1), " <small>(", fixed(band.low, 1), " – ",
                                      fixed(band.high, 1), ")</small>")
                             : fixed(band.mean, 1);
}

/// A difference with its interval; of a single pair nothing can be said but its value.
std::string in_words(const std::optional<PairedDifference>& d) {
    if (!d) {
        return "–";
    }
    return d->pairs > 1 ? joined(fixed(d->mean, 1), " <small>(", fixed(d->low, 1), " to ", fixed(d->high, 1),
                                 ")</small>")
                        : joined(fixed(d->mean, 1), " <small>(one replicate: chance unknown)</small>");
}

/// Mean over all years of the means over replicates.
double mean_of_years(const Series& series, std::size_t course) {
    double sum = 0.0;
    double count = 0.0;
    for (const std::int32_t year : years_of(series)) {
        if (const auto v = over_replicates(series, course, year)) {
            sum += v->band.mean;
            count += 1.0;
        }
    }
    return count > 0.0 ? sum / count : std::numeric_limits<double>::quiet_NaN();
}

std::string range_text(const OverReplicates& v, int decimals, const char* unit) {
    return joined("<b>", fixed(v.band.mean, decimals), unit, "</b>",
                  v.replicates > 1
                      ? joined(" (", fixed(v.band.low, decimals), " – ", fixed(v.band.high, decimals), ")")
                      : "");
}

/// What the forest keeps away in a year; of one replicate with the interval of its own rocks.
std::string kept_away(const OverReplicates& v, const PairedCounts& counts) {
    if (too_few_to_tell(counts)) {
        return joined("– (too few rocks arrive to tell: ", std::to_string(counts.bare()), ")");
    }
    const auto effect = protection_effect(counts);
    const std::string value = range_text(v, 1, "\u00a0%");
    if (v.replicates > 1 || !effect) {
        return value;
    }
    return effect->one_sided ? joined(value, " (with 95 % confidence at least ",
                                      fixed(100.0 * std::max(0.0, effect->interval.low), 1), ")")
                             : joined(value, " (95 % interval ", fixed(100.0 * effect->interval.low, 1),
                                      " to ", fixed(100.0 * effect->interval.high, 1), ")");
}

bool is_one_replicate(const Series& series) {
    return std::all_of(series.values.begin(), series.values.end(),
                       [](const auto& replicates) { return replicates.size() <= 1; });
}

/// Share of rocks that arrive over the bare slope, from what the forest keeps away and what arrives in each
/// replicate; NaN where it keeps away all of them.
double mean_bare_percent(const Series& protection, const Series& reached, std::size_t course,
                         std::int32_t year) {
    double sum = 0.0;
    double count = 0.0;
    for (std::size_t replicate = 0; replicate < reached.values[course].size(); ++replicate) {
        const auto& arrivals = reached.values[course][replicate];
        const auto& effects = protection.values[course][replicate];
        if (arrivals.contains(year) && effects.contains(year)) {
            sum += arrivals.at(year) / (1.0 - effects.at(year) / 100.0);
            count += 1.0;
        }
    }
    const double mean = count > 0.0 ? sum / count : std::numeric_limits<double>::quiet_NaN();
    return std::isfinite(mean) ? mean : std::numeric_limits<double>::quiet_NaN();
}

/// The answer for one course; `arrivals` are those of a year. What the forest keeps away at the start, at
/// worst and at the end, what arrives, how hard.
std::string answer_of(const Names& names, const Series& protection, const Series& reached,
                      const Series& energy, std::size_t course,
                      const std::function<PairedCounts(std::int32_t)>& arrivals) {
    const std::vector<std::int32_t> years = years_of(protection);
    const auto first = over_replicates(protection, course, years.front());
    const auto last = over_replicates(protection, course, years.back());
    const auto worst = worst_year(protection, course);
    if (!first || !last || !worst) {
        return "";
    }
    std::string text = joined("<p class=\"answer\"><b>", report::escaped(look_of(names, course).title()),
                              "</b>: of the rocks that would arrive the forest keeps away at the start ",
                              kept_away(*first, arrivals(years.front())), ", in year ",
                              std::to_string(years.back()), " ", kept_away(*last, arrivals(years.back())));
    // As much as at the ends in every year: there is no least.
    const PairedCounts at_worst = arrivals(worst->year);
    text += worst->value.band.mean < std::min(first->band.mean, last->band.mean) && !too_few_to_tell(at_worst)
                ? joined("; least in year ", std::to_string(worst->year), ": ",
                         kept_away(worst->value, at_worst), ". ")
                : ". ";
    if (const auto share = over_replicates(reached, course, years.back())) {
        text += joined("In year ", std::to_string(years.back()), " ", range_text(*share, 2, "\u00a0%"),
                       " of all rocks arrive");
        const double bare = mean_bare_percent(protection, reached, course, years.back());
        text += std::isnan(bare) ? "." : joined(", over the bare slope ", fixed(bare, 2), "\u00a0%.");
    }
    if (const auto hard = over_replicates(energy, course, years.back())) {
        text += joined(" One in twenty of the rocks that come through the forest has more than ",
                       range_text(*hard, 0, "\u00a0kJ"), ".");
    }
    return joined(text, "</p>");
}

std::string table_of(const Names& names, const Series& protection, const std::string& target) {
    const std::vector<std::int32_t> years = years_of(protection);
    const bool compares = names.regimes.size() > 1;
    const bool has_climates = names.climates.size() > 1;
    const bool one = is_one_replicate(protection);
    const std::string last = std::to_string(years.back());
    const bool several = years.size() > 1;  // of one year with rocks the first is the last
    std::vector<std::string> head{"Regime", joined("year ", std::to_string(years.front()))};
    if (several) {
        head.push_back(joined("year ", last));
    }
    head.insert(head.end(), {"mean of the years", "lowest", "in year"});
    if (compares) {
        head.push_back(joined("year ", last, " minus A", has_climates ? " in the same climate" : ""));
    }
    if (has_climates) {
        head.push_back(joined("year ", last, " minus ", report::escaped(names.climates.front()),
                              compares ? ", same regime" : ""));
    }
    report::HtmlTable table{
        joined("Rocks that the forest keeps away from ", report::escaped(target),
               ", percent of those that arrive over the bare slope; below 0 more arrive "
               "than without it. ",
               one ? "One replicate: no intervals. "
                   : "In brackets the 5th and 95th percentile of the replicates, of few replicates little "
                     "less than all of them. ",
               "The lowest of many years is low by chance too.",
               !one && (compares || has_climates)
                   ? joined(" Differences are paired by replicate, with their 95 % "
                            "interval: where it holds 0, the ",
                            compares ? "regimes" : "", compares && has_climates ? " or " : "",
                            has_climates ? "climates" : "", " cannot be told apart.")
                   : ""),
        head};
    for (std::size_t course = 0; course < names.courses(); ++course) {
        const auto worst = worst_year(protection, course);
        std::vector<std::string> cells{report::escaped(look_of(names, course).title()),
                                       in_words(over_replicates(protection, course, years.front()))};
        if (several) {
            cells.push_back(in_words(over_replicates(protection, course, years.back())));
        }
        cells.insert(cells.end(), {fixed(mean_of_years(protection, course), 1),
                                   worst ? in_words(std::optional{worst->value}) : "–",
                                   worst ? std::to_string(worst->year) : "–"});
        if (compares) {
            const std::size_t first = names.course(0, names.climate_of(course));
            cells.push_back(course == first ? ""
                                            : in_words(difference(protection, course, first, years.back())));
        }
        if (has_climates) {
            const std::size_t first = names.course(names.regime_of(course), 0);
            cells.push_back(course == first ? ""
                                            : in_words(difference(protection, course, first, years.back())));
        }
        table.row(cells);
    }
    return table.html();
}

}  // namespace

std::string protection_over_years(const Names& names, const Site& site, std::span<const Series> all_series,
                                  std::span<const MemberYears> members) {
    std::string html =
        site.nets.empty() || site.targets.empty()
            ? ""
            : "<p>The nets stand on the bare slope too: protection compares forest and no forest behind the "
              "same nets.</p>\n";
    for (std::uint32_t place = 0; place < site.targets.size(); ++place) {
        const rockfall::Target& target = site.targets[place];
        const auto find = [&](const char* quantity) -> const Series& {
            return *std::find_if(all_series.begin(), all_series.end(), [&](const Series& series) {
                return series.target == target.id && series.quantity == quantity;
            });
        };
        const Series& protection = find("protection_percent");
        if (years_of(protection).empty()) {
            html += joined("<p>No rock arrives at ", report::escaped(target.name),
                           " over the bare slope: there is no danger that a forest could lower.</p>\n");
            continue;
        }
        html += joined("<section class=\"card\"><h3>",
                       report::escaped(target.name.empty() ? target.id : target.name), "</h3>");
        for (std::size_t course = 0; course < names.courses(); ++course) {
            if (!splits_charts(names) || names.climate_of(course) == 0) {
                html += answer_of(
                    names, protection, find("reached_percent"), find("energy_95_kj"), course,
                    [&](std::int32_t year) { return arrivals_of(names, members, course, place, year); });
            }
        }
        html += splits_charts(names) ? other_climates() : "";
        html += joined(
            "<p class=\"soft\">",
            is_one_replicate(protection)
                ? "One replicate: no intervals of the replicates; those in brackets cover the chance in its "
                  "rocks alone."
                : "Means of the replicates, in brackets their 5th and 95th percentile.",
            "</p></section>\n", table_of(names, protection, target.name));
        html +=
            joined("<div class=\"halves\">",
                   charts_of(names, protection, joined("Protection: ", target.name), "Rocks kept away, %",
                             "Of the rocks that arrive over the bare slope. Below 0 is drawn as 0.", true),
                   charts_of(names, find("reached_percent"), joined("Rocks that arrive: ", target.name),
                             "Rocks that arrive, %", "Of all rocks released in the year.", false),
                   "</div>\n");
    }
    return html;
}

}  // namespace coupling::decades
