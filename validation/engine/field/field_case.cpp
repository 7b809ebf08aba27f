#include "validation/engine/field/field_case.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string_view>
#include <utility>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/observed/stops.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/text/markup.hpp"
#include "rockfall/motion/models.hpp"
#include "validation/engine/case/unpacked_case.hpp"
#include "validation/engine/field/field_events.hpp"
#include "validation/engine/field/field_falls.hpp"

namespace coupling::validation {
namespace {

using config::joined;
using observed::EventComparison;
using observed::StopComparison;
using observed::StopFigures;

/// A figure of the stops of a group.
struct Measure {
    const char* name;
    const char* label;
    const char* unit;
    double (*value)(const StopFigures& figures);  ///< null: a distance between both sides
    double (*distance)(const StopComparison& comparison);
};

constexpr std::array measures{
    Measure{"run_out_mean_m", "mean run-out", "m", [](const StopFigures& f) { return f.mean_m; }, nullptr},
    Measure{"run_out_deviation_m", "standard deviation of run-outs", "m",
            [](const StopFigures& f) { return f.deviation_m; }, nullptr},
    Measure{"run_out_p10_m", "10 % of run-outs", "m", [](const StopFigures& f) { return f.quantiles_m[0]; },
            nullptr},
    Measure{"run_out_p25_m", "25 % of run-outs", "m", [](const StopFigures& f) { return f.quantiles_m[1]; },
            nullptr},
    Measure{"run_out_p50_m", "median of run-outs", "m", [](const StopFigures& f) { return f.quantiles_m[2]; },
            nullptr},
    Measure{"run_out_p75_m", "75 % of run-outs", "m", [](const StopFigures& f) { return f.quantiles_m[3]; },
            nullptr},
    Measure{"run_out_p90_m", "90 % of run-outs", "m", [](const StopFigures& f) { return f.quantiles_m[4]; },
            nullptr},
    Measure{"run_out_longest_m", "longest run-out", "m", [](const StopFigures& f) { return f.longest_m; },
            nullptr},
    Measure{"sideways_deviation_m", "spread beside the axis", "m",
            [](const StopFigures& f) { return f.sideways_m; }, nullptr},
    Measure{"ks", "distance of the distributions (KS)", "-", nullptr,
            [](const StopComparison& c) { return c.largest_distance; }},
    Measure{"energy_distance_m", "energy distance of the distributions", "m", nullptr,
            [](const StopComparison& c) { return c.energy_distance_m; }},
};

/// "run_out_mean_m", "MODEL.run_out_mean_m:block 1": the model that the scenario itself names has no prefix.
std::string figure_name(const std::string& model, const Measure& measure, const std::string& group) {
    return joined(model, model.empty() ? "" : ".", measure.name, group.empty() ? "" : ":", group);
}

std::string label_of(const std::string& model, const Measure& measure, const std::string& group) {
    return joined(measure.label, group.empty() ? "" : ", ", group, model.empty() ? "" : ", ", model);
}

PlotSeries curve(const std::string& name, const std::string& style, const std::vector<double>& run_out_m) {
    constexpr std::size_t most_points = 300;
    const std::size_t step = std::max<std::size_t>(1, run_out_m.size() / most_points);
    const auto count = static_cast<double>(run_out_m.size());
    PlotSeries series{name, style, PlotSeries::Form::line, {{run_out_m.front(), 0.0}}, {}};
    for (std::size_t i = 0; i < run_out_m.size(); i += step) {
        series.points.push_back({run_out_m[i], static_cast<double>(i) / count});
        series.points.push_back({run_out_m[i], static_cast<double>(i + 1) / count});
    }
    series.points.push_back({run_out_m.back(), 1.0});
    return series;
}

/// Comparisons of one model, group by group.
struct ModelStops {
    std::string model;
    std::vector<StopComparison> groups;
    std::vector<EventComparison> events;
};

Plot plot_of(const std::vector<ModelStops>& models, std::size_t group) {
    const StopComparison& first = models.front().groups[group];
    double longest_m = first.observed_run_out_m.back();
    for (const ModelStops& model : models) {
        longest_m = std::max(longest_m, model.groups[group].simulated_run_out_m.back());
    }
    Plot plot{.title = joined("Run-out, ", first.group.empty() ? "all stops" : first.group),
              .x = report::Axis::from_zero("Plan distance from release to stop [m]", longest_m),
              .y = {"Share that stops within it [-]", 0.0, 1.0},
              .series = {},
              .labels = {},
              .caption = ""};
    plot.series.push_back(curve("observed", "strict", first.observed_run_out_m));
    constexpr std::array styles{"default", "other1", "other2", "other3"};
    for (std::size_t i = 0; i < models.size(); ++i) {
        plot.series.push_back(curve(models[i].model, styles[std::min(i, styles.size() - 1)],
                                    models[i].groups[group].simulated_run_out_m));
        plot.caption += joined(i == 0 ? "KS: " : ", ", models[i].model, " ",
                               report::fixed(models[i].groups[group].largest_distance, 2));
    }
    plot.caption +=
        joined("; 5 % of samples of one distribution exceed ", report::fixed(first.distance_by_chance, 2));
    return plot;
}

PlainTable table_of(const std::vector<ModelStops>& models) {
    PlainTable table{
        .caption = "Observed and simulated stops", .head = {"stops", "figure", "observed"}, .rows = {}};
    for (const ModelStops& model : models) {
        table.head.push_back(model.model);
    }
    for (std::size_t group = 0; group < models.front().groups.size(); ++group) {
        const StopComparison& first = models.front().groups[group];
        for (const Measure& measure : measures) {
            std::vector<std::string> row{
                first.group.empty() ? "all" : first.group, joined(measure.label, " [", measure.unit, "]"),
                measure.value != nullptr ? report::fixed(measure.value(first.observed), 1) : ""};
            for (const ModelStops& model : models) {
                const StopComparison& one = model.groups[group];
                row.push_back(measure.value != nullptr ? report::fixed(measure.value(one.simulated), 1)
                                                       : report::fixed(measure.distance(one), 2));
            }
            table.rows.push_back(std::move(row));
        }
    }
    return table;
}

/// The models whose rocks fall on one opened scenario each, the scenario's own first.
using AllOpened = std::vector<OpenedField>;

/// Figures of the scenario's own model bear no prefix.
std::string prefix_of(const AllOpened& all, std::size_t place) {
    return place == 0 ? "" : all[place].model;
}

/// Parts of the rocks, each with as many as were observed, and how far their figures scatter.
void take_deviations(const OpenedField& opened, const std::vector<observed::SimulatedStop>& stops,
                     Outcome& outcome) {
    constexpr std::size_t most_parts = 60;
    const std::size_t observed = opened.site.observed_stops.size();
    const std::size_t parts = observed == 0 ? 0 : std::min(most_parts, stops.size() / observed);
    std::map<std::string, std::vector<double>> values;
    for (std::size_t part = 0; part < parts; ++part) {
        std::vector<observed::SimulatedStop> some;
        // Rocks of a release follow one another: each part has its share of every release.
        for (std::size_t i = part; i < stops.size(); i += stops.size() / observed) {
            some.push_back(stops[i]);
        }
        for (const StopComparison& group : observed::compare_stops(opened.site.observed_stops, some)) {
            for (const Measure& measure : measures) {
                if (measure.value != nullptr) {
                    values[figure_name("", measure, group.group)].push_back(measure.value(group.simulated));
                }
            }
        }
    }
    for (const auto& [name, of_parts] : values) {
        double mean = 0.0;
        double squares = 0.0;
        for (std::size_t i = 0; i < of_parts.size(); ++i) {
            const double off = of_parts[i] - mean;
            mean += off / static_cast<double>(i + 1);
            squares += off * (of_parts[i] - mean);
        }
        if (of_parts.size() > 2) {
            outcome.deviations[name] = std::sqrt(squares / static_cast<double>(of_parts.size() - 1));
        }
    }
}

Outcome compare(const AllOpened& all, const Work& work) {
    std::vector<ModelStops> models;
    Outcome outcome;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (i > 0 && work.draw) {
            break;  // bands are those of the scenario's own model
        }
        FallenField fallen = fall_field(all[i], work);
        if (i == 0 && work.deviations) {
            take_deviations(all[i], fallen.stops, outcome);
        }
        models.push_back({all[i].model, observed::compare_stops(all[i].site.observed_stops, fallen.stops),
                          std::move(fallen.events)});
        take_event_values(prefix_of(all, i), models.back().events, outcome);
        if (models.back().groups.empty() && !all[i].site.observed_stops.empty()) {
            config::fail(config::ExitCode::data, {}, joined("no rock that starts, under ", all[i].model),
                         "rocks to compare");
        }
        for (const StopComparison& group : models.back().groups) {
            for (const Measure& measure : measures) {
                outcome.values[figure_name(prefix_of(all, i), measure, group.group)] =
                    measure.value != nullptr ? measure.value(group.simulated) : measure.distance(group);
            }
        }
    }
    if (!models.front().groups.empty()) {
        PlotGroup plots{.title = "Run-out", .plots = {}, .small = false};
        for (std::size_t group = 0; group < models.front().groups.size(); ++group) {
            plots.plots.push_back(plot_of(models, group));
        }
        outcome.plots.push_back(std::move(plots));
        outcome.tables.push_back(table_of(models));
    }
    if (std::vector<ModelEvents> of_models; !models.front().events.empty()) {
        for (const ModelStops& model : models) {
            of_models.push_back({model.model, model.events});
        }
        outcome.tables.push_back(events_table(of_models));
    }
    return outcome;
}

OpenedField open_observed(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                          const std::string& model) {
    std::vector<std::string> all{overrides};
    if (!model.empty()) {
        all.push_back(joined("rockfall.motion=", model));
    }
    OpenedField opened = open_field(file, all);
    if (opened.site.observed_stops.empty() && opened.site.observed_events.empty()) {
        config::fail(config::ExitCode::settings, opened.scenario->options->place_of("observed.stops"),
                     "neither observed.stops nor observed.passages nor observed.impacts",
                     "a table of what was observed");
    }
    return opened;
}

/// Of the groups and of all of them; what the reference says of each.
void name_figures(const AllOpened& all, Comparison& comparison) {
    // Without simulated rocks a group cannot be put together: sources stand in for their rocks.
    std::vector<observed::SimulatedStop> starts;
    const Eigen::Vector2d origin_m = all.front().site.origin_m();
    for (const rockfall::ReleaseSource& source : all.front().site.sources) {
        const Eigen::Vector2d middle_m = 0.5 * (source.first_m + source.last_m) + origin_m;
        starts.push_back({middle_m, middle_m, source.zone, false});
    }
    const std::vector<StopComparison> groups =
        observed::compare_stops(all.front().site.observed_stops, starts);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const std::string prefix = prefix_of(all, i);
        for (const StopComparison& group : groups) {
            for (const Measure& measure : measures) {
                const std::string name = figure_name(prefix, measure, group.group);
                const bool is_first = &measure == &measures.front();
                const bool listed = group.group.empty() && (prefix.empty() || is_first);
                comparison.figures.push_back(
                    {name, label_of(prefix, measure, group.group), measure.unit, listed, all[i].model});
                if (measure.value != nullptr) {
                    comparison.references[name] = {measure.value(group.observed), "observed.stops"};
                }
            }
        }
    }
}

}  // namespace

