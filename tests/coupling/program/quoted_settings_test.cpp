// The chapters quote settings and their defaults: those that the program has.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>

#include "config/options/options.hpp"
#include "coupling/inputs/collapse_settings.hpp"
#include "coupling/inputs/scenario/scenario.hpp"

namespace coupling::quoted_settings_test {
namespace {

namespace fs = std::filesystem;

/// Default text with unit, such as "9.144 m/s", by key.
std::map<std::string, std::string> defaults() {
    Scenario scenario;
    collapse::CollapseSettings of_collapse;
    config::Options options;
    declare(options, scenario);
    collapse::declare(options, of_collapse);
    std::map<std::string, std::string> defaults;
    for (const config::ParameterRow& row : options.rows()) {
        const bool has_unit = !row.unit.empty() && row.unit != "-";
        defaults[row.key] = has_unit ? row.default_text + ' ' + row.unit : row.default_text;
    }
    return defaults;
}

/// The text of each chapter, by its name from the root; line breaks are blanks.
std::map<std::string, std::string> chapters() {
    const fs::path root{BANNWALD_SOURCE_DIR};
    std::map<std::string, std::string> chapters;
    for (const char* room : {"rockfall", "forest", "coupling"}) {
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator{root / room}) {
            if (entry.path().filename() == "README.md" &&
                entry.path().string().find("node_modules") == std::string::npos) {
                std::ifstream in{entry.path()};
                std::string text{std::istreambuf_iterator<char>{in}, {}};
                std::replace(text.begin(), text.end(), '\n', ' ');
                chapters[fs::relative(entry.path(), root).generic_string()] = text;
            }
        }
    }
    return chapters;
}

TEST(Chapters, QuoteTheDefaultsOfTheProgram) {
    // `picus.rest_speed_mps` (default 0.5) or (default 0.5 m/s)
    const std::regex quoted{"`([a-z_0-9]+\\.[a-z_0-9]+)` +\\(default ([^),;]+)"};
    const std::map<std::string, std::string> all = defaults();
    std::size_t checked = 0;
    for (const auto& [name, text] : chapters()) {
        for (std::sregex_iterator at{text.begin(), text.end(), quoted}; at != std::sregex_iterator{}; ++at) {
            const auto found = all.find((*at)[1]);
            ASSERT_NE(found, all.end()) << name << ": no setting " << (*at)[1];
            const std::string with_unit = found->second;
            const std::string without = with_unit.substr(0, with_unit.find(' '));
            EXPECT_TRUE((*at)[2] == with_unit || (*at)[2] == without)
                << name << " says " << (*at)[1] << " (default " << (*at)[2] << "), the program has "
                << with_unit;
            ++checked;
        }
    }
    EXPECT_GE(checked, 20U);
}

TEST(Chapters, NameSettingsThatExist) {
    const std::regex setting{"`([a-z_0-9]+)\\.([a-z_0-9]+)(?: = [^`]*)?`"};
    const std::set<std::string> endings{"ini", "csv", "hpp", "cpp", "asc", "json", "html", "sh", "py"};
    const std::map<std::string, std::string> all = defaults();
    std::set<std::string> sections;
    for (const auto& [key, value] : all) {
        sections.insert(key.substr(0, key.find('.')));
    }
    std::size_t checked = 0;
    for (const auto& [name, text] : chapters()) {
        const bool of_cases = name.find("/validation/") != std::string::npos;  // settings of case.ini
        for (std::sregex_iterator at{text.begin(), text.end(), setting}; at != std::sregex_iterator{}; ++at) {
            const std::string section = (*at)[1];
            if (of_cases || !sections.contains(section) || endings.contains((*at)[2])) {
                continue;
            }
            EXPECT_TRUE(all.contains(section + '.' + (*at)[2].str())) << name << " names " << (*at)[0];
            ++checked;
        }
    }
    EXPECT_GE(checked, 100U);
}

}  // namespace
}  // namespace coupling::quoted_settings_test
