#include "coupling/assessments/models/tables.hpp"

#include <optional>

#include "config/text/joined.hpp"
#include "coupling/results/tables/table_of.hpp"

namespace coupling::models {
namespace {

using config::joined;

constexpr const char* of_runs = "summary.json and nets.csv of the run of each model";
constexpr const char* of_calls = "order of the call";
constexpr const char* of_field_cases = "config/data/model_verdicts.csv";
constexpr const char* as_quantity = "as the quantity says";

/// A figure under one model.
struct FigureOfModel {
    const FigureKey& key;
    const Figure& figure;
    const std::string& model;
    const QuantityVerdict* verdict;  ///< nullptr where field cases do not judge such a figure
};

/// A figure over the models.
struct RangeRow {
    const FigureKey& key;
    Range range;
    const Comparison& comparison;
};

/// The level at a target under one model.
struct LevelRow {
    const LevelOfModels& levels;
    std::size_t model;
    const Comparison& comparison;
};

ColumnsOf<FigureKey> key_columns() {
    return {{"return_period_years", as_given, "return period of a hazard map; empty without one", of_runs,
             [](const FigureKey& key) {
                 return key.return_period_years > 0.0 ? std::optional{key.return_period_years} : std::nullopt;
             }},
            {"about", "target, slope or net", of_runs, &FigureKey::about},
            {"id", "id of the target or name of the net; empty for the slope", of_runs, &FigureKey::id},
            {"name", "name of the target or net", of_runs, &FigureKey::name},
            {"cover", "forest or bare; empty for what compares both", of_runs, &FigureKey::cover},
            {"quantity", "the figure, its unit at the end", of_runs, &FigureKey::quantity},
            {"statistic", "mean, p50 (median) to p99 (percentiles) or max; empty for shares and designs",
             of_runs, &FigureKey::statistic}};
}

TableOf<FigureOfModel> models_table() {
    constexpr const char* rocks = "end of the 95 % interval of the chance in the rocks alone";
    constexpr const char* all = "end of the 95 % interval with what is not known of ground and trees";
    const auto criteria = [](const auto& of_verdict) {
        return [of_verdict](const FigureOfModel& row) {
            return row.verdict == nullptr ? std::nullopt : std::optional{of_verdict(*row.verdict)};
        };
    };
    return {"models.csv",
            "",
            "a figure under one motion model (written by `bannwald run --motion NAME,NAME`)",
            {{key_columns(), [](const auto& row) -> const FigureKey& { return row.key; }},
             {"model", "motion model", of_calls, [](const auto& row) { return &row.model; }},
             {"value", as_quantity, as_given, "the figure; empty where too few rocks arrive", of_runs,
              [](const auto& row) { return row.figure.value; }},
             {"low_rocks", as_quantity, as_given, joined("lower ", rocks), of_runs,
              [](const auto& row) { return row.figure.of_rocks.low; }},
             {"high_rocks", as_quantity, as_given, joined("upper ", rocks), of_runs,
              [](const auto& row) { return row.figure.of_rocks.high; }},
             {"low_all", as_quantity, as_given, joined("lower ", all), of_runs,
              [](const auto& row) { return row.figure.of_all.low; }},
             {"high_all", as_quantity, as_given, joined("upper ", all), of_runs,
              [](const auto& row) { return row.figure.of_all.high; }},
             {"judged_quantity", "what field cases judge of it; empty: no field case judges such a figure",
              of_field_cases, [](const auto& row) { return judged_quantity(row.key); }},
             {"criteria_met", "independent criteria of the quantity that the model meets", of_field_cases,
              criteria([](const QuantityVerdict& one) { return one.independent_met; })},
             {"criteria", "independent criteria of the quantity; 0: the model was not judged on it",
              of_field_cases, criteria([](const QuantityVerdict& one) { return one.independent(); })}}};
}

std::string best_of(const RangeRow& row) {
    const std::string quantity = judged_quantity(row.key);
    std::string names;
    if (!quantity.empty()) {
        for (const std::size_t model : row.comparison.verdicts.best_on(quantity)) {
            names += joined(names.empty() ? "" : " ", row.comparison.models[model]);
        }
    }
    return names;
}

TableOf<RangeRow> ranges_table() {
    constexpr const char* derived = "models.csv";
    return {
        "model_ranges.csv",
        "",
        "a figure over the motion models that know it (written by `bannwald run --motion NAME,NAME`)",
        {{key_columns(), [](const auto& row) -> const FigureKey& { return row.key; }},
         {"lowest", as_quantity, as_given, "the lowest value of a model", derived,
          [](const auto& row) { return row.range.low; }},
         {"lowest_model", "the model with it", derived,
          [](const auto& row) { return row.comparison.models[row.range.lowest]; }},
         {"highest", as_quantity, as_given, "the highest value of a model", derived,
          [](const auto& row) { return row.range.high; }},
         {"highest_model", "the model with it", derived,
          [](const auto& row) { return row.comparison.models[row.range.highest]; }},
         {"factor", 3, "highest / lowest; empty where the lowest is 0", derived,
          [](const auto& row) { return row.range.factor; }},
         {"models_disagree",
          "yes: the intervals of two models have no value in common; empty: a model has no interval", derived,
          [](const auto& row) {
              return row.range.agreement == Agreement::not_known
                         ? std::nullopt
                         : std::optional{row.range.agreement == Agreement::disagree};
          }},
         {"intervals", "those that were held against each other: rocks, all, or empty", derived,
          [](const auto& row) -> std::string {
              return row.range.intervals == Intervals::of_all     ? "all"
                     : row.range.intervals == Intervals::of_rocks ? "rocks"
                                                                  : "";
          }},
         {"judged_quantity", "what field cases judge of it; empty: no field case judges such a figure",
          of_field_cases, [](const auto& row) { return judged_quantity(row.key); }},
         {"judged_best",
          "models that meet the largest share of their independent criteria in it, at least half of them; "
          "blanks "
          "between names",
          of_field_cases, best_of}}};
}

TableOf<LevelRow> levels_table() {
    constexpr const char* of_maps = "summary.json of the hazard map of each model";
    return {"model_levels.csv",
            "",
            "a target on a slope under one motion model (of hazard maps)",
            {{"target_id", "target", of_maps, [](const auto& row) { return row.levels.id; }},
             {"name", "name of the target", of_maps, [](const auto& row) { return row.levels.name; }},
             {"cover", "forest or bare", of_maps, [](const auto& row) { return row.levels.cover; }},
             {"model", "motion model", of_calls,
              [](const auto& row) { return row.comparison.models[row.model]; }},
             {"level", "none, residual, low, moderate or high, by hazard.rule", of_maps,
              [](const auto& row) { return row.levels.by_model[row.model]; }}}};
}

}  // namespace

const std::vector<TableLayout>& models_layouts() {
    static const std::vector<TableLayout> layouts{models_table(), ranges_table(), levels_table()};
    return layouts;
}

void write_models(std::ostream& out, const Comparison& comparison) {
    models_table().write_to(out, [&](auto& rows) {
        for (const ModelFigure& figure : comparison.figures) {
            const std::string quantity = judged_quantity(figure.key);
            for (std::size_t model = 0; model < comparison.models.size(); ++model) {
                rows.add({figure.key, figure.by_model[model], comparison.models[model],
                          quantity.empty() ? nullptr : &comparison.verdicts.of(model, quantity)});
            }
        }
    });
}

void write_ranges(std::ostream& out, const Comparison& comparison) {
    ranges_table().write_to(out, [&](auto& rows) {
        for (const ModelFigure& figure : comparison.figures) {
            if (const std::optional<Range> range = range_over(figure)) {
                rows.add({figure.key, *range, comparison});
            }
        }
    });
}

void write_levels(std::ostream& out, const Comparison& comparison) {
    levels_table().write_to(out, [&](auto& rows) {
        for (const LevelOfModels& levels : comparison.levels) {
            for (std::size_t model = 0; model < comparison.models.size(); ++model) {
                rows.add({levels, model, comparison});
            }
        }
    });
}

}  // namespace coupling::models
