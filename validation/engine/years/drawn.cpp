#include "validation/engine/years/drawn.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <string_view>
#include <utility>

#include "config/text/joined.hpp"

namespace coupling::validation::years {
namespace {

using config::joined;

constexpr std::size_t colours = 7;
constexpr const char* others = "other species";

struct LayerRow {
    std::string plot;
    std::string layer;
    double x = 0.0;
    double y = 0.0;
};

/// What a query of layers gives, with the titles of its axes.
struct LayerRows {
    std::string x_title;
    std::string y_title;
    std::vector<LayerRow> rows;
};

LayerRows layers_of(geopackage::Database& database, const Query& query) {
    geopackage::Statement statement = prepared(database, query);
    if (statement.columns() != 4) {
        config::fail(config::ExitCode::data, query.place,
                     joined(std::to_string(statement.columns()), " columns"), "four: plot, layer, x, y");
    }
    LayerRows layers{statement.name(2), statement.name(3), {}};
    while (statement.step()) {
        layers.rows.push_back(
            {statement.text(0), statement.text(1), statement.number(2), statement.number(3)});
    }
    return layers;
}

/// Names of the layers, those with colours first: by their sums, the greatest first.
std::vector<std::string> ranked(const std::vector<LayerRow>& rows) {
    std::map<std::string, double> sums;
    for (const LayerRow& row : rows) {
        sums[row.layer] += row.y;
    }
    std::vector<std::string> names;
    for (const auto& [name, sum] : sums) {
        names.push_back(name);
    }
    std::stable_sort(names.begin(), names.end(),
                     [&](const std::string& a, const std::string& b) { return sums[a] > sums[b]; });
    if (names.size() > colours) {
        names.resize(colours);
        names.emplace_back(others);
    }
    return names;
}

/// "F. sylvatica": what fits beside a layer.
std::string short_name(const std::string& name) {
    const std::size_t blank = name.find(' ');
    return name == others || blank == std::string::npos ? name
                                                        : joined(name.substr(0, 1), ".", name.substr(blank));
}

/// The layers of one plot on top of each other; those that are thick at the end are named there.
Plot stacked(const std::string& title, const LayerRows& all, const std::vector<std::string>& names,
             report::Axis x, report::Axis y) {
    Plot plot{
        .title = title, .x = std::move(x), .y = std::move(y), .series = {}, .labels = {}, .caption = ""};
    std::map<double, std::vector<double>> at;  // by x and layer
    for (const LayerRow& row : all.rows) {
        if (row.plot == title) {
            const auto name = std::find(names.begin(), names.end(), row.layer);
            std::vector<double>& here = at.try_emplace(row.x, names.size(), 0.0).first->second;
            here[std::min<std::size_t>(static_cast<std::size_t>(name - names.begin()), names.size() - 1)] +=
                row.y;
        }
    }
    for (std::size_t layer = 0; layer < names.size(); ++layer) {
        PlotSeries series{
            names[layer], joined("layer", std::to_string(layer)), PlotSeries::Form::band, {}, {}};
        for (const auto& [place, thickness] : at) {
            const double floor = std::accumulate(thickness.begin(),
                                                 thickness.begin() + static_cast<std::ptrdiff_t>(layer), 0.0);
            series.ranges.push_back({place, floor, floor + thickness[layer]});
        }
        const report::ChartRange& last = series.ranges.back();
        constexpr double least_named = 0.06;
        if (last.high - last.low > least_named * plot.y.high) {
            plot.labels.push_back({last.x, 0.5 * (last.low + last.high), short_name(names[layer])});
        }
        plot.series.push_back(std::move(series));
    }
    return plot;
}

/// All plots of a query on the same axes. Charts with the same title stand side by side.
void add_stacks(const std::string& title, const LayerRows& layers, const std::vector<std::string>& names,
                Outcome& outcome) {
    std::vector<std::string> plots;
    std::map<std::pair<std::string, double>, double> sums;
    const auto [low, high] = std::minmax_element(layers.rows.begin(), layers.rows.end(),
                                                 [](const auto& a, const auto& b) { return a.x < b.x; });
    for (const LayerRow& row : layers.rows) {
        if (std::find(plots.begin(), plots.end(), row.plot) == plots.end()) {
            plots.push_back(row.plot);
        }
        sums[{row.plot, row.x}] += row.y;
    }
    double most = 0.0;
    for (const auto& [place, sum] : sums) {
        most = std::max(most, sum);
    }
    if (outcome.plots.empty() || outcome.plots.back().title != title) {
        outcome.plots.push_back({title, {}, plots.size() > 2});
    }
    constexpr double room_for_names = 0.35;
    for (const std::string& plot : plots) {
        outcome.plots.back().plots.push_back(stacked(
            plot, layers, names, {layers.x_title, low->x, high->x + room_for_names * (high->x - low->x)},
            report::Axis::from_zero(layers.y_title, most)));
    }
}

/// How a chart shows a series: the word in its query, the form, the class of the page's style.
struct LineStyle {
    std::string_view word;
    PlotSeries::Form form;
    const char* style;
};
constexpr std::array<LineStyle, 4> line_styles{{{"line", PlotSeries::Form::line, "default"},
                                                {"equal", PlotSeries::Form::line, "equal"},
                                                {"dots", PlotSeries::Form::dots, "published"},
                                                {"trees", PlotSeries::Form::dots, "tree"}}};

const LineStyle& style_of(const std::string& word, const Query& query) {
    const auto* const found = std::find_if(line_styles.begin(), line_styles.end(),
                                           [&](const LineStyle& style) { return style.word == word; });
    if (found == line_styles.end()) {
        config::fail(config::ExitCode::data, query.place, joined("style ", config::in_quotes(word)),
                     "line, equal, dots or trees");
    }
    return *found;
}

/// Charts of lines and dots, each with axes of its own.
PlotGroup lines_of(geopackage::Database& database, const Query& query, const std::string& title) {
    geopackage::Statement statement = prepared(database, query);
    if (statement.columns() != 6) {
        config::fail(config::ExitCode::data, query.place,
                     joined(std::to_string(statement.columns()), " columns"),
                     "six: plot, name, style, label, x, y");
    }
    PlotGroup group{title, {}, false};
    std::string label;
    while (statement.step()) {
        if (group.plots.empty() || group.plots.back().title != statement.text(0)) {
            group.plots.push_back({.title = statement.text(0),
                                   .x = {statement.name(4), 0.0, 0.0},
                                   .y = {statement.name(5), 0.0, 0.0},
                                   .series = {},
                                   .labels = {},
                                   .caption = ""});
        }
        Plot& plot = group.plots.back();
        const report::ChartPoint point{statement.number(4), statement.number(5)};
        const bool is_new =
            plot.series.empty() || plot.series.back().name != statement.text(1) || label != statement.text(3);
        label = statement.text(3);
        if (is_new) {
            const LineStyle& style = style_of(statement.text(2), query);
            plot.series.push_back({statement.text(1), style.style, style.form, {}, {}});
            if (!label.empty()) {
                plot.labels.push_back({point.x, point.y, label});
            }
        }
        plot.series.back().points.push_back(point);
        if (!label.empty()) {
            plot.labels.back().x = point.x;
            plot.labels.back().y = point.y;
        }
        plot.x.high = std::max(plot.x.high, point.x);
        plot.y.high = std::max(plot.y.high, point.y);
    }
    constexpr double room_for_labels = 1.2;
    for (Plot& plot : group.plots) {
        plot.x = report::Axis::from_zero(plot.x.title,
                                         plot.x.high * (plot.labels.empty() ? 1.0 : room_for_labels));
        plot.y = report::Axis::from_zero(plot.y.title, plot.y.high);
    }
    group.small = group.plots.size() > 2;
    return group;
}

PlainTable plain_table(geopackage::Database& database, const Query& query, const std::string& caption) {
    PlainTable table{.caption = caption, .head = {}, .rows = rows_of(database, query)};
    const geopackage::Statement statement = prepared(database, query);
    for (int column = 0; column < statement.columns(); ++column) {
        table.head.push_back(statement.name(column));
    }
    return table;
}

}  // namespace

void draw(ResultTables& tables, const std::vector<Query>& queries, const Fields& asked, Outcome& outcome) {
    std::vector<std::string> names;
    for (const Query& query : queries) {
        if (query.use == QueryUse::stack) {
            const LayerRows layers = layers_of(tables.database(), query);
            names = names.empty() ? ranked(layers.rows) : names;
            const bool has_more =
                std::any_of(layers.rows.begin(), layers.rows.end(), [&](const LayerRow& row) {
                    return std::find(names.begin(), names.end(), row.layer) == names.end();
                });
            if (has_more && names.back() != others) {
                names.emplace_back(others);
            }
            if (!layers.rows.empty()) {
                add_stacks(filled(query.title, asked, query.place), layers, names, outcome);
            }
        } else if (query.use == QueryUse::lines) {
            PlotGroup group = lines_of(tables.database(), query, filled(query.title, asked, query.place));
            if (!group.plots.empty()) {
                outcome.plots.push_back(std::move(group));
            }
        } else if (query.use == QueryUse::table) {
            PlainTable table = plain_table(tables.database(), query, filled(query.title, asked, query.place));
            if (!table.rows.empty()) {
                outcome.tables.push_back(std::move(table));
            }
        }
    }
}

}  // namespace coupling::validation::years
