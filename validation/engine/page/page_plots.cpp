#include <algorithm>

#include "config/text/joined.hpp"
#include "coupling/results/report/html_table.hpp"
#include "coupling/results/text/markup.hpp"
#include "validation/engine/page/page_parts.hpp"

namespace coupling::validation {
namespace {

using config::joined;
using report::Chart;
using report::escaped;

void add_name(Chart& chart, const PlotSeries& series) {
    switch (series.form) {
        case PlotSeries::Form::line:
            chart.add_name(series.style, series.name);
            break;
        case PlotSeries::Form::dots:
            chart.add_dot_name(series.style, series.name);
            break;
        case PlotSeries::Form::band:
            chart.add_band_name(series.style, series.name);
            break;
    }
}

/// Each name once, however many series have it.
void add_names(Chart& chart, const std::vector<Plot>& plots) {
    std::vector<std::string> named;
    for (const Plot& plot : plots) {
        for (const PlotSeries& series : plot.series) {
            if (std::find(named.begin(), named.end(), series.name) == named.end()) {
                named.push_back(series.name);
                add_name(chart, series);
            }
        }
    }
}

std::string drawing(const Plot& plot) {
    Chart chart{plot.title, plot.x, plot.y};
    for (const PlotSeries& series : plot.series) {
        switch (series.form) {
            case PlotSeries::Form::line:
                chart.add_line(series.style, series.points);
                break;
            case PlotSeries::Form::dots:
                chart.add_dots(series.style, series.points);
                break;
            case PlotSeries::Form::band:
                chart.add_band(series.style, series.ranges);
                break;
        }
    }
    for (const PlotLabel& label : plot.labels) {
        chart.add_label(label.x, label.y, label.text);
    }
    return chart.figure(escaped(plot.caption));
}

std::string group(const PlotGroup& plots) {
    Chart names{"", {}, {}};
    add_names(names, plots.plots);
    std::string html =
        joined("<section class=\"chart\"><h3>", escaped(plots.title), "</h3>\n", names.list_of_names(),
               "</section>\n<div class=\"", plots.small ? "thirds" : "halves", "\">");
    for (const Plot& plot : plots.plots) {
        html += drawing(plot);
    }
    return joined(html, "</div>\n");
}

std::string table_of(const PlainTable& plain) {
    std::vector<std::string> head;
    for (const std::string& name : plain.head) {
        head.push_back(escaped(name));
    }
    report::HtmlTable table{escaped(plain.caption), head};
    for (const std::vector<std::string>& row : plain.rows) {
        std::vector<std::string> cells;
        for (const std::string& cell : row) {
            cells.push_back(escaped(cell));
        }
        table.row(cells);
    }
    return joined("<section class=\"card\">", table.html(), "</section>\n");
}

}  // namespace

std::string plots_part(const CaseResult& result) {
    std::string html;
    for (const PlotGroup& plots : result.plots) {
        html += group(plots);
    }
    for (const PlainTable& table : result.tables) {
        html += table_of(table);
    }
    return html;
}

}  // namespace coupling::validation
