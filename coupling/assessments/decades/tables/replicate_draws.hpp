#pragma once

#include <filesystem>
#include <vector>

#include "coupling/inputs/site.hpp"
#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/tables/table_layout.hpp"

namespace coupling {
struct Scenario;
}

namespace coupling::decades {

TableLayout replicate_draws_layout();

/// Writes tables/replicate_draws.csv: what was drawn for the rocks of each replicate; nothing where nothing
/// was.
std::vector<WrittenFile> write_replicate_draws(const std::filesystem::path& folder, const Scenario& scenario,
                                               const Site& site);

}  // namespace coupling::decades
