#include "coupling/run/settings_hash.hpp"

#include <sstream>

#include "config/version.hpp"
#include "coupling/inputs/files/file_bytes.hpp"
#include "coupling/inputs/scenario/scenario.hpp"

namespace coupling {
namespace {

/// Changes no fall: the hazard map is made from finished ones, how often a run is saved concerns nobody else,
/// and what stands over its pages and behind its maps is written last.
const std::set<std::string>& settings_beside_the_falls() {
    static const std::set<std::string> keys{"hazard.rule",
                                            "hazard.energy",
                                            "hazard.least_reach_percent",
                                            "hazard.smallest_zone_m2",
                                            "hazard.matrix",
                                            "run.rocks_per_part",
                                            "report.title",
                                            "report.client",
                                            "report.author",
                                            "report.place",
                                            "report.date",
                                            "report.logo",
                                            "report.language",
                                            "terrain.picture"};
    return keys;
}

/// A hazard map takes its risk from finished falls; a run over years writes both together.
bool is_of_a_later_risk(const std::string& key, const Scenario& scenario) {
    return key.starts_with("risk.") && scenario.run.years == 0;
}

/// Without such a rule no fall counts by the width.
bool is_of_another_rule(const std::string& key, const Scenario& scenario) {
    return key == "hazard.reference_width_m" && scenario.hazard.rule == HazardRule::release;
}

}  // namespace

std::string text_of_settings(const Scenario& scenario, std::span<const InputFile> inputs,
                             const std::set<std::string>& beside) {
    std::ostringstream text;
    text << config::version() << '\n';
    for (const config::ParameterRow& row : scenario.shown_settings()) {
        if (!settings_beside_the_falls().contains(row.key) && !beside.contains(row.key) &&
            !is_of_a_later_risk(row.key, scenario) && !is_of_another_rule(row.key, scenario)) {
            text << row.key << " = " << row.value_text << '\n';
        }
    }
    for (const config::FreeEntry& entry : scenario.options->free_entries()) {
        text << entry.section << '.' << entry.key << " = " << entry.value << '\n';
    }
    for (const InputFile& input : inputs) {
        if (input.role == role_of_logo || input.role.starts_with("picture")) {
            continue;
        }
        text << input.role << ' ' << input.hash << '\n';
    }
    return text.str();
}

std::string settings_hash(const Scenario& scenario, std::span<const InputFile> inputs) {
    return hash_text(text_of_settings(scenario, inputs));
}

}  // namespace coupling
