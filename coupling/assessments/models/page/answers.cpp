#include "coupling/assessments/models/page/answers.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string_view>
#include <utility>

#include "config/text/joined.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/messages.hpp"
#include "coupling/results/text/page_text.hpp"
#include "rockfall/motion/models.hpp"

namespace coupling::models {
namespace {

using config::joined;
using report::escaped;
using report::page_text;
using report::PageFields;

constexpr std::size_t most_answered_targets = 3;

/// A figure of the first screen, on the first of its slopes that gives a range.
struct MainFigure {
    const char* about;
    const char* quantity;
    const char* statistic;
    const char* unit;
    std::vector<std::pair<const char*, const char*>> slopes;  ///< cover, sentence
};

const std::vector<MainFigure>& main_figures() {
    static const std::vector<MainFigure> figures{
        {"target", "protection_percent", "", "%", {{"", "Share of the rocks that the forest stops"}}},
        {"target",
         "reached_percent",
         "",
         "%",
         {{"forest", "Rocks that arrive with forest"}, {"bare", "Rocks that arrive over the bare slope"}}},
        {"target",
         "speed_mps",
         "p95",
         "m/s",
         {{"forest", "Speed that 95 % of the rocks that arrive with forest do not exceed"},
          {"bare", "Speed that 95 % of the rocks that arrive over the bare slope do not exceed"}}},
        {"target",
         "energy_kj",
         "p95",
         "kJ",
         {{"forest", "Energy that 95 % of the rocks that arrive with forest do not exceed"},
          {"bare", "Energy that 95 % of the rocks that arrive over the bare slope do not exceed"}}},
        {"target",
         "top_height_m",
         "p95",
         "m",
         {{"forest", "Height of the top of the rock that 95 % do not exceed with forest"},
          {"bare", "Height of the top of the rock that 95 % do not exceed over the bare slope"}}},
        {"net",
         "design_energy_kj",
         "",
         "kJ",
         {{"forest", "Design energy with forest"}, {"bare", "Design energy over the bare slope"}}},
        {"net",
         "design_height_m",
         "",
         "m",
         {{"forest", "Design height with forest"}, {"bare", "Design height over the bare slope"}}},
        {"slope",
         "run_out_m",
         "mean",
         "m",
         {{"forest", "Mean run-out with forest, of the rocks that stop on the terrain"},
          {"bare", "Mean run-out over the bare slope, of the rocks that stop on the terrain"}}}};
    return figures;
}

/// "34.5 kJ"; of shares with the sign of percent.
std::string with_its_unit(const FigureKey& key, double value, std::string_view unit) {
    return unit == "%" ? report::percent(value / 100.0) : joined(shown_value(key, value), " ", unit);
}

/// What is said of a line: its range or another opening, whether the models disagree, what judges it.
struct AnswerLine {
    std::optional<PageFields> ranged{};
    std::string opening{};  ///< behind the range, or in its place
    std::optional<PageFields> by_factor{};
    bool disagree = false;  ///< without a factor
    bool levels_disagree = false;
    std::string rest{};

