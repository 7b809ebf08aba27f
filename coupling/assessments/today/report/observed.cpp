#include <algorithm>
#include <cmath>

#include "config/text/joined.hpp"
#include "coupling/assessments/today/report/sections.hpp"
#include "coupling/results/report/chart.hpp"
#include "coupling/results/report/html_table.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::report {
namespace {

using config::joined;
using observed::StopComparison;
using observed::StopFigures;

std::string name_of_group(const StopComparison& comparison) {
    return comparison.group.empty() ? page_text("all") : escaped(comparison.group);
}

std::vector<std::string> cells_of(const std::string& name, const StopFigures& figures) {
    std::vector<std::string> cells{name, std::to_string(figures.rocks), fixed(figures.mean_m, 1),
                                   fixed(figures.deviation_m, 1)};
    for (const double quantile_m : figures.quantiles_m) {
        cells.push_back(fixed(quantile_m, 1));
    }
    cells.push_back(fixed(figures.longest_m, 1));
    cells.push_back(fixed(figures.sideways_m, 1));
    return cells;
}

/// The share that comes to rest within a distance, in percent, drawn at not more than some hundred places.
std::vector<ChartPoint> shares(const std::vector<double>& run_out_m) {
    constexpr std::size_t most_points = 400;
    const std::size_t step = std::max<std::size_t>(1, run_out_m.size() / most_points);
    const auto count = static_cast<double>(run_out_m.size());
    std::vector<ChartPoint> points{{run_out_m.front(), 0.0}};
    for (std::size_t i = 0; i < run_out_m.size(); i += step) {
        points.push_back({run_out_m[i], 100.0 * static_cast<double>(i) / count});
        points.push_back({run_out_m[i], 100.0 * static_cast<double>(i + 1) / count});
    }
    points.push_back({run_out_m.back(), 100.0});
    return points;
}

std::string chart_of(const StopComparison& comparison) {
    const double longest_m =
        std::max(comparison.observed_run_out_m.back(), comparison.simulated_run_out_m.back());
    Chart chart{joined(page_text("Run-out:"), " ", name_of_group(comparison)),
                Axis::from_zero(page_text("Plan distance from release to stop, m"), longest_m),
                {page_text("stop within it, %"), 0.0, 100.0}};
    chart.add_line("bare", shares(comparison.observed_run_out_m));
    chart.add_line("forest", shares(comparison.simulated_run_out_m));
    chart.add_name("bare", page_text("observed"));
    chart.add_name("forest", page_text("simulated"));
    return chart.figure(
        page_text("Largest distance between the curves (KS) {ks}; 5 % of samples of one distribution exceed "
                  "{chance}. Energy distance {energy_distance_m} m.",
                  {{"ks", fixed(comparison.largest_distance, 2)},
                   {"chance", fixed(comparison.distance_by_chance, 2)},
                   {"energy_distance_m", fixed(comparison.energy_distance_m, 1)}}));
}

}  // namespace

std::string observed_stops(const std::vector<StopComparison>& comparisons) {
    if (comparisons.empty()) {
        return "";
    }
    HtmlTable table{
        page_text("Plan distance from release to stop, m: mean, standard deviation, quantiles, longest; "
                  "beside the axis: standard deviation of the distance from the line that leads from the "
                  "mean release to the mean observed stop."),
        {page_text("Stops"), page_text("number"), page_text("mean, m"), page_text("± m"), "10 %", "25 %",
         "50 %", "75 %", "90 %", page_text("longest, m"), page_text("beside the axis, ± m")}};
    std::string charts;
    for (const StopComparison& comparison : comparisons) {
        const std::string name = name_of_group(comparison);
        table.row(cells_of(joined(name, ", ", page_text("observed")), comparison.observed));
        table.row(cells_of(joined(name, ", ", page_text("simulated")), comparison.simulated));
        charts += chart_of(comparison);
    }
    std::string left;
    if (const double share = comparisons.front().simulated.left_terrain; share > 0.0) {
        left = joined(
            "<p>",
            page_text("{share} of the simulated rocks left the terrain: their run-out ends at its border.",
                      {{"share", percent(share)}}),
            "</p>");
    }
    return joined("<h2>", page_text("Observed and simulated stops"), "</h2>\n<section class=\"card\">",
                  table.html(), left, "<div class=\"halves\">", charts, "</div></section>\n");
}

std::string observed_events(const std::vector<observed::EventComparison>& comparisons) {
    if (comparisons.empty()) {
        return "";
    }
    HtmlTable table{page_text("Rocks at their first arrival at a target, and impacts that end a flight. "
                              "Units as in the names; speed_ratio is the speed after an impact by that "
                              "before it. KS: largest distance between the distributions."),
                    {page_text("Quantity"), page_text("number"), page_text("mean"), "±", "10 %", "50 %",
                     "90 %", page_text("largest value"), "KS"}};
    for (const observed::EventComparison& one : comparisons) {
        const std::string name = joined("<code>", escaped(one.name()), "</code>");
        const auto add = [&](const char* side, const observed::SampleFigures& figures, double ks) {
            table.row({joined(name, ", ", page_text(side)), std::to_string(figures.count),
                       fixed(figures.mean, 2), fixed(figures.deviation, 2), fixed(figures.quantiles[0], 2),
                       fixed(figures.quantiles[2], 2), fixed(figures.quantiles[4], 2),
                       fixed(figures.largest, 2), fixed(ks, 2)});
        };
        add("observed", one.observed, std::nan(""));
        add("simulated", one.simulated, one.largest_distance);
    }
    return joined("<h2>", page_text("Observed and simulated passages and impacts"),
                  "</h2>\n<section class=\"card\">", table.html(), "</section>\n");
}

}  // namespace coupling::report
