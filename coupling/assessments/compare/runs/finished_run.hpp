#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "coupling/assessments/compare/runs/figure.hpp"
#include "coupling/results/figures/read_summary.hpp"

namespace coupling::compare {

/// A finished run as its folder holds it.
struct FinishedRun {
    std::filesystem::path folder;
    SummaryOfRun summary;
    std::vector<Figure> figures;  ///< in the order of the tables
};

/// Throws config::InputError: (file) for a folder that is missing, holds no finished results or lacks a
/// table, (data) for files that no run wrote.
FinishedRun read_finished_run(const std::filesystem::path& folder);

}  // namespace coupling::compare
