#pragma once

#include <vector>

#include "coupling/results/tables/table_layout.hpp"

namespace coupling::decades {

/// The tables of member, year and figure: those that have no file of their own.
const std::vector<TableLayout>& yearly_layouts();

}  // namespace coupling::decades
