#include <algorithm>

#include "coupling/results/report/html_table.hpp"
#include "coupling/results/templates/page_template.hpp"
#include "coupling/results/text/markup.hpp"
#include "validation/engine/page/page_parts.hpp"

namespace coupling::validation {
namespace {

using report::Chart;
using report::escaped;
using report::PageFields;

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

PageFields group_fields(const PlotGroup& group) {
    Chart names{"", {}, {}};
    add_names(names, group.plots);
    std::string drawings;
    for (const Plot& plot : group.plots) {
        drawings += drawing(plot);
    }
    return {{"title", group.title},
            {"names", names.list_of_names()},
            {"small", group.small},
            {"drawings", drawings}};
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
    return table.html();
}

}  // namespace

std::string plots_part(const CaseResult& result) {
    if (result.plots.empty() && result.tables.empty()) {
        return "";
    }
    std::vector<PageFields> plots;
    for (const PlotGroup& group : result.plots) {
        plots.push_back(group_fields(group));
    }
    std::vector<PageFields> tables;
    for (const PlainTable& table : result.tables) {
        tables.push_back({{"table", table_of(table)}});
    }
    return report::filled_template("plots.html", {{"plots", plots}, {"tables", tables}});
}

}  // namespace coupling::validation
