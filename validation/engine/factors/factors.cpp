#include "validation/engine/factors/factors.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "config/text/joined.hpp"
#include "config/units/constants.hpp"
#include "coupling/results/figures/indicators.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/run/progress.hpp"
#include "validation/engine/factors/outcome.hpp"
#include "validation/engine/kinds/verdict.hpp"

namespace coupling::validation {
namespace {

using config::j_per_kj;
using config::joined;

/// What the figures need of each series.
struct SeriesSums {
    std::vector<double> rocks;
    std::vector<double> arrivals;  ///< at the foot
    std::vector<double> energy_kj;
    std::vector<double> hits;
    std::vector<double> way_m;  ///< down the slope within the stand
};

/// Where trees stand, in plan along the profile.
struct Reach {
    double from_m = 0.0;
    double to_m = 0.0;
    [[nodiscard]] double way_m(double end_m) const { return std::clamp(end_m, from_m, to_m) - from_m; }
};

SeriesSums sums_of(const std::vector<Falls>& series, const Reach& reach) {
    SeriesSums sums;
    for (const Falls& falls : series) {
        double arrivals = 0.0;
        double energy_kj = 0.0;
        double hits = 0.0;
        double way_m = 0.0;
        for (std::size_t rock = 0; rock < falls.rocks.size(); ++rock) {
            const rockfall::Arrival& at_foot = falls.arrival(rock, falls.lines - 1);
            arrivals += at_foot.reached ? 1.0 : 0.0;
            energy_kj += at_foot.reached ? static_cast<double>(at_foot.energy_j) / j_per_kj : 0.0;
            hits += falls.rocks[rock].tree_hits;
            way_m += reach.way_m(falls.rocks[rock].end_m);
        }
        sums.rocks.push_back(static_cast<double>(falls.rocks.size()));
        sums.arrivals.push_back(arrivals);
        sums.energy_kj.push_back(energy_kj);
        sums.hits.push_back(hits);
        sums.way_m.push_back(way_m);
    }
    return sums;
}

std::map<std::string, SeriesEstimate> figures_of(const SeriesSums& forest, const SeriesSums& bare) {
    return {{"protection_effect", one_minus(ratio_of(forest.arrivals, bare.arrivals))},
            {"energy_kept_share", one_minus(ratio_of(forest.energy_kj, bare.energy_kj))},
            {"residual_energy_kj", ratio_of(forest.energy_kj, forest.arrivals)},
            {"hits_per_rock", ratio_of(forest.hits, forest.rocks)},
            {"free_path_m", ratio_of(forest.way_m, forest.hits)}};
}

double analytic_free_path_m(const Recipe& recipe) {
    constexpr double ha_per_m2 = 1e-4;
    constexpr double m_per_cm = 0.01;
    return 1.0 / (recipe.stems_per_ha * ha_per_m2 * (recipe.diameter_m + m_per_cm * recipe.dbh_mean_cm));
}

/// The interval of a figure; that of the protection effect knows what it means if no rock comes through.
Estimate interval_of(const std::string& figure, const CombinationOutcome& outcome) {
    const SeriesEstimate& estimate = outcome.figures.at(figure);
    if (figure == "protection_effect" && estimate.value == 1.0) {
        const auto effect = protection_effect({0, 0, static_cast<std::uint64_t>(outcome.bare_arrivals)});
        return {1.0, effect->interval.low, 1.0};
    }
    return estimate.interval();
}

/// All combinations under one set of settings.
class FactorRun {
public:
    FactorRun(const ValidationCase& of, std::string preset, int threads, Progress& progress)
        : case_{of},
          preset_{std::move(preset)},
          request_{.threads = threads, .fallen = [&progress](std::uint64_t rocks) { progress.add(rocks); }} {}

    std::vector<CombinationOutcome> run(const FactorPlan& plan) {
        std::vector<CombinationOutcome> outcomes;
        const std::unique_ptr<Recipe> base = case_.recipe(preset_);
        for (const Combination& combination : plan.combinations()) {
            outcomes.push_back(fall(plan, combination, *base));
        }
        return outcomes;
    }

    /// The recipe as it stands, as one large ensemble.
    VariantOutcome run_base() {
        const std::unique_ptr<Recipe> recipe = case_.recipe(preset_);
        const RebuiltSlope slope = rebuild(*recipe, case_.profile(*recipe));
        FallRequest both = request_;
        both.open_too = true;
        VariantOutcome outcome = outcome_of(simulate_falls(*recipe, slope, both),
                                            frame_of(*recipe, slope, case_.sections), slope, true);
        outcome.variant = preset_;
        return outcome;
    }

private:
    /// Series alone, each through a stand of its own.
    [[nodiscard]] std::unique_ptr<Recipe> recipe_for(const std::vector<std::string>& overrides) const {
        std::unique_ptr<Recipe> recipe = case_.recipe(preset_, overrides);
        recipe->rocks = 0;
        recipe->stands = std::max<std::uint64_t>(1, recipe->series);
        return recipe;
    }

