#pragma once

#include <filesystem>
#include <span>
#include <utility>
#include <vector>

#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/disk/write_watch.hpp"
#include "coupling/results/tables/table_layout.hpp"

namespace coupling {

/// Rows that a sheet of Excel takes, the one with the names of the columns included.
inline constexpr std::size_t most_sheet_rows = 1'048'576;

/// Writes tables as the sheets of an Excel workbook: first the list of them with what each holds, then each
/// table with its header fixed, columns of numbers as numbers, everything else as text. A table of more rows
/// than a sheet takes is named in the list only. `tables`: as the results name them, and where they lie now,
/// as this program writes them (CsvRow). The same tables give the same bytes: the date in the file is fixed.
/// Throws InputError (file), and what `watch` throws.
void write_workbook(const std::filesystem::path& file,
                    std::span<const std::pair<WrittenFile, std::filesystem::path>> tables,
                    const std::vector<TableLayout>& layouts, const WriteWatch& watch = {},
                    std::size_t most_rows = most_sheet_rows);

inline constexpr const char* workbook_sentence =
    "All tables as sheets of a workbook for Excel or LibreOffice.";

}  // namespace coupling
