#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "coupling/assessments/compare/runs/figure.hpp"

namespace coupling::compare {

/// The forest of a run over years, from its tables: wood, basal area, dead wood, saplings and ingrowth, what
/// died of which cause and what was cut as means over the `years`; wood, basal area and the wood of each
/// species in the last year. Throws config::InputError as read_finished_run() does.
void add_forest_over_years(const std::filesystem::path& folder, std::uint32_t years,
                           std::vector<Figure>& figures);

}  // namespace coupling::compare
