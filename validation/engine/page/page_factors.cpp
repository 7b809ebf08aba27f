#include <algorithm>
#include <cmath>
#include <set>

#include "config/text/joined.hpp"
#include "config/units/constants.hpp"
#include "coupling/results/report/chart.hpp"
#include "coupling/results/report/html_table.hpp"
#include "coupling/results/templates/page_template.hpp"
#include "coupling/results/text/element.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"
#include "validation/engine/page/page_notes.hpp"
#include "validation/engine/page/page_parts.hpp"

namespace coupling::validation {
namespace {

using config::joined;
using config::percent;

using report::Axis;
using report::Chart;
using report::ChartPoint;
using report::ChartRange;
using report::element;
using report::escaped;
using report::filled_template;
using report::HtmlTable;
using report::PageFields;

constexpr const char* protection = "protection_effect";
constexpr const char* free_path = "free_path_m";
constexpr const char* analytic = "analytic_free_path_m";

std::string low_to_high(const Estimate& estimate) {
    return report::page_text("{row_low} to {row_high}", {{"row_low", figure_text(estimate.low)},
                                                         {"row_high", figure_text(estimate.high)}});
}

std::string with_interval(const Estimate& estimate) {
    return element("span", {{"class", "line"}},
                   joined(figure_text(estimate.value), " ",
                          element("span", {{"class", "interval"}}, joined("(", low_to_high(estimate), ")"))));
}

const Estimate* figure_of(const FactorRow& row, const std::string& figure) {
    const auto found = row.figures.find(figure);
    return found == row.figures.end() ? nullptr : &found->second;
}

const DirectionRow* same_direction(const CaseResult& result, const DirectionRow& as, const char* variant) {
    const auto found =
        std::find_if(result.directions.begin(), result.directions.end(), [&](const DirectionRow& row) {
            return row.variant == variant && row.figure == as.figure && row.setting == as.setting;
        });
    return found == result.directions.end() ? nullptr : &*found;
}

std::string steps_cell(const DirectionRow* row) {
    std::string lines;
    for (std::size_t i = 0; row != nullptr && i < row->at_steps.size(); ++i) {
        lines += joined(i == 0 ? "" : element("br", {}), with_interval(row->at_steps[i]));
    }
    return lines.empty() ? "–" : lines;
}

std::string verdict_cell(const DirectionRow* row) {
    if (row == nullptr) {
        return "–";
    }
    const std::string against =
        row->steps_against == 0
            ? ""
            : report::page_text("steps against: {steps}", {{"steps", std::to_string(row->steps_against)}});
    return joined(badge(row->verdict), element("small", {}, figure_text(row->change.value)),
                  element("small", {}, report::join_with_semicolons({low_to_high(row->change), against})));
}

PageFields directions_fields(const CaseResult& result) {
    HtmlTable table{
        report::page_text(
            "Figures: mean over the other settings, where rocks give one at every step, with its 95 % "
            "interval. Below a verdict: the change from the first step to the last with its interval."),
        {report::page_text("direction"), report::page_text("at"), report::page_text("strict"),
         report::page_text("default"), report::page_text("strict"), report::page_text("default")}};
    Notes notes;
    for (const DirectionRow& row : result.directions) {
        const DirectionRow* strict = same_direction(result, row, strict_side.name);
        const DirectionRow* ours = same_direction(result, row, default_side.name);
        if (&row != (strict != nullptr ? strict : ours)) {
            continue;  // stands in the row of its twin
        }
        std::string values;
        for (std::size_t i = 0; i < row.steps.size(); ++i) {
            values += joined(i == 0 ? "" : element("br", {}), report::tick_text(row.steps[i]));
        }
        table.row({joined(escaped(direction_name(row)), notes.cite(row.source)), values, steps_cell(strict),
                   steps_cell(ours), verdict_cell(strict), verdict_cell(ours)});
    }
    return {{"directions", table.html()}, {"sources", notes.html()}};
}

/// Rows of one set in which all settings moved together, or one alone.
std::vector<const FactorRow*> rows_of(const CaseResult& result, const std::string& variant,
                                      const std::string& alone) {
    std::vector<const FactorRow*> rows;
    for (const FactorRow& row : result.factors) {
        if (row.variant == variant && row.alone == alone) {
            rows.push_back(&row);
        }
    }
    return rows;
}

/// Settings that take more than one value in these rows.
std::vector<std::size_t> moving(const std::vector<const FactorRow*>& rows) {
    std::vector<std::size_t> places;
    for (std::size_t f = 0; !rows.empty() && f < rows.front()->settings.size(); ++f) {
        if (std::any_of(rows.begin(), rows.end(), [&](const FactorRow* row) {
                return row->settings[f] != rows.front()->settings[f];
            })) {
            places.push_back(f);
        }
    }
    return places;
}

Axis axis_over(const std::string& setting, const std::vector<const FactorRow*>& rows, std::size_t place) {
    double most = 0.0;
    for (const FactorRow* row : rows) {
        most = std::max(most, row->settings[place]);
    }
    std::string title = factor_name(setting);
    title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(title[0])));
    return Axis::from_zero(std::move(title), 1.1 * most);
}

