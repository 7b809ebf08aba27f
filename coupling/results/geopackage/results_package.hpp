#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "coupling/inputs/site.hpp"
#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/disk/write_watch.hpp"
#include "coupling/results/geopackage/package.hpp"
#include "rockfall/ensemble.hpp"

namespace coupling::geopackage {

/// Areas that a kind of run adds to what all have, such as hazard zones.
struct AreaLayer {
    struct Row {
        std::vector<std::string> fields;
        std::vector<std::vector<config::Point2>> rings;  ///< closed, by the even-odd rule, absolute
        bool is_line = false;                            ///< then `rings` are lines, which are not closed
    };
    std::string name;
    std::string sentence;
    std::vector<Column> columns;
    std::vector<Row> rows;
    std::string drawn_by;
    std::vector<DrawnClass> classes;
};

/// What goes into results.gpkg.
struct Contents {
    const Site& site;
    const std::vector<TableLayout>& layouts;  ///< what the columns of the tables hold
    /// Finished tables: name as the results have it (tables/rocks.csv), and the file where it lies now.
    std::vector<std::pair<WrittenFile, std::filesystem::path>> tables;
    std::span<const rockfall::PathRecord> paths;  ///< sampled
    std::span<const AreaLayer> areas{};
};

/// Writes results.gpkg into a folder that exists and returns its layers and tables.
///
/// Every table goes in under its own name without `.csv`, its places as points or lines where it has columns
/// of places. Other names: `trees` is stems.csv, or all trees_YEAR.csv one after the other; `target_arrivals`
/// is targets.csv, as `targets` are their outlines. The two tables of paths are one layer, `trajectories`,
/// whose corners carry height above sea and energy; heights above ground stay in trajectories.csv. Throws
/// config::InputError (file), and what `watch` throws.
std::vector<Written> write_package(const std::filesystem::path& folder, const Contents& contents,
                                   const WriteWatch& watch = {});

/// A sentence for the list of files.
inline constexpr const char* package_sentence =
    "All layers (sources, deposits, trajectories, trees, targets, ...) and tables for QGIS, R and SQL.";

}  // namespace coupling::geopackage
