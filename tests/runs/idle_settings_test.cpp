#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "config/errors/input_error.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "tests/runs/years.hpp"

namespace coupling::idle_settings_test {
namespace {

/// Another value that a setting can have; "" where none is known (texts, lists, files).
std::string other_value(const config::ParameterRow& row) {
    if (row.kind == "yes/no") {
        return row.value_text == "yes" ? "no" : "yes";
    }
    if (row.kind.starts_with("one of ")) {
        const std::string words = row.kind.substr(7);
        const std::string first = words.substr(0, words.find('|'));
        return first != row.value_text ? first : words.substr(words.rfind('|') + 1);
    }
    double low = 0.0;
    double high = 0.0;
    if (row.kind.starts_with("list") || std::sscanf(row.range.c_str(), "[%lf, %lf]", &low, &high) != 2) {
        return "";
    }
    const double value = std::stod(row.value_text);
    for (const double other : {1.5 * value, value + 1.0, 0.5 * value, low, high}) {
        const bool fits = row.kind == "number" || std::floor(other) == other;
        if (fits && other != value && other >= low && other <= high) {
            return config::to_text(other);
        }
    }
    return "";
}

std::vector<std::string> idle_keys(const config::Options& options) {
    std::vector<std::string> keys;
    for (const config::IdleSettings& idle : options.idle()) {
        keys.insert(keys.end(), idle.keys.begin(), idle.keys.end());
    }
    return keys;
}

/// Other values of all settings that the program says have no effect beside `base`.
std::vector<std::string> changes_without_effect(const SampleProject& project,
                                                const std::vector<std::string>& base) {
    const std::unique_ptr<Scenario> scenario = read_scenario(project.file("scenario.ini"), base);
    std::vector<std::string> all = base;
    std::vector<std::string> keys;
    for (const config::ParameterRow& row : scenario->options->rows()) {
        const std::string other = row.needs.empty() ? "" : other_value(row);
        if (other.empty()) {
            continue;
        }
        std::vector<std::string> more = all;
        more.push_back(row.key + "=" + other);
        try {
            const auto changed = read_scenario(project.file("scenario.ini"), more);
            std::vector<std::string> wanted = keys;
            wanted.push_back(row.key);
            const std::vector<std::string> idle = idle_keys(*changed->options);
            if (std::all_of(wanted.begin(), wanted.end(), [&](const std::string& key) {
                    return std::find(idle.begin(), idle.end(), key) != idle.end();
                })) {
                all = std::move(more);
                keys = std::move(wanted);
            }
        } catch (const config::InputError&) {
            continue;  // refused beside the others: nobody can set it there
        }
    }
    return {all.begin() + static_cast<std::ptrdiff_t>(base.size()), all.end()};
}

void expect_no_effect(const SampleProject& project, const std::vector<std::string>& base) {
    const auto as_arguments = [](const std::vector<std::string>& settings) {
        std::string arguments;
        for (const std::string& setting : settings) {
            arguments += " --set " + setting;
        }
        return arguments;
    };
    const std::vector<std::string> changes = changes_without_effect(project, base);
    EXPECT_GT(changes.size(), 10U);
    const std::string run = "run scenario.ini --quiet --overwrite" + as_arguments(base);
    ASSERT_EQ(call(project, run + " --out first").code, 0);
    const Outcome changed = call(project, run + as_arguments(changes) + " --out second");
    ASSERT_EQ(changed.code, 0) << changed.err;
    // What repeats the settings differs.
    const Outcome same = shell(
        project,
        "diff -rq -x summary.json -x report.html -x .checksums -x .bannwald -x net_paths.bin -x members "
        "first second\n");
    EXPECT_EQ(same.code, 0) << same.out << as_arguments(base) << "\nbut" << as_arguments(changes);
}

TEST(SettingsWithoutEffect, ChangeNothingInARunOfToday) {
    const SampleProject project;
    for (const std::vector<std::string>& base : std::vector<std::vector<std::string>>{
             {},
             {"rockfall.motion=pir3d"},
             {"rockfall.motion=classical"},
             {"rockfall.motion=rigid", "release.shape=cube"},
             {"release.shape_keeps_size=yes"},
             {"nets.keep_paths=yes"},
             {"release.fall_height_m=3"},
             {"rockfall.motion=rigid", "release.shape=cube", "release.fall_height_m=3"},
             {"release.diameter_kind=uniform", "release.diameter_low_m=0.3", "release.diameter_high_m=0.6"},
             {"release.rocks=90"},
             {"picus.stopping=no"},
             {"picus.rt_noise=0"},
             {"picus.rt_noise_scope=off"}}) {
        expect_no_effect(project, base);
    }
}

TEST(SettingsWithoutEffect, ChangeNothingInARunOverYears) {
    const ForestProject project;
    const std::vector<std::string> stands{"trees.file=", "stands.records=records.csv", "run.years=12",
                                          "climate.sequence=repeat", "output.all_removed_trees=yes"};
    for (const std::vector<std::string>& base : std::vector<std::vector<std::string>>{
             {},
             {"forest.background_deaths=no", "forest.regeneration=no"},
             {"forest.stress_deaths=no", "disturbance.beetle=yes", "disturbance.beetle_background=0.9"},
             {"forest.age_deaths=gap_model", "disturbance.wind=yes", "disturbance.storm_interval=2"}}) {
        std::vector<std::string> all = stands;
        all.insert(all.end(), base.begin(), base.end());
        expect_no_effect(project, all);
    }
}

}  // namespace
}  // namespace coupling::idle_settings_test