    [[nodiscard]] bool is_empty() const { return !ranged && opening.empty(); }
    [[nodiscard]] PageFields fields() const {
        return {{"ranged", ranged},          {"has_opening", !opening.empty()},
                {"opening", opening},        {"by_factor", by_factor},
                {"disagree", disagree},      {"levels_disagree", levels_disagree},
                {"has_rest", !rest.empty()}, {"rest", rest}};
    }
};

/// Whether the models disagree; the sentence if they do not.
std::string add_agreement(const Range& range, AnswerLine& line) {
    constexpr double least_factor = 1.45;  // shown as 1.5: less is not worth a number [choice]
    const bool has_factor = range.factor && *range.factor >= least_factor;
    const std::string factor = has_factor ? report::fixed(*range.factor, 1) : "";
    if (range.agreement == Agreement::disagree) {
        line.by_factor = has_factor ? std::optional{PageFields{{"factor", factor}}} : std::nullopt;
        line.disagree = !has_factor;
        return "";
    }
    if (range.agreement == Agreement::agree) {
        return range.intervals == Intervals::of_all
                   ? page_text("Their intervals of all that is not known have values in common.")
                   : page_text("Their intervals of the chance in the rocks have values in common.");
    }
    return has_factor
               ? page_text(
                     "The highest is {factor} times the lowest; without an interval for each model it is not "
                     "known whether they disagree.",
                     {{"factor", factor}})
               : page_text("Without an interval for each model it is not known whether they disagree.");
}

std::string word_of_quantity(const std::string& quantity) {
    return quantity == "stops"    ? page_text("stops")
           : quantity == "speed"  ? page_text("speed")
           : quantity == "height" ? page_text("height")
                                  : page_text("energy");
}

/// Whether energies of some models count the rotation of rocks and those of others do not.
bool energies_differ(const Comparison& comparison) {
    std::vector<std::string_view> counted;
    for (const rockfall::MotionModel model : rockfall::all_models()) {
        const rockfall::ModelDescription& description = rockfall::description_of(model);
        if (std::find(comparison.models.begin(), comparison.models.end(), description.name) !=
            comparison.models.end()) {
            counted.push_back(description.energy);
        }
    }
    return std::adjacent_find(counted.begin(), counted.end(), std::not_equal_to<>{}) != counted.end();
}

/// Of these models those whose results carry a caution.
std::vector<std::string> with_caution(const Comparison& comparison, const std::vector<std::size_t>& models) {
    std::vector<std::string> names;
    for (const std::size_t model : models) {
        const std::string& name = comparison.models[model];
        const auto& all = rockfall::all_models();
        if (std::any_of(all.begin(), all.end(), [&](rockfall::MotionModel one) {
                const rockfall::ModelDescription& description = rockfall::description_of(one);
                return description.name == name && !description.caution.empty();
            })) {
            names.push_back(name);
        }
    }
    return names;
}

/// Which model is judged best on a figure, and which are not judged.
std::string judged_sentence(const Comparison& comparison, const FigureKey& key) {
    const std::string quantity = judged_quantity(key);
    if (quantity.empty()) {
        return page_text(
            "What a forest stops is not among the quantities by which field cases judge models here.");
    }
    const std::vector<std::size_t> judged = comparison.verdicts.judged_on(quantity);
    const std::vector<std::size_t> best = comparison.verdicts.best_on(quantity);
    const std::string word = word_of_quantity(quantity);
    if (judged.empty()) {
        return page_text("Field cases judge none of these models on “{quantity}”.", {{"quantity", word}});
    }
    std::vector<std::string> not_judged;
    for (std::size_t model = 0; model < comparison.models.size(); ++model) {
        if (std::find(judged.begin(), judged.end(), model) == judged.end()) {
            not_judged.push_back(comparison.models[model]);
        }
    }
    const std::string rest = not_judged.empty() ? ""
                                                : page_text("Not judged on it: {models}.",
                                                            {{"models", report::join_with_and(not_judged)}});
    if (best.empty()) {
        return report::join_sentences(
            {page_text("None of them meets half of its criteria of field cases on “{quantity}”: {models}.",
                       {{"quantity", word}, {"models", verdicts_of_models(comparison, judged, quantity)}}),
             rest});
    }
    const std::vector<std::string> cautions =
        quantity == "stops" ? with_caution(comparison, best) : std::vector<std::string>{};
    return report::join_sentences(
        {page_text("Judged best on “{quantity}”, by criteria of field cases: {models}.",
                   {{"quantity", word}, {"models", verdicts_of_models(comparison, best, quantity)}}),
         cautions.empty()
             ? ""
             : page_text("See the caution on {models} below.", {{"models", report::join_with_and(cautions)}}),
         not_judged.empty()
             ? ""
             : page_text("Not judged on it: {models}.", {{"models", report::join_with_and(not_judged)}})});
}

/// What is said of a figure; empty where no model knows it.
AnswerLine answer_of(const Comparison& comparison, const ModelFigure& figure, const MainFigure& main,
                     const char* label) {
    const FigureKey& key = figure.key;
    AnswerLine line;
    std::vector<std::string> unknown;
    std::size_t known = 0;  // the last one that is
    for (std::size_t model = 0; model < comparison.models.size(); ++model) {
        if (std::isnan(figure.by_model[model].value)) {
            unknown.push_back(comparison.models[model]);
        } else {
            known = model;
        }
    }
    if (unknown.size() == comparison.models.size()) {
        return line;
    }
    const std::optional<Range> range = range_over(figure);
    if (!range) {
        line.opening = page_text("{figure}: {value} ({model}); too few rocks under the other models.",
                                 {{"figure", page_text(label)},
                                  {"value", with_its_unit(key, figure.by_model[known].value, main.unit)},
                                  {"model", comparison.models[known]}});
        line.rest = judged_sentence(comparison, key);
        return line;
    }
    line.ranged = PageFields{{"figure", page_text(label)},
                             {"low", with_its_unit(key, range->low, main.unit)},
                             {"low_model", comparison.models[range->lowest]},
                             {"high", with_its_unit(key, range->high, main.unit)},
                             {"high_model", comparison.models[range->highest]}};
    if (!unknown.empty()) {
        line.opening =
            page_text("Too few rocks under {models}.", {{"models", report::join_with_and(unknown)}});
    }
    const std::string agreement = add_agreement(*range, line);
    line.rest =
        report::join_sentences({agreement,
                                judged_quantity(key) == "energy" && energies_differ(comparison)
                                    ? page_text("Energies of these models do not count the same: see below.")
                                    : "",
                                judged_sentence(comparison, key)});
    return line;
}

const ModelFigure* find_figure(const std::vector<const ModelFigure*>& figures, const MainFigure& main,
                               const char* cover) {
    const auto found = std::find_if(figures.begin(), figures.end(), [&](const ModelFigure* one) {
        return one->key.about == main.about && one->key.quantity == main.quantity &&
               one->key.statistic == main.statistic && one->key.cover == cover;
    });
    return found == figures.end() ? nullptr : *found;
}

/// The lines of a place: each main figure on the first slope where it has a range, else where one model
/// knows it.
std::vector<PageFields> lines_of_place(const Comparison& comparison,
                                       const std::vector<const ModelFigure*>& of_place) {
    std::vector<PageFields> lines;
    for (const MainFigure& main : main_figures()) {
        AnswerLine line;
        for (const auto& [cover, label] : main.slopes) {
            const ModelFigure* figure = find_figure(of_place, main, cover);
            if (figure == nullptr) {
                continue;
            }
            if (range_over(*figure)) {
                line = answer_of(comparison, *figure, main, label);
                break;
            }
            if (line.is_empty()) {
                line = answer_of(comparison, *figure, main, label);
            }
        }
        if (!line.is_empty()) {
            lines.push_back(line.fields());
        }
    }
    return lines;
}

/// "Level with forest: high (one model), moderate (another)."
AnswerLine level_line(const Comparison& comparison, const LevelOfModels& levels) {
    std::vector<std::string> list;
    for (std::size_t model = 0; model < comparison.models.size(); ++model) {
        const std::string& level = levels.by_model[model];
        list.push_back(
            joined(level.empty() ? "–" : report::message_html(level), " (", comparison.models[model], ")"));
    }
    AnswerLine line;
    line.opening =
        levels.cover == "forest"
            ? page_text("Level with forest: {levels}.", {{"levels", report::join_with_commas(list)}})
            : page_text("Level on the bare slope: {levels}.", {{"levels", report::join_with_commas(list)}});
    line.levels_disagree = levels_differ(levels);
    line.rest = line.levels_disagree ? "" : page_text("The models give the same level.");
    return line;
}

}  // namespace

std::string shown_value(const FigureKey& key, double value) {
    return std::isnan(value)                ? "–"
           : key.quantity == "design_class" ? report::fixed(value, 0)
                                            : report::three_digits(value);
}

std::string verdicts_of_models(const Comparison& comparison, const std::vector<std::size_t>& models,
                               const std::string& quantity) {
    std::vector<std::string> list;
    for (const std::size_t model : models) {
        const QuantityVerdict& verdict = comparison.verdicts.of(model, quantity);
        list.push_back(page_text("{quantity} {met} of {criteria}",
                                 {{"quantity", comparison.models[model]},
                                  {"met", std::to_string(verdict.independent_met)},
                                  {"criteria", std::to_string(verdict.independent())}}));
    }
    return report::join_with_commas(list);
}

std::vector<std::string> targets_by_reach(const std::vector<ModelFigure>& figures) {
    std::vector<std::pair<double, std::string>> targets;
    for (const ModelFigure& figure : figures) {
        if (figure.key.about != "target" || figure.key.quantity != "reached_percent" ||
            figure.key.cover != "bare") {
            continue;
        }
        double most = 0.0;
        for (const Figure& one : figure.by_model) {
            most = std::isnan(one.value) ? most : std::max(most, one.value);
        }
        const auto known = std::find_if(targets.begin(), targets.end(),
                                        [&](const auto& target) { return target.second == figure.key.id; });
        if (known == targets.end()) {
            targets.emplace_back(most, figure.key.id);
        } else {
            known->first = std::max(known->first, most);
        }
    }
    std::stable_sort(targets.begin(), targets.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<std::string> ids;
    for (const auto& [most, id] : targets) {
        ids.push_back(id);
    }
    return ids;
}

std::vector<PageFields> answers(const Comparison& comparison) {
    // Of a hazard map the longest return period.
    double period = 0.0;
    for (const ModelFigure& figure : comparison.figures) {
        period = std::max(period, figure.key.return_period_years);
    }
    const auto of_place = [&](const char* about, const std::string* id) {
        std::vector<const ModelFigure*> found;
        for (const ModelFigure& figure : comparison.figures) {
            if (figure.key.return_period_years == period && figure.key.about == about &&
                (id == nullptr || figure.key.id == *id)) {
                found.push_back(&figure);
            }
        }
        return found;
    };
    std::vector<PageFields> places;
    const auto add = [&](const std::string& place, std::vector<PageFields> lines) {
        if (!lines.empty()) {
            places.push_back({{"place", place},
                              {"has_period", period > 0.0},
                              {"years", report::exact(period)},
                              {"lines", std::move(lines)}});
        }
    };
    std::vector<std::string> ids = targets_by_reach(comparison.figures);
    ids.resize(std::min(ids.size(), most_answered_targets));
    for (const std::string& id : ids) {
        std::vector<PageFields> lines;
        for (const LevelOfModels& levels : comparison.levels) {
            if (levels.id == id) {
                lines.push_back(level_line(comparison, levels).fields());
            }
        }
        const std::vector<const ModelFigure*> figures = of_place("target", &id);
        const std::vector<PageFields> more = lines_of_place(comparison, figures);
        lines.insert(lines.end(), more.begin(), more.end());
        add(figures.front()->key.name, std::move(lines));
    }
    std::vector<std::string> nets;
    for (const ModelFigure* figure : of_place("net", nullptr)) {
        if (std::find(nets.begin(), nets.end(), figure->key.id) == nets.end()) {
            nets.push_back(figure->key.id);
        }
    }
    nets.resize(std::min(nets.size(), most_answered_targets));
    for (const std::string& net : nets) {
        add(page_text("Net {name}", {{"name", net}}), lines_of_place(comparison, of_place("net", &net)));
    }
    add(page_text("All rocks on the slope"), lines_of_place(comparison, of_place("slope", nullptr)));
    return places;
}

}  // namespace coupling::models