/// Protection effects of some rows over one setting: a line with whiskers.
void add_protection(Chart& chart, const std::string& series, const std::string& name,
                    const std::vector<const FactorRow*>& rows, std::size_t place) {
    std::vector<ChartPoint> points;
    std::vector<ChartRange> ranges;
    for (const FactorRow* row : rows) {
        if (const Estimate* effect = figure_of(*row, protection)) {
            points.push_back({row->settings[place], percent * effect->value});
            ranges.push_back(
                {row->settings[place], percent * effect->low, percent * std::min(1.0, effect->high)});
        }
    }
    chart.add_line(series, points);
    chart.add_whiskers(series, ranges);
    chart.add_name(series, name);
}

Chart protection_chart(const std::string& title, Axis x) {
    return {title, std::move(x), Axis{report::page_text("Protection effect, %"), 0.0, percent}};
}

/// One chart to each value of the last setting, one line to each value of the second, over the first.
std::string crossed_charts(const CaseResult& result) {
    const std::vector<const FactorRow*> rows = rows_of(result, "default", "");
    const std::vector<std::size_t> places = moving(rows);
    if (places.size() < 3) {
        return "";
    }
    const std::size_t over = places[0];
    const std::size_t lines = places[1];
    const std::size_t charts = places.back();
    std::set<double> line_values;
    std::set<double> chart_values;
    for (const FactorRow* row : rows) {
        line_values.insert(row->settings[lines]);
        chart_values.insert(row->settings[charts]);
    }
    std::string html;
    for (const double of_chart : chart_values) {
        Chart chart = protection_chart(
            report::page_text("Protection effect, default: {charts_of_chart}",
                              {{"charts_of_chart",
                                factor_at(result.factor_settings[charts], report::tick_text(of_chart))}}),
            axis_over(result.factor_settings[over], rows, over));
        std::size_t number = 0;
        for (const double of_line : line_values) {
            std::vector<const FactorRow*> chosen;
            std::copy_if(rows.begin(), rows.end(), std::back_inserter(chosen), [&](const FactorRow* row) {
                return row->settings[lines] == of_line && row->settings[charts] == of_chart;
            });
            const std::string series = number == 0 ? "default" : joined("other", std::to_string(number - 1));
            add_protection(chart, series,
                           factor_at(result.factor_settings[lines], report::tick_text(of_line)), chosen,
                           over);
            ++number;
        }
        html += chart.figure(report::page_text("Whiskers: 95 % over rocks and stands."));
    }
    return html;
}

