#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "config/text/joined.hpp"
#include "config/units/constants.hpp"
#include "coupling/assessments/today/report/sections.hpp"
#include "coupling/results/figures/colours.hpp"
#include "coupling/results/report/chart.hpp"
#include "coupling/results/report/map/rebin.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::report {
namespace {

using config::j_per_kj;
using config::joined;

/// Where axes of energy begin: a rock of less is as good as at rest.
constexpr double least_kj = 0.1;

std::vector<double> in_percent_of(std::vector<double> counts, std::uint64_t whole) {
    for (double& count : counts) {
        count *= whole > 0 ? 100.0 / static_cast<double>(whole) : 0.0;
    }
    return counts;
}

/// Thirty bars of one width from 0 on.
std::vector<double> even_edges(double high) {
    std::vector<double> edges(31);
    for (std::size_t i = 0; i < edges.size(); ++i) {
        edges[i] = high * static_cast<double>(i) / 30.0;
    }
    return edges;
}

/// The bare slope first: the forest is drawn over it.
std::vector<Cover> drawing_order(const RunResults& results) {
    std::vector<Cover> covers = covers_of(results);
    std::reverse(covers.begin(), covers.end());
    return covers;
}

/// A histogram of one quantity on the slopes in percent of the rocks that fell.
std::string histogram(const RunResults& results, const std::string& title, Axis x,
                      const std::vector<double>& edges,
                      const std::function<std::vector<double>(Cover)>& counts_of, const std::string& caption,
                      const std::vector<Cover>& covers, bool energy_marks) {
    std::vector<std::vector<double>> heights;
    double highest = 0.0;
    for (const Cover cover : covers) {
        heights.push_back(in_percent_of(counts_of(cover), results.tally.runs[index_of(cover)].rocks));
        highest = std::max(highest, *std::max_element(heights.back().begin(), heights.back().end()));
    }
    Chart chart{title, std::move(x), Axis::from_zero(page_text("% of all rocks"), highest)};
    for (std::size_t i = 0; i < covers.size(); ++i) {
        chart.add_steps(name_of(covers[i]), edges, heights[i]);
        chart.add_name(name_of(covers[i]), title_of(covers[i]));
    }
    if (energy_marks) {
        chart.add_mark(intensity_limits_kj[0], page_text("30 kJ"));
        chart.add_mark(intensity_limits_kj[1], page_text("300 kJ"));
    }
    return chart.figure(caption);
}

std::string energy_histogram(const RunResults& results, std::size_t target) {
    const rockfall::TargetTally& tally = results.tally.targets[target];
    const double high_kj = std::max(1.0, tally.by_cover[index_of(Cover::bare)].energy_max_j / j_per_kj);
    const double most_kj = std::max(high_kj, tally.by_cover[index_of(Cover::forest)].energy_max_j / j_per_kj);
    Axis x = Axis::powers_of_ten(page_text("Energy at the target, kJ"), least_kj, most_kj);
    constexpr int bars_a_decade = 8;
    const int bars = static_cast<int>(std::lround(bars_a_decade * std::log10(x.high / x.low)));
    std::vector<double> edges;
    for (int i = 0; i <= bars; ++i) {
        edges.push_back(x.low * std::pow(10.0, static_cast<double>(i) / bars_a_decade));
    }
    const auto counts = [&](Cover cover) {
        return rebinned(rockfall::fine_energy_bins, tally.by_cover[index_of(cover)].energy.all(), j_per_kj,
                        edges);
    };
    return histogram(results, page_text("Energy of the rocks that arrive"), std::move(x), edges, counts,
                     page_text("Eight bars to each power of ten; the first takes all below."),
                     drawing_order(results), true);
}

std::string speed_histogram(const RunResults& results, std::size_t target) {
    const rockfall::TargetTally& tally = results.tally.targets[target];
    const double most_mps = std::max(tally.by_cover[0].speed_max_mps, tally.by_cover[1].speed_max_mps);
    Axis x = Axis::from_zero(page_text("Speed at the target, m/s"), most_mps);
    const std::vector<double> edges = even_edges(x.high);
    const auto counts = [&](Cover cover) {
        return rebinned(rockfall::fine_speed_bins, tally.by_cover[index_of(cover)].speed.all(), 1.0, edges);
    };
    return histogram(results, page_text("Speed of the rocks that arrive"), std::move(x), edges, counts,
                     page_text("Translation, where a rock first meets the target."), drawing_order(results),
                     false);
}

/// Heights above the ground at a target: of the rocks' undersides, or of their tops.
std::string height_histogram(const RunResults& results, std::size_t target, const std::string& title,
                             const std::string& axis, const std::string& caption,
                             rockfall::BinCounts rockfall::ArrivalTally::*counts_of,
                             double rockfall::ArrivalTally::*most_of) {
    const rockfall::TargetTally& tally = results.tally.targets[target];
    Axis x = Axis::from_zero(axis, std::max(tally.by_cover[0].*most_of, tally.by_cover[1].*most_of));
    const std::vector<double> edges = even_edges(x.high);
    const auto counts = [&](Cover cover) {
        return rebinned(rockfall::fine_height_bins, (tally.by_cover[index_of(cover)].*counts_of).all(), 1.0,
                        edges);
    };
    return histogram(results, title, std::move(x), edges, counts, caption, drawing_order(results), false);
}

/// Share of rocks that arrive with more than an energy.
std::string exceedance(const RunResults& results, std::size_t target) {
    const rockfall::TargetTally& tally = results.tally.targets[target];
    const double most_kj =
        std::max({1.0, tally.by_cover[0].energy_max_j / j_per_kj, tally.by_cover[1].energy_max_j / j_per_kj});
    const double rocks = std::max(1.0, static_cast<double>(results.tally.runs[index_of(Cover::bare)].rocks));
    double highest_percent = 0.0;
    for (const rockfall::ArrivalTally& arrivals : tally.by_cover) {
        highest_percent = std::max(highest_percent, 100.0 * static_cast<double>(arrivals.reached) / rocks);
    }
    const double least_percent = 100.0 / rocks;
    Chart chart{page_text("Energy exceeded at the target"),
                Axis::powers_of_ten(page_text("Energy E, kJ"), least_kj, most_kj),
                Axis::powers_of_ten(page_text("% of all rocks with more than E"), least_percent,
                                    std::max(highest_percent, 10.0 * least_percent))};
    for (const Cover cover : drawing_order(results)) {
        const std::vector<std::uint64_t> counts = tally.by_cover[index_of(cover)].energy.all();
        std::vector<ChartPoint> points{
            {least_kj, 100.0 * static_cast<double>(tally.by_cover[index_of(cover)].reached) / rocks}};
        for (const auto& [energy_j, above] : exceeded(rockfall::fine_energy_bins, counts)) {
            points.push_back({std::max(least_kj, energy_j / j_per_kj), 100.0 * above / rocks});
        }
        chart.add_line(name_of(cover), points);
        chart.add_name(name_of(cover), title_of(cover));
    }
    chart.add_mark(intensity_limits_kj[0], page_text("30 kJ"));
    chart.add_mark(intensity_limits_kj[1], page_text("300 kJ"));
    return chart.figure(
        page_text("Both axes by powers of ten. A curve ends at the largest energy of any rock."));
}

/// "over the bare slope 92.1 %, with forest 99.0 %".
std::string shares_that_stop(const RunResults& results) {
    std::vector<std::string> shares;
    for (const Cover cover : drawing_order(results)) {
        const rockfall::RunTally& tally = results.tally.runs[index_of(cover)];
        shares.push_back(
            page_text("{slope} {share}",
                      {{"slope", page_text(cover == Cover::bare ? "over the bare slope" : "with forest")},
                       {"share", percent(share_of(tally.stopped(), tally.rocks).value)}}));
    }
    return join_with_commas(shares);
}

std::string run_out_histogram(const RunResults& results) {
    double most_m = 1.0;
    for (const Cover cover : covers_of(results)) {
        most_m = std::max(most_m, results.tally.runs[index_of(cover)].max_run_out_m);
    }
    const double width_m = std::max(rockfall::RunTally::run_out_bin_m, nice_step(most_m / 50.0));
    const auto merged = static_cast<std::size_t>(std::lround(width_m / rockfall::RunTally::run_out_bin_m));
    const auto bars = static_cast<std::size_t>(std::ceil(most_m / width_m));
    std::vector<double> edges(bars + 1);
    for (std::size_t i = 0; i <= bars; ++i) {
        edges[i] = width_m * static_cast<double>(i);
    }
    const auto counts = [&](Cover cover) {
        std::vector<double> sums(bars, 0.0);
        const auto& bins = results.tally.runs[index_of(cover)].run_out;
        for (std::size_t bin = 0; bin < bins.size(); ++bin) {
            sums[std::min(bin / merged, bars - 1)] += static_cast<double>(bins[bin]);
        }
        return sums;
    };
    Axis x = Axis::from_zero(page_text("Run-out in plan, m"), edges.back());
    return histogram(results, page_text("Run-out"), std::move(x), edges, counts,
                     page_text("Distance in plan from release to where a rock stops, in bars of {width_m} m. "
                               "Only rocks that stop on the terrain: {stopped}.",
                               {{"width_m", tick_text(width_m)}, {"stopped", shares_that_stop(results)}}),
                     drawing_order(results), false);
}

std::string tree_hit_histogram(const RunResults& results) {
    const rockfall::RunTally& run = results.tally.runs[index_of(Cover::forest)];
    // As many bars as hold all but one rock in two hundred; the last takes the rest.
    std::vector<double> rocks_by_hits;
    double left_over = static_cast<double>(run.rocks);
    for (const std::uint64_t rocks : run.tree_hits) {
        rocks_by_hits.push_back(static_cast<double>(rocks));
        left_over -= static_cast<double>(rocks);
        if (left_over <= 5e-3 * static_cast<double>(run.rocks)) {
            break;
        }
    }
    rocks_by_hits.back() += std::max(0.0, left_over);
    const std::size_t bars = rocks_by_hits.size();
    std::vector<double> edges(bars + 1);
    for (std::size_t i = 0; i <= bars; ++i) {
        edges[i] = static_cast<double>(i) - 0.5;
    }
    Axis x{page_text("Trees hit by a rock"), edges.front(), edges.back(), false, true};
    const std::string caption = left_over > 0.0 ? page_text("The last bar takes {bars} hits and more.",
                                                            {{"bars", std::to_string(bars - 1)}})
                                                : "";
    return histogram(
        results, page_text("Tree hits per rock"), std::move(x), edges, [&](Cover) { return rocks_by_hits; },
        caption, {Cover::forest}, false);
}

}  // namespace

