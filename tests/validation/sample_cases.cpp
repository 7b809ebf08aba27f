#include "tests/validation/sample_cases.hpp"

#include <cmath>

namespace coupling::validation::testing {
namespace {

Value with_series(double value, double series, double deviation) {
    return {value, series, deviation};
}

VerdictRow mean_speed() {
    VerdictRow row;
    row.quantity = "mean_speed_mps";
    row.label = "mean speed";
    row.unit = "m/s";
    row.observed = 8.0;
    row.observed_source = "Rammer et al. 2010, Table 3";
    row.published = 6.8;
    row.published_deviation = 1.2;
    row.published_source = "Rammer et al. 2010, Table 3";
    row.strict_value = with_series(4.9, 4.8, 0.4);
    row.default_value = with_series(7.6, 7.5, 0.5);
    row.low = 5.6;
    row.high = 8.0;
    row.rests_on = "independent";
    row.rule = "published ± one deviation";
    row.strict_verdict = Verdict::missed;
    row.default_verdict = Verdict::inside;
    row.cause = "the taper is off & rocks lose <too much> at stems";
    return row;
}

VerdictRow height(const std::string& quantity, const std::string& label, double observed, double published,
                  double strict, double ours) {
    VerdictRow row;
    row.quantity = quantity;
    row.label = label;
    row.unit = "m";
    row.observed = observed;
    row.observed_source = "Table 3";
    row.published = published;
    row.published_source = "Table 3";
    row.strict_value = with_series(strict, 0.8 * strict, 0.1 * strict);
    row.default_value = with_series(ours, 0.8 * ours, 0.1 * ours);
    return row;
}

VerdictRow tree_hits() {
    VerdictRow row = height("tree_hits", "tree hits per rock", 2.8, 2.8, 2.86, 2.79);
    row.unit = "-";
    row.low = 2.6;
    row.high = 3.1;
    row.rests_on = "rebuilding";
    row.rule = "reference";
    row.strict_verdict = Verdict::inside;
    row.default_verdict = Verdict::inside;
    return row;
}

VerdictRow height_90() {
    VerdictRow row = height("rebound_height_90_m", "90 % of maximum rebound heights", 2.0, 2.2, 2.1, 1.6);
    row.observed.reset();
    row.low = 1.3;
    row.high = 2.2;
    row.rests_on = "independent";
    row.rule = "at most the published";
    row.strict_verdict = Verdict::inside;
    row.default_verdict = Verdict::inside;
    return row;
}

VariantOutcome variant(const std::string& name, double reach, double stretch) {
    VariantOutcome outcome;
    outcome.variant = name;
    outcome.meaning = "all that " + name + " switches on";
    outcome.values["mean_speed_mps"].value = 6.0 * stretch;
    outcome.values["tree_hits"].value = 2.8;
    outcome.values["rebound_height_90_m"].value = 2.1 * stretch;
    outcome.values["rebound_height_max_m"].value = 7.0 * stretch;
    for (int i = 0; i <= 60; ++i) {
        const double x = 4.0 * i;
        const double share = 1.0 / (1.0 + std::exp((x - reach) / 25.0));
        outcome.run_out.push_back({x, share});
        if (name == "strict" || name == "default") {
            outcome.run_out_low.push_back({x, std::max(0.0, share - 0.08 * stretch)});
            outcome.run_out_high.push_back({x, std::min(1.0, share + 0.08 * stretch)});
        }
    }
    return outcome;
}

void add_trees_and_jumps(VariantOutcome& outcome, double stretch) {
    outcome.tree_hits = {0.1, 0.16, 0.22 * stretch, 0.2, 0.13, 0.08, 0.05, 0.03, 0.004};
    outcome.hit_heights = {0.6, 0.2, 0.11 * stretch, 0.05, 0.02, 0.01};
    for (int i = 0; i < 24; ++i) {
        const double mean = stretch * (3.0 + 2.0 * std::sin(0.4 * i));
        outcome.jumps.push_back(
            {10.0 * i, 10.0 * (i + 1), i == 15 ? 0U : 120U, 0.3 * mean, mean, 2.4 * mean});
    }
}

}  // namespace

CaseResult forested_case() {
    CaseResult result;
    result.name = "vaujany_forest";
    result.title = "Vaujany, Site 2 <forested>";
    result.citation = "Rammer et al. 2010, Nat. Hazards Earth Syst. Sci. 10:699-711";
    result.rebuilt = "The profile and the map of trees are not public: both are drawn from published means.";
    result.profile = {{0.0, 1400.0, "fine_debris_forest"},
                      {70.0, 1345.3, "soil_with_debris"},
                      {140.0, 1290.6, "road"},
                      {144.0, 1290.6, "forest_soil"},
                      {190.0, 1254.7, "forest_soil_woody_debris"},
                      {240.0, 1215.6, "forest_soil_woody_debris"}};
    result.rows = {mean_speed(), tree_hits(), height_90(),
                   height("rebound_height_max_m", "largest rebound height", 2.0, 7.9, 8.4, 4.2)};
    result.variants = {variant("strict", 140.0, 1.0),
                       variant("default", 150.0, 0.8),
                       variant("initial", 190.0, 1.5),
                       variant("improved rebound", 170.0, 1.2),
                       variant("strict + contact zone", 145.0, 0.9),
                       variant("strict + scatter", 141.0, 1.1)};
    add_trees_and_jumps(result.variants[0], 1.0);
    add_trees_and_jumps(result.variants[1], 0.9);
    ChoiceOutcome steeper{
        "slope steeper by 1 deg", "terrain.slope_change_deg=1", "survey error of a slope", {}, {}};
    steeper.strict_values["mean_speed_mps"].value = 5.2;
    steeper.strict_values["tree_hits"].value = 2.9;
    steeper.default_values["mean_speed_mps"].value = 8.3;
    steeper.default_values["tree_hits"].value = 2.9;
    ChoiceOutcome base{"as rebuilt", "", "nothing moved; as few rocks as below", {}, {}};
    base.strict_values["mean_speed_mps"].value = 4.95;
    base.strict_values["tree_hits"].value = 2.8;
    base.default_values["mean_speed_mps"].value = 7.7;
    base.default_values["tree_hits"].value = 2.8;
    result.choices = {base, steeper};
    result.sections = {{"A", 0.0, 120.0, {}, {}}, {"B", 120.0, 220.0, 0.33, 0.3}};
    result.observed_run_out = {{223.5, 0.34}};
    result.observed_tree_hits = {0.14, 0.2, 0.16, 0.17, 0.12, 0.11, 0.06, 0.04};
    result.published_tree_hits = {0.08, 0.15, 0.24, 0.22, 0.13, 0.09, 0.05, 0.04};
    result.notes = {"profile.csv replaced by <surveyed>.csv"};
    result.rocks = 10'000;
    result.series = 100;
    result.rocks_per_series = 100;
    return result;
}

CaseResult bare_case() {
    CaseResult result;
    result.name = "steg";
    result.title = "Steg";
    VerdictRow row;
    row.quantity = "run_out_m";
    row.label = "run-out";
    row.unit = "m";
    row.strict_value.value = std::nan("");
    row.default_value.value = 447.0;
    row.low = 435.0;
    row.high = 471.0;
    row.rests_on = "independent";
    row.strict_verdict = Verdict::missed;
    row.default_verdict = Verdict::inside;
    result.rows = {row};
    return result;
}

}  // namespace coupling::validation::testing
