#include <algorithm>
#include <cmath>
#include <optional>

#include "coupling/assessments/today/report/sections.hpp"
#include "coupling/results/report/chart.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::report {
namespace {

using observed::StopComparison;
using observed::StopFigures;

std::string name_of_group(const StopComparison& comparison) {
    return comparison.group.empty() ? page_text("all") : comparison.group;
}

PageFields stops_row(const std::string& name, const StopFigures& figures) {
    std::vector<PageFields> lengths;
    const auto add = [&](double length_m) { lengths.push_back({{"length", fixed(length_m, 1)}}); };
    add(figures.mean_m);
    add(figures.deviation_m);
    std::for_each(figures.quantiles_m.begin(), figures.quantiles_m.end(), add);
    add(figures.longest_m);
    add(figures.sideways_m);
    return {{"name", name}, {"number", std::to_string(figures.rocks)}, {"lengths", lengths}};
}

PageFields events_row(const std::string& name, const std::string& side,
                      const observed::SampleFigures& figures, double ks) {
    std::vector<PageFields> values;
    for (const double value : {figures.mean, figures.deviation, figures.quantiles[0], figures.quantiles[2],
                               figures.quantiles[4], figures.largest, ks}) {
        values.push_back({{"value", fixed(value, 2)}});
    }
    return {{"name", name}, {"side", side}, {"number", std::to_string(figures.count)}, {"values", values}};
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
    Chart chart{with_label(page_text("Run-out"), name_of_group(comparison)),
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

std::optional<PageFields> observed_stops(const std::vector<StopComparison>& comparisons) {
    if (comparisons.empty()) {
        return std::nullopt;
    }
    std::vector<PageFields> rows;
    std::string charts;
    for (const StopComparison& comparison : comparisons) {
        const std::string name = name_of_group(comparison);
        rows.push_back(stops_row(join_with_commas({name, page_text("observed")}), comparison.observed));
        rows.push_back(stops_row(join_with_commas({name, page_text("simulated")}), comparison.simulated));
        charts += chart_of(comparison);
    }
    const double left = comparisons.front().simulated.left_terrain;
    return PageFields{
        {"rows", rows},
        {"left_terrain", left > 0.0 ? std::optional{PageFields{{"share", percent(left)}}} : std::nullopt},
        {"charts", charts}};
}

std::optional<PageFields> observed_events(const std::vector<observed::EventComparison>& comparisons) {
    if (comparisons.empty()) {
        return std::nullopt;
    }
    std::vector<PageFields> rows;
    for (const observed::EventComparison& one : comparisons) {
        rows.push_back(events_row(one.name(), page_text("observed"), one.observed, std::nan("")));
        rows.push_back(events_row(one.name(), page_text("simulated"), one.simulated, one.largest_distance));
    }
    return PageFields{{"rows", rows}};
}

}  // namespace coupling::report
