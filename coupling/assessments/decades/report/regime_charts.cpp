#include <algorithm>

#include "coupling/assessments/decades/report/page_parts.hpp"
#include "coupling/assessments/decades/report/regime_chart.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::decades {
namespace {

constexpr std::size_t most_chart_points = 200;

struct RegimeChart {
    std::string title;
    std::string axis;
    YearFigure figure;
    std::string caption = {};
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
    RegimeCurve curve{.line = regime.look.line,
                      .climate = regime.climate,
                      .name = run.regimes.size() == 1 && run.replicates() > 1 ? report::page_text("mean")
                                                                              : regime.look.title_in_chart(),
                      .letter = regime.look.letter};
    for (const Stretch& stretch : stretches_of(wanted, run.years)) {
        const double x = 0.5 * static_cast<double>(stretch.first + stretch.last);
        const Band band = regime.mean_band(stretch.first, stretch.last, wanted.figure);
        curve.means.push_back({x, band.mean});
        if (run.replicates() > 1) {
            curve.ranges.push_back(range_at(x, band));
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

std::optional<report::PageFields> charts_of_regimes(const RunView& run) {
    if (run.years == 0) {
        return std::nullopt;
    }
    const std::size_t five = run.years > 20 ? 5 : 1;
    const std::string by_five = five > 1 ? report::page_text("Means over 5 years.") : "";
    const std::vector<RegimeChart> charts{
        {report::page_text("Volume"), report::page_text("Volume, m³/ha"),
         [](const YearView& year) { return year.stand->volume_m3pha; }},
        {report::page_text("Basal area"), report::page_text("Basal area, m²/ha"),
         [](const YearView& year) { return year.stand->basal_area_m2pha; }},
        {report::page_text("Stems from 12 cm on"), report::page_text("Stems per ha"),
         [](const YearView& year) { return stems_from_12_cm(*year.stand); }},
        {report::page_text("Dominant height"), report::page_text("Height, m"),
         [](const YearView& year) { return year.stand->dominant_height_m; },
         report::page_text("Mean of the 100 thickest trees per hectare.")},
        {report::page_text("Leaf area index"), report::page_text("Leaf area index, m²/m²"),
         [](const YearView& year) { return year.stand->leaf_area_index; }},
        {report::page_text("Increment"), report::page_text("Increment, m³/ha a year"),
         [](const YearView& year) { return year.row->volume_increment_m3pha; }, by_five, 1, five},
        {report::page_text("Drought"), report::page_text("Drought index"),
         [](const YearView& year) { return year.drought_index; },
         report::join_sentences(
             {report::page_text(
                  "Share of the demand for water that was not met in the warm months. 0: never dry."),
              by_five}),
         1, five},
        {report::page_text("Standing dead wood"), report::page_text("Volume, m³/ha"),
         [](const YearView& year) { return year.row->snags_m3pha; },
         report::page_text("Snags and the stumps of felled trees. Volume that decay has left: a piece "
                           "shrinks once it has lost 40 % of its density.")},
        {report::page_text("Lying dead wood"), report::page_text("Volume, m³/ha"),
         [](const YearView& year) { return year.row->logs_m3pha; },
         report::page_text(
             "Volume that decay has left: a piece shrinks once it has lost 40 % of its density.")},
        {report::page_text("Mass of dead wood"), report::page_text("Dry mass, t/ha"),
         [](const YearView& year) { return year.row->dead_stems_tpha; },
         report::page_text("Standing and lying, as far as it has not rotted.")},
        {report::page_text("Saplings"), report::page_text("Saplings per ha"),
         [](const YearView& year) { return year.row->saplings_pha; },
         report::page_text("Young trees below 1 cm diameter.")},
        {report::page_text("Ingrowth"), report::page_text("Stems/ha a year"),
         [](const YearView& year) { return year.row->ingrowth_stems_pha; },
         five > 1 ? report::page_text("Trees that passed 1 cm or were planted; means over 5 years.")
                  : report::page_text("Trees that passed 1 cm or were planted."),
         1, five},
    };
    std::string drawn;
    for (const RegimeChart& chart : charts) {
        drawn += chart_of(run, chart);
    }
    const std::size_t lines = run.regimes.size() / (run.chart_a_climate ? run.climates.size() : 1);
    return report::PageFields{{"without_ranges", lines > most_bands && run.replicates() > 1},
                              {"charts", drawn}};
}

}  // namespace coupling::decades
