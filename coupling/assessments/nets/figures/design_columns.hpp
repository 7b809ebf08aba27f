#pragma once

#include "coupling/assessments/nets/figures/barrier_design.hpp"
#include "coupling/results/tables/table_of.hpp"

namespace coupling {

/// The figures of a design, which are the same in every table that shows one.
ColumnsOf<BarrierDesign> design_columns();

}  // namespace coupling
