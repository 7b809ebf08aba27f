#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "coupling/inputs/parameters/parameter_draws.hpp"
#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/figures/drawn_figure.hpp"
#include "coupling/results/tables/table_of.hpp"

namespace coupling {

/// A figure with both intervals, as a row of a table.
struct DrawnRow {
    const char* quantity;
    const char* of_unit;
    double factor;  ///< from the figure to that unit
    const DrawnFigure* figure;
    std::string first_parameter;  ///< "" where none brings anything
    double first_share;           ///< of the spread that parameters bring
};

/// Nothing where the figure has no intervals.
std::optional<DrawnRow> drawn_row(const char* quantity, const char* unit, double factor,
                                  const std::optional<DrawnFigure>& figure, const ParameterDraws& draws);

/// Quantity, unit, value, both intervals, what brings most of the second one. `quantities`: which there are.
ColumnsOf<DrawnRow> drawn_columns(const char* quantities);

/// parameter_draws.csv: what was drawn for each stratum of rocks.
TableLayout draws_layout();
WrittenFile write_draws(const ParameterDraws& draws, const std::filesystem::path& folder);

}  // namespace coupling
