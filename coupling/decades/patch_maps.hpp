#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "coupling/decades/decade_tables.hpp"
#include "coupling/decades/records.hpp"
#include "coupling/results/out_file.hpp"
#include "coupling/results/table_layout.hpp"
#include "coupling/results/write_watch.hpp"
#include "forest/patch.hpp"

namespace coupling::decades {

/// The rasters of patches: name, unit and meaning.
std::vector<Column> patch_raster_columns();

/// Writes rasters/forest/REGIME/year_N/{stems,basal_area,volume,top_height,leaf_area_index,ground_light}.asc:
/// means over the replicates, on the frame of the patches; cells without forest are NODATA. `projection` is
/// the text for the .prj files, empty for none. At the start there is no ground_light.
std::vector<WrittenFile> write_patch_maps(const std::filesystem::path& folder, const Names& names,
                                          std::span<const MemberYears> members, const forest::PatchGrid& grid,
                                          const std::string& projection, const WriteWatch& watch = {});

}  // namespace coupling::decades