std::string alone_charts(const CaseResult& result) {
    std::string html;
    for (std::size_t f = 0; f < result.factor_settings.size(); ++f) {
        const std::string& setting = result.factor_settings[f];
        const std::vector<const FactorRow*> rows = rows_of(result, "default", setting);
        if (rows.empty()) {
            continue;
        }
        Chart chart = protection_chart(report::page_text("Protection effect over {factor_name_setting}",
                                                         {{"factor_name_setting", factor_name(setting)}}),
                                       axis_over(setting, rows, f));
        add_protection(chart, "strict", "strict", rows_of(result, "strict", setting), f);
        add_protection(chart, "default", "default", rows, f);
        html += chart.figure(
            report::page_text("All other settings as in the recipe. Whiskers: 95 % over rocks and stands."));
    }
    return html;
}

std::string free_path_chart(const CaseResult& result) {
    double most_m = 0.0;
    std::map<std::string, std::vector<ChartPoint>> points;
    for (const FactorRow& row : result.factors) {
        const Estimate* ours = figure_of(row, free_path);
        const Estimate* exact = figure_of(row, analytic);
        if (ours != nullptr && exact != nullptr && std::isfinite(ours->value)) {
            points[row.variant].push_back({exact->value, ours->value});
            most_m = std::max({most_m, ours->value, exact->value});
        }
    }
    if (points.empty()) {
        return "";
    }
    Chart chart{report::page_text("Way between tree hits"),
                Axis::from_zero(report::page_text("1 / (n (D + DBH)), m"), most_m),
                Axis::from_zero(report::page_text("Way down the slope per hit, m"), most_m)};
    chart.add_line("other2", std::vector<ChartPoint>{{0.0, 0.0}, {most_m, most_m}});
    chart.add_name("other2", report::page_text("equal"));
    for (const auto& [variant, of_variant] : points) {
        chart.add_dots(variant, of_variant);
        chart.add_dot_name(variant, variant);
    }
    return chart.figure(
        report::page_text("One dot to each combination. Rocks also go sideways, so their way down the slope "
                          "between two hits is a little shorter than their path."));
}

std::string combinations_table(const CaseResult& result) {
    std::vector<std::string> head;
    for (const std::string& setting : result.factor_settings) {
        head.push_back(escaped(factor_name(setting)));
    }
    const std::vector<std::pair<std::string, std::string>> figures{
        {"basal_area_m2pha", report::page_text("basal area, m²/ha")},
        {protection, report::page_text("protection effect")},
        {"energy_kept_share", report::page_text("energy kept")},
        {"residual_energy_kj", report::page_text("mean energy, kJ")},
        {"hits_per_rock", report::page_text("hits per rock")},
        {free_path, report::page_text("way between hits, m")},
        {analytic, report::page_text("1 / (n (D + DBH)), m")}};
    for (const auto& [figure, name] : figures) {
        head.push_back(name);
    }
    HtmlTable table{report::page_text("Mean energy: of rocks that arrive at the foot with forest. Settings "
                                      "that move alone stand last."),
                    head};
    for (const Side& side : {strict_side, default_side}) {
        table.group(side.name);
        for (const FactorRow& row : result.factors) {
            if (row.variant != side.name) {
                continue;
            }
            std::vector<std::string> cells;
            for (const double value : row.settings) {
                cells.push_back(report::tick_text(value));
            }
            for (const auto& [figure, name] : figures) {
                const Estimate* estimate = figure_of(row, figure);
                cells.push_back(estimate == nullptr    ? "–"
                                : figure == protection ? with_interval(*estimate)
                                                       : figure_text(estimate->value));
            }
            table.row(cells);
        }
    }
    return table.html();
}

}  // namespace

std::string factors_part(const CaseResult& result) {
    if (result.factors.empty() && result.directions.empty()) {
        return "";
    }
    PageFields fields = directions_fields(result);
    fields.insert(fields.end(),
                  {{"charts", joined(crossed_charts(result), alone_charts(result), free_path_chart(result))},
                   {"combinations", combinations_table(result)}});
    return filled_template("factors.html", fields);
}

}  // namespace coupling::validation
