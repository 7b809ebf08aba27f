#pragma once

#include <cstddef>
#include <span>

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

struct PlacedTree {
    double x_m = 0.0;
    double y_m = 0.0;
    double dbh_cm = 0.0;
};

/// Basal area on the cells of 20 m that hold a tree [m2/ha]; 0 without trees. Stems of one tree, which may
/// stand on one spot, count here, too: places that are those of a part of a plot show in it.
double basal_area_where_trees_stand_m2pha(std::span<const PlacedTree> trees);

}  // namespace coupling::plausible
