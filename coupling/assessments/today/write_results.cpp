#include "coupling/assessments/today/write_results.hpp"

#include "coupling/assessments/nets/figures/net_tables.hpp"
#include "coupling/assessments/today/figures/static_layouts.hpp"
#include "coupling/assessments/today/report/page.hpp"
#include "coupling/assessments/today/summary.hpp"
#include "coupling/assessments/today/tables.hpp"
#include "coupling/results/figures/figures.hpp"
#include "coupling/results/maps/rasters.hpp"
#include "coupling/results/tables/data_dictionary.hpp"

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
    files.insert(files.end(), streamed.files.begin(), streamed.files.end());
    const std::vector<WrittenFile> rasters = write_rasters(results, folder, watch);
    files.insert(files.end(), rasters.begin(), rasters.end());
    add_data_dictionary(folder, {static_layouts(), raster_columns()}, files);
    const std::vector<WrittenFile> gis =
        write_gis_files(folder, results.scenario.gis, results.site, files, streamed, results.paths, watch);
    files.insert(files.end(), gis.begin(), gis.end());

    watch("summary.json");
    OutFile summary{folder / "summary.json"};
    write_summary(summary.stream(), results, figures, files);
    summary.close();

    watch("report.html");
    OutFile page{folder / "report.html"};
    report::write_page(page.stream(), results, figures, files);
    page.close();
    return files;
}

}  // namespace coupling
