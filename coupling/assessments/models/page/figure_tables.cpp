#include "coupling/assessments/models/page/figure_tables.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "coupling/assessments/models/page/answers.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::models {
namespace {

using report::page_text;
using report::PageFields;

/// Figures that stand together below a heading.
struct Group {
    const char* about;
    const char* title;
    std::vector<const char*> quantities;
};

const std::vector<Group>& groups() {
    static const std::vector<Group> all{
        {"target", "Share of the rocks that the forest stops, %", {"protection_percent"}},
        {"target", "Rocks that arrive, %", {"reached_percent"}},
        {"target", "Speed, m/s", {"speed_mps"}},
        {"target", "Energy, kJ", {"energy_kj"}},
        {"target", "Height of the underside above the ground, m", {"height_m"}},
        {"target", "Height of the top of the rock above the ground, m", {"top_height_m"}},
        {"slope", "Run-out of the rocks that stop on the terrain, m", {"run_out_m"}},
        {"slope", "Run-out of all rocks, at least, m", {"run_out_at_least_m"}},
        {"slope", "Rocks that leave the terrain, %", {"left_terrain_percent"}},
        {"net", "Rocks that reach the net, %", {"reached_percent"}},
        {"net", "Rocks that a net holds, of those that reach it, %", {"held_percent"}},
        {"net", "Energy, kJ, and class", {"energy_kj", "design_energy_kj", "design_class"}},
        {"net",
         "Height of the top of the rock above the ground, m",
         {"height_m", "design_height_m", "sold_height_m"}}};
    return all;
}

constexpr std::array shown_statistics{"", "mean", "p50", "p90", "p95", "p99"};
constexpr std::array shown_of_periods{"", "mean", "p95"};

bool is_shown(const FigureKey& key) {
    const auto has = [&](const auto& list) {
        return std::find(list.begin(), list.end(), key.statistic) != list.end();
    };
    return key.return_period_years > 0.0 ? has(shown_of_periods) : has(shown_statistics);
}

/// "with forest, median".
std::string label_of(const FigureKey& key) {
    const std::string slope = key.cover == "forest" ? page_text("with forest")
                              : key.cover == "bare" ? page_text("bare slope")
                                                    : "";
    const std::string what = key.quantity == "design_energy_kj"  ? page_text("design energy")
                             : key.quantity == "design_class"    ? page_text("class of the net to order")
                             : key.quantity == "design_height_m" ? page_text("design height")
                             : key.quantity == "sold_height_m"   ? page_text("height of the net to order")
                             : key.statistic == "mean"           ? page_text("mean")
                             : key.statistic == "p50"            ? page_text("median")
                             : key.statistic.empty()
                                 ? ""
                                 : page_text("{number} % below", {{"number", key.statistic.substr(1)}});
    const std::string label = report::join_with_commas({slope, what});
    return label.empty() ? page_text("with 95 % interval") : label;
}

std::optional<PageFields> interval_fields(const FigureKey& key, const Interval& interval) {
    const bool no_low = std::isnan(interval.low) && !std::isnan(interval.high);
    if (!no_low && !(interval.low <= interval.high)) {
        return std::nullopt;
    }
    return PageFields{{"no_low", no_low},
                      {"low", shown_value(key, interval.low)},
                      {"high", shown_value(key, interval.high)}};
}

PageFields row_of_figure(const ModelFigure& figure) {
    std::vector<PageFields> values;
    for (const Figure& one : figure.by_model) {
        const bool is_known = !std::isnan(one.value);
        values.push_back({{"value", shown_value(figure.key, one.value)},
                          {"of_rocks", is_known ? interval_fields(figure.key, one.of_rocks) : std::nullopt},
                          {"of_all", is_known ? interval_fields(figure.key, one.of_all) : std::nullopt}});
    }
    const std::optional<Range> range = range_over(figure);
    const bool has_factor = range && range->factor && figure.key.quantity != "design_class";
    return {{"label", label_of(figure.key)},
            {"values", values},
            {"has_factor", has_factor},
            {"factor", has_factor ? report::fixed(*range->factor, 1) : ""},
            {"disagree", range && range->agreement == Agreement::disagree},
            {"agree", range && range->agreement == Agreement::agree}};
}

/// What field cases say of each model in a quantity.
std::vector<PageFields> verdict_cells(const Comparison& comparison, const std::string& quantity) {
    std::vector<PageFields> cells;
    for (std::size_t model = 0; model < comparison.models.size(); ++model) {
        const QuantityVerdict* verdict =
            quantity.empty() ? nullptr : &comparison.verdicts.of(model, quantity);
        const bool is_judged = verdict != nullptr && verdict->independent() > 0;
        cells.push_back({{"is_judged", is_judged},
                         {"met", is_judged ? std::to_string(verdict->independent_met) : ""},
                         {"criteria", is_judged ? std::to_string(verdict->independent()) : ""}});
    }
    return cells;
}

/// The table of a place; nothing where no model knows a figure of it.
std::optional<PageFields> table_of(const Comparison& comparison, const std::string& place,
                                   const std::vector<const ModelFigure*>& of_place) {
    std::vector<PageFields> shown;
    for (const Group& group : groups()) {
        std::vector<PageFields> rows;
        std::string quantity;
        for (const ModelFigure* figure : of_place) {
            const FigureKey& key = figure->key;
            const bool is_here = key.about == group.about &&
                                 std::find(group.quantities.begin(), group.quantities.end(), key.quantity) !=
                                     group.quantities.end();
            const bool any = std::any_of(figure->by_model.begin(), figure->by_model.end(),
                                         [](const Figure& one) { return !std::isnan(one.value); });
            if (is_here && any && is_shown(key)) {
                quantity = judged_quantity(key);
                rows.push_back(row_of_figure(*figure));
            }
        }
        if (!rows.empty()) {
            shown.push_back({{"title", page_text(group.title)},
                             {"verdicts", verdict_cells(comparison, quantity)},
                             {"rows", rows}});
        }
    }
    if (shown.empty()) {
        return std::nullopt;
    }
    std::vector<PageFields> heads;
    for (const std::string& model : comparison.models) {
        heads.push_back({{"model", model}});
    }
    return PageFields{{"place", place}, {"models", heads}, {"groups", shown}};
}

}  // namespace

