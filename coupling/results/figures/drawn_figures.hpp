#pragma once

#include <optional>

#include "coupling/results/figures/drawn_figure.hpp"
#include "coupling/results/figures/run_results.hpp"

namespace coupling {

struct Figures;

/// Nothing where nothing was drawn.
///
/// Shares, the protection effect and means are those of each stratum. A percentile has too few rocks in a
/// stratum: it is taken to change as the mean does [choice].
std::optional<DrawnFigures> drawn_figures(const RunResults& results, const Figures& figures);

}  // namespace coupling
