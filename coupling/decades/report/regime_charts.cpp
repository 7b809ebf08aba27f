#include <algorithm>

#include "coupling/decades/report/page_parts.hpp"
#include "coupling/results/report/chart.hpp"
#include "coupling/results/report/markup.hpp"

namespace coupling::decades {
namespace {

using report::Axis;
using report::Chart;
using report::ChartPoint;
using report::ChartRange;

/// Bands of more regimes would hide each other.
constexpr std::size_t most_bands = 4;
constexpr std::size_t most_points = 200;

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
    const std::size_t step = years / most_points + 1;
    for (std::size_t year = wanted.first_year; year < years; year += step) {
        stretches.push_back({year, year});
    }
    if (years >= wanted.first_year) {
        stretches.push_back({years, years});
    }
    return stretches;
}

struct Curve {
    std::vector<ChartPoint> means;
    std::vector<ChartRange> bands;
};

Curve curve_of(const RegimeView& regime, const RegimeChart& wanted, std::size_t years) {
    Curve curve;
    for (const Stretch& stretch : stretches_of(wanted, years)) {
        const double x = 0.5 * static_cast<double>(stretch.first + stretch.last);
        const Band band = regime.mean_band(stretch.first, stretch.last, wanted.figure);
        curve.means.push_back({x, band.mean});
        curve.bands.push_back({x, band.low, band.high});
    }
    return curve;
}

Axis years_axis(std::size_t years) {
    return {"Years since the start", 0.0, static_cast<double>(std::max<std::size_t>(years, 1)), false, true};
}

std::string chart_of(const RunView& run, const RegimeChart& wanted) {
    const bool with_bands = run.replicates() > 1 && run.regimes.size() <= most_bands;
    std::vector<Curve> curves;
    double most = 0.0;
    for (const RegimeView& regime : run.regimes) {
        curves.push_back(curve_of(regime, wanted, run.years));
        const Curve& curve = curves.back();
        for (std::size_t i = 0; i < curve.means.size(); ++i) {
            most = std::max(most, with_bands ? curve.bands[i].high : curve.means[i].y);
        }
    }
    Chart chart{wanted.title, years_axis(run.years), Axis::from_zero(wanted.axis, most)};
    for (std::size_t i = 0; with_bands && i < curves.size(); ++i) {
        chart.add_band(line_of_regime(i), curves[i].bands);
    }
    for (std::size_t i = 0; i < curves.size(); ++i) {
        chart.add_line(line_of_regime(i), curves[i].means);
        if (!curves[i].means.empty()) {
            chart.add_end_letter(curves[i].means.back().y, run.regimes[i].letter);
        }
        chart.add_name(line_of_regime(i), run.regimes.size() > 1 ? run.regimes[i].title()
                                          : run.replicates() > 1 ? "mean"
                                                                 : run.regimes[i].name);
    }
    if (with_bands) {
        chart.add_band_name(line_of_regime(0), "nine in ten replicates");
    }
    return chart.figure(wanted.caption);
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
         "Snags and the stumps of felled trees."},
        {"Lying dead wood", "Volume, m³/ha", [](const YearView& year) { return year.row->logs_m3pha; }},
        {"Saplings", "Saplings per ha", [](const YearView& year) { return year.row->saplings_pha; },
         "Young trees below 1 cm diameter."},
        {"Ingrowth", "Stems/ha a year", [](const YearView& year) { return year.row->ingrowth_stems_pha; },
         five > 1 ? "Trees that passed 1 cm or were planted; means over 5 years."
                  : "Trees that passed 1 cm or were planted.",
         1, five},
    };
    std::string html;
    if (run.regimes.size() > most_bands && run.replicates() > 1) {
        html += "<p class=\"soft\">Means of the replicates; their ranges stand in tables/.</p>\n";
    }
    html += "<div class=\"halves\">";
    for (const RegimeChart& chart : charts) {
        html += chart_of(run, chart);
    }
    return joined(html, "</div>\n");
}

}  // namespace coupling::decades
