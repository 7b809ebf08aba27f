#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "validation/engine/case/plot.hpp"

namespace coupling::validation {

/// A figure of a case: over all rocks, and between series of few rocks as an experiment has them.
struct Value {
    double value = 0.0;               ///< of the one large ensemble; NaN where no rock gives it
    std::optional<double> series;     ///< mean over the small series
    std::optional<double> deviation;  ///< standard deviation between the small series
};

/// Figures by the name of their quantity.
using Values = std::map<std::string, Value>;

/// The jumps that end in one stretch of slope.
struct SegmentJumps {
    double from_m = 0.0;  ///< along the slope from its upper end
    double to_m = 0.0;
    std::uint64_t jumps = 0;
    double shortest_m = 0.0;  ///< straight from impact to impact
    double mean_m = 0.0;
    double longest_m = 0.0;
    double deviation_m = 0.0;    ///< n - 1; NaN of one jump
    double mean_height_m = 0.0;  ///< of their largest heights above the ground, vertical
    double highest_m = 0.0;
    bool upper = true;  ///< in the upper half of the slope length
};

/// A corner of a curve.
struct CurvePoint {
    double x;
    double y;
};

/// What one set of settings gives on one case.
struct VariantOutcome {
    std::string variant;  ///< "strict", "default", "paper_initial", ...
    std::string meaning;
    Values values;
    std::vector<CurvePoint> run_out;  ///< (plan distance [m], share of rocks that get further)
    std::vector<CurvePoint> run_out_low, run_out_high;  ///< 5 and 95 % of the small series
    std::vector<double> tree_hits;  ///< share of rocks by number of hits; empty without stand
    std::vector<double> tree_hits_low, tree_hits_high;  ///< 5 and 95 % of the small series
    std::vector<double> hit_heights;  ///< share of hits by height, bins of 0.5 m; empty without
    std::vector<SegmentJumps> jumps;
};

/// A free choice of the rebuilding, moved, and what that does to the figures.
struct ChoiceOutcome {
    std::string choice;
    std::string overrides;
    std::string reason;
    Values strict_values;
    Values default_values;
};

enum class Verdict : std::uint8_t { inside, missed, no_criterion };

/// A line of the verdict table.
struct VerdictRow {
    std::string quantity;
    std::string label;  ///< for people, such as "mean of maximum speeds"
    std::string unit;
    std::optional<double> observed;
    std::string observed_source;
    std::optional<double> published;
    std::optional<double> published_deviation;
    std::string published_source;
    Value strict_value;
    Value default_value;
    std::optional<Value> scatter_value{};  ///< of the variant strict_scatter, where the case has it
    std::optional<double> low, high;       ///< criterion
    std::string rests_on;                  ///< "independent" or "rebuilding"
    std::string rule;                      ///< where the criterion comes from
    Verdict strict_verdict = Verdict::no_criterion;
    Verdict default_verdict = Verdict::no_criterion;
    std::string cause;       ///< likely cause of a miss, as the case's folder states it
    std::string model{};     ///< motion model of the figure with default settings; "" without one
    std::string measures{};  ///< as Figure has it
};

/// A figure of the field, or of a paper where the field gives none, against two 90 % bands of the simulated
/// one.
struct Coverage {
    std::string quantity;
    double known = 0.0;
    bool observed = false;  ///< else published
    double value = 0.0;     ///< with default settings
    double of_rocks = 0.0;  ///< half width by the chance of as many rocks as were observed
    double of_all = 0.0;    ///< half width by that and all that is not known
    bool in_rocks = false;
    bool in_all = false;
};

/// The slope as it was used, for the page.
struct ProfileCorner {
    double distance_m;
    double height_m;
    std::string surface;
};

/// A stretch of slope that rocks may stop in.
struct SectionShare {
    std::string section;
    double from_m = 0.0;  ///< in plan from the start
    double to_m = 0.0;
    std::optional<double> observed;  ///< share of rocks that stop in it
    std::optional<double> published;
};

/// A figure with its 95 % interval.
struct Estimate {
    double value = 0.0;
    double low = 0.0;
    double high = 0.0;
};

/// One combination of stand and rock on a slope, and what the forest does there.
struct FactorRow {
    std::string variant;           ///< "strict" or "default"
    std::string alone;             ///< the setting that moved alone; empty where all moved together
    std::vector<double> settings;  ///< in the order of CaseResult::factor_settings
    std::map<std::string, Estimate> figures;
};

/// Whether a figure goes the way the literature has it when a setting grows.
struct DirectionRow {
    std::string variant;  ///< "strict" or "default"
    std::string figure;
    std::string setting;
    bool rises = true;  ///< as the literature has it
    std::string source;
    std::vector<double> steps;        ///< values of the setting
    std::vector<Estimate> at_steps;   ///< the figure there, mean over all other settings
    std::uint64_t steps_against = 0;  ///< steps that go the other way by more than their interval
    Estimate change;                  ///< from the first step to the last
    Verdict verdict = Verdict::no_criterion;
};

/// Everything that validating a case has found.
struct CaseResult {
    std::string name;
    bool is_own = false;  ///< of a folder of the user's, not shipped
    std::string title;
    std::string citation;
    std::string rebuilt;  ///< one paragraph: what is rebuilt and what that means for the verdicts
    std::vector<ProfileCorner> profile;
    std::vector<VerdictRow> rows;
    std::vector<VariantOutcome> variants;  ///< strict and default first
    std::vector<ChoiceOutcome> choices;
    std::vector<SectionShare> sections;
    std::vector<CurvePoint> observed_run_out;  ///< as run_out of the variants
    std::vector<double> observed_tree_hits;    ///< as tree_hits of the variants
    std::vector<double> published_tree_hits;
    std::vector<std::string> factor_settings;  ///< such as "stand.stems_per_ha"; empty without factors
    std::vector<FactorRow> factors;
    std::vector<DirectionRow> directions;
    std::vector<std::string> notes;     ///< such as "profile.csv replaced by surveyed.csv"
    std::vector<std::string> warnings;  ///< what the user should look at before using the verdicts
    std::vector<std::string> details;   ///< lines for the screen, below the verdicts
    std::vector<Coverage> coverage;     ///< where it was asked for
    bool has_strict = true;             ///< else `default` alone is judged
    std::string extent;                 ///< what was computed, such as "10000 rocks, 100 series of 100"
    std::vector<PlotGroup> plots;
    std::vector<PlainTable> tables;
    std::uint64_t rocks = 0;  ///< 0 where none falls
    std::uint64_t series = 0;
    std::uint64_t rocks_per_series = 0;
    double seconds = 0.0;
};

}  // namespace coupling::validation
