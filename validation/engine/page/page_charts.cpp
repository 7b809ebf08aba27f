#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "config/text/joined.hpp"
#include "config/units/constants.hpp"
#include "coupling/results/report/chart.hpp"
#include "coupling/results/text/element.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"
#include "validation/engine/page/page_parts.hpp"

namespace coupling::validation {
namespace {

using config::joined;
using config::percent;

using report::Axis;
using report::Chart;
using report::ChartPoint;
using report::ChartRange;
using report::escaped;

/// Default last, so that it is drawn over the others.
std::vector<std::size_t> drawing_order(const CaseResult& result) {
    std::vector<std::size_t> order(result.variants.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        order[i] = order.size() - 1 - i;
    }
    std::stable_partition(order.begin(), order.end(),
                          [&](std::size_t i) { return result.variants[i].variant != "default"; });
    return order;
}

std::vector<ChartPoint> in_percent(const std::vector<CurvePoint>& curve) {
    std::vector<ChartPoint> points;
    points.reserve(curve.size());
    for (const CurvePoint& corner : curve) {
        points.push_back({corner.x, percent * corner.y});
    }
    return points;
}

/// Share of rocks that get further than a distance: straight between the corners of the curve.
double further_than(const std::vector<CurvePoint>& curve, double distance_m) {
    for (std::size_t i = 0; i < curve.size(); ++i) {
        if (curve[i].x < distance_m) {
            continue;
        }
        if (i == 0 || curve[i].x == curve[i - 1].x) {
            return curve[i].y;
        }
        const double part = (distance_m - curve[i - 1].x) / (curve[i].x - curve[i - 1].x);
        return curve[i - 1].y + part * (curve[i].y - curve[i - 1].y);
    }
    return curve.empty() ? NAN : curve.back().y;
}

/// "Stopped in B (240 to 340 m): observed 33.0 %, strict 31.2 %, default 30.1 %."
std::string section_shares(const CaseResult& result) {
    std::string sentences;
    for (const SectionShare& section : result.sections) {
        std::vector<std::string> shares;
        if (section.observed) {
            shares.push_back(
                report::page_text("observed {share}", {{"share", report::percent(*section.observed)}}));
        }
        if (section.published) {
            shares.push_back(
                report::page_text("published {share}", {{"share", report::percent(*section.published)}}));
        }
        for (const VariantOutcome& variant : result.variants) {
            if (variant.variant == "strict" || variant.variant == "default") {
                shares.push_back(joined(variant.variant, " ",
                                        report::percent(further_than(variant.run_out, section.from_m) -
                                                        further_than(variant.run_out, section.to_m))));
            }
        }
        sentences = report::join_sentences(
            {sentences, report::page_text("Stopped in {section} ({from_m} to {to_m} m): {shares}.",
                                          {{"section", escaped(section.section)},
                                           {"from_m", report::tick_text(section.from_m)},
                                           {"to_m", report::tick_text(section.to_m)},
                                           {"shares", report::join_with_commas(shares)}})});
    }
    return sentences;
}

std::vector<ChartRange> series_band(const VariantOutcome& variant) {
    std::vector<ChartRange> ranges;
    for (const CurvePoint& low : variant.run_out_low) {
        ranges.push_back({low.x, percent * low.y, percent * further_than(variant.run_out_high, low.x)});
    }
    return ranges;
}

std::string run_out_chart(const CaseResult& result) {
    double most_m = 0.0;
    for (const VariantOutcome& variant : result.variants) {
        most_m = std::max(most_m, variant.run_out.empty() ? 0.0 : variant.run_out.back().x);
    }
    if (most_m <= 0.0) {
        return "";
    }
    Chart chart{report::page_text("Run-out"),
                Axis::from_zero(report::page_text("Distance in plan from the start, m"), most_m),
                Axis{report::page_text("% of rocks that get further"), 0.0, percent}};
    const std::vector<std::size_t> order = drawing_order(result);
    // Bands of strict and default alone: those of all variants would hide each other.
    const auto has_band = [&](std::size_t i) {
        const VariantOutcome& variant = result.variants[i];
        return !variant.run_out_low.empty() && (variant.variant == "strict" || variant.variant == "default");
    };
    for (const std::size_t i : order) {
        if (has_band(i)) {
            chart.add_band(series_of(result, i), series_band(result.variants[i]));
        }
    }
    for (const std::size_t i : order) {
        chart.add_line(series_of(result, i), in_percent(result.variants[i].run_out));
    }
    for (std::size_t i = 0; i < result.variants.size(); ++i) {
        chart.add_name(series_of(result, i), result.variants[i].variant);
    }
    for (std::size_t i = 0; i < result.variants.size(); ++i) {
        if (has_band(i)) {
            chart.add_band_name(series_of(result, i),
                                report::page_text("{variants_variant}, 90 % of series",
                                                  {{"variants_variant", result.variants[i].variant}}));
        }
    }
    if (!result.observed_run_out.empty()) {
        chart.add_dots("observed", in_percent(result.observed_run_out));
        chart.add_dot_name("observed", report::page_text("observed"));
    }
    for (const SectionShare& section : result.sections) {
        chart.add_mark(section.from_m, section.section);
    }
    if (!result.sections.empty()) {
        chart.add_mark(result.sections.back().to_m, "");
    }
    return chart.figure(section_shares(result));
}

/// The variants that charts of distributions show: the three of the paper, and default.
constexpr std::array drawn_variants{"initial", "improved_rebound", "strict", "default"};

/// Their place among the variants; nothing for one that the case does not have.
std::optional<std::size_t> place_of_variant(const CaseResult& result, const std::string& name) {
    for (std::size_t i = 0; i < result.variants.size(); ++i) {
        if (result.variants[i].variant == name) {
            return i;
        }
    }
    return std::nullopt;
}

/// Variants as steps; the last takes all that lies above.
void add_shares(Chart& chart, const CaseResult& result, const std::vector<double>& edges,
                std::vector<double> VariantOutcome::*shares) {
    for (const char* name : drawn_variants) {
        const auto place = place_of_variant(result, name);
        if (!place || (result.variants[*place].*shares).empty()) {
            continue;
        }
        const VariantOutcome& variant = result.variants[*place];
        std::vector<double> heights(edges.size() - 1, 0.0);
        for (std::size_t i = 0; i < (variant.*shares).size(); ++i) {
            heights[std::min(i, heights.size() - 1)] += percent * (variant.*shares)[i];
        }
        chart.add_steps(series_of(result, *place), edges, heights);
        chart.add_name(series_of(result, *place), variant.variant);
    }
}

void add_seen(Chart& chart, const std::string& series, const std::vector<double>& shares) {
    std::vector<ChartPoint> points;
    for (std::size_t i = 0; i < shares.size(); ++i) {
        points.push_back({static_cast<double>(i), percent * shares[i]});
    }
    if (!points.empty()) {
        chart.add_dots(series, points);
        chart.add_dot_name(series, series);
    }
}

double largest(const std::vector<double>& values) {
    return values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
}

/// Bins that hold all but the last half per cent of any variant.
std::size_t bins_worth_showing(const CaseResult& result, std::vector<double> VariantOutcome::*shares) {
    std::size_t bins = 0;
    for (const VariantOutcome& variant : result.variants) {
        double sum = 0.0;
        for (std::size_t i = 0; i < (variant.*shares).size() && sum < 0.995; ++i) {
            sum += (variant.*shares)[i];
            bins = std::max(bins, i + 1);
        }
    }
    return bins;
}

double highest_percent(const CaseResult& result, std::vector<double> VariantOutcome::*shares) {
    double most = 0.0;
    for (const VariantOutcome& variant : result.variants) {
        most = std::max(most, largest(variant.*shares));
    }
    return percent * most;
}

std::string tree_hit_chart(const CaseResult& result) {
    const std::size_t bins = std::max({bins_worth_showing(result, &VariantOutcome::tree_hits),
                                       result.observed_tree_hits.size(), result.published_tree_hits.size()});
    if (bins == 0) {
        return "";
    }
    std::vector<double> edges;
    for (std::size_t i = 0; i <= bins; ++i) {
        edges.push_back(static_cast<double>(i) - 0.5);
    }
    const double most = std::max({highest_percent(result, &VariantOutcome::tree_hits),
                                  percent * largest(result.observed_tree_hits),
                                  percent * largest(result.published_tree_hits)});
    Chart chart{report::page_text("Tree hits per rock"),
                Axis{report::page_text("Trees hit by a rock"), -0.5, edges.back(), false, true},
                Axis::from_zero(report::page_text("% of rocks"), most)};
    add_shares(chart, result, edges, &VariantOutcome::tree_hits);
    add_seen(chart, "observed", result.observed_tree_hits);
    add_seen(chart, "published", result.published_tree_hits);
    return chart.figure(
        report::page_text("The last bar takes {bins} hits and more.", {{"bins", std::to_string(bins - 1)}}));
}

std::string hit_height_chart(const CaseResult& result) {
    constexpr double bin_m = 0.5;
    const std::size_t bins = bins_worth_showing(result, &VariantOutcome::hit_heights);
    if (bins == 0) {
        return "";
    }
    std::vector<double> edges;
    for (std::size_t i = 0; i <= bins; ++i) {
        edges.push_back(bin_m * static_cast<double>(i));
    }
    Chart chart{report::page_text("Heights of tree hits"),
                Axis{report::page_text("Height of the rock's centre above ground, m"), 0.0, edges.back()},
                Axis::from_zero(report::page_text("% of hits"),
                                highest_percent(result, &VariantOutcome::hit_heights))};
    add_shares(chart, result, edges, &VariantOutcome::hit_heights);
    return chart.figure(report::page_text("In bars of 0.5 m; the last one takes all above."));
}

std::string jump_chart(const VariantOutcome& variant, const std::string& series, double most_m,
                       double end_m) {
    Chart chart{report::page_text("Jump lengths, {variant}", {{"variant", variant.variant}}),
                Axis::from_zero(report::page_text("Distance along the slope, m"), end_m),
                Axis::from_zero(report::page_text("Length of a jump, m"), most_m)};
    // Stretches in which no jump ends part the curve.
    std::vector<ChartRange> ranges;
    std::vector<ChartPoint> means;
    const auto draw = [&] {
        chart.add_band(series, ranges);
        chart.add_line(series, means);
        ranges.clear();
        means.clear();
    };
    for (const SegmentJumps& segment : variant.jumps) {
        if (segment.jumps == 0 || (!ranges.empty() && ranges.back().x < segment.from_m)) {
            draw();
        }
        if (segment.jumps == 0) {
            continue;
        }
        for (const double at_m : {segment.from_m, segment.to_m}) {
            ranges.push_back({at_m, segment.shortest_m, segment.longest_m});
            means.push_back({at_m, segment.mean_m});
        }
    }
    draw();
    chart.add_name(series, report::page_text("mean"));
    chart.add_band_name(series, report::page_text("shortest to longest"));
    return chart.figure(
        report::page_text("Straight from impact to impact, by the stretch of slope in which the jump ends."));
}

std::string jump_charts(const CaseResult& result) {
    double most_m = 0.0;
    double end_m = 0.0;
    std::vector<std::size_t> drawn;
    for (const char* name : drawn_variants) {
        const auto place = place_of_variant(result, name);
        if (!place || result.variants[*place].jumps.empty()) {
            continue;
        }
        drawn.push_back(*place);
        for (const SegmentJumps& segment : result.variants[*place].jumps) {
            most_m = std::max(most_m, segment.jumps > 0 ? segment.longest_m : 0.0);
            end_m = std::max(end_m, segment.jumps > 0 ? segment.to_m : 0.0);
        }
    }
    std::string html;
    for (const std::size_t place : drawn) {
        html +=
            end_m > 0.0 ? jump_chart(result.variants[place], series_of(result, place), most_m, end_m) : "";
    }
    return html;
}

}  // namespace

std::string case_charts(const CaseResult& result) {
    const auto beside = [](const std::string& charts) {
        return charts.empty() ? "" : report::element("div", {{"class", "halves"}}, charts);
    };
    return joined(profile_drawing(result), beside(joined(run_out_chart(result), tree_hit_chart(result))),
                  beside(hit_height_chart(result)), beside(jump_charts(result)));
}

}  // namespace coupling::validation
