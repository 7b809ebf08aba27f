#pragma once

#include "coupling/assessments/nets/figures/barrier_design.hpp"
#include "coupling/results/tables/table_of.hpp"

namespace coupling {

/// Energy, class and height of a design, with what its percentiles are taken of in words.
ColumnsOf<BarrierDesign> needed_columns(const char* energies, const char* heights);

/// The figures of a design, which are the same in every table that shows one.
ColumnsOf<BarrierDesign> design_columns();

}  // namespace coupling
