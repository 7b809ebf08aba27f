#pragma once

#include <cstdint>
#include <vector>

#include "config/options/options.hpp"

namespace coupling {

/// How the tables of results are written.
enum class CsvForm : std::uint8_t {
    plain,  ///< commas, decimal points: R, Python and this program read them
    excel,  ///< semicolons, the decimal sign of the page's language, byte-order mark
};

/// What GIS programs and spreadsheets are given beside tables and ESRI ASCII grids.
struct GisFiles {
    bool geopackage = true;  ///< results.gpkg and results.qlr
    bool geotiff = false;    ///< a .tif beside each grid
    bool vtp = false;        ///< trajectories.vtp
    bool workbook = false;   ///< results.xlsx
    CsvForm csv = CsvForm::plain;
    bool shapefile = false;  ///< the layers of results.gpkg in shapefiles/
    bool kml = false;        ///< the same as results.kmz
    bool gpx = false;        ///< its sources, targets, nets and trajectories as results.gpx

    /// In longitude and latitude, so that the system of the terrain has to be known.
    [[nodiscard]] bool wants_degrees() const { return kml || gpx; }
};

/// The settings of section [output] for any kind of run.
struct OutputSettings {
    double cell_size_m = 0.0;  ///< of the maps; 0: that of the DEM
    bool percentiles = true;   ///< percentile maps
    bool rock_table = true;
    bool arrival_table = true;
    bool tree_hit_table = true;
    bool impact_table = false;
    bool spread_maps = false;   ///< how far what is not known moves the figures of a cell
    std::uint64_t repeats = 0;  ///< rocks are shared out among so many repeats; 0: none
    std::uint64_t sample_paths = 500;
    std::vector<double> path_rocks;  ///< numbers of rocks whose paths are kept too
    GisFiles gis;
};

void declare(config::Options& options, OutputSettings& output);

}  // namespace coupling