PageFields charts(const RunResults& results, const Figures& figures) {
    const std::vector<std::size_t> charted = most_reached(results.tally.targets, most_targets_shown);
    std::optional<PageFields> some_charted;
    if (charted.size() < figures.targets.size()) {
        some_charted = {{"charted", grouped(charted.size())}, {"targets", grouped(figures.targets.size())}};
    }
    std::vector<PageFields> targets;
    for (const std::size_t target : charted) {
        const TargetFigures& named = figures.targets[target];
        std::optional<PageFields> arrivals;
        if (named.at(Cover::bare).share.part > 0 || named.at(Cover::forest).share.part > 0) {
            arrivals = PageFields{
                {"charts",
                 joined(
                     energy_histogram(results, target), speed_histogram(results, target),
                     height_histogram(results, target, page_text("Height of the rocks that arrive"),
                                      page_text("Height above ground at the target, m"),
                                      page_text("Underside of the rock, vertically above the ground."),
                                      &rockfall::ArrivalTally::height, &rockfall::ArrivalTally::height_max_m),
                     height_histogram(
                         results, target, page_text("Top of the rocks that arrive"),
                         page_text("Top of the rock above ground at the target, m"),
                         page_text("Highest point of the rock: what a net must reach, without any reserve."),
                         &rockfall::ArrivalTally::top_height, &rockfall::ArrivalTally::top_height_max_m),
                     exceedance(results, target))}};
        }
        targets.push_back({{"name", named.name.empty() ? named.id : named.name},
                           {"arrivals", arrivals},
                           {"not_on_paper", some_charted && targets.size() >= most_target_cards}});
    }
    const bool with_trees = results.with_forest && !results.site.trees.empty();
    return {{"some_charted", some_charted},
            {"charted_targets", targets},
            {"charts_of_all_rocks",
             joined(run_out_histogram(results), with_trees ? tree_hit_histogram(results) : "")}};
}

}  // namespace coupling::report
