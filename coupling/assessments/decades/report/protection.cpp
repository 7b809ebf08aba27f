#include "coupling/assessments/decades/report/protection.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "config/text/joined.hpp"
#include "coupling/assessments/decades/report/regime_chart.hpp"
#include "coupling/assessments/decades/report/series.hpp"
#include "coupling/assessments/decades/tables/arrivals.hpp"
#include "coupling/results/figures/effect_words.hpp"
#include "coupling/results/figures/few_rocks.hpp"
#include "coupling/results/report/energy_rates.hpp"
#include "coupling/results/report/html_table.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::decades {
namespace {

using config::joined;
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
                    const report::ChartRange range = range_at(x, v->band);
                    curve.ranges.push_back({x, std::max(0.0, range.low), std::max(0.0, range.high)});
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
    return band.has_interval() ? joined(fixed(band.mean, 1), " <small>(", fixed(band.low, 1), " – ",
                                        fixed(band.high, 1), ")</small>")
                               : fixed(band.mean, 1);
}

/// A difference with its interval; of a single pair nothing can be said but its value.
std::string in_words(const std::optional<PairedDifference>& d) {
    if (!d) {
        return "–";
    }
    return !std::isnan(d->low)
               ? report::page_text(
                     "{mean} <small>({low} to {high})</small>",
                     {{"mean", fixed(d->mean, 1)}, {"low", fixed(d->low, 1)}, {"high", fixed(d->high, 1)}})
               : report::page_text(d->pairs > 1 ? "{mean} <small>(all pairs equal: chance unknown)</small>"
                                                : "{mean} <small>(one replicate: chance unknown)</small>",
                                   {{"mean", fixed(d->mean, 1)}});
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
                  v.band.has_interval()
                      ? joined(" (", fixed(v.band.low, decimals), " – ", fixed(v.band.high, decimals), ")")
                      : "");
}

/// What the forest stops in a year; of one replicate, and where all replicates are equal, with the interval
/// of their rocks.
std::string stopped_in_words(const std::optional<OverReplicates>& v, const PairedCounts& counts) {
    if (!v || too_few_for_protection(counts)) {
        return joined("– (", too_few_in_words(counts.bare()), ")");
    }
    const auto effect = protection_effect(counts);
    const std::string value = range_text(*v, 1, "\u00a0%");
    if (v->band.has_interval() || !effect) {
        return value;
    }
    return effect->one_sided
               ? report::page_text("{value} (with 95 % confidence at least {interval_low})",
                                   {{"value", value},
                                    {"interval_low", fixed(100.0 * std::max(0.0, effect->interval.low), 1)}})
               : report::page_text("{value} (95 % interval {interval_low} to {interval_high})",
                                   {{"value", value},
                                    {"interval_low", fixed(100.0 * effect->interval.low, 1)},
                                    {"interval_high", fixed(100.0 * effect->interval.high, 1)}});
}

bool is_one_replicate(const Series& series) {
    return std::all_of(series.values.begin(), series.values.end(),
                       [](const auto& replicates) { return replicates.size() <= 1; });
}

/// "In year 50 0.42 % of all rocks arrive, over the bare slope 3.10 %. ..."
std::string last_year_in_words(const Series& reached, std::size_t course, const YearAtTarget& last) {
    const auto share = over_replicates(reached, course, last.year);
    if (!share) {
        return "";
    }
    const std::string text = report::page_text(
        "In year {last_year}, {range_text_share} of all rocks arrive, over the bare slope {bare_share} %.",
        {{"last_year", std::to_string(last.year)},
         {"range_text_share", range_text(*share, 2, "\u00a0%")},
         {"bare_share", fixed(100.0 * last.bare.share.value, 2)}});
    return report::join_sentences(
        {text,
         std::isnan(last.forest.energy_kj.p95)
             ? ""
             : report::page_text(
                   "Of the rocks that come through the forest 5 % have more than <b>{energy_kj_p95} kJ</b>.",
                   {{"energy_kj_p95", fixed(last.forest.energy_kj.p95, 0)}}),
         rise_in_words(last.forest, last.bare)});
}

