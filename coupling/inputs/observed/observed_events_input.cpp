#include "coupling/inputs/observed/observed_events_input.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "rockfall/slope/slope.hpp"
#include "rockfall/tally/target.hpp"

namespace coupling {
namespace {

using config::joined;

constexpr config::NumberRange seen_speeds{.low = 0.0, .high = 200.0};
constexpr config::NumberRange seen_heights{.low = 0.0, .high = 1000.0};
constexpr config::NumberRange seen_energies{.low = 0.0, .high = 1e9};
constexpr config::NumberRange seen_angles{.low = -90.0, .high = 90.0};
constexpr config::NumberRange ground_codes{.low = 0.0, .high = 1e6};

std::optional<double> field_of(const config::Table& table, std::size_t row, const char* column,
                               const config::NumberRange& range, config::Problems& problems) {
    return has_value(table, row, column) ? table.number(row, column, range, problems) : std::nullopt;
}

std::string group_of(const config::Table& table, std::size_t row) {
    return table.has("group") ? table.text(row, "group") : "";
}

void show(config::Problems& problems, const std::string& file) {
    config::Problems shown;
    add_first(shown, problems, file);
    shown.throw_if_any();
}

void refuse_empty_row(const config::Table& table, std::size_t row, const char* wanted,
                      config::Problems& problems) {
    problems.add(config::ExitCode::data, table.place(row, table.columns().front()), "a row without a figure",
                 joined("at least one of ", wanted), "remove the row, or fill in what was measured");
}

std::vector<ObservedPassage> read_passages(std::span<const rockfall::Target> targets, Reading& reading) {
    const config::Table table =
        reading.table("observed.passages", "observed_passages", reading.scenario().observed_passages);
    config::Problems problems;
    table.require({"target_id"}, problems);
    problems.throw_if_any();
    std::vector<std::string> names;
    for (const rockfall::Target& target : targets) {
        names.push_back(target.id);
    }
    std::vector<ObservedPassage> passages;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const std::string& id = table.text(row, "target_id");
        const auto target = std::find(names.begin(), names.end(), id);
        if (target == names.end()) {
            const std::string nearest = config::nearest_word(id, names);
            problems.add(
                config::ExitCode::data, table.place(row, "target_id"),
                joined("target_id ", config::in_quotes(id)),
                joined("a target of targets.file", nearest.empty() ? "" : joined(" (", nearest, "?)")),
                "add the target as a line or area, or correct its name");
            continue;
        }
        ObservedPassage passage;
        passage.target = static_cast<std::uint32_t>(target - names.begin());
        passage.speed_mps = field_of(table, row, "speed_mps", seen_speeds, problems);
        passage.height_m = field_of(table, row, "height_m", seen_heights, problems);
        passage.energy_kj = field_of(table, row, "energy_kj", seen_energies, problems);
        passage.translational_kj = field_of(table, row, "translational_kj", seen_energies, problems);
        passage.group = group_of(table, row);
        // Nothing measured: the rock still counts among those that passed.
        passages.push_back(std::move(passage));
    }
    show(problems, table.file());
    return passages;
}

std::vector<ObservedImpact> read_impacts(Reading& reading) {
    const config::Table table =
        reading.table("observed.impacts", "observed_impacts", reading.scenario().observed_impacts);
    config::Problems problems;
    std::vector<ObservedImpact> impacts;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        ObservedImpact impact;
        if (has_value(table, row, "ground")) {
            const auto code = table.whole(row, "ground", ground_codes, problems);
            impact.ground = static_cast<int>(code.value_or(0));
        }
        impact.speed_in_mps = field_of(table, row, "speed_in_mps", seen_speeds, problems);
        impact.speed_out_mps = field_of(table, row, "speed_out_mps", seen_speeds, problems);
        impact.angle_in_deg = field_of(table, row, "angle_in_deg", seen_angles, problems);
        impact.angle_out_deg = field_of(table, row, "angle_out_deg", seen_angles, problems);
        impact.group = group_of(table, row);
        if (!impact.speed_in_mps && !impact.speed_out_mps && !impact.angle_in_deg && !impact.angle_out_deg) {
            refuse_empty_row(table, row, "speed_in_mps, speed_out_mps, angle_in_deg, angle_out_deg",
                             problems);
        }
        impacts.push_back(std::move(impact));
    }
    if (impacts.empty()) {
        problems.add(config::ExitCode::data, {table.file()}, "no impacts", "at least one row");
    }
    show(problems, table.file());
    return impacts;
}

}  // namespace

std::optional<ObservedEvents> read_observed_events(std::span<const rockfall::Target> targets,
                                                   Reading& reading) {
    const Scenario& scenario = reading.scenario();
    return reading.attempt([&] {
        ObservedEvents events;
        events.rocks = scenario.observed_rocks;
        if (!scenario.observed_passages.empty()) {
            events.passages = read_passages(targets, reading);
        }
        if (!scenario.observed_impacts.empty()) {
            events.impacts = read_impacts(reading);
        }
        if (events.rocks > 0 && events.passages.size() > events.rocks * targets.size()) {
            config::fail(config::ExitCode::settings, scenario.options->place_of("observed.rocks"),
                         joined("observed.rocks ", std::to_string(events.rocks), " for ",
                                counted(events.passages.size(), "passage")),
                         "not fewer rocks than passed a target", "count all rocks that were released");
        }
        return events;
    });
}

void check_observed_grounds(const ObservedEvents& events, std::span<const rockfall::SurfaceType> types,
                            Reading& reading) {
    std::set<int> unknown;
    for (const ObservedImpact& impact : events.impacts) {
        const bool is_known =
            !impact.ground || std::any_of(types.begin(), types.end(), [&](const rockfall::SurfaceType& type) {
                return type.code == *impact.ground;
            });
        if (!is_known) {
            unknown.insert(*impact.ground);
        }
    }
    if (!unknown.empty()) {
        reading.refuse({reading.shown(reading.scenario().observed_impacts)},
                       joined("ground ", std::to_string(*unknown.begin()), ", which this run does not have"),
                       "codes of its ground types (0 is that of terrain.ground)",
                       "correct the column ground, or leave it empty to compare with all impacts");
    }
}

}  // namespace coupling
