#include "coupling/decades/decade_results.hpp"

#include "coupling/decades/fall_tables.hpp"
#include "coupling/decades/patch_maps.hpp"
#include "coupling/decades/report/decade_page.hpp"
#include "coupling/decades/work_tables.hpp"

namespace coupling::decades {

std::vector<WrittenFile> write_results(const DecadeResults& results, const std::filesystem::path& folder) {
    std::vector<WrittenFile> files{
        {"report.html",
         "The results as a page: stands, growth, work and losses over the years, pictures of the forest, "
         "settings."},
        {"summary.json", "Figures of start and end, settings, input hashes and warnings for scripts."}};
    const auto add = [&](const std::vector<WrittenFile>& written) {
        files.insert(files.end(), written.begin(), written.end());
    };
    if (results.rocks > 0) {
        add(write_fall_tables(folder, results.names, results.site, results.members));
    }
    add(write_forest_tables(folder, results.names, results.members));
    add(write_work_tables(folder, results.names, results.members, results.site.forest->grid.area_ha()));
    add(write_patch_maps(folder, results.names, results.members, results.site.forest->grid,
                         results.site.projection));
    if (results.rocks > 0) {
        add(write_fall_maps(folder, results.names, results.site, results.members));
    }
    OutFile summary{folder / "summary.json"};
    write_summary(summary.stream(), results, files);
    summary.close();
    OutFile page{folder / "report.html"};
    write_decade_page(page.stream(), {.scenario = results.scenario,
                                      .names = results.names,
                                      .grid = results.site.forest->grid,
                                      .members = results.members,
                                      .warnings = results.warnings,
                                      .inputs = results.site.inputs,
                                      .files = files,
                                      .version = results.version,
                                      .climate = "",
                                      .first = {}});
    page.close();
    return files;
}

}  // namespace coupling::decades