/// The answer for one course: what the forest stops at the start, at worst and at the end, what arrives, how
/// hard. `at_year` sums a year over the replicates.
std::string answer_of(const Names& names, const Series& protection, const Series& reached, std::size_t course,
                      const std::function<YearAtTarget(std::int32_t)>& at_year) {
    const std::vector<std::int32_t> years = years_of(reached);
    const auto effect_in = [&](std::int32_t year) { return over_replicates(protection, course, year); };
    const auto first = effect_in(years.front());
    const auto last = effect_in(years.back());
    const YearAtTarget at_end = at_year(years.back());
    const auto worst = worst_year(protection, course);
    const auto is_below = [&](const std::optional<OverReplicates>& end) {
        return !end || worst->value.band.mean < end->band.mean;
    };
    const std::string stops = report::join_with_semicolons(
        {report::page_text(
             "<b>{course}</b>: of the rocks that would arrive the forest stops at the start {at_start}, in "
             "year {last_year} {in_last_year}",
             {{"course", report::escaped(look_of(names, course).title())},
              {"at_start", stopped_in_words(first, at_year(years.front()).paired)},
              {"last_year", std::to_string(years.back())},
              {"in_last_year", stopped_in_words(last, at_end.paired)}}),
         worst && is_below(first) && is_below(last)
             ? report::page_text("lowest in year {year}: {effect}",
                                 {{"year", std::to_string(worst->year)},
                                  {"effect", stopped_in_words(worst->value, at_year(worst->year).paired)}})
             : ""});
    return joined("<p class=\"answer\">",
                  report::join_sentences({joined(stops, "."), last_year_in_words(reached, course, at_end)}),
                  "</p>");
}

/// Rocks above given energies in the first and the last year; the bare slope is the same for all courses.
std::string rates_over_years(const Names& names, std::span<const MemberYears> members, const Series& reached,
                             std::uint32_t target) {
    const std::vector<std::int32_t> all_years = years_of(reached);
    if (all_years.empty()) {
        return "";
    }
    std::vector<std::int32_t> years{all_years.front(), all_years.back()};
    years.erase(std::unique(years.begin(), years.end()), years.end());
    std::vector<report::EnergyRates> rows;
    for (const std::int32_t year : years) {
        const std::string when = report::page_text("year {year}", {{"year", std::to_string(year)}});
        rows.push_back({joined(when, ", ", report::page_text("bare slope")),
                        at_target(names, members, 0, target, year).bare.above});
        for (std::size_t course = 0; course < names.courses(); ++course) {
            rows.push_back({joined(when, ", ", report::escaped(look_of(names, course).title())),
                            at_target(names, members, course, target, year).forest.above});
        }
    }
    return report::energy_rates_table(report::page_text("Rocks"), rows);
}

