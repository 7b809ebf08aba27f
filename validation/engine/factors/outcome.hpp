#pragma once

#include "validation/engine/case/case_result.hpp"
#include "validation/engine/slope/falls.hpp"
#include "validation/engine/slope/quantities.hpp"

namespace coupling::validation {

/// What figures need to know of a rebuilt slope.
FigureFrame frame_of(const Recipe& recipe, const RebuiltSlope& slope, const std::vector<Section>& sections);

/// Every figure of the ensembles: over the large one, and mean and standard deviation (n - 1) over the series
/// that have it.
Values values_of(const Ensembles& ensembles, const FigureFrame& frame);

/// The outcome of a variant: figures, run-out curve with the 5-95 % band of the series, tree hits, heights of
/// hits, jumps by slope length. Curves go to the lower end in steps of 5 m.
VariantOutcome outcome_of(const Ensembles& ensembles, const FigureFrame& frame, const RebuiltSlope& slope,
                          bool with_stand);

}  // namespace coupling::validation
