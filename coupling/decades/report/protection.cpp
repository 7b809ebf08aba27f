#include "coupling/decades/report/protection.hpp"

#include <algorithm>

#include "coupling/decades/report/page_parts.hpp"
#include "coupling/results/joined.hpp"
#include "coupling/results/report/chart.hpp"
#include "coupling/results/report/html_table.hpp"
#include "coupling/results/report/markup.hpp"

namespace coupling::decades {
namespace {

using report::Axis;
using report::Chart;
using report::ChartPoint;
using report::ChartRange;
using report::fixed;

std::string letter_of(std::size_t regime, std::size_t regimes) {
    return regimes > 1 ? std::string(1, static_cast<char>('A' + regime)) : std::string{};
}

std::string title_of(const Names& names, std::size_t regime) {
    const std::string letter = letter_of(regime, names.regimes.size());
    return letter.empty() ? names.regimes[regime] : joined(letter, ": ", names.regimes[regime]);
}

std::string chart_of(const Names& names, const Series& series, const std::string& title, const char* axis,
                     double most, const char* caption) {
    const std::vector<std::int32_t> years = years_of(series);
    if (years.empty()) {
        return "";
    }
    Chart chart{title,
                {"Years since the start", 0.0, std::max(1.0, static_cast<double>(years.back())), false, true},
                Axis::from_zero(axis, most)};
    std::vector<std::vector<ChartPoint>> lines(names.regimes.size());
    bool with_bands = false;
    for (std::size_t regime = 0; regime < names.regimes.size(); ++regime) {
        std::vector<ChartRange> band;
        for (const std::int32_t year : years) {
            if (const auto v = over_replicates(series, regime, year)) {
                lines[regime].push_back({static_cast<double>(year), std::max(0.0, v->mean)});
                band.push_back({static_cast<double>(year), std::max(0.0, v->low), std::max(0.0, v->high)});
                with_bands = with_bands || v->replicates > 1;
            }
        }
        if (with_bands && band.size() > 1) {
            chart.add_band(line_of_regime(regime), band);
        }
    }
    for (std::size_t regime = 0; regime < names.regimes.size(); ++regime) {
        if (lines[regime].empty()) {
            continue;
        }
        chart.add_line(line_of_regime(regime), lines[regime]);
        chart.add_end_letter(lines[regime].back().y, letter_of(regime, names.regimes.size()));
        chart.add_name(line_of_regime(regime), title_of(names, regime));
    }
    if (with_bands) {
        chart.add_band_name(line_of_regime(0), "nine in ten replicates");
    }
    return chart.figure(caption);
}

std::string in_words(const std::optional<OverReplicates>& v) {
    if (!v) {
        return "–";
    }
    return v->replicates > 1 ? joined(fixed(v->mean, 1), " <small>(", fixed(v->low, 1), " – ",
                                      fixed(v->high, 1), ")</small>")
                             : fixed(v->mean, 1);
}

/// Mean over all years of the means over replicates.
double mean_of_years(const Series& series, std::size_t regime) {
    double sum = 0.0;
    double count = 0.0;
    for (const std::int32_t year : years_of(series)) {
        if (const auto v = over_replicates(series, regime, year)) {
            sum += v->mean;
            count += 1.0;
        }
    }
    return count > 0.0 ? sum / count : std::numeric_limits<double>::quiet_NaN();
}

std::string table_of(const Names& names, const Series& protection, const std::string& target) {
    const std::vector<std::int32_t> years = years_of(protection);
    report::HtmlTable table{
        joined("Rocks that the forest keeps away from ", report::escaped(target),
               ", percent of those that arrive over the bare slope; in brackets where nine in ten "
               "replicates lie. The lowest of many years is low by chance too."),
        {"Regime", joined("year ", std::to_string(years.front())),
         joined("year ", std::to_string(years.back())), "mean of the years", "lowest", "in year"}};
    for (std::size_t regime = 0; regime < names.regimes.size(); ++regime) {
        const auto worst = worst_year(protection, regime);
        table.row({report::escaped(title_of(names, regime)),
                   in_words(over_replicates(protection, regime, years.front())),
                   in_words(over_replicates(protection, regime, years.back())),
                   fixed(mean_of_years(protection, regime), 1), worst ? in_words(worst->value) : "–",
                   worst ? std::to_string(worst->year) : "–"});
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
        double most = 0.0;
        const Series& reached = find("reached_percent");
        for (const std::int32_t year : years_of(reached)) {
            for (std::size_t regime = 0; regime < names.regimes.size(); ++regime) {
                if (const auto v = over_replicates(reached, regime, year)) {
                    most = std::max(most, v->high);
                }
            }
        }
        html += table_of(names, protection, target.name);
        html +=
            joined("<div class=\"halves\">",
                   chart_of(names, protection, joined("Protection: ", target.name), "Rocks kept away, %",
                            100.0, "Of the rocks that arrive over the bare slope. Below 0 is drawn as 0."),
                   chart_of(names, reached, joined("Rocks that arrive: ", target.name),
                            "Rocks that arrive, %", most, "Of all rocks released in the year."),
                   "</div>\n");
    }
    return html;
}

}  // namespace coupling::decades
