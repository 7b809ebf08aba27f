#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "config/grid/raster.hpp"
#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/disk/write_watch.hpp"
#include "coupling/results/figures/colours.hpp"
#include "coupling/results/figures/figures.hpp"
#include "coupling/results/figures/run_results.hpp"

namespace coupling {

/// How a map of a raster is coloured.
enum class RasterStyle : std::uint8_t {
    energy_classes,  ///< below 30, 30 to 300, above 300 kJ
    linear,          ///< straight from 0 to the largest value
    logarithmic,     ///< by powers of ten: counts
};

/// What a raster of the results holds: one value for each cell that a rock passed.
struct RasterKind {
    std::string_view stem;  ///< file name without ending, after Rockyfor3D
    std::string_view unit;
    std::string_view meaning;
    RasterStyle style = RasterStyle::linear;
    Palette palette = Palette::height;
    bool percentile = false;  ///< needs the distributions by cell
    bool compared = false;    ///< also written as difference
    float (*value)(const rockfall::CellSums& sums, const rockfall::CellHistograms* histograms,
                   std::size_t cell);
    bool of_all = false;  ///< `value` counts rocks; shown in percent of all that fell, of today alone
};

/// Every raster of the results.
const std::vector<RasterKind>& raster_kinds();
/// Requires a stem of the list.
const RasterKind& raster_kind(std::string_view stem);

/// Share of the repeats in which a cell is reached: written where output.repeats asks for it.
const RasterKind& repeats_kind();
/// How far what is not known moves reach probability and mean energy: written where output.spread_maps asks
/// for it.
const std::vector<RasterKind>& spread_kinds();
/// How many rocks pass a cell for each release of hazard.blocks, by energy as `rockfall::CellReleases` counts
/// them: written of a return period.
const std::vector<RasterKind>& release_kinds();

/// One raster on the frame of the maps in absolute coordinates; NaN where no rock passed. Requires
/// distributions for a percentile.
config::Raster<float> raster_of(const RasterKind& kind, const RunResults& results, Cover cover);

/// Smallest and largest value of a raster.
struct ValueRange {
    float low = 0.0F;
    float high = 0.0F;
};

/// A raster and what QGIS and people need to read it.
struct DrawnRaster {
    std::string path;  ///< in the folder of results, without ending
    std::string sentence;
    const config::Raster<float>& raster;
};
/// Writes grid, projection (.prj, unless the text is empty) and QGIS style (.qml); the style has the colours
/// of the kind over `range`. The folder has to exist.
WrittenFile write_raster(const std::filesystem::path& folder, const DrawnRaster& drawn,
                         const std::string& projection, const RasterKind& kind, ValueRange range);

/// The same for values that stand for classes. Requires at least one class.
WrittenFile write_raster(const std::filesystem::path& folder, const DrawnRaster& drawn,
                         const std::string& projection, std::span<const ClassColour> classes);

/// With forest minus bare slope; a cell that no rock passes on one of them counts as 0 there (no rock: no
/// energy, no height). NaN where none passes on either.
///
/// With forest fewer sources feed a cell, so that its reach probability, a share of their rocks, can rise
/// although fewer rocks pass. The difference therefore takes both as shares of the same rocks: those of the
/// slope on which more feed it.
config::Raster<float> difference_of(const RasterKind& kind, const RunResults& results);

/// {0, 0} where all are NaN.
ValueRange range_of(const config::Raster<float>& raster);

/// Writes rasters/forest, rasters/bare and rasters/difference into a folder: grid, projection (.prj, where
/// the DEM has one) and QGIS style (.qml). Both slopes share the colours of a quantity, so that they can be
/// compared by eye.
std::vector<WrittenFile> write_rasters(const RunResults& results, const std::filesystem::path& folder,
                                       const WriteWatch& watch = {});

}  // namespace coupling
