#include "coupling/assessments/vary/write_table.hpp"

#include "config/units/constants.hpp"
#include "coupling/results/tables/figure_columns.hpp"

namespace coupling::vary {
namespace {

using config::percent;

constexpr const char* from_factors = "input FACTORS.csv";

/// A target in a run of the study; the first one is that of the scenario.
struct TargetOfRun : TargetOutcome {
    std::size_t number;
    const Outcome& outcome;

    [[nodiscard]] const Combination& combination() const { return outcome.combination; }
};

/// A regime at a target in a run of a study over years.
struct RegimeOfRun : RegimeOutcome {
    std::size_t number;
    const RegimeRun& run;

    [[nodiscard]] const Combination& combination() const { return run.combination; }
};

/// Which run it is: a column for each factor, empty where it is as in the scenario.
template <class Row>
ColumnsOf<Row> run_columns(const std::vector<Factor>& factors) {
    ColumnsOf<Row> columns{
        {"run", "number of the run; 0: the scenario as it is", "definition", &Row::number},
        {"moved", "none, or whether settings are moved alone or crossed; their columns follow", from_factors,
         [](const Row& row) {
             return row.number == 0 ? "none" : row.combination().alone.empty() ? "crossed" : "alone";
         }}};
    for (std::size_t i = 0; i < factors.size(); ++i) {
        columns += {factors[i].setting, "value of the setting; empty: as in the scenario", from_factors,
                    [i](const Row& row) { return row.combination().values[i]; }};
    }
    return columns;
}

/// What arrives on one slope: share_bare, energy_mean_bare_kj, ...
ColumnsOf<ArrivalFigures> slope_outcome_columns(const std::string& slope, const char* where) {
    const std::string share = "share_" + slope;
    return {{share, 6, std::string{"share of the rocks that arrive "} + where, from_counting,
             [](const auto& f) { return f.share.value; }},
            {share + "_low", 6, "lower end of its 95 % interval", "Clopper and Pearson 1934",
             [](const auto& f) { return f.share.interval.low; }},
            {share + "_high", 6, "upper end of its 95 % interval", "Clopper and Pearson 1934",
             [](const auto& f) { return f.share.interval.high; }},
            {"energy_mean_" + slope + "_kj", 3, "mean of their energies",
             [](const auto& f) { return f.energy_kj.mean; }},
            {"energy_p95_" + slope + "_kj", 3, "95th percentile of their energies",
             [](const auto& f) { return f.energy_kj.p95; }},
            {"height_mean_" + slope + "_m", 3, "mean of their heights, of the underside above the ground",
             [](const auto& f) { return f.height_m.mean; }},
            {"height_p95_" + slope + "_m", 3, "95th percentile of these heights",
             [](const auto& f) { return f.height_m.p95; }},
            {"top_height_p95_" + slope + "_m", 3,
             "95th percentile of the heights of the rock's highest point above the ground, which a net needs",
             [](const auto& f) { return f.top_height_m.p95; }}};
}

TableOf<TargetOfRun> target_table(const std::vector<Factor>& factors) {
    constexpr const char* paired = "paired ratio by the delta method (coupling/results/README.md)";
    const ColumnsOf<ProtectionEffect> effect{
        {"protection_percent", 3, "share of the arriving rocks that the forest stops", from_counting,
         [](const auto& e) { return percent * e.value; }},
        {"protection_low_percent", 3, "lower end of its 95 % interval", paired,
         [](const auto& e) { return percent * e.interval.low; }},
        {"protection_high_percent", 3, "upper end of its 95 % interval", paired,
         [](const auto& e) { return percent * e.interval.high; }}};
    return {"vary.csv",
            "",
            "a run of a study of today and a target",
            {run_columns<TargetOfRun>(factors),
             {target_id_column(), &TargetOutcome::id},
             {"rocks", "rocks that fell", from_counting, [](const auto& row) { return row.outcome.rocks; }},
             {slope_outcome_columns("bare", "over the bare slope"), &TargetOutcome::bare},
             {slope_outcome_columns("forest", "with forest"),
              [](const auto& row) { return row.outcome.with_forest ? &row.forest : nullptr; }},
             {effect, &TargetOutcome::protection},
             {"run_out_mean_m", 2, "mean run-out of the rocks that stop",
              [](const auto& row) { return row.outcome.run_out_mean_m; }},
             {"left_terrain_percent", 4, "share of the rocks that leave the terrain", from_counting,
              [](const auto& row) { return percent * row.outcome.left_terrain.value; }}}};
}

TableOf<RegimeOfRun> regime_table(const std::vector<Factor>& factors) {
    using decades::PairedDifference;
    constexpr const char* paired = "pairs of replicates, Student's t";
    const ColumnsOf<PairedDifference> difference{
        {"pairs", "replicates that know protection in both regimes", paired, &PairedDifference::pairs},
        {"difference_percent", 3, "protection minus that of the first regime", paired,
         &PairedDifference::mean},
        {"difference_low_95", "%", 3, "lower end of its 95 % interval", paired, &PairedDifference::low},
        {"difference_high_95", "%", 3, "upper end of its 95 % interval", paired, &PairedDifference::high},
        {"replicates_needed", "replicates to tell the two apart; empty: not known", paired,
         [](const auto& d) { return decades::replicates_needed(d.mean, d.deviation); }}};
    return {
        "vary.csv",
        "",
        "a run of a study over years, a climate, a target and a regime",
        {run_columns<RegimeOfRun>(factors),

         {"climate", "name of the climate", "input climate.variants", &RegimeOutcome::climate},
         {target_id_column(), &RegimeOutcome::target},
         {"regime", "name of the regime", "input regimes.list", &RegimeOutcome::regime},
         {"protection_percent", 3, "mean over years with rocks after the start and replicates",
          &RegimeOutcome::protection_percent},
         {"rank", "1: the regime with the highest", &RegimeOutcome::rank},
         {"rank_changes",
          "yes: it stands before a regime that it is behind in the scenario, or the other way round, both "
          "beyond chance (pairs of replicates, 95 %)",
          &RegimeOutcome::changes_rank},
         {difference, &RegimeOutcome::difference},
         {"cheapest_that_keeps",
          "regime that keeps what [decision] asks for at the least cost; empty: none, or undecided",
          [](const auto& row) { return row.run.cheapest; }}}};
}

}  // namespace

std::vector<TableLayout> target_layouts(const std::vector<Factor>& factors) {
    return {target_table(factors)};
}

std::vector<TableLayout> regime_layouts(const std::vector<Factor>& factors) {
    return {regime_table(factors)};
}

const std::vector<TableLayout>& vary_layouts() {
    static const std::vector<TableLayout> layouts = together(target_layouts({}), regime_layouts({}));
    return layouts;
}

void write_table(std::ostream& out, const std::vector<Factor>& factors,
                 const std::vector<Outcome>& outcomes) {
    target_table(factors).write_to(out, [&](auto& rows) {
        for (std::size_t i = 0; i < outcomes.size(); ++i) {
            for (const TargetOutcome& target : outcomes[i].targets) {
                rows.add({target, i, outcomes[i]});
            }
        }
    });
}

void write_regime_table(std::ostream& out, const std::vector<Factor>& factors,
                        const std::vector<RegimeRun>& runs) {
    regime_table(factors).write_to(out, [&](auto& rows) {
        for (std::size_t i = 0; i < runs.size(); ++i) {
            for (const RegimeOutcome& regime : runs[i].regimes) {
                rows.add({regime, i, runs[i]});
            }
        }
    });
}

}  // namespace coupling::vary
