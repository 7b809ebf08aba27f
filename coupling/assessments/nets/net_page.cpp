#include "coupling/assessments/nets/net_page.hpp"

#include <algorithm>
#include <cmath>

#include "config/text/joined.hpp"
#include "config/units/constants.hpp"
#include "coupling/assessments/nets/figures/net_tables.hpp"
#include "coupling/assessments/nets/figures/net_words.hpp"
#include "coupling/assessments/nets/net_drawing.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/figures/colours.hpp"
#include "coupling/results/figures/figures.hpp"
#include "coupling/results/report/chart.hpp"
#include "coupling/results/report/html_table.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::report {
namespace {

using config::j_per_kj;
using config::joined;

/// Where the axis of energy begins: a rock of less is as good as at rest.
constexpr double least_kj = 0.1;
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
    const Axis x_of = x;
    Chart chart{title, std::move(x), Axis::from_zero(page_text("% of all rocks"), std::max(highest, 1e-6))};
    for (std::size_t i = 0; i < covers.size(); ++i) {
        chart.add_steps(name_of(covers[i]), edges, heights[i]);
        chart.add_name(name_of(covers[i]), title_of(covers[i]));
    }
    if (with_classes) {
        const double capacity_kj = results.site.nets[net].net.capacity_j / j_per_kj;
        for (const double limit_kj : intensity_limits_kj) {
            if (std::abs(x_of.share_of(limit_kj) - x_of.share_of(capacity_kj)) > room_for_a_label) {
                chart.add_mark(limit_kj, page_text("{limit_kj} kJ", {{"limit_kj", tick_text(limit_kj)}}));
            }
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
    Axis energy =
        Axis::powers_of_ten(page_text("Energy in front of the net, kJ"), least_kj, std::max(1.0, most_kj));
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
        "<div class=\"halves\">",
        histogram(
            results, net, page_text("Energy at the net"), std::move(energy), energy_edges,
            [](const NetRow& row) { return static_cast<double>(row.crossing.energy_j) / j_per_kj; }, true),
        histogram(
            results, net, page_text("Height at the net"), std::move(height), height_edges,
            [](const NetRow& row) { return static_cast<double>(row.crossing.height_m); }, false),
        "</div>\n");
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
    return page_text("{estimate} ({interval_low} to {high})",
                     {{"estimate", three_digits(estimate.value)},
                      {"interval_low", three_digits(estimate.interval.low)},
                      {"high", high}});
}

/// Heights are those of centres: said beside the figure, as nets are ordered by it.
std::string what_comes_on_top(const RunResults& results) {
    const double largest_m =
        rockfall::diameter_range(start_law(results.scenario.release), results.site.sources).largest_m;
    return joined("<p>",
                  page_text("Heights are those of the rock&#39;s centre. Its radius, here up to {largest_m} "
                            "m, and the margins that guidelines for design ask for on height and energy come "
                            "on top of the class and height needed.",
                            {{"largest_m", three_digits(0.5 * largest_m)}}),
                  "</p>\n");
}

std::string key_figures_of(const RunResults& results, const std::vector<NetFigures>& figures) {
    std::vector<std::string> head{page_text("Rocks")};
    for (const NetFigures& of : figures) {
        head.emplace_back(title_of(of.cover));
    }
    HtmlTable table{page_text("Shares with 95 % intervals; held, over, below and broken through are shares "
                              "of the rocks that reach the net."),
                    head};
    const auto row = [&](const std::string& name, const auto& text_of) {
        std::vector<std::string> cells{name};
        for (const NetFigures& of : figures) {
            cells.push_back(text_of(of));
        }
        table.row(cells);
    };
    row(page_text("Reach the net"), [](const NetFigures& of) {
        return joined(grouped(of.reached.part), ", ", with_interval(of.reached));
    });
    const std::array<std::string, rockfall::net_outcomes> words{
        page_text("Held"), page_text("Pass over"), page_text("Pass below"), page_text("Break through")};
    for (std::size_t i = 0; i < words.size(); ++i) {
        row(words[i], [&](const NetFigures& of) { return with_interval(of.outcome[i]); });
    }
    const auto number = [](double value) { return std::isnan(value) ? "–" : three_digits(value); };
    for (const auto& [name, quantity] :
         {std::pair{page_text("Energy, kJ"), &NetFigures::energy_kj},
          std::pair{page_text("Height of the centre, m"), &NetFigures::height_m}}) {
        const auto row_of = [&](const std::string& figure, const auto& text_of) {
            row(with_label(name, figure), [&](const NetFigures& of) { return text_of(of.*quantity); });
        };
        row_of(page_text("mean"), [&](const NetQuantity& of) { return number(of.mean); });
        row_of(page_text("median"), [&](const NetQuantity& of) { return number(of.p50); });
        row_of("90 %", [&](const NetQuantity& of) { return number(of.p90); });
        row_of("95 %", [](const NetQuantity& of) { return with_interval(of.p95); });
        row_of("99 %", [](const NetQuantity& of) { return with_interval(of.p99); });
    }
    const double wanted = results.scenario.nets.wanted_share;
    row(page_text("To hold {wanted}", {{"wanted", percent(wanted)}}),
        [&](const NetFigures& of) { return escaped(need_in_words(of, wanted)); });
    return joined("<div class=\"wide\">", table.html(), "</div>\n", what_comes_on_top(results));
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
std::string developed_views(const RunResults& results, std::uint32_t net) {
    const NetRecord& record = results.site.nets[net];
    const std::vector<Cover> covers = covers_of(results);
    std::size_t most_rocks = 0;
    double highest_m = 0.0;
    for (const Cover cover : covers) {
        const std::vector<const NetRow*> rows = rows_at(results, net, cover);
        most_rocks = std::max(most_rocks, rows.size());
        highest_m = std::max(highest_m, drawn_height_m(record.net, rows));
    }
    std::string html;
    for (const Cover cover : covers) {
        const std::vector<const NetRow*> rows = rows_at(results, net, cover);
        const std::size_t drawn = drawn_rocks(rows.size(), most_rocks);
        html += developed_view(record, evenly_spaced(rows, drawn), highest_m,
                               joined(record.name, ", ", title_of(cover)),
                               caption_of(drawn, rows.size(), most_rocks, covers.size() > 1));
    }
    return html;
}

std::string one_net(const RunResults& results, std::uint32_t net, const std::vector<NetFigures>& all) {
    const NetRecord& record = results.site.nets[net];
    std::vector<NetFigures> figures;
    std::copy_if(all.begin(), all.end(), std::back_inserter(figures),
                 [&](const NetFigures& of) { return of.net == net; });
    std::string html = joined(
        "<h3>", escaped(record.name), "</h3>\n<p>",
        join_with_commas({page_text("{length_m} m long, {height_m} m high, capacity {capacity_kj} kJ",
                                    {{"length_m", three_digits(length_m(record.net))},
                                     {"height_m", three_digits(record.net.height_m)},
                                     {"capacity_kj", three_digits(record.net.capacity_j / j_per_kj)}}),
                          record.energy_class.empty()
                              ? ""
                              : page_text("class {class}", {{"class", escaped(record.energy_class)}}),
                          record.net.gap_m > 0.0 ? page_text("gap of {gap_m} m at the ground",
                                                             {{"gap_m", three_digits(record.net.gap_m)}})
                                                 : ""}),
        ".</p>\n");
    html += developed_views(results, net);
    return joined(html, histograms(results, net), key_figures_of(results, figures));
}

}  // namespace

std::string nets(const RunResults& results) {
    if (results.site.nets.empty()) {
        return "";
    }
    const std::vector<NetFigures> figures = net_figures(results);
    std::string html = joined(
        "<h2>", page_text("Nets"), "</h2>\n<p>",
        join_sentences(
            {results.with_forest
                 ? page_text("The nets stand on the bare slope too: the protection effect above "
                             "compares forest and no forest behind the same nets.")
                 : "",
             page_text(
                 "Each rock meets intact nets. It passes over where its centre is above the upper edge, and "
                 "below where all of it fits under the lower one. A rock with more energy than the capacity "
                 "breaks through and continues with the remaining energy.")}),
        "</p>\n", developed_view_legend());
    for (std::uint32_t net = 0; net < results.site.nets.size(); ++net) {
        html += one_net(results, net, figures);
    }
    return html;
}

}  // namespace coupling::report
