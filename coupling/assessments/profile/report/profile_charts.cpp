#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "config/text/joined.hpp"
#include "config/units/constants.hpp"
#include "coupling/assessments/profile/report/profile_page.hpp"
#include "coupling/results/figures/colours.hpp"
#include "coupling/results/figures/indicators.hpp"
#include "coupling/results/report/chart.hpp"
#include "coupling/results/report/map/rebin.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"
#include "coupling/results/text/phrases.hpp"
#include "rockfall/motion/models.hpp"

namespace coupling::profile {
namespace {

using config::j_per_kj;
using config::joined;
using config::percent;

using report::Axis;
using report::Chart;
using report::ChartPoint;
using report::ChartRange;

Axis distance_axis(const ProfileResults& results) {
    return {report::page_text("Distance in plan, m"), results.site.first_m(), results.site.last_m()};
}

/// Stations as numbers, for names would cover each other; `caption_of_marks` names them.
void mark_stations(const ProfileResults& results, Chart& chart) {
    for (std::size_t i = 0; i < results.site.stations.size(); ++i) {
        chart.add_mark(results.site.stations[i].distance_m, std::to_string(i + 1));
    }
}

std::string caption_of_marks(const ProfileResults& results) {
    std::vector<std::string> stations;
    for (std::size_t i = 0; i < results.site.stations.size(); ++i) {
        stations.push_back(
            joined(std::to_string(i + 1), " ", report::escaped(results.site.stations[i].name)));
    }
    return stations.empty() ? ""
                            : report::page_text("Stations: {stations}.",
                                                {{"stations", report::join_with_commas(stations)}});
}

std::string run_out(const ProfileResults& results) {
    Chart chart{report::page_text("Run-out"), distance_axis(results),
                Axis::from_zero(report::page_text("% of rocks ending beyond"), percent)};
    std::vector<ChartPoint> line;
    std::vector<ChartRange> band;
    for (std::size_t i = 0; i < results.tally.ends.size(); ++i) {
        const double x_m = std::min(results.site.first_m() + static_cast<double>(i) * results.tally.stretch_m,
                                    results.site.last_m());
        const Share share = share_of(results.tally.ended_beyond(i), results.tally.rocks);
        line.push_back({x_m, percent * share.value});
        band.push_back({x_m, percent * share.interval.low, percent * share.interval.high});
    }
    chart.add_band("forest", band);
    chart.add_line("forest", line);
    mark_stations(results, chart);
    chart.add_name("forest", report::page_text("rocks whose fall ends further on"));
    chart.add_band_name("forest", report::page_text("95 % interval"));
    return chart.figure(report::join_sentences(
        {report::page_text(
             "At the lower end: rocks that leave the profile. Rocks that leave over the upper end "
             "count as ending there."),
         caption_of_marks(results)}));
}

/// Runs of stretches with a known value: a gap breaks the line.
void add_curve(const ProfileResults& results, Chart& chart, const std::string& series,
               const std::function<double(const StretchTally&)>& value_of) {
    std::vector<ChartPoint> points;
    const auto flush = [&] {
        if (points.size() > 1) {
            chart.add_line(series, points);
        }
        points.clear();
    };
    for (std::size_t i = 0; i < results.tally.stretches.size(); ++i) {
        const StretchTally& stretch = results.tally.stretches[i];
        const double value = stretch.energy_j.moments.count() == 0 ? std::numeric_limits<double>::quiet_NaN()
                                                                   : value_of(stretch);
        if (std::isnan(value)) {
            flush();
            continue;
        }
        const double middle_m =
            results.site.first_m() + (static_cast<double>(i) + 0.5) * results.tally.stretch_m;
        points.push_back({std::min(middle_m, results.site.last_m()), value});
    }
    flush();
}

std::string envelope(const ProfileResults& results, const std::string& title, const std::string& axis,
                     const rockfall::LogBins& bins, Spread StretchTally::*quantity, double unit,
                     const std::string& caption) {
    double most = 0.0;
    for (const StretchTally& stretch : results.tally.stretches) {
        const Moments& moments = (stretch.*quantity).moments;
        most = moments.count() > 0 ? std::max(most, moments.most() / unit) : most;
    }
    Chart chart{title, distance_axis(results), Axis::from_zero(axis, most)};
    add_curve(results, chart, "most",
              [&](const StretchTally& stretch) { return (stretch.*quantity).moments.most() / unit; });
    add_curve(results, chart, "bare",
              [&](const StretchTally& stretch) { return (stretch.*quantity).quantile(bins, 0.95) / unit; });
    add_curve(results, chart, "forest",
              [&](const StretchTally& stretch) { return (stretch.*quantity).moments.mean() / unit; });
    mark_stations(results, chart);
    chart.add_name("forest", report::page_text("mean of the rocks that pass"));
    chart.add_name("bare", report::page_text("95 % of them stay below"));
    chart.add_name("most", report::page_text("largest"));
    return chart.figure(report::join_sentences({caption, caption_of_marks(results)}));
}

/// Corners of a stair: each segment from its beginning to its end.
std::string jump_lengths(const ProfileResults& results) {
    const ProfileTally& tally = results.tally;
    const double whole_m = results.site.slope_length_m(results.site.last_m());
    double longest_m = 0.0;
    for (const SegmentTally& segment : tally.segments) {
        longest_m = segment.length_m.count() > 0 ? std::max(longest_m, segment.length_m.most()) : longest_m;
    }
    Chart chart{report::page_text("Jump lengths along the slope"),
                {report::page_text("Length along the slope, m"), 0.0, whole_m},
                Axis::from_zero(report::page_text("Jump length, m"), longest_m)};
    std::vector<ChartPoint> line;
    std::vector<ChartRange> band;
    const auto flush = [&] {
        if (!line.empty()) {
            chart.add_band("forest", band);
            chart.add_line("forest", line);
        }
        line.clear();
        band.clear();
    };
    for (std::size_t i = 0; i < tally.segments.size(); ++i) {
        const Moments& length_m = tally.segments[i].length_m;
        if (length_m.count() == 0) {
            flush();
            continue;
        }
        const double from_m = static_cast<double>(i) * tally.segment_m;
        for (const double x_m : {from_m, std::min(whole_m, from_m + tally.segment_m)}) {
            line.push_back({x_m, length_m.mean()});
            band.push_back({x_m, length_m.least(), length_m.most()});
        }
    }
    flush();
    chart.add_name("forest", report::page_text("mean"));
    chart.add_band_name("forest", report::page_text("shortest to longest"));
    return chart.figure(
        report::page_text("Straight from impact to impact, in segments of {tally_segment_m} m slope length, "
                          "counted where the jump ends. A flight from the release is left out.",
                          {{"tally_segment_m", report::tick_text(tally.segment_m)}}));
}

std::string energy_histogram(const ProfileResults& results, std::size_t station) {
    const Spread& energy = results.tally.stations[station].energy_j;
    constexpr std::size_t bars = 25;
    const double mean_kj = energy.moments.mean() / j_per_kj;
    const double p95_kj = energy.quantile(rockfall::fine_energy_bins, 0.95) / j_per_kj;
    Axis x = Axis::from_zero(report::page_text("Energy, kJ"), energy.moments.most() / j_per_kj);
    std::vector<double> edges;
    for (std::size_t i = 0; i <= bars; ++i) {
        edges.push_back(x.high * static_cast<double>(i) / bars);
    }
    std::vector<double> heights =
        report::rebinned(rockfall::fine_energy_bins, energy.counts, j_per_kj, edges);
    for (double& height : heights) {
        height *= percent / static_cast<double>(results.tally.rocks);
    }
    const bool is_known = std::isfinite(p95_kj);
    Chart chart{report::page_text("Energy at the station “{station_name}”",
                                  {{"station_name", results.site.stations[station].name}}),
                std::move(x),
                Axis::from_zero(report::page_text("% of all rocks"),
                                *std::max_element(heights.begin(), heights.end()))};
    chart.add_steps("forest", edges, heights);
    chart.add_mark(mean_kj, report::page_text("mean"));
    if (is_known) {
        chart.add_mark(p95_kj, "95 %");
    }
    chart.add_name("forest", report::page_text("rocks that pass"));
    const std::string rocks = report::grouped(energy.moments.count());
    const std::string mean = report::three_digits(mean_kj);
    return chart.figure(
        is_known ? report::page_text(
                       "Kinetic energy of the {rocks} rocks that pass. Dotted: their mean, {mean_kj} kJ, "
                       "and what 95 % of them stay below, {p95_kj} kJ.",
                       {{"rocks", rocks}, {"mean_kj", mean}, {"p95_kj", report::three_digits(p95_kj)}})
                 : report::page_text(
                       "Kinetic energy of the {rocks} rocks that pass. Dotted: their mean, {mean_kj} kJ; "
                       "too few for what 95 % of them stay below.",
                       {{"rocks", rocks}, {"mean_kj", mean}}));
}

}  // namespace

report::PageFields charts_along(const ProfileResults& results) {
    std::optional<report::PageFields> jumps;
    if (results.tally.jump_length_m.count() > 0) {
        jumps = {{"chart", jump_lengths(results)}};
    }
    return {
        {"run_out", run_out(results)},
        {"jumps", jumps},
        {"envelopes",
         joined(envelope(results, report::page_text("Height above the ground"),
                         report::page_text("Height, m"), rockfall::height_bins, &StretchTally::height_m, 1.0,
                         report::page_text(
                             "Largest height of each rock in each stretch: of its underside, at right "
                             "angles to the slope, so less than the vertical height of the key figures.")),
                envelope(results, report::page_text("Kinetic energy"), report::page_text("Energy, kJ"),
                         rockfall::energy_bins, &StretchTally::energy_j, j_per_kj,
                         report::page_text(
                             "Largest energy of each rock in each stretch ({energies}).",
                             {{"energies", report::in_page_language(rockfall::what_energies_count())}})))}};
}

std::optional<report::PageFields> charts_at_stations(const ProfileResults& results) {
    constexpr std::size_t most_charts = 8;
    std::string html;
    std::size_t drawn = 0;
    for (std::size_t i = 0; i < results.site.stations.size() && drawn < most_charts; ++i) {
        if (results.tally.stations[i].energy_j.moments.count() > 0) {
            html += energy_histogram(results, i);
            ++drawn;
        }
    }
    return drawn == 0 ? std::nullopt : std::optional{report::PageFields{{"charts", html}}};
}

}  // namespace coupling::profile
