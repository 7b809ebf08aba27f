#pragma once

#include <string>
#include <vector>

#include "validation/engine/case/case_result.hpp"
#include "validation/engine/factors/factor_plan.hpp"
#include "validation/engine/factors/series_estimate.hpp"
#include "validation/engine/kinds/validation_case.hpp"

namespace coupling::validation {

/// What falls with and without forest give under one combination of settings.
struct CombinationOutcome {
    Combination settings;
    double basal_area_m2pha = 0.0;
    double analytic_free_path_m = 0.0;  ///< 1 / (n (D + DBH)) with n stems per m2 and the mean DBH
    std::map<std::string, SeriesEstimate> figures;  ///< by the names of factor_figures()
    double bare_arrivals = 0.0;                     ///< at the foot, of all series
};

/// Judges one direction on outcomes of all combinations.
///
/// The figure at a step is its mean over all combinations of the other crossed settings; a combination counts
/// only with its whole chain, so that steps differ in nothing else. Chains with a figure that no rock gives
/// are left out. The basal area has three steps: the lower, middle and upper third of the stands by rank.
///
/// A direction holds (Verdict::inside) if no step goes against it by more than the interval of that step, and
/// the last step differs from the first as expected by more than the interval of that difference. Intervals:
/// series_estimate.hpp.
DirectionRow judge_direction(const Direction& direction, const FactorPlan& plan,
                             const std::vector<CombinationOutcome>& outcomes);

/// Forest against bare slope over the combinations of a case's factors, in strict and in default.
///
/// Series i falls the same rocks under every combination and over the bare slope (common random numbers),
/// with forest through stand i. Figures at the foot, the lower end of the profile:
///
/// - protection_effect = 1 - N_forest / N_bare, N the rocks that arrive [-]; where none comes through the
///   forest the interval is that of protection_effect() in coupling/results/figures/indicators.hpp;
/// - energy_kept_share = 1 - (sum of energies with forest) / (sum over the bare slope) [-];
/// - residual_energy_kj: mean energy of the rocks that arrive with forest;
/// - hits_per_rock: tree hits of a rock;
/// - free_path_m: way down the slope in plan within the stand, per tree hit. A little shorter than the path
///   itself, which also goes sideways.
///
/// The recipe itself, as one ensemble with and without forest, fills the verdict rows, outcomes and curves.
CaseResult validate_factors(const ValidationCase& of, int threads, bool quiet = true);

}  // namespace coupling::validation
