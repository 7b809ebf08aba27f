#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "config/errors/warnings.hpp"
#include "coupling/inputs/site_falls.hpp"
#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/figures/figures.hpp"
#include "coupling/results/figures/forest_bounds.hpp"
#include "coupling/results/tables/table_layout.hpp"

namespace coupling {

/// Lets a sample of the rocks (3000, or a tenth of all where that is more [choice]) fall past the trees as
/// they are derived and past the bounds of their forest (inputs/forest/tops/bound_trees.hpp), each rock with
/// its own start, draw and numbers. What the bounds change in the sample is added to the figures of all
/// rocks.
///
/// Nothing where trees are mapped with their diameters, where trees.bounds is no, and without a forest.
/// `total`: of all rocks. Throws Interrupted.
std::optional<ForestBounds> bounds_of_forest(const Scenario& scenario, const Site& site,
                                             const SiteFalls& falls, const rockfall::EnsembleTally& total,
                                             int threads);

/// The bounds at the target that most rocks reach, else of the run-out, in one sentence.
void warn_of_bounds(const ForestBounds& bounds, const Site& site, const rockfall::EnsembleTally& total,
                    config::Warnings& warnings);

/// forest_bounds.csv; nothing without bounds.
std::vector<WrittenFile> write_bounds(const RunResults& results, const std::filesystem::path& folder);
TableLayout bounds_layout();

}  // namespace coupling
