#include "coupling/decades/report/protection.hpp"

#include <algorithm>
#include <limits>

#include "coupling/decades/report/regime_chart.hpp"
#include "coupling/decades/report/series.hpp"
#include "coupling/results/joined.hpp"
#include "coupling/results/report/html_table.hpp"
#include "coupling/results/report/markup.hpp"

namespace coupling::decades {
namespace {

using report::fixed;

std::string title_of(const Names& names, std::size_t regime) {
    const std::string letter = letter_of(regime, names.regimes.size());
    return letter.empty() ? names.regimes[regime] : joined(letter, ": ", names.regimes[regime]);
}

/// A line cannot leave the chart downwards: below 0 it is drawn at 0.
std::string chart_of(const Names& names, const Series& series, const std::string& title,
                     const std::string& axis, const std::string& caption) {
    const std::vector<std::int32_t> years = years_of(series);
    std::vector<RegimeCurve> curves;
    for (std::size_t regime = 0; regime < names.regimes.size(); ++regime) {
        RegimeCurve curve{regime, title_of(names, regime), letter_of(regime, names.regimes.size())};
        for (const std::int32_t year : years) {
            if (const auto v = over_replicates(series, regime, year)) {
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
    return regime_chart(title, axis, static_cast<std::size_t>(years.back()), curves, caption);
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
double mean_of_years(const Series& series, std::size_t regime) {
    double sum = 0.0;
    double count = 0.0;
    for (const std::int32_t year : years_of(series)) {
        if (const auto v = over_replicates(series, regime, year)) {
            sum += v->band.mean;
            count += 1.0;
        }
    }
    return count > 0.0 ? sum / count : std::numeric_limits<double>::quiet_NaN();
}

std::string table_of(const Names& names, const Series& protection, const std::string& target) {
    const std::vector<std::int32_t> years = years_of(protection);
    const bool compares = names.regimes.size() > 1;
    const std::string last = std::to_string(years.back());
    std::vector<std::string> head{"Regime",
                                  joined("year ", std::to_string(years.front())),
                                  joined("year ", last),
                                  "mean of the years",
                                  "lowest",
                                  "in year"};
    if (compares) {
        head.push_back(joined("year ", last, " minus A"));
    }
    report::HtmlTable table{joined("Rocks that the forest keeps away from ", report::escaped(target),
                                   ", percent of those that arrive over the bare slope; below 0 more arrive "
                                   "than without it. In brackets the "
                                   "5th and 95th percentile of the replicates, of few replicates little less "
                                   "than all of them. The lowest of many "
                                   "years is low by chance too.",
                                   compares ? " Differences are paired by replicate, with their 95 % "
                                              "interval: where it holds 0, the regimes cannot "
                                              "be told apart."
                                            : ""),
                            head};
    for (std::size_t regime = 0; regime < names.regimes.size(); ++regime) {
        const auto worst = worst_year(protection, regime);
        std::vector<std::string> cells{report::escaped(title_of(names, regime)),
                                       in_words(over_replicates(protection, regime, years.front())),
                                       in_words(over_replicates(protection, regime, years.back())),
                                       fixed(mean_of_years(protection, regime), 1),
                                       worst ? in_words(std::optional{worst->value}) : "–",
                                       worst ? std::to_string(worst->year) : "–"};
        if (compares) {
            cells.push_back(regime == 0 ? "" : in_words(difference(protection, regime, 0, years.back())));
        }
        table.row(cells);
    }
    return table.html();
}

}  // namespace

std::string protection_over_years(const Names& names, const Site& site, std::span<const Series> all_series) {
    std::string html;
    for (const rockfall::Target& target : site.targets) {
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
        html += table_of(names, protection, target.name);
        html += joined("<div class=\"halves\">",
                       chart_of(names, protection, joined("Protection: ", target.name), "Rocks kept away, %",
                                "Of the rocks that arrive over the bare slope. Below 0 is drawn as 0."),
                       chart_of(names, find("reached_percent"), joined("Rocks that arrive: ", target.name),
                                "Rocks that arrive, %", "Of all rocks released in the year."),
                       "</div>\n");
    }
    return html;
}

}  // namespace coupling::decades
