#include <array>
#include <cmath>
#include <memory>

#include "config/text/joined.hpp"
#include "coupling/results/report/markup.hpp"
#include "coupling/validation/forest_cases/comparison.hpp"
#include "coupling/validation/forest_cases/mapped_stand.hpp"

namespace coupling::validation::forest_cases {
namespace {

using config::joined;

/// Columns as wide as the model's own, and finer ones.
struct Columns {
    const char* prefix;  ///< of the names of figures
    const char* words;
    MappedSettings settings;
};

const std::array<Columns, 2>& columns() {
    static const std::array<Columns, 2> both{
        {{"", "10 m columns", {}},
         {"fine_",
          "5 m columns",
          {.column_m = 5.0, .extinction = forest::effective_extinction_of_5m, .ground_points = 2}}}};
    return both;
}

/// A figure of the agreement on a slope.
struct LightMeasure {
    const char* name;
    const char* label;
    double LightAgreement::*value;
};
constexpr std::array<LightMeasure, 7> light_measures{
    {{"energy_direct_ratio", "direct energy / reference", &LightAgreement::energy_direct_ratio},
     {"energy_diffuse_ratio", "diffuse energy / reference", &LightAgreement::energy_diffuse_ratio},
     {"ground_light", "ground light", &LightAgreement::ground_light},
     {"ground_light_difference", "ground light - reference", &LightAgreement::ground_light_difference},
     {"tree_light_correlation", "trees' light, r", &LightAgreement::tree_light_correlation},
     {"tree_light_bias", "trees' light - reference", &LightAgreement::tree_light_bias},
     {"tree_light_rmse", "trees' light, RMSE", &LightAgreement::tree_light_rmse}}};

std::string figure_name(const Columns& of, const LightMeasure& measure, const MappedSlope& slope) {
    return joined(of.prefix, measure.name, ":", slope.name);
}

/// "35 deg south": the slope and where it faces.
std::string slope_words(const MappedSlope& slope) {
    static const std::array<const char*, 8> ways{"north", "north-east", "east", "south-east",
                                                 "south", "south-west", "west", "north-west"};
    const auto way = static_cast<std::size_t>(std::lround(slope.aspect.in_degrees() / 45.0)) % ways.size();
    return joined(report::tick_text(slope.slope.in_degrees()), " deg ", ways[way]);
}

double mean_of(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values) {
        sum += value;
    }
    return sum / static_cast<double>(values.size());
}

Plot scatter(const MappedSlope& slope, const LightAgreement& agreement) {
    Plot plot{.title = slope_words(slope),
              .x = {"Light of a tree, reference [-]", 0.0, 1.0},
              .y = {"Light of a tree, Bannwald [-]", 0.0, 1.0},
              .series = {},
              .labels = {},
              .caption = joined("r ", report::fixed(agreement.tree_light_correlation, 2), ", bias ",
                                report::fixed(agreement.tree_light_bias, 3), ", RMSE ",
                                report::fixed(agreement.tree_light_rmse, 3))};
    PlotSeries trees{"a tree", "tree", PlotSeries::Form::dots, {}, {}};
    for (std::size_t i = 0; i < agreement.tree_light.size(); ++i) {
        trees.points.push_back({slope.tree_light[i], agreement.tree_light[i]});
    }
    plot.series = {{"equal", "equal", PlotSeries::Form::line, {{0.0, 0.0}, {1.0, 1.0}}, {}},
                   std::move(trees)};
    return plot;
}

Outcome compare(const MappedStand& stand, const Work& work) {
    const std::size_t slopes = stand.slopes.size();
    std::vector<LightAgreement> agreements(columns().size() * slopes);
    each_piece(work, agreements.size(), [&](std::size_t piece) {
        agreements[piece] =
            compare_light(stand, stand.slopes[piece % slopes], columns()[piece / slopes].settings);
    });
    Outcome outcome;
    PlainTable table{.caption = "Light relative to the open slope [-]",
                     .head = {"columns and slope", "direct energy, ratio", "diffuse energy, ratio",
                              "ground light", "reference", "tree light r", "bias", "RMSE"},
                     .rows = {}};
    for (std::size_t c = 0; c < columns().size(); ++c) {
        const Columns& of = columns()[c];
        PlotGroup group{.title = joined("Light of each tree, ", of.words), .plots = {}, .small = true};
        for (std::size_t s = 0; s < slopes; ++s) {
            const MappedSlope& slope = stand.slopes[s];
            const LightAgreement& found = agreements[c * slopes + s];
            for (const LightMeasure& measure : light_measures) {
                outcome.values[figure_name(of, measure, slope)] = found.*measure.value;
            }
            group.plots.push_back(scatter(slope, found));
            table.rows.push_back(
                {joined(of.words, ", ", slope_words(slope)), report::fixed(found.energy_direct_ratio, 3),
                 report::fixed(found.energy_diffuse_ratio, 3), report::fixed(found.ground_light, 3),
                 report::fixed(mean_of(slope.ground_light), 3),
                 report::fixed(found.tree_light_correlation, 2), report::fixed(found.tree_light_bias, 3),
                 report::fixed(found.tree_light_rmse, 3)});
        }
        outcome.plots.push_back(std::move(group));
    }
    outcome.tables.push_back(std::move(table));
    return outcome;
}

}  // namespace

Comparison read_light(const CaseFiles& files) {
    const auto stand = std::make_shared<const MappedStand>(mapped_stand(
        table_of(files, "trees.csv"), table_of(files, "ground.csv"), table_of(files, "leaves.csv"),
        table_of(files, "radiation.csv"), table_of(files, "slopes.csv")));
    Comparison comparison;
    comparison.extent = joined(std::to_string(stand->trees.size()), " trees on ",
                               std::to_string(stand->slopes.size()), " slopes, in two widths of columns");
    for (const Columns& of : columns()) {
        for (const MappedSlope& slope : stand->slopes) {
            for (const LightMeasure& measure : light_measures) {
                const std::string fine = *of.prefix == '\0' ? "" : joined(", ", of.words);
                comparison.figures.push_back({figure_name(of, measure, slope),
                                              joined(measure.label, ", ", slope_words(slope), fine), "-"});
            }
            comparison.references[joined(of.prefix, "ground_light:", slope.name)] = {
                mean_of(slope.ground_light), "mean of ground.csv"};
        }
    }
    comparison.pieces = columns().size() * stand->slopes.size();
    comparison.run = [stand](const Work& work) { return compare(*stand, work); };
    return comparison;
}

}  // namespace coupling::validation::forest_cases
