#include "coupling/validation/field_states.hpp"

#include <memory>
#include <sstream>
#include <utility>

#include "config/table/table.hpp"
#include "config/text/joined.hpp"
#include "config/units/constants.hpp"
#include "coupling/results/report/markup.hpp"
#include "coupling/validation/field_falls.hpp"
#include "coupling/validation/unpacked_case.hpp"

namespace coupling::validation {
namespace {

using config::joined;
using config::percent;

struct State {
    std::string name;
    std::string meaning;
    OpenedField opened;
};
using States = std::vector<State>;

config::Table table_of_case(const CaseFiles& files, const std::string& name) {
    const auto text = files.texts.find(name);
    if (text == files.texts.end()) {
        config::fail(config::ExitCode::file, {files.shown(name)}, "no such file", "a table of the case");
    }
    std::istringstream in{text->second};
    return config::Table::read(in, files.shown(name));
}

States open_states(const CaseFiles& files, const FieldSettings& settings,
                   const std::vector<std::string>& overrides) {
    const UnpackedCase folder{files};
    const config::Table table = table_of_case(files, settings.states);
    config::Problems problems;
    table.require({"state", "overrides", "meaning"}, problems);
    problems.throw_if_any();
    if (table.rows() < 2) {
        config::fail(config::ExitCode::data, {table.file()}, "fewer than two states",
                     "what changes, and what it is compared with");
    }
    States states;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        std::istringstream words{table.text(row, "overrides")};
        std::vector<std::string> all{overrides};
        for (std::string word; words >> word;) {
            all.push_back(word);
        }
        states.push_back({table.text(row, "state"), table.text(row, "meaning"),
                          open_field(folder.path() / settings.scenario, all)});
    }
    return states;
}

/// A figure of a state.
std::string of_state(const char* figure, const State& state) {
    return joined(figure, ":", state.name);
}

Outcome compare_states(const States& states, bool first_impacts, const Work& work) {
    Outcome outcome;
    PlainTable table{.caption = "The same rocks in each state",
                     .head = {"state", "rocks", "mean run-out [m]", "change [%]", "pass the line [%]"},
                     .rows = {}};
    double first_m = 0.0;
    for (const State& state : states) {
        const FallenField fallen = fall_field(state.opened, work, first_impacts);
        double sum_m = 0.0;
        for (const observed::SimulatedStop& stop : fallen.stops) {
            sum_m += (stop.end_m - stop.start_m).norm();
        }
        const auto rocks = static_cast<double>(fallen.stops.size());
        const double mean_m = sum_m / rocks;
        first_m = &state == &states.front() ? mean_m : first_m;
        const double change = percent * (mean_m / first_m - 1.0);
        outcome.values[of_state("run_out_mean_m", state)] = mean_m;
        outcome.values[of_state("run_out_change_percent", state)] = change;
        if (first_impacts) {
            take_first_impacts(state.name, fallen.first_impacts, outcome);
        }
        std::string passing;
        if (!fallen.arrived.empty()) {
            const double share = percent * static_cast<double>(fallen.arrived.front()) / rocks;
            outcome.values[of_state("passing_percent", state)] = share;
            passing = report::fixed(share, 1);
        }
        table.rows.push_back({state.meaning, std::to_string(fallen.stops.size()), report::fixed(mean_m, 1),
                              report::fixed(change, 0), passing});
    }
    outcome.tables.push_back(std::move(table));
    return outcome;
}

void name_state_figures(const CaseFiles& files, const States& states, bool first_impacts,
                        Comparison& comparison) {
    for (const State& state : states) {
        comparison.figures.push_back(
            {of_state("run_out_mean_m", state), joined("mean run-out, ", state.meaning), "m"});
        comparison.figures.push_back({of_state("run_out_change_percent", state),
                                      joined("change of mean run-out, ", state.meaning), "%"});
        if (!state.opened.site.targets.empty()) {
            comparison.figures.push_back(
                {of_state("passing_percent", state), joined("rocks that pass, ", state.meaning), "%"});
        }
        if (first_impacts) {
            name_first_impacts(state.name, state.meaning, comparison);
        }
    }
    if (!files.has("observed.csv")) {
        return;
    }
    const config::Table table = table_of_case(files, "observed.csv");
    config::Problems problems;
    if (table.require({"quantity", "value", "source"}, problems)) {
        for (std::size_t row = 0; row < table.rows(); ++row) {
            const std::string& name = table.text(row, "quantity");
            const auto value = table.number(row, "value", {}, problems);
            if (comparison.figure(name).name.empty()) {
                problems.add(config::ExitCode::data, table.place(row, "quantity"), config::in_quotes(name),
                             "a figure of a state, such as run_out_change_percent:STATE");
            } else if (value) {
                comparison.references[name] = {*value, table.text(row, "source")};
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
    for (const State& state : *states) {
        comparison.pieces += state.opened.rocks();
    }
    comparison.extent =
        joined(std::to_string(states->size()), " states, ", std::to_string(states->front().opened.rocks()),
               " rocks in each, ", states->front().opened.model);
    name_state_figures(files, *states, settings.first_impacts, comparison);
    comparison.run = [states, first_impacts = settings.first_impacts](const Work& work) {
        return compare_states(*states, first_impacts, work);
    };
    return comparison;
}

}  // namespace coupling::validation
