#include "coupling/results/report/head_of_run.hpp"

#include <algorithm>

namespace coupling::report {

std::string setting_of(const SummaryOfRun& run, const std::string& key) {
    const auto found = std::find_if(run.settings.begin(), run.settings.end(),
                                    [&](const auto& setting) { return setting.key == key; });
    return found == run.settings.end() ? "" : found->value;
}

ReportSettings head_of_run(const SummaryOfRun& run) {
    ReportSettings head;
    head.title = setting_of(run, "report.title");
    head.client = setting_of(run, "report.client");
    head.author = setting_of(run, "report.author");
    head.place = setting_of(run, "report.place");
    head.date = setting_of(run, "report.date");
    head.language = config::language_of(setting_of(run, "report.language")).value_or(config::Language::en);
    return head;
}

}  // namespace coupling::report
