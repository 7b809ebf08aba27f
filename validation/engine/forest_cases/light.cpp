#include <array>
#include <cmath>
#include <memory>
#include <numeric>
#include <optional>
#include <span>

#include "config/text/joined.hpp"
#include "coupling/results/text/markup.hpp"
#include "validation/engine/forest_cases/light_agreement.hpp"
#include "validation/engine/forest_cases/shared/comparison.hpp"
#include "validation/engine/forest_cases/shared/plot_checks.hpp"
#include "validation/engine/forest_cases/shared/slip_checks.hpp"

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

/// What of a reference a figure needs.
enum class Needs { nothing, energy, ground, trees, sensors };

/// A figure of the agreement on a slope.
struct LightMeasure {
    const char* name;
    const char* label;
    double LightAgreement::*value;
    Needs needs;
};
constexpr std::array<LightMeasure, 10> light_measures{
    {{"energy_direct_ratio", "direct energy / reference", &LightAgreement::energy_direct_ratio,
      Needs::energy},
     {"energy_diffuse_ratio", "diffuse energy / reference", &LightAgreement::energy_diffuse_ratio,
      Needs::energy},
     {"ground_light", "ground light", &LightAgreement::ground_light, Needs::nothing},
     {"ground_light_difference", "ground light - reference", &LightAgreement::ground_light_difference,
      Needs::ground},
     {"tree_light_correlation", "trees' light, r", &LightAgreement::tree_light_correlation, Needs::trees},
     {"tree_light_bias", "trees' light - reference", &LightAgreement::tree_light_bias, Needs::trees},
     {"tree_light_rmse", "trees' light, RMSE", &LightAgreement::tree_light_rmse, Needs::trees},
     {"sensor_correlation", "light at sensors, r", &LightAgreement::sensor_correlation, Needs::sensors},
     {"sensor_bias", "light at sensors - measured", &LightAgreement::sensor_bias, Needs::sensors},
     {"sensor_rmse", "light at sensors, RMSE", &LightAgreement::sensor_rmse, Needs::sensors}}};

bool is_known(const LightMeasure& measure, const MappedSlope& slope) {
    switch (measure.needs) {
        case Needs::energy:
            return slope.direct_mjpm2 > 0.0;
        case Needs::ground:
            return !slope.ground_light.empty();
        case Needs::trees:
            return !slope.tree_light.empty();
        case Needs::sensors:
            return !slope.sensor_light.empty();
        case Needs::nothing:
            break;
    }
    return true;
}

/// Why a figure that a slope has a reference for cannot be computed; "" where it can.
std::string why_unknown(const LightMeasure& measure, const MappedStand& stand, const MappedSlope& slope,
                        const Columns& of) {
    if (measure.value == &LightAgreement::tree_light_correlation) {
        return why_no_correlation(slope.tree_light);
    }
    if (measure.value == &LightAgreement::sensor_correlation) {
        return why_no_correlation(stand, slope, of.settings.column_m);
    }
    return "";
}

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

/// Light of single places, theirs and ours.
Plot scatter(const MappedSlope& slope, const std::string& of, const std::vector<double>& reference,
             const std::vector<double>& ours, const std::string& caption) {
    Plot plot{.title = slope_words(slope),
              .x = {joined("Light of a ", of, ", reference [-]"), 0.0, 1.0},
              .y = {joined("Light of a ", of, ", Bannwald [-]"), 0.0, 1.0},
              .series = {},
              .labels = {},
              .caption = caption};
    PlotSeries places{joined("a ", of), "tree", PlotSeries::Form::dots, {}, {}};
    for (std::size_t i = 0; i < ours.size(); ++i) {
        places.points.push_back({reference[i], ours[i]});
    }
    plot.series = {{"equal", "equal", PlotSeries::Form::line, {{0.0, 0.0}, {1.0, 1.0}}, {}},
                   std::move(places)};
    return plot;
}

std::string agreement_words(double r, double bias, double rmse) {
    return joined("r ", std::isfinite(r) ? report::fixed(r, 2) : "unknown", ", bias ", report::fixed(bias, 3),
                  ", RMSE ", report::fixed(rmse, 3));
}

/// Dots of trees and sensors, as far as the reference has them.
void add_plots(Outcome& outcome, const MappedStand& stand, const Columns& of,
               std::span<const LightAgreement> agreements) {
    PlotGroup trees{.title = joined("Light of each tree, ", of.words), .plots = {}, .small = true};
    PlotGroup sensors{.title = joined("Light at each sensor, ", of.words), .plots = {}, .small = true};
    for (std::size_t s = 0; s < stand.slopes.size(); ++s) {
        const MappedSlope& slope = stand.slopes[s];
        const LightAgreement& found = agreements[s];
        if (!slope.tree_light.empty()) {
            trees.plots.push_back(scatter(
                slope, "tree", slope.tree_light, found.tree_light,
                agreement_words(found.tree_light_correlation, found.tree_light_bias, found.tree_light_rmse)));
        }
        if (!slope.sensor_light.empty()) {
            sensors.plots.push_back(
                scatter(slope, "sensor", slope.sensor_light, found.sensor_light,
                        agreement_words(found.sensor_correlation, found.sensor_bias, found.sensor_rmse)));
        }
    }
    for (PlotGroup* group : {&trees, &sensors}) {
        if (!group->plots.empty()) {
            outcome.plots.push_back(std::move(*group));
        }
    }
}