std::vector<PageFields> figure_tables(const Comparison& comparison, double return_period_years) {
    std::vector<std::pair<std::string, std::string>> places;  // about, id
    std::vector<std::string> targets = targets_by_reach(comparison.figures);
    targets.resize(std::min(targets.size(), most_shown_targets));
    for (const std::string& id : targets) {
        places.emplace_back("target", id);
    }
    for (const ModelFigure& figure : comparison.figures) {
        const std::pair place{figure.key.about, figure.key.id};
        if (place.first != "target" && std::find(places.begin(), places.end(), place) == places.end()) {
            places.push_back(place);
        }
    }
    std::vector<PageFields> tables;
    for (const auto& [about, id] : places) {
        std::vector<const ModelFigure*> of_place;
        for (const ModelFigure& figure : comparison.figures) {
            if (figure.key.return_period_years == return_period_years && figure.key.about == about &&
                figure.key.id == id) {
                of_place.push_back(&figure);
            }
        }
        if (of_place.empty()) {
            continue;
        }
        const std::string& name = of_place.front()->key.name;
        const std::string title = about == "slope" ? page_text("All rocks on the slope")
                                  : about == "net" ? page_text("Net {name}", {{"name", name}})
                                                   : name;
        if (const std::optional<PageFields> table = table_of(comparison, title, of_place)) {
            tables.push_back(*table);
        }
    }
    return tables;
}

}  // namespace coupling::models
