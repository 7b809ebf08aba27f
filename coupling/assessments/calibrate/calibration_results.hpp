#pragma once

#include <filesystem>
#include <vector>

#include "coupling/assessments/calibrate/outcome/calibration.hpp"
#include "coupling/results/disk/write_watch.hpp"

namespace coupling::calibrate {

/// Writes tables, calibrated.ini, summary.json and report.html into an existing folder, from which they move
/// to `final_folder`.
std::vector<WrittenFile> write_results(const Calibration& calibration, const std::filesystem::path& folder,
                                       const std::filesystem::path& final_folder, const WriteWatch& watch);

}  // namespace coupling::calibrate
