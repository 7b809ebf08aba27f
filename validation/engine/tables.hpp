#pragma once

#include <ostream>
#include <span>

#include "validation/engine/case/case_result.hpp"

namespace coupling::validation {

/// CSV tables of validated cases, one row an observation, units in the names. What is not known or not finite
/// is an empty field.

void write_verdicts(std::ostream& out, std::span<const CaseResult> cases);
/// Every figure of every variant.
void write_figures(std::ostream& out, std::span<const CaseResult> cases);
/// Figures of the verdict table under every moved choice.
void write_choices(std::ostream& out, std::span<const CaseResult> cases);
void write_run_out(std::ostream& out, std::span<const CaseResult> cases);
void write_jumps(std::ostream& out, std::span<const CaseResult> cases);
void write_tree_hits(std::ostream& out, std::span<const CaseResult> cases);
void write_hit_heights(std::ostream& out, std::span<const CaseResult> cases);
/// Figures of every combination of factors with their 95 % intervals; settings as `section.key=value`.
void write_factors(std::ostream& out, std::span<const CaseResult> cases);
void write_directions(std::ostream& out, std::span<const CaseResult> cases);
/// Every point of every plot of the forest.
void write_plots(std::ostream& out, std::span<const CaseResult> cases);

}  // namespace coupling::validation
