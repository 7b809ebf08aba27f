#pragma once

#include <cstddef>

#include "config/table/table.hpp"

namespace coupling::plausible {

/// Trees of a list that leave no room for each other: a list with more than one census in it, though neither
/// numbers of trees nor exact places say so.
struct CloseTrees {
    // Trees less the first of each group that hangs together, so that the order of the list does not count.
    std::size_t inside = 0;  ///< whose middle lies inside the stem of another, or on its middle
    std::size_t twins = 0;   ///< within 0.5 m of another of the same species and nearly its dbh
};

/// Reads `x_m`, `y_m`, `species`, `dbh_cm`; rows without numbers are passed over.
CloseTrees close_trees(const config::Table& table);

/// Whether so many of all trees stand inside each other, or have a twin, that no stand could be meant.
bool are_too_close(const CloseTrees& found, std::size_t all);

}  // namespace coupling::plausible
