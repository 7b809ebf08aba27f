#include "coupling/assessments/hazard/period_results.hpp"

#include <algorithm>

#include "coupling/inputs/files/file_bytes.hpp"
#include "coupling/results/figures/read_summary.hpp"

namespace coupling::hazard {

ResultsOfPeriod results_in(const std::filesystem::path& folder) {
    const std::filesystem::path file = folder / "summary.json";
    const FileBytes bytes = open_file(file, {}, "a summary");
    ResultsOfPeriod results;
    for (const Cover cover : all_covers) {
        results.departures[index_of(cover)] = read_departures(bytes.text(), cover, file.string());
    }
    results.warnings = read_summary(bytes.text(), file.string()).warnings;
    return results;
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
