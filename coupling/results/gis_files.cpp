#include "coupling/results/gis_files.hpp"

#include <algorithm>

#include "config/grid/ascii_grid.hpp"
#include "coupling/inputs/files/file_bytes.hpp"
#include "coupling/inputs/scenario/output_settings.hpp"
#include "coupling/results/geopackage/results_package.hpp"
#include "coupling/results/maps/geotiff.hpp"
#include "coupling/results/maps/vtp.hpp"
#include "coupling/results/qgis/results_tree.hpp"
#include "coupling/results/vectors/gpx.hpp"
#include "coupling/results/vectors/kml.hpp"
#include "coupling/results/vectors/shapefiles.hpp"
#include "coupling/results/workbook.hpp"

namespace coupling {
namespace {

namespace fs = std::filesystem;

/// The GeoPackage, and what is made of its layers. Without output.geopackage it is there only as long as
/// these are written.
void add_layers(const fs::path& folder, const GisFiles& wanted, const geopackage::Contents& contents,
                std::span<const WrittenFile> files, std::vector<WrittenFile>& added,
                const WriteWatch& watch) {
    if (!wanted.geopackage && !wanted.shapefile && !wanted.wants_degrees()) {
        return;
    }
    const std::vector<geopackage::Written> layers = geopackage::write_package(folder, contents, watch);
    const fs::path file = folder / "results.gpkg";
    const std::string& projection = contents.site.projection;
    if (wanted.geopackage) {
        added.push_back({"results.gpkg", geopackage::package_sentence});
        added.push_back(qgis::write_results_tree(folder, projection, files, layers));
    }
    {
        geopackage::Database database{file, geopackage::Database::Open::to_read};
        if (wanted.shapefile) {
            added.push_back(vectors::write_shapefiles(folder, database, layers, projection, watch));
        }
        if (wanted.kml) {
            added.push_back(vectors::write_kmz(folder, database, layers, projection, watch));
        }
        if (wanted.gpx) {
            added.push_back(vectors::write_gpx(folder, database, layers, projection, watch));
        }
    }
    if (!wanted.geopackage) {
        delete_entry(file);
    }
}

void add_geotiffs(const fs::path& folder, const std::string& projection, std::span<const WrittenFile> files,
                  std::vector<WrittenFile>& added, const WriteWatch& watch) {
    for (const WrittenFile& file : files) {
        if (!file.path.ends_with(".asc")) {
            continue;
        }
        const fs::path grid = folder / file.path;
        const FileBytes bytes = open_file(grid, {.file = grid.string()}, "a raster of this run");
        const std::string path = fs::path{file.path}.replace_extension(".tif").generic_string();
        watch(path);
        write_geotiff(folder / path, config::read_ascii_grid(bytes.text(), grid.string()), projection);
        added.push_back({path, file.sentence});
    }
}

}  // namespace

std::vector<WrittenFile> write_gis_files(const fs::path& folder, const GisFiles& wanted, const Site& site,
                                         std::span<const WrittenFile> files,
                                         const std::vector<TableLayout>& layouts,
                                         const StreamedTables& streamed,
                                         std::span<const rockfall::PathRecord> paths, const WriteWatch& watch,
                                         std::span<const geopackage::AreaLayer> areas) {
    std::vector<WrittenFile> added;
    geopackage::Contents contents{site, layouts, {}, paths, areas};
    for (const WrittenFile& file : files) {
        const bool is_streamed =
            std::any_of(streamed.files.begin(), streamed.files.end(),
                        [&](const WrittenFile& other) { return other.path == file.path; });
        if (file.path.ends_with(".csv")) {
            contents.tables.emplace_back(
                file, is_streamed ? streamed.folder / fs::path{file.path}.filename() : folder / file.path);
        }
    }
    add_layers(folder, wanted, contents, files, added, watch);
    if (wanted.geotiff) {
        add_geotiffs(folder, site.projection, files, added, watch);
    }
    if (wanted.workbook) {
        write_workbook(folder / "results.xlsx", contents.tables, layouts, watch);
        added.push_back({"results.xlsx", workbook_sentence});
    }
    if (wanted.vtp && !paths.empty()) {
        watch("trajectories.vtp");
        OutFile vtp{folder / "trajectories.vtp"};
        write_vtp(vtp.stream(), paths, site.origin_m());
        vtp.close();
        added.push_back({"trajectories.vtp", "Sampled paths with energy and height for ParaView."});
    }
    return added;
}

}  // namespace coupling
