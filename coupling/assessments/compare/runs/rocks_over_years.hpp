#pragma once

#include <filesystem>
#include <vector>

#include "coupling/assessments/compare/runs/figure.hpp"

namespace coupling::compare {

/// Protection, arriving rocks and their energies at the targets of a run over years, from its tables.
/// Throws config::InputError as read_finished_run() does.
void add_targets_over_years(const std::filesystem::path& folder, std::vector<Figure>& figures);

}  // namespace coupling::compare
