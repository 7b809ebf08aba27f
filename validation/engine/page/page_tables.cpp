#include <algorithm>
#include <cmath>
#include <set>

#include "config/text/joined.hpp"
#include "coupling/results/report/html_table.hpp"
#include "coupling/results/templates/page_template.hpp"
#include "coupling/results/text/element.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"
#include "validation/engine/kinds/verdict.hpp"
#include "validation/engine/page/page_notes.hpp"
#include "validation/engine/page/page_parts.hpp"
#include "validation/engine/slope/quantities.hpp"

namespace coupling::validation {
namespace {

using config::joined;
using report::element;
using report::escaped;
using report::filled_template;
using report::HtmlTable;
using report::PageFields;

std::string with_deviation(double value, std::optional<double> deviation) {
    return deviation ? figure_text(value, *deviation) : figure_text(value);
}

/// The figure of all rocks with its verdict, and below it what the small series give.
std::string ours(const Value& value, Verdict verdict) {
    std::string cell = figure_text(value.value);
    if (verdict != Verdict::no_criterion) {
        cell += joined(" ", badge(verdict));
    }
    if (value.series) {
        cell += element("small", {}, with_deviation(*value.series, value.deviation));
    }
    return cell;
}

std::string miss_of(const std::string& set, const Value& value) {
    return joined(set, " ", figure_text(value.value));
}

const VerdictRow* row_named(const CaseResult& result, const std::string& quantity) {
    const auto found = std::find_if(result.rows.begin(), result.rows.end(),
                                    [&](const VerdictRow& row) { return row.quantity == quantity; });
    return found == result.rows.end() ? nullptr : &*found;
}

std::string shown_value_of(const Values& values, const std::string& quantity) {
    const auto found = values.find(quantity);
    return found == values.end() ? "–" : figure_text(found->second.value);
}

/// Observed and published of a quantity without a row in the verdict table are not known: an en dash.
std::string known(const VerdictRow* row, std::optional<double> VerdictRow::*figure) {
    return row != nullptr && row->*figure ? figure_text(*(row->*figure)) : "–";
}

/// Quantities of the rows first, in their order; then those that only variants have.
std::vector<std::string> quantities_of(const CaseResult& result) {
    std::vector<std::string> names;
    for (const VerdictRow& row : result.rows) {
        names.push_back(row.quantity);
    }
    for (const VariantOutcome& variant : result.variants) {
        for (const auto& [name, value] : variant.values) {
            // What is nothing everywhere, such as tree hits without trees, is not worth a line.
            const bool says_something = std::any_of(
                result.variants.begin(), result.variants.end(), [&n = name](const VariantOutcome& v) {
                    const auto found = v.values.find(n);
                    return found != v.values.end() && std::isfinite(found->second.value) &&
                           found->second.value != 0.0;
                });
            if (says_something && std::find(names.begin(), names.end(), name) == names.end()) {
                names.push_back(name);
            }
        }
    }
    return names;
}

std::vector<const VerdictRow*> rows_with_criterion(const CaseResult& result) {
    std::vector<const VerdictRow*> rows;
    for (const VerdictRow& row : result.rows) {
        if (row.low || row.high) {
            rows.push_back(&row);
        }
    }
    return rows;
}

/// A figure with a choice moved; where that turns the verdict that it has with the same few rocks and nothing
/// moved, it says so.
std::string moved_cell(const VerdictRow& row, const Values& moved, const Values& base) {
    const auto found = moved.find(row.quantity);
    if (found == moved.end()) {
        return "–";
    }
    const Verdict now = judge(row, found->second.value);
    const std::string figure = figure_text(found->second.value);
    const auto before = base.find(row.quantity);
    const bool turns = before != base.end() && judge(row, before->second.value) != now;
    return turns ? joined(element("b", {}, figure), " ", badge(now)) : figure;
}

void add_choices(HtmlTable& table, const CaseResult& result, const std::vector<const VerdictRow*>& rows,
                 const Side& side) {
    table.group(side.name);
    const Values& base = result.choices.front().*side.moved;
    for (const ChoiceOutcome& choice : result.choices) {
        std::vector<std::string> cells{
            choice.overrides.empty()
                ? escaped(choice.choice)
                : joined(escaped(choice.choice), element("small", {}, escaped(choice.overrides)))};
        for (const VerdictRow* row : rows) {
            const bool is_base = &choice == &result.choices.front();
            const std::string cell = moved_cell(*row, choice.*side.moved, base);
            const auto value = base.find(row->quantity);
            cells.push_back(is_base && value != base.end()
                                ? joined(cell, " ", badge(judge(*row, value->second.value)))
                                : cell);
        }
        table.row(cells);
    }
}

/// How many criteria have a verdict that any of the choices turns.
std::size_t turned(const CaseResult& result, const std::vector<const VerdictRow*>& rows, const Side& side) {
    std::set<std::string> quantities;
    for (const Flip& flip : flips_of(result)) {
        if (flip.strict == (&side == &strict_side)) {
            quantities.insert(flip.quantity);
        }
    }
    return static_cast<std::size_t>(std::count_if(
        rows.begin(), rows.end(), [&](const VerdictRow* row) { return quantities.contains(row->quantity); }));
}

/// The verdicts of the forest: one set of settings, no series.
std::string forest_verdicts(const CaseResult& result) {
    const bool has_reference = std::any_of(result.rows.begin(), result.rows.end(),
                                           [](const VerdictRow& row) { return row.published.has_value(); });
    std::vector<std::string> head{report::page_text("quantity"), report::page_text("Bannwald"),
                                  report::page_text("criterion"), report::page_text("rests on")};
    if (has_reference) {
        head.emplace_back(report::page_text("reference"));
    }
    HtmlTable table{escaped(result.extent), head};
    table.text_columns({3});
    Notes notes;
    for (const VerdictRow& as_judged : result.rows) {
        const VerdictRow row = in_readable_unit(as_judged);
        std::vector<std::string> cells{row_name(row), ours(row.default_value, row.default_verdict),
                                       joined(criterion_text(row), notes.cite(row.rule)),
                                       escaped(row.rests_on)};
        if (has_reference) {
            cells.push_back(
                row.published ? joined(figure_text(*row.published), notes.cite(row.published_source)) : "–");
        }
        table.row(cells);
    }
    return result.rows.empty() ? "" : joined(table.html(), notes.html());
}

}  // namespace

std::string verdict_table(const CaseResult& result) {
    if (!result.has_strict) {
        return forest_verdicts(result);
    }
    HtmlTable table{
        report::page_text("Large figures: all {result_rocks} rocks; small ones: mean ± standard deviation of "
                          "{result_series} series of {result_rocks_per_series} rocks.",
                          {{"result_rocks", report::grouped(result.rocks)},
                           {"result_series", report::grouped(result.series)},
                           {"result_rocks_per_series", report::grouped(result.rocks_per_series)}}),
        {report::page_text("quantity"), report::page_text("observed"), report::page_text("published"),
         report::page_text("strict"), report::page_text("default"), report::page_text("criterion"),
         report::page_text("rests on")}};
    table.text_columns({6});
    Notes notes;
    for (const VerdictRow& row : result.rows) {
        const std::string observed =
            row.observed ? joined(figure_text(*row.observed), notes.cite(row.observed_source)) : "–";
        const std::string published = row.published
                                          ? joined(with_deviation(*row.published, row.published_deviation),
                                                   notes.cite(row.published_source))
                                          : "–";
        table.row({row_name(row), observed, published,
                   joined(ours(row.strict_value, row.strict_verdict),
                          row.scatter_value ? element("small", {},
                                                      joined(report::page_text("with a scattered jump angle"),
                                                             " ", figure_text(row.scatter_value->value)))
                                            : ""),
                   ours(row.default_value, row.default_verdict),
                   joined(criterion_text(row), notes.cite(row.rule)), escaped(row.rests_on)});
    }
    return result.rows.empty() ? "" : joined(table.html(), notes.html());
}

std::string misses(const CaseResult& result) {
    std::vector<PageFields> missed;
    for (const VerdictRow& as_judged : result.rows) {
        const VerdictRow row = in_readable_unit(as_judged);
        std::vector<std::string> values;
        if (row.strict_verdict == Verdict::missed) {
            values.push_back(miss_of("strict", row.strict_value));
        }
        if (row.default_verdict == Verdict::missed) {
            values.push_back(
                miss_of(result.has_strict ? "default" : report::page_text("Bannwald"), row.default_value));
        }
        if (!values.empty()) {
            missed.push_back({{"figure_html", row_name(row)},
                              {"values", report::join_with_and(values)},
                              {"criterion", criterion_text(row)},
                              {"has_cause", !row.cause.empty()},
                              {"cause", row.cause}});
        }
    }
    return missed.empty() ? "" : filled_template("misses.html", {{"misses", missed}});
}

Nearness nearness(const CaseResult& result) {
    Nearness found;
    for (const VerdictRow& row : result.rows) {
        if (!row.observed || !row.published) {
            continue;
        }
        const double published_off = std::abs(*row.published - *row.observed);
        ++found.compared;
        found.strict += std::abs(row.strict_value.value - *row.observed) < published_off ? 1U : 0U;
        found.ours += std::abs(row.default_value.value - *row.observed) < published_off ? 1U : 0U;
    }
    return found;
}

/// The name of a figure for people, with its unit; the machine's name where the program knows none.
std::string figure_name(const std::string& name) {
    const std::optional<FigureName> figure = parse_figure(name);
    if (!figure) {
        return escaped(name);
    }
    return figure->unit() == "-" ? escaped(figure->label())
                                 : joined(escaped(figure->label()), ", ", escaped(figure->unit()));
}

/// With room to break a line: improved_rebound -> improved rebound.
std::string spaced(std::string name) {
    std::replace(name.begin(), name.end(), '_', ' ');
    return name;
}

std::string variants_table(const CaseResult& result) {
    if (result.variants.size() < 2) {
        return "";
    }
    std::vector<std::string> head{report::page_text("quantity"), report::page_text("observed"),
                                  report::page_text("published")};
    for (const VariantOutcome& variant : result.variants) {
        head.push_back(escaped(spaced(variant.variant)));
    }
    HtmlTable table{report::page_text("All rocks."), head};
    for (const std::string& quantity : quantities_of(result)) {
        const VerdictRow* row = row_named(result, quantity);
        std::vector<std::string> cells{row == nullptr ? figure_name(quantity) : row_name(*row),
                                       known(row, &VerdictRow::observed), known(row, &VerdictRow::published)};
        for (const VariantOutcome& variant : result.variants) {
            cells.push_back(shown_value_of(variant.values, quantity));
        }
        table.row(cells);
    }
    std::vector<PageFields> meanings;
    for (const VariantOutcome& variant : result.variants) {
        if (!variant.meaning.empty()) {
            meanings.push_back({{"variant", variant.variant}, {"meaning", variant.meaning}});
        }
    }
    return filled_template(
        "variants.html",
        {{"table", table.html()}, {"has_meanings", !meanings.empty()}, {"meanings", meanings}});
}

std::string choices_table(const CaseResult& result) {
    const std::vector<const VerdictRow*> rows = rows_with_criterion(result);
    if (result.choices.empty() || rows.empty()) {
        return "";
    }
    std::vector<std::string> head{report::page_text("free choice")};
    for (const VerdictRow* row : rows) {
        head.push_back(joined(row_name(*row), element("small", {}, criterion_text(*row))));
    }
    HtmlTable table{report::page_text("The first line holds the verdicts with nothing moved, on as few "
                                      "rocks; further down a badge stands where one turns."),
                    head};
    add_choices(table, result, rows, strict_side);
    add_choices(table, result, rows, default_side);
    std::vector<PageFields> choices;
    for (const ChoiceOutcome& choice : result.choices) {
        choices.push_back({{"choice", choice.choice}, {"reason", choice.reason}});
    }
    return filled_template("choices.html",
                           {{"turned_in_strict", std::to_string(turned(result, rows, strict_side))},
                            {"turned_in_default", std::to_string(turned(result, rows, default_side))},
                            {"rows", std::to_string(rows.size())},
                            {"table", table.html()},
                            {"choices", choices}});
}

}  // namespace coupling::validation
