#include "coupling/assessments/hazard/hazard_screen.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "config/text/numbers.hpp"
#include "coupling/assessments/consequences/risk_words.hpp"
#include "coupling/assessments/hazard/target_ranks.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/inputs/tables/words.hpp"
#include "coupling/results/text/markup.hpp"

namespace coupling::hazard {
namespace {

void print_risk(const risk::RiskResults& risk) {
    for (const Cover cover : risk.slopes) {
        const risk::SlopeRisk& slope = risk.all.slopes[index_of(cover)];
        const risk::Estimate& money = slope.at(risk::Quantity::money);
        const risk::Estimate& deaths = slope.at(risk::Quantity::deaths);
        std::printf("  risk of %s %s: ", counted(risk.targets.size(), "exposed target").c_str(),
                    cover == Cover::forest ? "with forest" : "on the bare slope");
        if (!std::isnan(deaths.value)) {
            std::printf("%s deaths a year (95 %%: %s to %s); in money ",
                        consequences::rate_text(deaths.value).c_str(),
                        consequences::rate_text(deaths.low).c_str(),
                        consequences::rate_text(deaths.high).c_str());
        }
        std::printf("%s %s a year (95 %%: %s to %s)\n", report::three_digits(money.value).c_str(),
                    risk.settings.currency.c_str(), report::three_digits(money.low).c_str(),
                    report::three_digits(money.high).c_str());
    }
    if (!risk.avoided) {
        return;
    }
    for (const risk::AvoidedOnSlope& slope : risk.avoided->slopes) {
        std::printf("  nets and works spare %s: %s %s a year (95 %%: %s to %s)\n",
                    slope.cover == Cover::forest ? "with forest" : "on the bare slope",
                    report::three_digits(slope.money.value).c_str(), risk.settings.currency.c_str(),
                    report::three_digits(slope.money.low).c_str(),
                    report::three_digits(slope.money.high).c_str());
    }
    if (const auto cost = risk.avoided->cost_per_year()) {
        std::printf("  and cost %s %s a year\n", report::three_digits(*cost).c_str(),
                    risk.settings.currency.c_str());
    }
}

/// At how many targets the rule for comparison gives another level, and by how much at most.
void print_comparison(const HazardResults& results) {
    for (const SlopeHazard& slope : results.slopes) {
        const std::vector<LevelSteps> found =
            level_differences(levels_of_targets(slope, &TargetHazard::ruled),
                              levels_of_targets(slope, &TargetHazard::compared));
        std::size_t differ = 0;
        for (const LevelSteps& of : found) {
            differ += of.places.size();
        }
        std::printf("  hazard.rule %s, for comparison, %s: ", rule_name(slope.compared.rule),
                    slope.cover == Cover::forest ? "with forest" : "on the bare slope");
        if (found.empty()) {
            std::printf("the same levels\n");
            continue;
        }
        const auto most = static_cast<std::uint64_t>(std::abs(found.front().steps));
        std::printf("another level at %zu of %s, by up to %s\n", differ,
                    counted(slope.targets.size(), "target").c_str(), counted(most, "step").c_str());
    }
}

}  // namespace

void print_summary(const HazardResults& results) {
    std::printf("hazard map of %s\n", counted(results.periods.size(), "return period").c_str());
    for (const SlopeHazard& slope : results.slopes) {
        const FinishedPeriod& most = leaves_most(results.periods, slope.cover);
        const char* name = slope.cover == Cover::forest ? "with forest" : "over the bare slope";
        std::printf("  return period of %s years: %s\n", config::to_text(most.return_period_years).c_str(),
                    in_words(most.departures[index_of(slope.cover)], name).c_str());
    }
    const std::vector<std::size_t> hit = ranked_targets(results);
    const std::size_t all = results.site.targets.size();
    if (all > 0) {
        std::printf("  rocks hit %zu of %s; levels by hazard.rule %s:\n", hit.size(),
                    counted(all, "target").c_str(), rule_name(results.scenario.hazard.rule));
    }
    constexpr std::size_t most_shown = 10;
    for (std::size_t k = 0; k < std::min(most_shown, hit.size()); ++k) {
        std::printf("  %s:", results.site.targets[hit[k]].name.c_str());
        for (const SlopeHazard& slope : results.slopes) {
            const TargetHazard& here = slope.targets[hit[k]];
            std::printf("%s %s %s", &slope == &results.slopes.front() ? "" : ";",
                        level_name(here.ruled.level),
                        slope.cover == Cover::forest ? "with forest" : "on the bare slope");
            if (slope.map.rule == HazardRule::cadanav) {
                for (const FewRocks& few : here.few_rocks) {
                    std::printf(" (by only %s of its class, most often of the return period of %s years)",
                                counted(few.rocks, "rock").c_str(),
                                config::to_text(few.return_period_years).c_str());
                }
            } else if (here.rests_on_few_rocks(slope.map.rule)) {
                const std::uint64_t rocks = here.ruled.energy.rocks;
                std::printf(" (by the %s of the return period of %s years)",
                            rocks == 1 ? "energy of the only rock"
                                       : ("largest energy of only " + counted(rocks, "rock")).c_str(),
                            config::to_text(here.ruled.release_years).c_str());
            }
        }
        std::printf("\n");
    }
    if (hit.size() > most_shown) {
        std::printf("  and %zu more: tables/hazard_targets.csv\n", hit.size() - most_shown);
    }
    if (all > 0) {
        print_comparison(results);
    }
    if (results.risk) {
        print_risk(*results.risk);
    }
}

}  // namespace coupling::hazard
