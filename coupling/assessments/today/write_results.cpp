#include "coupling/assessments/today/write_results.hpp"

#include "coupling/assessments/nets/figures/net_tables.hpp"
#include "coupling/assessments/today/report/page.hpp"
#include "coupling/assessments/today/summary.hpp"
#include "coupling/assessments/today/tables.hpp"
#include "coupling/assessments/works/work_tables.hpp"
#include "coupling/results/figures/figures.hpp"
#include "coupling/results/finish.hpp"
#include "coupling/results/maps/rasters.hpp"

namespace coupling {

std::vector<WrittenFile> write_results(const RunResults& results, const std::filesystem::path& folder,
                                       const StreamedTables& streamed, const WriteWatch& watch) {
    watch("figures");
    const Figures figures = figures_of(results);

    std::vector<WrittenFile> files{
        {"report.html",
         "The results as a page: answers, maps, charts, settings. Opens offline in any browser."},
        {"summary.json", "All figures, settings, input hashes and warnings for scripts."}};
    watch("tables");
    const std::vector<WrittenFile> tables = write_tables(results, figures, folder);
    files.insert(files.end(), tables.begin(), tables.end());
    watch("tables of nets");
    const std::vector<WrittenFile> of_nets = write_net_tables(results, folder);
    files.insert(files.end(), of_nets.begin(), of_nets.end());
    const std::vector<WrittenFile> of_works = write_work_tables(results, folder);
    files.insert(files.end(), of_works.begin(), of_works.end());
    files.insert(files.end(), streamed.files.begin(), streamed.files.end());
    const std::vector<WrittenFile> rasters = write_rasters(results, folder, watch);
    files.insert(files.end(), rasters.begin(), rasters.end());
    finish_results(folder,
                   {.scenario = results.scenario,
                    .dictionary = {static_layouts(), raster_columns()},
                    .summary = [&](std::ostream& out,
                                   const auto& written) { write_summary(out, results, figures, written); },
                    .page = [&](std::ostream& out,
                                const auto& written) { report::write_page(out, results, figures, written); },
                    .drawn = &results.site,
                    .streamed = streamed,
                    .paths = results.paths},
                   files, watch);
    return files;
}

}  // namespace coupling
