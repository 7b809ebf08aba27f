#include "coupling/assessments/profile/profile_results.hpp"

#include "config/text/language.hpp"
#include "coupling/assessments/profile/report/profile_page.hpp"
#include "coupling/results/finish.hpp"

namespace coupling::profile {
std::vector<WrittenFile> write_results(const ProfileResults& results, const std::filesystem::path& folder,
                                       const std::vector<WrittenFile>& streamed, const WriteWatch& watch) {
    std::vector<WrittenFile> files{
        {"report.html", "The results as a page: profile, run-out, jumps, energies, settings. Opens offline."},
        {"summary.json", "All figures, settings, input hashes and warnings for scripts."}};
    files.insert(files.end(), streamed.begin(), streamed.end());
    const std::vector<WrittenFile> tables = write_tables(results, folder);
    files.insert(files.end(), tables.begin(), tables.end());
    finish_results(
        folder,
        {.scenario = results.scenario,
         .dictionary = {profile_layouts(), {}},
         .summary = [&](std::ostream& out, const auto& written) { write_summary(out, results, written); },
         .page = [&](std::ostream& out, const auto& written) { write_page(out, results, written); }},
        files, watch);
    return files;
}

}  // namespace coupling::profile
