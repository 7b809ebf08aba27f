#include "coupling/results/gis_files.hpp"

#include <algorithm>

#include "coupling/results/geopackage/results_package.hpp"
#include "coupling/results/qgis/results_tree.hpp"

namespace coupling {
namespace {

namespace fs = std::filesystem;

void add_package(const fs::path& folder, const geopackage::Contents& contents,
                 std::span<const WrittenFile> files, std::vector<WrittenFile>& added) {
    const std::vector<geopackage::Written> layers = geopackage::write_package(folder, contents);
    added.push_back({"results.gpkg", geopackage::package_sentence});
    added.push_back(qgis::write_results_tree(folder, contents.site.projection, files, layers));
}

}  // namespace

std::vector<WrittenFile> write_gis_files(const fs::path& folder, const Site& site,
                                         std::span<const WrittenFile> files, const StreamedTables& streamed,
                                         std::span<const rockfall::PathRecord> paths) {
    std::vector<WrittenFile> added;
    geopackage::Contents contents{site, {}, paths};
    for (const WrittenFile& file : files) {
        const bool is_streamed =
            std::any_of(streamed.files.begin(), streamed.files.end(),
                        [&](const WrittenFile& other) { return other.path == file.path; });
        if (file.path.ends_with(".csv")) {
            contents.tables.emplace_back(
                file, is_streamed ? streamed.folder / fs::path{file.path}.filename() : folder / file.path);
        }
    }
    add_package(folder, contents, files, added);
    return added;
}

}  // namespace coupling
