#pragma once

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/figures/run_results.hpp"
#include "coupling/results/tables/table_layout.hpp"

namespace coupling {

/// A ground type with the figures that the chosen motion model uses.
struct GroundFigures {
    int code = 0;
    std::string label;
    double area_share = 0.0;        ///< of the cells of the maps with ground [-]
    std::string soil{};             ///< "" where the model uses none
    std::vector<double> figures{};  ///< in the order of ground_columns(); NaN where the model uses none

    [[nodiscard]] bool has(std::size_t column) const { return !std::isnan(figures[column]); }
};

/// The ground types that occur on the maps or on faces of a mesh, in the order of their table.
std::vector<GroundFigures> grounds_of(const Scenario& scenario, const Site& site);
std::vector<GroundFigures> grounds_of(const RunResults& results);

/// Mean diameter of the rocks, for which stopping is shown [m].
double middle_diameter_m(const RunResults& results);

/// Writes tables/grounds.csv.
WrittenFile write_grounds(const std::filesystem::path& folder, const RunResults& results);
TableLayout ground_layout();

}  // namespace coupling
