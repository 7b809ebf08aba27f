#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/tables/table_layout.hpp"

namespace coupling {

/// What the files of a kind of run hold.
struct DictionaryOfRun {
    const std::vector<TableLayout>& tables;
    std::vector<Column> rasters;  ///< by name without ending
};

/// Writes tables/data_dictionary.csv, every column of the tables among `files`, and, where there are rasters,
/// tables/raster_dictionary.csv; adds both to `files`. Files that are not declared are left out: a test holds
/// declarations and files against each other. Throws config::InputError (file) as OutFile does.
void add_data_dictionary(const std::filesystem::path& folder, const DictionaryOfRun& declared,
                         std::vector<WrittenFile>& files);

/// Rows of data_dictionary.csv: every column of those `files` in `folder` ("tables/", or "") that are
/// declared.
void write_dictionary(std::ostream& out, const std::vector<TableLayout>& tables, std::string_view folder,
                      std::span<const WrittenFile> files);

/// The two tables of the dictionary itself.
const std::vector<TableLayout>& dictionary_layouts();

/// Rasters of rocks, of all kinds of runs, as raster_kinds() declares them.
std::vector<Column> raster_columns();

/// Folder of a raster with its regime, climate and year replaced: "rasters/rockfall/REGIME/year_N" or, of
/// several climates, "rasters/rockfall/REGIME/CLIMATE/year_N".
std::string folder_pattern(const std::string& path);

}  // namespace coupling
