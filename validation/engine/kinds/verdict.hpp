#pragma once

#include <span>
#include <vector>

#include "validation/engine/case/case_result.hpp"
#include "validation/engine/kinds/validation_case.hpp"

namespace coupling::validation {

/// Name of the first of the choices: nothing moved, with as few rocks as the choices have.
inline constexpr const char* as_rebuilt = "as rebuilt";

/// Inside where low <= value <= high; a figure that no rock gives misses its criterion.
Verdict verdict_of(double value, const Criterion& criterion);

/// A line for every figure that is observed, published or has a criterion.
std::vector<VerdictRow> verdict_rows(const ValidationCase& of, const Values& strict_values,
                                     const Values& default_values);

/// The same line in a unit that keeps its figures short: parts per billion become per cent or times the
/// reference, g/ha become t/ha. Tables for programs keep the unit of the criterion.
VerdictRow in_readable_unit(VerdictRow row);

/// A verdict that a moved choice changes.
struct Flip {
    std::string choice;
    std::string quantity;
    bool strict = false;  ///< of strict; else of default
    double before = 0.0;  ///< as rebuilt, with as few rocks
    double after = 0.0;
    Verdict becomes = Verdict::no_criterion;
};

/// The verdicts that differ between `as rebuilt` and a moved choice, choice by choice.
std::vector<Flip> flips_of(const CaseResult& result);

/// Whether strict or default misses a criterion, or a direction goes against the literature.
bool misses_any(const CaseResult& result);

}  // namespace coupling::validation
