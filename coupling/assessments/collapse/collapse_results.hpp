#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "config/errors/warnings.hpp"
#include "coupling/assessments/collapse/collapse_record.hpp"
#include "coupling/inputs/site.hpp"
#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/disk/write_watch.hpp"
#include "coupling/results/geopackage/results_package.hpp"
#include "coupling/results/maps/rasters.hpp"
#include "coupling/results/tables/table_layout.hpp"
#include "coupling/results/templates/page_template.hpp"

namespace coupling::collapse {

inline constexpr double j_per_mj = 1e6;

/// A finished collapse, ready to be written.
struct CollapseResults {
    const CollapseScenario& scenario;
    const CollapseSite& site;
    const CollapseRecord& record;
    const rockfall::rock_mass::RockMass& mass;
    const HandOver& hand_over;
    const config::Warnings& warnings;
    std::string version;

    /// A free block at the end.
    [[nodiscard]] SeenBlock seen(std::size_t block) const { return hand_over.seen(mass, block); }
    /// Whether single blocks may have left the mass: tables then tell them apart.
    [[nodiscard]] bool hands_over() const { return scenario.settings.hand_over != HandOverTo::none; }
};

/// The figures that are held against those of others.
struct KeyFigures {
    /// Until less than a hundredth of the blocks moves, after the mean speed's peak; none: more still move at
    /// the end of the run.
    std::optional<double> duration_s;
    double peak_mean_speed_mps = 0.0;
    double peak_time_s = 0.0;
    double largest_speed_mps = 0.0;
    double front_m = 0.0;
    double area_m2 = 0.0;           ///< of cells that a block passed
    std::size_t left = 0;           ///< blocks that left the terrain
    double left_share = 0.0;        ///< their share of the volume
    double largest_residual = 0.0;  ///< share of the energy turned over
    double moving_share = 0.0;      ///< of the volume, at the end of the run
};
KeyFigures key_figures(const CollapseResults& results);

/// Above this share of the volume that still moves, a run warns that it ended too early [choice].
inline constexpr double most_moving_share = 0.02;

/// Pieces that hold together at the end: blocks by number of their piece.
std::vector<std::size_t> pieces_of(const CollapseResults& results);

/// All tables of a collapse, with all columns.
const std::vector<TableLayout>& collapse_layouts();
/// The same without what only runs have that hand single blocks over, where this one does not.
const std::vector<TableLayout>& layouts_of(const CollapseResults& results);

/// A map of the results and how it is described.
struct CollapseMap {
    RasterKind kind;
    config::Raster<float> raster;
};
/// Blocks that passed, largest energy and speed, depth of the deposit, largest block: in this order.
std::vector<CollapseMap> maps_of(const CollapseResults& results);

/// The largest speed or displacement of the blocks whose middle is in a cell, at the time of a picture. Stems
/// number the pictures from 1.
struct FieldMap {
    std::string stem;
    std::string meaning;
    bool is_speed = true;  ///< else displacement
    double time_s = 0.0;
    config::Raster<float> raster;

    /// Refers to this one.
    [[nodiscard]] RasterKind kind() const;
};
/// Speed and displacement at each picture, one after the other.
std::vector<FieldMap> fields_of(const CollapseResults& results);
/// Over all pictures, so that they have one scale.
ValueRange range_of_fields(const std::vector<FieldMap>& fields, bool speed);

/// What maps and layers of other kinds of run are drawn from: frame, heights, targets, trees; no rocks.
Site drawn_site(const CollapseSite& site);

/// The cells in which blocks lie at the end, as a layer of the GeoPackage.
geopackage::AreaLayer deposit_layer(const CollapseResults& results);

/// The ground as it was dug out below the mass, where a part of the mass hides behind the original one.
config::Raster<double> dug_out(const CollapseSite& site);

/// Parts of the page, HTML: maps with their definitions, and the mass in three dimensions with a slider of
/// time.
report::PageFields maps_of_page(const CollapseResults& results);
std::string scene_of_page(const CollapseResults& results);

/// Writes tables, rasters, perhaps VTP, summary.json and report.html into an existing folder. Throws
/// config::InputError (file), and what `watch` throws.
std::vector<WrittenFile> write_results(const CollapseResults& results, const std::filesystem::path& folder,
                                       const WriteWatch& watch);

/// The tables of a run, into the folder tables of `folder`.
void write_tables(const CollapseResults& results, const std::filesystem::path& folder,
                  const WriteWatch& watch, std::vector<WrittenFile>& files);

void write_summary(std::ostream& out, const CollapseResults& results, const std::vector<WrittenFile>& files);
void write_page(std::ostream& out, const CollapseResults& results, const std::vector<WrittenFile>& files);

/// Blocks of a frame as VTK poly data, absolute coordinates, with number, speed and volume.
void write_blocks_vtp(std::ostream& out, const CollapseResults& results, std::size_t frame);

}  // namespace coupling::collapse