    CombinationOutcome fall(const FactorPlan& plan, const Combination& combination, const Recipe& base) {
        const std::vector<std::string> overrides = plan.overrides(combination, base);
        const std::unique_ptr<Recipe> recipe = recipe_for(overrides);
        const RebuiltSlope slope = rebuild(*recipe, case_.profile(*recipe));
        const Reach reach{std::max(recipe->stand_from_m, slope.upper_m()),
                          std::min(recipe->stand_to_m, slope.lower_m() + margin_m)};
        const SeriesSums forest = sums_of(simulate_falls(*recipe, slope, request_).series, reach);
        const SeriesSums& bare = over_bare_slope(overrides, slope, reach);
        CombinationOutcome outcome;
        outcome.settings = combination;
        outcome.basal_area_m2pha =
            basal_area_m2pha(recipe->stems_per_ha, recipe->dbh_mean_cm, recipe->dbh_deviation_cm);
        outcome.analytic_free_path_m = analytic_free_path_m(*recipe);
        outcome.figures = figures_of(forest, bare);
        outcome.bare_arrivals = std::accumulate(bare.arrivals.begin(), bare.arrivals.end(), 0.0);
        return outcome;
    }

    /// The stand does not matter there: once for all combinations that differ in nothing else.
    const SeriesSums& over_bare_slope(const std::vector<std::string>& overrides, const RebuiltSlope& slope,
                                      const Reach& reach) {
        std::vector<std::string> without_stand;
        std::copy_if(overrides.begin(), overrides.end(), std::back_inserter(without_stand),
                     [](const std::string& text) { return !text.starts_with("stand."); });
        const auto [found, is_new] = bare_.try_emplace(without_stand);
        if (is_new) {
            without_stand.emplace_back("stand.stems_per_ha=0");
            found->second =
                sums_of(simulate_falls(*recipe_for(without_stand), slope, request_).series, reach);
        }
        return found->second;
    }

    const ValidationCase& case_;
    std::string preset_;
    FallRequest request_;
    std::map<std::vector<std::string>, SeriesSums> bare_;
};

void add_rows(CaseResult& result, const std::string& preset, const FactorPlan& plan,
              const std::vector<CombinationOutcome>& outcomes) {
    std::size_t place = 0;
    for (const CombinationOutcome& outcome : outcomes) {
        FactorRow row{preset, plan.alone_at(place++), outcome.settings, {}};
        for (const std::string& figure : factor_figures()) {
            row.figures[figure] = interval_of(figure, outcome);
        }
        row.figures["analytic_free_path_m"] = {outcome.analytic_free_path_m, outcome.analytic_free_path_m,
                                               outcome.analytic_free_path_m};
        row.figures["basal_area_m2pha"] = {outcome.basal_area_m2pha, outcome.basal_area_m2pha,
                                           outcome.basal_area_m2pha};
        result.factors.push_back(std::move(row));
    }
    for (const Direction& direction : plan.directions) {
        result.directions.push_back(judge_direction(direction, plan, outcomes));
        result.directions.back().variant = preset;
    }
}

/// How far the protection effects of one set reach, in words.
std::string range_note(const std::string& preset, const std::vector<CombinationOutcome>& outcomes) {
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    for (const CombinationOutcome& outcome : outcomes) {
        const double effect = outcome.figures.at("protection_effect").value;
        least = std::min(least, effect);
        most = std::max(most, effect);
    }
    return joined(preset, ": protection effects of ", report::percent(least), " to ", report::percent(most),
                  " over ", std::to_string(outcomes.size()), " combinations");
}

std::uint64_t falls_planned(const Recipe& recipe, const FactorPlan& plan) {
    const std::uint64_t of_series = recipe.series * recipe.rocks_per_series;
    const std::uint64_t combinations = plan.combinations().size();
    return 2 * (combinations * of_series + 2 * (recipe.rocks + of_series));
}

CaseResult head_of(const ValidationCase& of, const Recipe& recipe) {
    CaseResult result;
    result.name = of.files.name;
    result.is_own = of.files.is_own();
    result.title = recipe.head.title;
    result.citation = recipe.head.citation;
    result.rebuilt = recipe.head.rebuilt;
    result.profile = with_slope_change(of.profile(recipe), recipe.slope_change_deg);
    result.notes = of.notes;
    result.rocks = recipe.rocks;
    result.series = recipe.series;
    result.rocks_per_series = recipe.rocks_per_series;
    result.extent = extent_of(recipe);
    return result;
}

}  // namespace

CaseResult validate_factors(const ValidationCase& of, int threads, bool quiet) {
    const std::unique_ptr<Recipe> recipe = of.recipe("default");
    const FactorPlan plan = read_factor_plan(of.files, *recipe);
    CaseResult result = head_of(of, *recipe);
    for (const Factor& factor : plan.factors) {
        result.factor_settings.push_back(factor.setting);
    }
    Progress progress{of.files.name, falls_planned(*recipe, plan), 0, quiet};
    for (const std::string preset : {"strict", "default"}) {
        FactorRun run{of, preset, threads, progress};
        result.variants.push_back(run.run_base());
        const std::vector<CombinationOutcome> outcomes = run.run(plan);
        add_rows(result, preset, plan, outcomes);
        result.notes.push_back(range_note(preset, outcomes));
    }
    result.variants[0].meaning = of.variants[0].meaning;
    result.variants[1].meaning = of.variants[1].meaning;
    result.rows = verdict_rows(of, result.variants[0].values, result.variants[1].values);
    progress.finish();
    result.seconds = progress.seconds();
    return result;
}

}  // namespace coupling::validation
