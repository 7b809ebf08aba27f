#include "validation/engine/field/field_states.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "config/table/table.hpp"
#include "config/text/joined.hpp"
#include "config/text/words_of_list.hpp"
#include "config/units/constants.hpp"
#include "coupling/results/text/markup.hpp"
#include "validation/engine/case/unpacked_case.hpp"
#include "validation/engine/field/field_falls.hpp"
#include "validation/engine/field/field_trends.hpp"
#include "validation/engine/field/reach_figures.hpp"

namespace coupling::validation {
namespace {

using config::joined;
using config::percent;

struct State {
    std::string name;
    std::string meaning;
    std::string prefix;  ///< of the names of its figures: empty for the first preset, else "PRESET."
    OpenedField opened;
};

/// All states: those of the first preset, then the same of the next.
struct States {
    std::vector<State> all;
    std::vector<std::string> prefixes;
    std::vector<Trend> trends;

    [[nodiscard]] std::size_t of_a_preset() const { return all.size() / prefixes.size(); }
    [[nodiscard]] const State& first_with(const std::string& prefix) const {
        return *std::find_if(all.begin(), all.end(),
                             [&](const State& state) { return state.prefix == prefix; });
    }
};

States open_states(const CaseFiles& files, const FieldSettings& settings,
                   const std::vector<std::string>& overrides) {
    const UnpackedCase folder{files};
    const config::Table table = files.table(settings.states);
    config::Problems problems;
    table.require({"state", "overrides", "meaning"}, problems);
    problems.throw_if_any();
    if (table.rows() < 2) {
        config::fail(config::ExitCode::data, {table.file()}, "fewer than two states",
                     "what changes, and what it is compared with");
    }
    States states;
    if ((settings.first_impacts || settings.reach_angles) && !settings.presets.empty()) {
        config::fail(config::ExitCode::settings, {files.shown("case.ini")},
                     joined(settings.first_impacts ? "field.first_impacts" : "field.reach_angles",
                            " with field.presets"),
                     "one of them");
    }
    const auto sets_preset = [](const std::string& change) { return change.starts_with("rockfall.preset="); };
    if (!settings.presets.empty() && std::any_of(overrides.begin(), overrides.end(), sets_preset)) {
        config::fail(config::ExitCode::settings, {}, "--set rockfall.preset for a case that compares presets",
                     "no preset, or --set field.presets");
    }
    std::vector<std::string> presets = config::words_between_blanks(settings.presets);
    if (presets.empty()) {
        presets.emplace_back();
    }
    std::vector<std::string> names;
    for (const std::string& preset : presets) {
        states.prefixes.push_back(&preset == &presets.front() ? "" : joined(preset, "."));
        for (std::size_t row = 0; row < table.rows(); ++row) {
            std::vector<std::string> all{overrides};
            if (!preset.empty()) {
                all.push_back(joined("rockfall.preset=", preset));
            }
            for (std::string& change : config::words_between_blanks(table.text(row, "overrides"))) {
                all.push_back(std::move(change));
            }
            names.push_back(table.text(row, "state"));
            states.all.push_back({names.back(), table.text(row, "meaning"), states.prefixes.back(),
                                  open_field(folder.path() / settings.scenario, all)});
        }
    }
    if (!settings.trends.empty()) {
        states.trends = read_trends(files.table(settings.trends), names, problems);
        problems.throw_if_any();
    }
    return states;
}

/// A figure of a state.
std::string of_state(const char* figure, const State& state) {
    return joined(state.prefix, figure, ":", state.name);
}

/// "sliding, unity_compat".
std::string meaning_of(const State& state) {
    return state.prefix.empty()
               ? state.meaning
               : joined(state.meaning, ", ", state.prefix.substr(0, state.prefix.size() - 1));
}

using WaysOfStates = std::vector<std::vector<RockWay>>;

/// The means of a state's rocks, preset beside preset.
void add_ways(const States& states, const WaysOfStates& ways, Outcome& outcome) {
    PlainTable table{.caption = "Means over the rocks of each state", .head = {"state"}, .rows = {}};
    for (const WayFigure& figure : way_figures()) {
        for (const std::string& prefix : states.prefixes) {
            table.head.push_back(joined(figure.label, " [", figure.unit, "]", prefix.empty() ? "" : ", ",
                                        prefix.empty() ? "" : prefix.substr(0, prefix.size() - 1)));
        }
    }
    const std::size_t count = states.of_a_preset();
    for (std::size_t i = 0; i < count; ++i) {
        table.rows.push_back({states.all[i].meaning});
        for (const WayFigure& figure : way_figures()) {
            for (std::size_t place = i; place < states.all.size(); place += count) {
                double sum = 0.0;
                for (const RockWay& way : ways[place]) {
                    sum += way.*figure.value;
                }
                const double mean = sum / static_cast<double>(ways[place].size());
                outcome.values[of_state(figure.name, states.all[place])] = mean;
                table.rows.back().push_back(report::fixed(mean, 1));
            }
        }
    }
    outcome.tables.push_back(std::move(table));
}

void add_trends(const States& states, const WaysOfStates& ways, Outcome& outcome) {
    for (const std::string& prefix : states.prefixes) {
        for (const Trend& trend : states.trends) {
            const auto ways_of = [&](const std::string& name) -> std::span<const RockWay> {
                for (std::size_t i = 0; i < states.all.size(); ++i) {
                    if (states.all[i].name == name && states.all[i].prefix == prefix) {
                        return ways[i];
                    }
                }
                return {};
            };
            take_trend(trend, prefix, find_trend(trend, ways_of), outcome);
        }
    }
}

Outcome compare_states(const States& states, const FieldSettings& settings, const Work& work) {
    Outcome outcome;
    PlainTable reach = reach_table();
    PlainTable table{.caption = "The same rocks in each state",
                     .head = {"state", "rocks", "mean run-out [m]", "change [%]", "pass the line [%]"},
                     .rows = {}};
    double first_m = 0.0;
    WaysOfStates ways;
    for (const State& state : states.all) {
        FallenField fallen = fall_field(state.opened, work, settings.first_impacts);
        double sum_m = 0.0;
        for (const observed::SimulatedStop& stop : fallen.stops) {
            sum_m += (stop.end_m - stop.start_m).norm();
        }
        const auto rocks = static_cast<double>(fallen.stops.size());
        const double mean_m = sum_m / rocks;
        if (&state == &states.all.front() || state.prefix != (&state - 1)->prefix) {
            first_m = mean_m;  // of this preset
        }
        ways.push_back(std::move(fallen.ways));
        const double change = percent * (mean_m / first_m - 1.0);
        outcome.values[of_state("run_out_mean_m", state)] = mean_m;
        outcome.values[of_state("run_out_change_percent", state)] = change;
        if (settings.first_impacts) {
            take_first_impacts(state.name, fallen.first_impacts, outcome);
        }
        if (settings.reach_angles) {
            const ReachSample sample = reach_sample_of(state.opened.site.slope.terrain, fallen.stops);
            take_reach_figures(state.name, sample, outcome);
            reach.rows.push_back(reach_row(state.meaning, sample));
        }
        std::string passing;
        if (!fallen.arrived.empty()) {
            const double share = percent * static_cast<double>(fallen.arrived.front()) / rocks;
            outcome.values[of_state("passing_percent", state)] = share;
            passing = report::fixed(share, 1);
        }
        table.rows.push_back({meaning_of(state), std::to_string(fallen.stops.size()),
                              report::fixed(mean_m, 1), report::fixed(change, 0), passing});
    }
    outcome.tables.push_back(std::move(table));
    if (settings.reach_angles) {
        outcome.tables.push_back(std::move(reach));
    }
    if (!states.trends.empty()) {
        add_ways(states, ways, outcome);
        add_trends(states, ways, outcome);
    }
    return outcome;
}

/// Figures from `before` on are of the model of a state, unless a preset changed its settings.
void of_default_model(const State& state, std::size_t before, Comparison& comparison) {
    for (std::size_t i = before; i < comparison.figures.size() && state.prefix.empty(); ++i) {
        comparison.figures[i].model = state.opened.model;
    }
}

void name_state_figures(const CaseFiles& files, const States& states, const FieldSettings& settings,
                        Comparison& comparison) {
    for (const State& state : states.all) {
        const std::size_t before = comparison.figures.size();
        const std::string meaning = meaning_of(state);
        comparison.figures.push_back(
            {of_state("run_out_mean_m", state), joined("mean run-out, ", meaning), "m"});
        comparison.figures.push_back(
            {of_state("run_out_change_percent", state), joined("change of mean run-out, ", meaning), "%"});
        if (!state.opened.site.targets.empty()) {
            comparison.figures.push_back(
                {of_state("passing_percent", state), joined("rocks that pass, ", meaning), "%"});
        }
        if (settings.first_impacts) {
            name_first_impacts(state.name, meaning, comparison);
        }
        if (settings.reach_angles) {
            name_reach_figures(state.name, meaning, comparison);
        }
        if (!states.trends.empty()) {
            for (const WayFigure& figure : way_figures()) {
                comparison.figures.push_back(
                    {of_state(figure.name, state), joined(figure.label, ", ", meaning), figure.unit});
            }
        }
        of_default_model(state, before, comparison);
    }
    for (const std::string& prefix : states.prefixes) {
        for (const Trend& trend : states.trends) {
            const std::size_t before = comparison.figures.size();
            name_trend(trend, prefix, comparison);
            of_default_model(states.first_with(prefix), before, comparison);
        }
    }
    if (!files.has("observed.csv")) {
        return;
    }
    const config::Table table = files.table("observed.csv");
    config::Problems problems;
    if (table.require({"quantity", "value", "source"}, problems)) {
        for (std::size_t row = 0; row < table.rows(); ++row) {
            const std::string& name = table.text(row, "quantity");
            const auto value = table.number(row, "value", {}, problems);
            if (comparison.figure(name).name.empty()) {
                problems.add(config::ExitCode::data, table.place(row, "quantity"), config::in_quotes(name),
                             "a figure of a state, such as run_out_change_percent:STATE");
            } else if (value) {
                for (const std::string& prefix : states.prefixes) {
                    comparison.references[joined(prefix, name)] = {*value, table.text(row, "source")};
                }
            }
        }
    }
    problems.throw_if_any();
}

}  // namespace

Comparison read_states(const CaseFiles& files, const FieldSettings& settings,
                       const std::vector<std::string>& overrides) {
    auto states = std::make_shared<const States>(open_states(files, settings, overrides));
    Comparison comparison;
    for (const State& state : states->all) {
        comparison.pieces += state.opened.rocks();
    }
    comparison.extent = joined(std::to_string(states->all.size()), " states, ",
                               std::to_string(states->all.front().opened.rocks()), " rocks in each, ",
                               states->all.front().opened.model);
    name_state_figures(files, *states, settings, comparison);
    comparison.run = [states, settings](const Work& work) { return compare_states(*states, settings, work); };
    return comparison;
}

}  // namespace coupling::validation
