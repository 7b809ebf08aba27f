#include "coupling/assessments/calibrate/outcome/calibrated_scenario.hpp"

#include <algorithm>
#include <sstream>
#include <vector>

#include "config/text/joined.hpp"
#include "config/text/reading.hpp"

namespace coupling::calibrate {
namespace {

using config::joined;

constexpr std::string_view parameters_key = "run.parameters";

/// A name from the scenario's folder, from `folder`.
std::string name_from(const Scenario& scenario, const std::filesystem::path& folder,
                      const std::string& name) {
    const auto layer = name.find('|');
    const std::string file = name.substr(0, layer);
    const std::string rest = layer == std::string::npos ? "" : name.substr(layer);
    // Links are followed: "../" leads out of the folder that a link leads to.
    const std::filesystem::path path = std::filesystem::weakly_canonical(scenario.resolve(file));
    const std::filesystem::path from_there =
        path.lexically_relative(std::filesystem::weakly_canonical(folder));
    return (from_there.empty() ? path : from_there).generic_string() + rest;
}

std::string value_of(const Scenario& scenario, const std::filesystem::path& folder,
                     const config::ParameterRow& row) {
    const std::vector<std::string> names = files_in(row);
    if (names.empty()) {
        return row.value_text;
    }
    std::string value;
    if (row.files == config::NamesFiles::one) {
        for (const std::string& name : names) {
            value += joined(value.empty() ? "" : ", ", name_from(scenario, folder, name));
        }
        return value;
    }
    // A list of files and of shipped names.
    std::istringstream entries{row.value_text};
    for (std::string entry; std::getline(entries, entry, ',');) {
        const std::string name{config::trimmed(entry)};
        const bool is_file = std::find(names.begin(), names.end(), name) != names.end();
        value += joined(value.empty() ? "" : ", ", is_file ? name_from(scenario, folder, name) : name);
    }
    return value;
}

}  // namespace

std::string calibrated_scenario(const Scenario& scenario, const std::filesystem::path& folder,
                                const std::string& parameters, const std::string& opening) {
    std::vector<std::pair<std::string, std::string>> sections;  // in the order of the settings
    const auto lines_of = [&](const std::string& section) -> std::string& {
        for (auto& [name, lines] : sections) {
            if (name == section) {
                return lines;
            }
        }
        return sections.emplace_back(section, "").second;
    };
    const auto add = [&](const std::string& key, const std::string& value) {
        const auto dot = key.find('.');
        lines_of(key.substr(0, dot)) += joined(key.substr(dot + 1), " = ", value, "\n");
    };
    for (const config::ParameterRow& row : scenario.options->rows()) {
        if (row.key == parameters_key) {
            add(row.key, parameters);
        } else if (row.changed || scenario.options->was_set(row.key)) {
            add(row.key, value_of(scenario, folder, row));
        }
    }
    for (const config::FreeEntry& entry : scenario.options->free_entries()) {
        lines_of(entry.section) += joined(entry.key, " = ", entry.value, "\n");
    }
    std::string text = opening;
    for (const auto& [section, lines] : sections) {
        text += joined("\n[", section, "]\n", lines);
    }
    return text;
}

}  // namespace coupling::calibrate
