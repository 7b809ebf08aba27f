#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "coupling/assessments/works/work_figures.hpp"
#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/figures/json.hpp"
#include "coupling/results/tables/table_layout.hpp"

namespace coupling {

/// works.csv.
std::vector<TableLayout> work_layouts();

/// Into folder/tables; nothing without works.
std::vector<WrittenFile> write_work_tables(const RunResults& results, const std::filesystem::path& folder);

/// `works` of summary.json.
Json works_json(const RunResults& results);

/// "dam 'a', with forest: 120 of 2 000 rocks reach it; it holds 80 %; ...", in the language of the run.
std::string in_words(const WorkRecord& work, const WorkFigures& figures);

}  // namespace coupling