std::string table_of(const Names& names, const Series& protection, const Series& reached,
                     const std::string& target) {
    const std::vector<std::int32_t> years = years_of(reached);
    const bool compares = names.regimes.size() > 1;
    const bool has_climates = names.climates.size() > 1;
    const bool one = is_one_replicate(protection);
    const std::string last = std::to_string(years.back());
    const bool several = years.size() > 1;  // of one year with rocks the first is the last
    std::vector<std::string> head{
        report::page_text("Regime"),
        report::page_text("year {years}", {{"years", std::to_string(years.front())}})};
    if (several) {
        head.push_back(report::page_text("year {last}", {{"last", last}}));
    }
    head.insert(head.end(), {report::page_text("mean of the years"), report::page_text("lowest"),
                             report::page_text("in year")});
    if (compares) {
        head.push_back(report::page_text(
            has_climates ? "year {last} minus A in the same climate" : "year {last} minus A",
            {{"last", last}}));
    }
    if (has_climates) {
        head.push_back(report::page_text(
            compares ? "year {last} minus {climate}, same regime" : "year {last} minus {climate}",
            {{"last", last}, {"climate", report::escaped(names.climates.front())}}));
    }
    report::HtmlTable table{
        report::join_sentences(
            {report::page_text(
                 "Rocks that the forest stops above {target}, percent of those that arrive over the "
                 "bare slope; below 0 more arrive than without it. A dash: fewer than "
                 "{least_arrivals_for_protection} rocks arrive over the bare slope, too few for a "
                 "protection figure.",
                 {{"target", report::escaped(target)},
                  {"least_arrivals_for_protection", std::to_string(least_arrivals_for_protection)}}),
             report::page_text(
                 one ? "One replicate: no intervals."
                     : "In brackets the 90 % interval of the mean (Student’s t, skewness by Hall "
                       "1992); none where all replicates are equal."),
             report::page_text("The lowest of many years is partly chance."),
             one || !(compares || has_climates)
                 ? ""
                 : report::page_text(
                       !has_climates
                           ? "Differences are paired by replicate, with their 95 % interval: where it "
                             "includes 0, the difference between the regimes is not significant."
                       : !compares
                           ? "Differences are paired by replicate, with their 95 % interval: where it "
                             "includes 0, the difference between the climates is not significant."
                           : "Differences are paired by replicate, with their 95 % interval: where it "
                             "includes 0, the difference between the regimes or climates is not "
                             "significant.")}),
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
    std::string html = site.nets.empty() || site.targets.empty()
                           ? ""
                           : joined("<p>",
                                    report::page_text("The nets stand on the bare slope too: protection "
                                                      "compares forest and no forest behind the same nets."),
                                    "</p>\n");
    for (std::uint32_t place = 0; place < site.targets.size(); ++place) {
        const rockfall::Target& target = site.targets[place];
        const auto find = [&](const char* quantity) -> const Series& {
            return *std::find_if(all_series.begin(), all_series.end(), [&](const Series& series) {
                return series.target == target.id && series.quantity == quantity;
            });
        };
        const Series& protection = find("protection_percent");
        const Series& reached = find("reached_percent");
        const std::string title = report::escaped(target.name.empty() ? target.id : target.name);
        if (years_of(protection).empty()) {
            html += joined(
                "<section class=\"card\"><h3>", title, "</h3><p>",
                report::page_text(
                    "No protection figure in any year: fewer than {least_arrivals_for_protection} rocks a "
                    "year arrive over the bare slope.",
                    {{"least_arrivals_for_protection", std::to_string(least_arrivals_for_protection)}}),
                "</p>", rates_over_years(names, members, reached, place), "</section>\n");
            continue;
        }
        html += joined("<section class=\"card\"><h3>", title, "</h3>");
        for (std::size_t course = 0; course < names.courses(); ++course) {
            if (!splits_charts(names) || names.climate_of(course) == 0) {
                html += answer_of(names, protection, reached, course, [&](std::int32_t year) {
                    return at_target(names, members, course, place, year);
                });
            }
        }
        html += splits_charts(names) ? other_climates() : "";
        html += joined("<p class=\"soft\">",
                       is_one_replicate(protection)
                           ? report::page_text("One replicate: no intervals of the replicates; those in "
                                               "brackets cover only the chance in its rocks.")
                           : report::page_text("Means of the replicates, in brackets their 90 % intervals "
                                               "(Student’s t, skewness by Hall 1992)."),
                       "</p>", rates_over_years(names, members, reached, place), "</section>\n",
                       table_of(names, protection, reached, target.name));
        html += joined(
            "<div class=\"halves\">",
            charts_of(names, protection,
                      report::page_text("Protection: {target_name}", {{"target_name", target.name}}),
                      report::page_text("Rocks stopped, %"),
                      report::page_text("Of the rocks that arrive over the bare slope. Below 0 is drawn as "
                                        "0. Years with too few rocks have no point."),
                      true),
            charts_of(names, reached,
                      report::page_text("Rocks that arrive: {target_name}", {{"target_name", target.name}}),
                      report::page_text("Rocks that arrive, %"),
                      report::page_text("Of all rocks released in the year."), false),
            "</div>\n");
    }
    return html;
}

}  // namespace coupling::decades