Comparison read_field(const CaseFiles& files, const FieldSettings& settings,
                      const std::vector<std::string>& overrides, std::vector<std::string>& notes) {
    const UnpackedCase folder{files};
    const std::filesystem::path file = folder.path() / settings.scenario;
    auto all = std::make_shared<AllOpened>();
    all->push_back(open_observed(file, overrides, ""));
    for (const rockfall::MotionModel model : rockfall::all_models()) {
        const std::string name{rockfall::description_of(model).name};
        if (name == all->front().model) {
            continue;
        }
        try {
            all->push_back(open_observed(file, overrides, name));
        } catch (const config::InputError& error) {
            notes.push_back(joined(name, " left out: ", error.what()));
        }
    }
    Comparison comparison;
    for (const OpenedField& opened : *all) {
        comparison.pieces += opened.rocks();
    }
    const Site& first = all->front().site;
    comparison.extent =
        joined(std::to_string(first.observed_stops.size()), " observed stops, ",
               first.observed_events.empty()
                   ? ""
                   : joined(std::to_string(first.observed_events.passages.size()), " passages, ",
                            std::to_string(first.observed_events.impacts.size()), " impacts, "),
               std::to_string(all->front().rocks()), " rocks for each of ", std::to_string(all->size()),
               " motion models");
    if (!first.observed_stops.empty()) {
        name_figures(*all, comparison);
    }
    for (std::size_t i = 0; i < all->size(); ++i) {
        name_event_figures(prefix_of(*all, i), (*all)[i].site, (*all)[i].model, comparison);
    }
    comparison.run = [all](const Work& work) { return compare(*all, work); };
    return comparison;
}

}  // namespace coupling::validation
