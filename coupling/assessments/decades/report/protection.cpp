#include "coupling/assessments/decades/report/protection.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include "config/text/joined.hpp"
#include "coupling/assessments/decades/report/figure_cells.hpp"
#include "coupling/assessments/decades/report/regime_chart.hpp"
#include "coupling/assessments/decades/report/series.hpp"
#include "coupling/assessments/decades/tables/arrivals.hpp"
#include "coupling/results/figures/effect_words.hpp"
#include "coupling/results/figures/few_rocks.hpp"
#include "coupling/results/report/energy_rates.hpp"
#include "coupling/results/text/element.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::decades {
namespace {

using config::joined;
using report::fixed;
using report::PageFields;

/// A difference with its interval; of a single pair nothing can be said but its value.
PageFields difference_fields(const std::optional<PairedDifference>& d) {
    if (!d) {
        return {{"known", false}};
    }
    const bool has_interval = !std::isnan(d->low);
    if (has_interval && says_nothing(d->low, d->high)) {
        return {{"known", false}};
    }
    return {{"known", PageFields{{"mean", fixed(d->mean, 1)},
                                 {"low", fixed(d->low, 1)},
                                 {"high", fixed(d->high, 1)},
                                 {"interval", has_interval},
                                 {"all_equal", !has_interval && d->pairs > 1},
                                 {"single_pair", !has_interval && d->pairs <= 1}}}};
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

std::string range_text(const Band& band, int decimals, const char* unit) {
    return joined(report::element("b", {}, joined(fixed(band.mean, decimals), unit)),
                  band.has_interval()
                      ? joined(" (", fixed(band.low, decimals), " – ", fixed(band.high, decimals), ")")
                      : "");
}

/// What the forest stops in a year; of one replicate, and where all replicates are equal, with the interval
/// of their rocks.
std::string stopped_in_words(const std::optional<OverReplicates>& v, const PairedCounts& counts) {
    if (!v || too_few_for_protection(counts) ||
        (v->band.has_interval() && says_nothing(v->band.low, v->band.high))) {
        return joined("– (", too_few_in_words(counts.bare()), ")");
    }
    const auto effect = protection_effect(counts);
    const std::string value = range_text(v->band, 1, "\u00a0%");
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

/// What arrives in the last year, and how hard.
std::optional<PageFields> arriving_fields(const Series& reached, std::size_t course,
                                          const YearAtTarget& last) {
    const auto share = over_replicates(reached, course, last.year);
    if (!share) {
        return std::nullopt;
    }
    const double p95_kj = last.forest.energy_kj.p95;
    return PageFields{{"share_html", range_text(share->band, 2, "\u00a0%")},
                      {"bare_share", fixed(100.0 * last.bare.share.value, 2)},
                      {"strong", !std::isnan(p95_kj)},
                      {"energy_kj_p95", fixed(p95_kj, 0)},
                      {"rise", rise_in_words(last.forest, last.bare)}};
}

/// The lowest year of the forest behind its rocks (decision/drawn_protection), as in the decision.
std::string lowest_in_words(const Band& band) {
    return band.has_interval() && says_nothing(band.low, band.high) ? "–" : range_text(band, 1, "\u00a0%");
}

/// The answer for one course: what the forest stops at the start, at worst and at the end, what arrives, how
/// hard. `at_year` sums a year over the replicates.
PageFields answer_fields(const Names& names, const Series& protection, const Series& reached,
                         const std::optional<Extreme>& worst, std::size_t course,
                         const std::function<YearAtTarget(std::int32_t)>& at_year) {
    const std::vector<std::int32_t> years = years_of(reached);
    const auto effect_in = [&](std::int32_t year) { return over_replicates(protection, course, year); };
    const auto first = effect_in(years.front());
    const auto last = effect_in(years.back());
    const YearAtTarget at_end = at_year(years.back());
    const auto is_below = [&](const std::optional<OverReplicates>& end) {
        return !end || worst->value.band.mean < end->band.mean;
    };
    std::optional<PageFields> lowest;
    if (worst && is_below(first) && is_below(last)) {
        lowest = PageFields{{"year", std::to_string(worst->year)},
                            {"effect_html", lowest_in_words(worst->value.band)}};
    }
    return {{"course", look_of(names, course).title()},
            {"at_start_html", stopped_in_words(first, at_year(years.front()).paired)},
            {"last_year", std::to_string(years.back())},
            {"at_end_html", stopped_in_words(last, at_end.paired)},
            {"lowest", lowest},
            {"arriving", arriving_fields(reached, course, at_end)}};
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
        rows.push_back({report::join_with_commas({when, report::page_text("bare slope")}),
                        at_target(names, members, 0, target, year).bare.above});
        std::vector<std::array<Share, rockfall::counted_energies_j.size()>> of_courses;
        for (std::size_t course = 0; course < names.courses(); ++course) {
            of_courses.push_back(at_target(names, members, course, target, year).forest.above);
        }
        const bool all_equal = std::all_of(of_courses.begin(), of_courses.end(), [&](const auto& above) {
            return std::equal(above.begin(), above.end(), of_courses.front().begin(),
                              [](const Share& a, const Share& b) { return a.value == b.value; });
        });
        if (all_equal) {  // at the start all regimes have the same forest
            rows.push_back(
                {report::join_with_commas({when, report::page_text("with forest")}), of_courses.front()});
            continue;
        }
        for (std::size_t course = 0; course < names.courses(); ++course) {
            rows.push_back({report::join_with_commas({when, report::escaped(look_of(names, course).title())}),
                            of_courses[course]});
        }
    }
    return report::energy_rates_table(report::page_text("Rocks"), rows);
}

/// A row of the table: what the forest stops in `years`, in the mean of all and in the worst, and what
/// differs from the first regime and the first climate.
PageFields row_fields(const Names& names, const Series& protection, const std::optional<Extreme>& worst,
                      std::size_t course, const std::vector<std::int32_t>& years) {
    std::vector<std::string> cells;
    for (const std::int32_t year : years) {
        cells.push_back(protection_cell(over_replicates(protection, course, year)));
    }
    cells.insert(cells.end(),
                 {fixed(mean_of_years(protection, course), 1), worst ? protection_cell(worst->value) : "–",
                  worst ? std::to_string(worst->year) : "–"});
    std::vector<PageFields> differences;
    const auto compare_with = [&](std::size_t first) {
        differences.push_back({{"other", course == first ? std::nullopt
                                                         : std::optional{difference_fields(difference(
                                                               protection, course, first, years.back()))}}});
    };
    if (names.regimes.size() > 1) {
        compare_with(names.course(0, names.climate_of(course)));
    }
    if (names.climates.size() > 1) {
        compare_with(names.course(names.regime_of(course), 0));
    }
    PageFields row = row_of_course(look_of(names, course).title(), cells);
    row.push_back({"differences", differences});
    return row;
}

/// The lowest year of a course at the target; nothing where no year after the start has a figure.
using LowestOf = std::function<std::optional<Extreme>(std::size_t course)>;

PageFields protection_table(const Names& names, const Series& protection, const LowestOf& lowest_of,
                            std::vector<std::int32_t> years) {
    years = {years.front(), years.back()};
    years.erase(std::unique(years.begin(), years.end()), years.end());
    std::vector<PageFields> rows;
    for (std::size_t course = 0; course < names.courses(); ++course) {
        rows.push_back(row_fields(names, protection, lowest_of(course), course, years));
    }
    const bool regimes = names.regimes.size() > 1;
    const bool climates = names.climates.size() > 1;
    const bool one = is_one_replicate(protection);
    return {{"one_replicate", one},
            {"several_regimes", regimes},
            {"several_climates", climates},
            {"paired_regimes", !one && regimes && !climates},
            {"paired_climates", !one && climates && !regimes},
            {"paired_both", !one && regimes && climates},
            {"years", heads_of(years)},
            {"last", std::to_string(years.back())},
            {"climate", climates ? names.climates.front() : ""},
            {"rows", rows}};
}

const Series& series_at(const rockfall::Target& target, const char* quantity,
                        std::span<const Series> all_series) {
    return *std::find_if(all_series.begin(), all_series.end(), [&](const Series& series) {
        return series.target == target.id && series.quantity == quantity;
    });
}

PageFields target_fields(const Names& names, const rockfall::Target& target, std::uint32_t place,
                         std::span<const Series> all_series, std::span<const MemberYears> members,
                         const LowestOf& lowest_of) {
    const Series& protection = series_at(target, "protection_percent", all_series);
    const Series& reached = series_at(target, "reached_percent", all_series);
    std::optional<PageFields> known;
    if (const std::vector<std::int32_t> years = years_of(protection); !years.empty()) {
        std::vector<PageFields> answers;
        for (std::size_t course = 0; course < names.courses(); ++course) {
            if (!splits_charts(names) || names.climate_of(course) == 0) {
                answers.push_back(answer_fields(
                    names, protection, reached, lowest_of(course), course,
                    [&](std::int32_t year) { return at_target(names, members, course, place, year); }));
            }
        }
        known = protection_table(names, protection, lowest_of, years);
        known->insert(
            known->end(),
            {{"answers", answers},
             {"splits_climates", splits_charts(names)},
             {"charts", series_charts(names, reached,
                                      {.title = report::page_text("Rocks that arrive: {target_name}",
                                                                  {{"target_name", target.name}}),
                                       .y_title = report::page_text("Rocks that arrive, %")},
                                      report::page_text("Of all rocks released in the year."))}});
    }
    return {{"target", target.name.empty() ? target.id : target.name},
            {"rates", rates_over_years(names, members, reached, place)},
            {"known", known}};
}

}  // namespace

std::string protection_charts(const Names& names, const Site& site, std::span<const Series> all_series) {
    std::string charts;
    for (const rockfall::Target& target : site.targets) {
        const Series& protection = series_at(target, "protection_percent", all_series);
        if (!years_of(protection).empty()) {
            charts += series_charts(
                names, protection,
                {.title = report::page_text("Protection: {target_name}", {{"target_name", target.name}}),
                 .y_title = report::page_text("Rocks stopped, %"),
                 .may_begin_above_0 = true},
                report::page_text("Of the rocks that arrive over the bare slope. Below 0 is drawn as "
                                  "0. Years with too few rocks have no point."));
        }
    }
    return charts;
}

std::string protection_over_years(const Names& names, const Site& site, std::span<const Series> all_series,
                                  std::span<const MemberYears> members, const LowestYears& lowest) {
    std::vector<PageFields> targets;
    for (std::uint32_t place = 0; place < site.targets.size(); ++place) {
        const auto lowest_of = [&](std::size_t course) { return lowest(course, site.targets[place].id); };
        targets.push_back(target_fields(names, site.targets[place], place, all_series, members, lowest_of));
    }
    const bool drawn = site.knowledge && site.knowledge->has_spread();
    return report::filled_template(
        "protection.html", {{"drawn", drawn},
                            {"nets", !site.nets.empty() && !site.targets.empty()},
                            {"least_arrivals_for_protection", std::to_string(least_arrivals_for_protection)},
                            {"targets", targets}});
}

}  // namespace coupling::decades
