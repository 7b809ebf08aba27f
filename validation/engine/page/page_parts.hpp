#pragma once

#include <optional>
#include <string>
#include <vector>

#include "validation/engine/case/case_result.hpp"
#include "validation/engine/case/factor_names.hpp"

namespace coupling::validation {

// The parts of the page, each a piece of HTML.

/// Each figure as observed, published and ours, with its criterion; sources as numbered notes below.
std::string verdict_table(const CaseResult& result);
/// The misses in words, each with its likely cause; empty without any.
std::string misses(const CaseResult& result);
/// The slope, run-out, tree hits and jumps.
std::string case_charts(const CaseResult& result);
/// The slope at true scale with its ground types.
std::string profile_drawing(const CaseResult& result);
/// All variants side by side; empty with fewer than two.
std::string variants_table(const CaseResult& result);
/// What moving each free choice does to the figures that have a criterion; empty without choices.
std::string choices_table(const CaseResult& result);
/// Figures over the settings of stand and rock; empty without them.
std::string factors_part(const CaseResult& result);

/// Plots and tables of a case of the forest; empty for others.
std::string plots_part(const CaseResult& result);

// What the parts share.

/// One of the two sets of settings that are judged, and where results keep it.
struct Side {
    const char* name;
    Value VerdictRow::*value;
    Verdict VerdictRow::*verdict;
    Values ChoiceOutcome::*moved;
};
inline constexpr Side strict_side{"strict", &VerdictRow::strict_value, &VerdictRow::strict_verdict,
                                  &ChoiceOutcome::strict_values};
inline constexpr Side default_side{"default", &VerdictRow::default_value, &VerdictRow::default_verdict,
                                   &ChoiceOutcome::default_values};

/// Criteria of a case met and missed by one side; directions of factors count as criteria.
struct Score {
    std::size_t met = 0;
    std::size_t missed = 0;
    std::size_t met_independent = 0;  ///< of those that do not rest on the rebuilding
    std::size_t independent = 0;

    void add(Verdict verdict, bool rests_on_nothing);
    void add(const Score& other);
    [[nodiscard]] std::string text() const;  ///< "3 of 4"
};
Score score_of(const CaseResult& result, const Side& side);

/// How many figures of strict and default are nearer to the observed ones than the published model's, of
/// those that are both observed and published.
struct Nearness {
    std::size_t compared = 0;
    std::size_t strict = 0;
    std::size_t ours = 0;
};
Nearness nearness(const CaseResult& result);

/// "met" or "missed" as a badge; "no criterion" as an en dash.
std::string badge(Verdict verdict);
/// "9.4 to 10.4", "at most 8", "at least 0.999"; an en dash without either.
std::string criterion_text(const VerdictRow& row);
/// Whether a value lies inside the row's criterion; a NaN never does.
Verdict judge(const VerdictRow& row, double value);
/// Label and unit of a row, escaped: "mean speed, m/s".
std::string row_name(const VerdictRow& row);
/// The class of a variant's series in the charts: by name for strict and default, by place for others.
std::string series_of(const CaseResult& result, std::size_t variant);
/// Two decimals below 10, one below 100, none above; an en dash where it is not finite.
std::string figure_text(double value);
/// "6.80 ± 1.20": the deviation has the decimals of the value.
std::string figure_text(double value, double deviation);

}  // namespace coupling::validation
