#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/inputs/site.hpp"
#include "coupling/results/text/messages.hpp"
#include "coupling/results/text/writing_language.hpp"
#include "tests/coupling/inputs/sample_project.hpp"

namespace coupling {

/// A project that was read, or why it was not. Names of the temporary folder are left out of the messages.
struct Opened {
    std::unique_ptr<Scenario> scenario;
    std::unique_ptr<Site> site;
    config::ExitCode code = config::ExitCode::done;
    std::string errors;
    std::vector<std::string> warnings;
};

inline std::string without_folder(std::string text, const std::filesystem::path& folder) {
    const std::string prefix = folder.string() + "/";
    for (std::size_t at = text.find(prefix); at != std::string::npos; at = text.find(prefix)) {
        text.erase(at, prefix.size());
    }
    return text;
}

/// Every warning of every test that opens a project can stand on a page of another language.
inline void expect_translated(const std::vector<std::string>& warnings) {
    const report::WritingLanguage german{config::Language::de};
    for (const std::string& sentence : warnings) {
        EXPECT_TRUE(report::translated(sentence)) << "add a row to messages.csv: " << sentence;
    }
}

inline Opened open(const SampleProject& project, const std::vector<std::string>& overrides = {}) {
    Opened opened;
    config::Warnings warnings;
    try {
        opened.scenario = read_scenario(project.file("scenario.ini"), overrides);
        opened.site = std::make_unique<Site>(open_site(*opened.scenario, warnings));
    } catch (const config::InputError& error) {
        opened.code = error.code();
        opened.errors = without_folder(error.what(), project.folder());
    }
    for (const std::string& sentence : warnings.all()) {
        opened.warnings.push_back(without_folder(sentence, project.folder()));
    }
    expect_translated(opened.warnings);
    return opened;
}

}  // namespace coupling
