#include "coupling/inputs/scenario/output_settings.hpp"

namespace coupling {

void declare(config::Options& options, OutputSettings& output) {
    options.number(
        "output.cell_size_m", output.cell_size_m,
        {.unit = "m",
         .low = 0.0,
         .high = 1000.0,
         .meaning = "cell size of the maps; 0: that of the DEM (points: their mean spacing, rounded up)",
         .source = "choice"});
    options.flag("output.percentiles", output.percentiles,
                 {.meaning = "maps of percentiles; they need most of the memory",
                  .source = "choice",
                  .needs = {{"run.years", {"0"}}}});
    options.flag("output.rock_table", output.rock_table,
                 {.meaning = "table of every rock", .source = "choice", .needs = {{"run.years", {"0"}}}});
    options.flag("output.arrivals", output.arrival_table,
                 {.meaning = "arrivals.csv, a row for each rock that reaches a target, also in results.gpkg; "
                             "no: shares and distributions at the targets only",
                  .source = "choice",
                  .needs = {{"run.years", {"0"}}}});
    options.flag("output.tree_hit_table", output.tree_hit_table,
                 {.meaning = "tables of every hit on a tree and on a log",
                  .source = "choice",
                  .needs = {{"run.years", {"0"}}}});
    options.flag("output.impact_table", output.impact_table,
                 {.meaning = "table of every ground impact of the rocks whose paths are kept",
                  .source = "choice",
                  .needs = {{"run.years", {"0"}}}});
    options.count(
        "output.repeats", output.repeats,
        {.low = 0.0,
         .high = 64.0,
         .meaning = "rocks are shared out among so many repeats, and a map says in which share of them a "
                    "cell is reached; 0: no such map",
         .source = "Cottaz et al. 2010: up to 30 repeats"});
    options.flag("output.spread_maps", output.spread_maps,
                 {.meaning = "maps of how far what is not known moves reach probability and mean energy of a "
                             "cell; 200 bytes more for each cell, slope and thread",
                  .source = "choice",
                  .needs = {{"run.years", {"0"}}, {"run.parameter_draws"}}});
    options.count("output.sample_paths", output.sample_paths,
                  {.low = 0.0,
                   .high = 1e6,
                   .meaning = "how many rocks keep their path for pictures",
                   .source = "choice",
                   .needs = {{"run.years", {"0"}}}});
    options.whole_numbers(
        "output.path_rocks", output.path_rocks,
        {.low = 0.0,
         .high = 4e9,
         .meaning = "numbers of rocks (tables/rocks.csv) whose paths are kept and drawn too",
         .needs = {{"run.years", {"0"}}}});
    options.flag(
        "output.geopackage", output.gis.geopackage,
        {.meaning = "results.gpkg with layers and tables, results.qlr for QGIS", .source = "choice"});
    options.flag("output.geotiff", output.gis.geotiff,
                 {.meaning = "a GeoTIFF (.tif) beside each grid", .source = "choice"});
    options.flag("output.shapefile", output.gis.shapefile,
                 {.meaning = "shapefiles/: the layers of results.gpkg as Shapefiles", .source = "choice"});
    options.flag("output.kml", output.gis.kml,
                 {.meaning = "results.kmz: the same layers for Google Earth and others; the system of the "
                             "terrain has to be known",
                  .source = "choice"});
    options.flag(
        "output.gpx", output.gis.gpx,
        {.meaning = "results.gpx: sources, targets, nets and trajectories for GPS devices; the system of "
                    "the terrain has to be known",
         .source = "choice"});
    options.flag("output.xlsx", output.gis.workbook,
                 {.meaning = "results.xlsx: a workbook with a sheet for each table", .source = "choice"});
    options.choice(
        "output.csv", output.gis.csv, {{"plain", CsvForm::plain}, {"excel", CsvForm::excel}},
        {.meaning = "form of the tables; plain: commas and decimal points; excel: semicolons, decimal "
                    "sign of the page's language, byte-order mark",
         .source = "choice"});
    options.flag("output.vtp", output.gis.vtp,
                 {.meaning = "sampled paths as trajectories.vtp for ParaView; assessment of today",
                  .source = "choice",
                  .needs = {{"run.years", {"0"}}}});
}

}  // namespace coupling
