#include <algorithm>

#include "config/text/joined.hpp"
#include "coupling/decades/report/page_parts.hpp"
#include "coupling/decades/report/regime_chart.hpp"
#include "coupling/results/report/markup.hpp"

namespace coupling::decades {
namespace {

using config::joined;

constexpr std::size_t most_chart_points = 200;

struct RegimeChart {
    const char* title;
    const char* axis;
    YearFigure figure;
    const char* caption = "";
    std::size_t first_year = 0;     ///< 1 for what only a year can have
    std::size_t years_a_point = 1;  ///< > 1: means over so many years
};

/// Years that a chart shows: all, or every so many of a long run, the last one always.
struct Stretch {
    std::size_t first;
    std::size_t last;
};
std::vector<Stretch> stretches_of(const RegimeChart& wanted, std::size_t years) {
    std::vector<Stretch> stretches;
    if (wanted.years_a_point > 1) {
        for (std::size_t first = wanted.first_year; first <= years; first += wanted.years_a_point) {
            stretches.push_back({first, std::min(years, first + wanted.years_a_point - 1)});
        }
        return stretches;
    }
    const std::size_t step = years / most_chart_points + 1;
    for (std::size_t year = wanted.first_year; year < years; year += step) {
        stretches.push_back({year, year});
    }
    if (years >= wanted.first_year) {
        stretches.push_back({years, years});
    }
    return stretches;
}

RegimeCurve curve_of(const RunView& run, const RegimeView& regime, const RegimeChart& wanted) {
    RegimeCurve curve{
        .line = regime.look.line,
        .climate = regime.climate,
        .name = run.regimes.size() == 1 && run.replicates() > 1 ? "mean" : regime.look.title_in_chart(),
        .letter = regime.look.letter};
    for (const Stretch& stretch : stretches_of(wanted, run.years)) {
        const double x = 0.5 * static_cast<double>(stretch.first + stretch.last);
        const Band band = regime.mean_band(stretch.first, stretch.last, wanted.figure);
        curve.means.push_back({x, band.mean});
        if (run.replicates() > 1) {
            curve.ranges.push_back({x, band.low, band.high});
        }
    }
    return curve;
}

std::string chart_of(const RunView& run, const RegimeChart& wanted) {
    std::vector<RegimeCurve> curves;
    for (const RegimeView& regime : run.regimes) {
        curves.push_back(curve_of(run, regime, wanted));
    }
    return regime_charts({.title = wanted.title,
                          .y_title = wanted.axis,
                          .years = run.years,
                          .climates = run.chart_a_climate ? run.climates : std::vector<std::string>{}},
                         curves, wanted.caption);
}

}  // namespace

std::string charts_of_regimes(const RunView& run) {
    if (run.years == 0) {
        return "";
    }
    const std::size_t five = run.years > 20 ? 5 : 1;
    const char* by_five = five > 1 ? "Means over 5 years." : "";
    const std::vector<RegimeChart> charts{
        {"Volume", "Volume, m³/ha", [](const YearView& year) { return year.stand->volume_m3pha; }},
        {"Basal area", "Basal area, m²/ha",
         [](const YearView& year) { return year.stand->basal_area_m2pha; }},
        {"Stems from 12 cm on", "Stems per ha",
         [](const YearView& year) { return stems_from_12_cm(*year.stand); }},
        {"Dominant height", "Height, m", [](const YearView& year) { return year.stand->dominant_height_m; },
         "Mean of the 100 thickest trees per hectare."},
        {"Leaf area index", "Leaf area index, m²/m²",
         [](const YearView& year) { return year.stand->leaf_area_index; }},
        {"Increment", "Increment, m³/ha a year",
         [](const YearView& year) { return year.row->volume_increment_m3pha; }, by_five, 1, five},
        {"Standing dead wood", "Volume, m³/ha", [](const YearView& year) { return year.row->snags_m3pha; },
         "Snags and the stumps of felled trees. A piece counts with its full volume until less than a tenth "
         "of "
         "its density is left."},
        {"Lying dead wood", "Volume, m³/ha", [](const YearView& year) { return year.row->logs_m3pha; },
         "A piece counts with its full volume until less than a tenth of its density is left."},
        {"Mass of dead wood", "Dry mass, t/ha",
         [](const YearView& year) { return year.row->dead_stems_tpha; },
         "Standing and lying, as far as it has not rotted."},
        {"Saplings", "Saplings per ha", [](const YearView& year) { return year.row->saplings_pha; },
         "Young trees below 1 cm diameter."},
        {"Ingrowth", "Stems/ha a year", [](const YearView& year) { return year.row->ingrowth_stems_pha; },
         five > 1 ? "Trees that passed 1 cm or were planted; means over 5 years."
                  : "Trees that passed 1 cm or were planted.",
         1, five},
    };
    std::string html;
    const std::size_t lines = run.regimes.size() / (run.chart_a_climate ? run.climates.size() : 1);
    if (lines > most_bands && run.replicates() > 1) {
        html += "<p class=\"soft\">Means of the replicates; their ranges stand in tables/.</p>\n";
    }
    html += "<div class=\"halves\">";
    for (const RegimeChart& chart : charts) {
        html += chart_of(run, chart);
    }
    return joined(html, "</div>\n");
}

}  // namespace coupling::decades
