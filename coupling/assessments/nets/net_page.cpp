#include "coupling/assessments/nets/net_page.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "config/text/joined.hpp"
#include "config/units/constants.hpp"
#include "coupling/assessments/nets/figures/net_tables.hpp"
#include "coupling/assessments/nets/figures/net_words.hpp"
#include "coupling/assessments/nets/moving/moving_nets.hpp"
#include "coupling/assessments/nets/net_drawing.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/figures/colours.hpp"
#include "coupling/results/figures/figures.hpp"
#include "coupling/results/report/chart.hpp"
#include "coupling/results/report/map/map_sheet.hpp"
#include "coupling/results/templates/page_template.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::report {
namespace {

using config::j_per_kj;
using config::joined;

/// Where the axis of energy begins: a rock of less is as good as at rest.
constexpr double least_net_kj = 0.1;
/// Of an axis: what a label at a mark needs.
constexpr double room_for_a_label = 0.13;

const std::string& title_of(Cover cover) {
    return cover == Cover::forest ? page_text("with forest") : page_text("bare slope");
}

/// Crossings of a net on one slope; each rock once, as it first crosses the line.
std::vector<const NetRow*> rows_at(const RunResults& results, std::uint32_t net, Cover cover) {
    std::vector<const NetRow*> rows;
    for (const NetRow& row : results.net_rows) {
        if (row.crossing.net == net && row.cover == cover && row.crossing.first) {
            rows.push_back(&row);
        }
    }
    return rows;
}

template <class Value>
std::vector<double> counted_in(const std::vector<double>& edges, const std::vector<const NetRow*>& rows,
                               const Value& value_of, std::uint64_t rocks) {
    std::vector<double> shares(edges.size() - 1);
    for (const NetRow* row : rows) {
        const auto above = std::upper_bound(edges.begin(), edges.end(), value_of(*row));
        const auto bin = std::clamp<std::ptrdiff_t>(above - edges.begin() - 1, 0,
                                                    static_cast<std::ptrdiff_t>(shares.size()) - 1);
        shares[static_cast<std::size_t>(bin)] +=
            100.0 / static_cast<double>(std::max<std::uint64_t>(1, rocks));
    }
    return shares;
}

template <class Value>
std::string histogram(const RunResults& results, std::uint32_t net, const std::string& title, Axis x,
                      const std::vector<double>& edges, const Value& value_of, bool with_classes) {
    std::vector<Cover> covers = covers_of(results);
    std::reverse(covers.begin(), covers.end());  // the forest is drawn over the bare slope
    std::vector<std::vector<double>> heights;
    double highest = 0.0;
    for (const Cover cover : covers) {
        heights.push_back(counted_in(edges, rows_at(results, net, cover), value_of,
                                     results.tally.runs[index_of(cover)].rocks));
        highest = std::max(highest, *std::max_element(heights.back().begin(), heights.back().end()));
    }
    Chart chart{title, std::move(x), Axis::from_zero(page_text("% of all rocks"), highest)};
    for (std::size_t i = 0; i < covers.size(); ++i) {
        chart.add_steps(name_of(covers[i]), edges, heights[i]);
        chart.add_name(name_of(covers[i]), title_of(covers[i]));
    }
    if (with_classes) {
        const double capacity_kj = results.site.nets[net].net.capacity_j / j_per_kj;
        for (const double limit_kj : intensity_limits_kj) {
            chart.add_mark(limit_kj, page_text("{limit_kj} kJ", {{"limit_kj", tick_text(limit_kj)}}));
        }
        chart.add_mark(capacity_kj, page_text("net"));
    } else {
        chart.add_mark(results.site.nets[net].net.height_m, page_text("net"));
    }
    return chart.figure(page_text(
        "Each rock as it first comes to the net; the first and the last bar take all below and above."));
}

std::string histograms(const RunResults& results, std::uint32_t net) {
    const rockfall::Net& wall = results.site.nets[net].net;
    double most_kj = wall.capacity_j / j_per_kj;
    double most_m = 0.0;
    for (const Cover cover : covers_of(results)) {
        most_m = std::max(most_m, drawn_height_m(wall, rows_at(results, net, cover)));
    }
    for (const NetRow& row : results.net_rows) {
        if (row.crossing.net == net) {
            most_kj = std::max(most_kj, static_cast<double>(row.crossing.energy_j) / j_per_kj);
        }
    }
    Axis energy = Axis::powers_of_ten(page_text("Energy in front of the net, kJ"), least_net_kj,
                                      std::max(1.0, most_kj));
    constexpr int bars_a_decade = 8;
    const int bars = static_cast<int>(std::lround(bars_a_decade * std::log10(energy.high / energy.low)));
    std::vector<double> energy_edges;
    for (int i = 0; i <= bars; ++i) {
        energy_edges.push_back(energy.low * std::pow(10.0, static_cast<double>(i) / bars_a_decade));
    }
    // No farther than twice the net: what flies higher passes in any case, and bars stay fine below.
    constexpr double most_nets = 2.0;
    Axis height = Axis::from_zero(page_text("Centre of the rock above the ground, m"),
                                  std::min(most_m, most_nets * wall.height_m));
    std::vector<double> height_edges;
    constexpr int steps = 30;
    for (int i = 0; i <= steps; ++i) {
        height_edges.push_back(height.high * static_cast<double>(i) / steps);
    }
    return joined(
        histogram(
            results, net, page_text("Energy at the net"), std::move(energy), energy_edges,
            [](const NetRow& row) { return static_cast<double>(row.crossing.energy_j) / j_per_kj; }, true),
        histogram(
            results, net, page_text("Height at the net"), std::move(height), height_edges,
            [](const NetRow& row) { return static_cast<double>(row.crossing.height_m); }, false));
}

std::string with_interval(const Share& share) {
    return share.whole == 0 ? "–"
                            : page_text("{share} ({interval_low} to {interval_high})",
                                        {{"share", percent(share.value)},
                                         {"interval_low", percent(share.interval.low)},
                                         {"interval_high", percent(share.interval.high)}});
}

std::string with_interval(const QuantileEstimate& estimate) {
    if (std::isnan(estimate.value)) {
        return "–";
    }
    const std::string high =
        std::isfinite(estimate.interval.high) ? three_digits(estimate.interval.high) : page_text("not known");
    return page_text(
        "{estimate} ({interval_low} to {high})",
        {{"estimate", three_digits(estimate.value)},
         {"interval_low",
          std::isnan(estimate.interval.low) ? page_text("not known") : three_digits(estimate.interval.low)},
         {"high", high}});
}

std::string with_all(double value, const Interval& all) {
    if (std::isnan(all.low)) {
        return page_text("{estimate} (at most {high})",
                         {{"estimate", three_digits(value)}, {"high", three_digits(all.high)}});
    }
    return page_text("{estimate} ({interval_low} to {high})", {{"estimate", three_digits(value)},
                                                               {"interval_low", three_digits(all.low)},
                                                               {"high", three_digits(all.high)}});
}

/// The figures of a design; dashes without one.
PageFields design_fields(const NetFigures& of) {
    const auto text = [&](const auto& text_of) { return of.design ? text_of(*of.design) : std::string{"–"}; };
    using Design = BarrierDesign;
    const std::optional<DesignSpread> spread = of.design ? of.design->spread : std::nullopt;
    return {{"percentile_energy", text([&](const Design& d) {
                 return spread ? with_all(d.percentile_energy_kj, spread->energy_kj)
                               : three_digits(d.percentile_energy_kj);
             })},
            {"design_energy", text([](const Design& d) { return three_digits(d.design_energy_kj); })},
            {"percentile_height", text([&](const Design& d) {
                 return spread ? with_all(d.percentile_height_m, spread->height_m)
                               : three_digits(d.percentile_height_m);
             })},
            {"upper", spread ? in_words(spread->at_upper_ends) : "–"},
            {"design_height", text([](const Design& d) { return three_digits(d.design_height_m); })},
            {"held", text([](const Design& d) { return percent(d.held.value); })},
            {"over", text([](const Design& d) { return grouped(d.over.part); })},
            {"through", text([](const Design& d) { return grouped(d.through.part); })}};
}

/// The figures of a net on each slope.
std::vector<PageFields> shares_by_slope(const std::vector<NetFigures>& figures,
                                        const DesignSettings& settings) {
    std::vector<PageFields> slopes;
    for (const NetFigures& of : figures) {
        slopes.push_back(
            {{"slope", title_of(of.cover)},
             {"reached", join_with_commas({grouped(of.reached.part), with_interval(of.reached)})},
             {"need", need_in_words(of, settings)},
             {"design", design_fields(of)}});
    }
    return slopes;
}

/// What becomes of the rocks that reach a net, on each slope.
std::vector<PageFields> outcomes_by_slope(const std::vector<NetFigures>& figures) {
    std::vector<PageFields> rows;
    for (std::size_t i = 0; i < rockfall::net_outcomes; ++i) {
        std::vector<PageFields> slopes;
        for (const NetFigures& of : figures) {
            slopes.push_back({{"share", with_interval(of.outcome[i])}});
        }
        rows.push_back({{"what_becomes", coupling::in_words(static_cast<rockfall::NetOutcome>(i))},
                        {"on_slopes", slopes}});
    }
    return rows;
}

/// Whether a net has to be stronger or higher with forest than without.
bool forest_asks_for_more(const std::vector<NetFigures>& figures) {
    const auto design_of = [&](Cover cover) -> const BarrierDesign* {
        const auto found = std::find_if(figures.begin(), figures.end(),
                                        [&](const NetFigures& of) { return of.cover == cover; });
        return found != figures.end() && found->design ? &*found->design : nullptr;
    };
    const BarrierDesign* with_forest = design_of(Cover::forest);
    const BarrierDesign* bare = design_of(Cover::bare);
    return with_forest != nullptr && bare != nullptr && asks_for_more(*with_forest, *bare);
}

PageFields quantity_by_slope(const std::string& name, const std::vector<NetFigures>& figures,
                             NetQuantity NetFigures::*quantity) {
    std::vector<PageFields> slopes;
    for (const NetFigures& figure : figures) {
        const NetQuantity& of = figure.*quantity;
        slopes.push_back({{"mean", three_digits(of.mean)},
                          {"median", three_digits(of.p50)},
                          {"p90", three_digits(of.p90)},
                          {"p95", with_interval(of.p95)},
                          {"p99", with_interval(of.p99)}});
    }
    return {{"quantity", name}, {"on_slopes", slopes}};
}

/// "520 of 6 734 rocks are drawn, 7.73 % as on the other slope; ...": what share is drawn, and of how many.
std::string caption_of(std::size_t drawn, std::size_t rocks, std::size_t most_rocks, bool beside_another) {
    if (rocks == 0) {
        return page_text("No rock reaches the net.");
    }
    if (most_rocks <= most_drawn_rocks) {
        return page_text(rocks == 1 ? "{rocks} rock, drawn; place of its centre."
                                    : "{rocks} rocks, all drawn; places of their centres.",
                         {{"rocks", grouped(rocks)}});
    }
    const double share = static_cast<double>(most_drawn_rocks) / static_cast<double>(most_rocks);
    return page_text(
        beside_another
            ? "{drawn} of {rocks} rocks are drawn, on both slopes the same share of {share}, evenly "
              "chosen; places of their centres."
            : "{drawn} of {rocks} rocks are drawn, a share of {share}, evenly chosen; places of their "
              "centres.",
        {{"drawn", grouped(drawn)}, {"rocks", grouped(rocks)}, {"share", percent(share)}});
}

/// The net on each slope, with the same share of the rocks and the same height of the drawing.
std::vector<PageFields> developed_views(const RunResults& results, std::uint32_t net) {
    const NetRecord& record = results.site.nets[net];
    const std::vector<Cover> covers = covers_of(results);
    std::size_t most_rocks = 0;
    double highest_m = 0.0;
    for (const Cover cover : covers) {
        const std::vector<const NetRow*> rows = rows_at(results, net, cover);
        most_rocks = std::max(most_rocks, rows.size());
        highest_m = std::max(highest_m, drawn_height_m(record.net, rows));
    }
    std::vector<PageFields> views;
    for (const Cover cover : covers) {
        const std::vector<const NetRow*> rows = rows_at(results, net, cover);
        const std::size_t drawn = drawn_rocks(rows.size(), most_rocks);
        const std::string title = joined(record.name, ", ", title_of(cover));
        const DevelopedView view = developed_view(record, evenly_spaced(rows, drawn), highest_m, title);
        std::optional<PageFields> higher;
        if (view.above > 0) {
            higher = PageFields{{"above", grouped(view.above)}};
        }
        views.push_back({{"title", title},
                         {"drawing", view.drawing},
                         {"caption", caption_of(drawn, rows.size(), most_rocks, covers.size() > 1)},
                         {"higher", higher}});
    }
    return views;
}

/// "20 m long, 3 m high, capacity 1 000 kJ, class 3".
std::string size_of(const NetRecord& record) {
    return join_with_commas(
        {page_text("{length_m} m long, {height_m} m high, capacity {capacity_kj} kJ",
                   {{"length_m", three_digits(length_m(record.net))},
                    {"height_m", three_digits(record.net.height_m)},
                    {"capacity_kj", three_digits(record.net.capacity_j / j_per_kj)}}),
         record.energy_class.empty() ? "" : page_text("class {class}", {{"class", record.energy_class}}),
         record.net.gap_m > 0.0
             ? page_text("gap of {gap_m} m at the ground", {{"gap_m", three_digits(record.net.gap_m)}})
             : ""});
}

PageFields one_net(const RunResults& results, std::uint32_t net, const std::vector<NetFigures>& all) {
    const NetRecord& record = results.site.nets[net];
    std::vector<NetFigures> figures;
    std::copy_if(all.begin(), all.end(), std::back_inserter(figures),
                 [&](const NetFigures& of) { return of.net == net; });
    const std::vector<PageFields> quantities{
        quantity_by_slope(page_text("Energy, kJ"), figures, &NetFigures::energy_kj),
        quantity_by_slope(page_text("Height of passage, m"), figures, &NetFigures::height_m)};
    return {{"net", record.name},
            {"size", size_of(record)},
            {"views", developed_views(results, net)},
            {"histograms", histograms(results, net)},
            {"slopes", shares_by_slope(figures, results.scenario.design)},
            {"outcomes", outcomes_by_slope(figures)},
            {"has_spread", std::any_of(figures.begin(), figures.end(),
                                       [](const NetFigures& of) { return of.design && of.design->spread; })},
            {"forest_asks_for_more", forest_asks_for_more(figures)},
            {"columns", std::to_string(figures.size() + 1)},
            {"quantities", quantities}};
}

}  // namespace

bool has_moving_nets(const RunResults& results) {
    return !results.site.nets.empty() && !results.net_paths.empty();
}

std::string nets(const RunResults& results, const MapWindow& shown) {
    if (results.site.nets.empty()) {
        return "";
    }
    std::string moving;
    if (has_moving_nets(results)) {
        NetPathsReader paths{results.net_paths};
        moving = moving::moving_nets(paths, results.site.nets, MapSheet{results.site, shown});
    }
    const std::vector<NetFigures> figures = net_figures(results);
    std::vector<PageFields> rows;
    for (std::uint32_t net = 0; net < results.site.nets.size(); ++net) {
        rows.push_back(one_net(results, net, figures));
    }
    const double largest_m =
        rockfall::diameter_range(start_law(results.scenario.release), results.site.sources).largest_m;
    return filled_template("net_section.html", {{"with_forest", results.with_forest},
                                                {"legend", developed_view_legend()},
                                                {"nets", rows},
                                                {"moving", moving},
                                                {"percentile", exact(results.scenario.design.percentile)},
                                                {"rule", design_rule_in_words(results.scenario.design)},
                                                {"largest_m", three_digits(0.5 * largest_m)}});
}

}  // namespace coupling::report
