#include "coupling/assessments/hazard/period_results.hpp"

#include <algorithm>

#include "config/text/joined.hpp"
#include "coupling/inputs/files/file_bytes.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/figures/read_summary.hpp"

namespace coupling::hazard {

namespace {

/// Settings of [report] that a page was not written with.
std::vector<std::string> other_settings_of_page(const SummaryOfRun& written, const Scenario& scenario) {
    std::vector<std::string> others;
    for (const config::ParameterRow& row : scenario.shown_settings()) {
        if (!row.key.starts_with("report.")) {
            continue;
        }
        const auto same = std::find_if(written.settings.begin(), written.settings.end(),
                                       [&](const SummaryOfRun::Setting& one) {
                                           return one.key == row.key && one.value == row.value_text;
                                       });
        if (same == written.settings.end()) {
            others.push_back(row.key);
        }
    }
    return others;
}

}  // namespace

ResultsOfPeriod results_in(const std::filesystem::path& folder, const Scenario& scenario) {
    const std::filesystem::path file = folder / "summary.json";
    const FileBytes bytes = open_file(file, {}, "a summary");
    ResultsOfPeriod results;
    for (const Cover cover : all_covers) {
        results.departures[index_of(cover)] = read_departures(bytes.text(), cover, file.string());
    }
    const SummaryOfRun written = read_summary(bytes.text(), file.string());
    results.warnings = written.warnings;
    results.other_page_settings = other_settings_of_page(written, scenario);
    return results;
}

void warn_of_page(const ResultsOfPeriod& results, config::Warnings& warnings) {
    if (results.other_page_settings.empty()) {
        return;
    }
    std::string names;
    for (const std::string& name : results.other_page_settings) {
        names += config::joined(names.empty() ? "" : ", ", name);
    }
    warnings.add(
        config::joined("page and workbook of the return period are as they were written, with another ",
                       names, ": finished results do not change; --overwrite simulates them again"));
}

void add_unknown(const std::vector<std::string>& sentences, config::Warnings& warnings) {
    for (const std::string& sentence : sentences) {
        const std::vector<std::string>& known = warnings.warnings();
        if (std::find(known.begin(), known.end(), sentence) == known.end()) {
            warnings.add(sentence, config::Effect::answer);
        }
    }
}

}  // namespace coupling::hazard
