#include "coupling/decades/decade_results.hpp"

#include "coupling/decades/fall_tables.hpp"
#include "coupling/decades/patch_maps.hpp"
#include "coupling/decades/work_tables.hpp"

namespace coupling::decades {

std::vector<WrittenFile> write_results(const DecadeResults& results, const std::filesystem::path& folder) {
    std::vector<WrittenFile> files{
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
    return files;
}

}  // namespace coupling::decades