Outcome compare(const MappedStand& stand, const LightMonths& months, const Work& work) {
    const std::size_t slopes = stand.slopes.size();
    std::vector<LightAgreement> agreements(columns().size() * slopes);
    each_piece(work, agreements.size(), [&](std::size_t piece) {
        MappedSettings settings = columns()[piece / slopes].settings;
        settings.months = months;
        agreements[piece] = compare_light(stand, stand.slopes[piece % slopes], settings);
    });
    Outcome outcome;
    PlainTable table{
        .caption = "Light relative to the open slope [-]; empty: the reference has none",
        .head = {"columns and slope", "direct energy, ratio", "diffuse energy, ratio", "ground light",
                 "reference", "tree light r", "bias", "RMSE", "sensor light r", "bias", "RMSE"},
        .rows = {}};
    for (std::size_t c = 0; c < columns().size(); ++c) {
        const Columns& of = columns()[c];
        for (std::size_t s = 0; s < slopes; ++s) {
            const MappedSlope& slope = stand.slopes[s];
            const LightAgreement& found = agreements[c * slopes + s];
            std::vector<std::string> row{joined(of.words, ", ", slope_words(slope))};
            for (const LightMeasure& measure : light_measures) {
                const bool known = is_known(measure, slope) && std::isfinite(found.*measure.value);
                if (known) {
                    outcome.values[figure_name(of, measure, slope)] = found.*measure.value;
                }
                if (measure.needs == Needs::ground) {
                    row.push_back(known ? report::fixed(mean_of(slope.ground_light), 3) : "");
                } else {
                    row.push_back(known ? report::fixed(found.*measure.value, 3) : "");
                }
            }
            table.rows.push_back(std::move(row));
        }
        add_plots(outcome, stand, of, std::span{agreements}.subspan(c * slopes, slopes));
    }
    outcome.tables.push_back(std::move(table));
    return outcome;
}

/// The months that count, from the settings.
LightMonths months_of(const LightSettings& settings) {
    if (settings.first_month > settings.last_month) {
        config::fail(config::ExitCode::settings, {},
                     joined("light.first_month ", std::to_string(settings.first_month),
                            " after light.last_month ", std::to_string(settings.last_month)),
                     "a month up to the last one");
    }
    return {static_cast<int>(settings.first_month), static_cast<int>(settings.last_month),
            settings.least_angle_deg};
}

}  // namespace

Comparison read_light(const CaseFiles& files, const LightSettings& settings) {
    const auto if_there = [&files](const char* name) {
        return files.has(name) ? std::optional{files.table(name)} : std::nullopt;
    };
    const MappedTables tables{.trees = files.table("trees.csv"),
                              .leaves = files.table("leaves.csv"),
                              .radiation = files.table("radiation.csv"),
                              .slopes = files.table("slopes.csv"),
                              .ground = if_there("ground.csv"),
                              .sensors = if_there("sensors.csv")};
    const auto stand = std::make_shared<const MappedStand>(mapped_stand(tables));
    config::Warnings warnings;
    warn_of_unknown_columns(tables, warnings);
    warn_of_shared_places(tables.trees, warnings);
    warn_of_empty_edges(tables.trees, {stand->side_m, stand->side_m}, tables.slopes.file(), warnings);
    if (tables.sensors) {
        warn_of_shared_places(*tables.sensors, warnings);
    }
    warn_of_trees(tables.trees, stand->side_m * stand->side_m / 10'000.0, warnings);
    warn_of_latitude(stand->latitude.in_degrees(), tables.slopes.place(0, "latitude_deg"), warnings);
    warn_of_radiation(
        std::accumulate(stand->radiation.direct_mjpm2.begin(), stand->radiation.direct_mjpm2.end(), 0.0) +
            std::accumulate(stand->radiation.diffuse_mjpm2.begin(), stand->radiation.diffuse_mjpm2.end(),
                            0.0),
        tables.radiation.file(), warnings);
    const LightMonths months = months_of(settings);
    Comparison comparison;
    comparison.warnings = warnings.all();
    comparison.extent = joined(
        std::to_string(stand->trees.size()), " trees on ", std::to_string(stand->slopes.size()),
        stand->slopes.size() == 1 ? " slope, in two widths of columns" : " slopes, in two widths of columns");
    for (const Columns& of : columns()) {
        for (const MappedSlope& slope : stand->slopes) {
            for (const LightMeasure& measure : light_measures) {
                if (!is_known(measure, slope)) {
                    continue;
                }
                if (std::string why = why_unknown(measure, *stand, slope, of); !why.empty()) {
                    comparison.unknown[figure_name(of, measure, slope)] = std::move(why);
                    continue;
                }
                const std::string fine = *of.prefix == '\0' ? "" : joined(", ", of.words);
                comparison.figures.push_back({figure_name(of, measure, slope),
                                              joined(measure.label, ", ", slope_words(slope), fine), "-"});
            }
            if (!slope.ground_light.empty()) {
                comparison.references[joined(of.prefix, "ground_light:", slope.name)] = {
                    mean_of(slope.ground_light), "mean of ground.csv"};
            }
        }
    }
    comparison.pieces = columns().size() * stand->slopes.size();
    comparison.run = [stand, months](const Work& work) { return compare(*stand, months, work); };
    return comparison;
}

}  // namespace coupling::validation::forest_cases
