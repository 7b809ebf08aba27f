#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "coupling/assessments/decades/members/records.hpp"
#include "coupling/assessments/decades/tables/decade_tables.hpp"
#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/disk/write_watch.hpp"
#include "coupling/results/tables/table_layout.hpp"
#include "forest/stand/patch.hpp"

namespace coupling::decades {

/// The rasters of patches: name, unit and meaning.
std::vector<Column> patch_raster_columns();

/// Writes rasters/forest/REGIME/year_N/{stems,basal_area,volume,top_height,leaf_area_index,ground_light}.asc:
/// means over the replicates, on the frame of the patches; cells without forest are NODATA. `projection` is
/// the text for the .prj files, empty for none. At the start there is no ground_light.
std::vector<WrittenFile> write_patch_maps(const std::filesystem::path& folder, const Names& names,
                                          std::span<const MemberYears> members, const forest::PatchGrid& grid,
                                          const std::string& projection, const WriteWatch& watch = {});

/// Writes rasters/forest/REGIME/all_years/{protection_spared,protection_lost_if_cut}.asc of all years with
/// rocks together (protection_places.hpp), on the same frame.
std::vector<WrittenFile> write_protection_maps(const std::filesystem::path& folder, const Names& names,
                                               std::span<const MemberYears> members,
                                               const forest::PatchGrid& grid, const std::string& projection,
                                               const WriteWatch& watch = {});

}  // namespace coupling::decades
