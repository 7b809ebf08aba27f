#include "coupling/assessments/hazard/hazard_answers.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <optional>
#include <set>
#include <utility>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "config/units/constants.hpp"
#include "coupling/assessments/hazard/target_ranks.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/figures/few_rocks.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"
#include "coupling/results/text/years.hpp"

namespace coupling::hazard {
namespace {

using config::joined;
using report::page_text;
using report::PageFields;

/// Cards of the first screen.
constexpr std::size_t most_cards = 4;
constexpr double m2_of_a_hectare = 1e4;

std::string energy_text(double energy_kj) {
    return joined(report::three_digits(energy_kj), "\u00a0kJ");
}

std::string about_years(double years) {
    return page_text("{years} years", {{"years", report::tick_text(years)}});
}

/// Mean time between two hits in words.
std::string every(const PeriodArrivals& arrivals, Cover cover) {
    const double per_release = arrivals.hits[index_of(cover)].at_place.per_release;
    return per_release > 0.0
               ? about_years(arrival_return_period_years(arrivals.return_period_years, per_release))
               : page_text("none arrives");
}

/// Mean time between two hits of the rocks that give the level.
std::string arrival_of(const HazardResults& results, std::size_t target, const SlopeHazard& slope) {
    const auto found =
        std::find_if(results.arrivals.begin(), results.arrivals.end(), [&](const PeriodArrivals& arrivals) {
            return arrivals.target == target &&
                   arrivals.return_period_years == slope.targets[target].ruled.release_years;
        });
    return found == results.arrivals.end() ? "–" : every(*found, slope.cover);
}

/// What gives the level of a target, as a sentence.
std::string reason_of(const HazardResults& results, std::size_t target, const SlopeHazard& slope) {
    const RuledLevel& ruled = slope.targets[target].ruled;
    if (ruled.is_free()) {
        return page_text("No simulated rock hits it.");
    }
    const HazardSettings& settings = results.scenario.hazard;
    const double from_kj = results.matrix.energy_from_kj()[ruled.intensity];
    switch (settings.rule) {
        case HazardRule::cadanav:
            return from_kj > 0.0 ? page_text("Rocks of {from_kj} kJ and more hit it once in {years} years.",
                                             {{"from_kj", report::exact(from_kj)},
                                              {"years", report::tick_text(ruled.years)}})
                                 : page_text("Rocks hit it once in {years} years.",
                                             {{"years", report::tick_text(ruled.years)}});
        case HazardRule::arrival:
            return page_text(
                "Rocks of return periods with this intensity or a higher one hit it once in {years} years; "
                "{energy_words}: {energy}.",
                {{"years", report::tick_text(ruled.years)},
                 {"energy_words", energy_in_words(ruled.energy, settings.energy)},
                 {"energy", energy_text(ruled.energy.kj)}});
        case HazardRule::release:
            break;
    }
    return page_text(
        "Of the rocks that break off once in {years} years one hits it in {arrival_period} on average; "
        "{energy_words}: {energy}.",
        {{"years", report::exact(ruled.release_years)},
         {"arrival_period", arrival_of(results, target, slope)},
         {"energy_words", energy_in_words(ruled.energy, settings.energy)},
         {"energy", energy_text(ruled.energy.kj)}});
}

std::string of_few_in_words(std::uint64_t rocks) {
    return rocks == 1 ? page_text("of the only rock")
                      : page_text("largest of {rocks} rocks", {{"rocks", report::grouped(rocks)}});
}

/// "312 kJ", and below it what else it is than the percentile.
PageFields energy_cell(const EnergyOfRocks& energy) {
    return {{"energy", energy.rocks > 0 ? energy_text(energy.kj) : std::string{"–"}},
            {"rocks", energy.rocks > 0 ? report::grouped(energy.rocks) : std::string{"–"}},
            {"of_few", energy.is_largest ? std::optional{PageFields{{"it_is", of_few_in_words(energy.rocks)}}}
                                         : std::nullopt}};
}

/// How often rocks hit a target whose level follows from the release, where they come so seldom that the
/// frequency alone would say residual hazard at most.
std::optional<PageFields> rarely_hit(const HazardResults& results, std::size_t target,
                                     const SlopeHazard& slope) {
    const TargetHazard& here = slope.targets[target];
    const auto ends = results.matrix.return_period_to_years();
    if (slope.map.rule != HazardRule::release || here.ruled.level <= Level::residual || ends.size() < 2) {
        return std::nullopt;
    }
    const double years = 1.0 / here.hits_per_year;
    return years > ends[ends.size() - 2] ? std::optional{PageFields{{"hit_years", report::tick_text(years)}}}
                                         : std::nullopt;
}

std::vector<PageFields> answers_at(const HazardResults& results, std::size_t target) {
    std::vector<PageFields> answers;
    for (const SlopeHazard& slope : results.slopes) {
        const TargetHazard& here = slope.targets[target];
        answers.push_back(
            {{"is_first", slope.cover == results.slopes.front().cover},
             {"slope", page_text(slope.cover == Cover::forest ? "With forest" : "Bare slope")},
             {"level", level_in_words(here.ruled.level)},
             {"reason", reason_of(results, target, slope)},
             {"rare", rarely_hit(results, target, slope)},
             {"arrival", here.rocks > 0 ? about_years(1.0 / here.hits_per_year) : std::string{"–"}},
             {"ruling_energy", std::optional{energy_cell(here.ruled.energy)}},
             {"highest_energy", std::optional{energy_cell(here.highest)}},
             {"every", here.ruled.is_free() ? std::string{"–"} : about_years(here.ruled.years)},
             {"compared_level", level_in_words(here.compared.level)}});
    }
    return answers;
}

std::optional<PageFields> stopped_by_forest(const PeriodArrivals& arrivals) {
    if (std::isnan(arrivals.protection_percent) || too_few_for_protection(arrivals.bare_rocks) ||
        says_nothing(arrivals.protection_low_percent, arrivals.protection_high_percent)) {
        return std::nullopt;
    }
    return PageFields{{"stopped", report::percent(arrivals.protection_percent / config::percent)},
                      {"low", report::percent(arrivals.protection_low_percent / config::percent)},
                      {"high", report::percent(arrivals.protection_high_percent / config::percent)}};
}

std::optional<PageFields> with_all(const PeriodArrivals& arrivals, Cover cover) {
    const auto& interval = arrivals.with_all_percent[index_of(cover)];
    return interval ? std::optional{PageFields{{"low", report::three_digits(interval->low)},
                                               {"high", report::three_digits(interval->high)}}}
                    : std::nullopt;
}

std::vector<PageFields> arrivals_at(const HazardResults& results, std::size_t target) {
    std::vector<PageFields> rows;
    for (const PeriodArrivals& arrivals : results.arrivals) {
        if (arrivals.target == target) {
            rows.push_back({{"years", report::years_in_words(arrivals.return_period_years)},
                            {"bare_share", report::percent(arrivals.bare_percent / config::percent)},
                            {"forest_share", report::percent(arrivals.forest_percent / config::percent)},
                            {"bare_with_all", with_all(arrivals, Cover::bare)},
                            {"forest_with_all", with_all(arrivals, Cover::forest)},
                            {"protection", stopped_by_forest(arrivals)},
                            {"no_protection",
                             std::isnan(arrivals.protection_percent) ? "–" : page_text("too few rocks")},
                            {"every_bare", every(arrivals, Cover::bare)},
                            {"every_forest", every(arrivals, Cover::forest)}});
        }
    }
    return rows;
}

/// "2 steps lower at 3 targets (Road, House, Barn)".
std::string steps_in_words(const LevelSteps& of, const Site& site) {
    constexpr std::size_t most_named = 3;
    std::vector<std::string> names;
    for (const std::size_t target : of.places) {
        if (names.size() == most_named) {
            names.emplace_back("…");
            break;
        }
        names.push_back(site.targets[target].name);
    }
    const auto number = [](std::size_t count) { return report::grouped(count); };
    return page_text(of.steps < 0 ? "{steps} steps lower at {targets} targets ({names})"
                                  : "{steps} steps higher at {targets} targets ({names})",
                     {{"steps", number(static_cast<std::size_t>(std::abs(of.steps)))},
                      {"targets", number(of.places.size())},
                      {"names", report::join_with_commas(names)}});
}

/// Where levels of targets differ between two answers, slope by slope, and by how many steps.
/// `levels_of(slope)` gives those of both.
PageFields differences_at_targets(const HazardResults& results, const auto& levels_of) {
    std::vector<std::string> by_slope;
    std::set<std::size_t> all;
    for (const SlopeHazard& slope : results.slopes) {
        const auto [from, to] = levels_of(slope);
        std::vector<std::string> parts{slope_words(slope.cover)};
        for (const LevelSteps& of : level_differences(from, to)) {
            parts.push_back(steps_in_words(of, results.site));
            all.insert(of.places.begin(), of.places.end());
        }
        if (parts.size() > 1) {
            by_slope.push_back(report::join_with_commas(parts));
        }
    }
    return {{"targets_all", report::grouped(results.site.targets.size())},
            {"differ", !all.empty()},
            {"targets_differ", report::grouped(all.size())},
            {"differences", report::join_with_semicolons(by_slope)}};
}

/// By the rule for comparison.
PageFields compared_at_targets(const HazardResults& results) {
    PageFields fields = differences_at_targets(results, [](const SlopeHazard& slope) {
        return std::pair{levels_of_targets(slope, &TargetHazard::ruled),
                         levels_of_targets(slope, &TargetHazard::compared)};
    });
    fields.push_back({"other_rule", rule_name(results.slopes.front().compared.rule)});
    return fields;
}

/// What nets and works do to levels, where the run without them is known.
std::optional<PageFields> changes_by_barriers(const HazardResults& results) {
    if (results.slopes.front().without.empty()) {
        return std::nullopt;
    }
    PageFields fields = differences_at_targets(results, [](const SlopeHazard& slope) {
        return std::pair{slope.without, levels_of_targets(slope, &TargetHazard::ruled)};
    });
    std::set<std::size_t> few;
    for (const SlopeHazard& slope : results.slopes) {
        for (std::size_t target = 0; target < slope.targets.size(); ++target) {
            const RuledLevel& now = slope.targets[target].ruled;
            if (slope.targets[target].rests_on_few_rocks(slope.map.rule) &&
                now.level != slope.without[target]) {
                few.insert(target);
            }
        }
    }
    fields.push_back({"is_of_few", !few.empty()});
    fields.push_back({"of_few", report::grouped(few.size())});
    return fields;
}

/// The same of the map of the slope as it is, for a site without targets.
PageFields compared_on_map(const HazardResults& results) {
    const SlopeHazard& slope = results.slopes.front();
    const std::vector<LevelSteps> found =
        level_differences(levels_of_cells(slope.map.level), levels_of_cells(slope.compared.level));
    std::size_t cells = 0;
    for (const LevelSteps& of : found) {
        cells += of.places.size();
    }
    return {{"other_rule", rule_name(slope.compared.rule)},
            {"differ", !found.empty()},
            {"area", report::hectares(static_cast<double>(cells) * slope.map.level.frame.cell_area_m2() /
                                      m2_of_a_hectare)},
            {"steps",
             report::grouped(found.empty() ? 0 : static_cast<std::size_t>(std::abs(found.front().steps)))},
            {"words_of_slope", slope_words(slope.cover)}};
}

std::optional<PageFields> changes_in_words(const HazardResults& results) {
    const std::optional<ForestChanges> changes = changes_by_forest(results);
    if (!changes) {
        return std::nullopt;
    }
    const bool is_unclear = changes->unclear_targets > 0 || changes->all_unclear_ha() > 0.0;
    return PageFields{{"raises", changes->raises()},
                      {"is_unclear", is_unclear},
                      {"at_targets", changes->unclear_targets > 0},
                      {"unclear_targets", report::grouped(changes->unclear_targets)},
                      {"unclear_area", report::hectares(changes->all_unclear_ha())},
                      {"least", least_of_level()},
                      {"lowered_targets", report::grouped(changes->lowered_targets)},
                      {"raised_targets", report::grouped(changes->raised_targets)},
                      {"targets_all", report::grouped(results.site.targets.size())},
                      {"lowered_area", report::hectares(changes->all_lowered_ha())},
                      {"raised_area", report::hectares(changes->all_raised_ha())}};
}

}  // namespace

std::string least_of_level() {
    return report::grouped(static_cast<std::uint64_t>(least_rocks_of_level));
}

const std::string& slope_words(Cover cover) {
    return cover == Cover::forest ? page_text("with forest") : page_text("bare slope");
}

std::string energy_in_words(HazardEnergy energy) {
    switch (energy) {
        case HazardEnergy::mean:
            return page_text("mean energy");
        case HazardEnergy::max:
            return page_text("largest energy");
        default:
            return page_text("{energy_substr}th percentile of the energies",
                             {{"energy_substr", stem_of(energy).substr(2)}});
    }
}

std::string energy_in_words(const EnergyOfRocks& energy, HazardEnergy settings) {
    if (!energy.is_largest) {
        return energy_in_words(settings);
    }
    return energy.rocks == 1 ? page_text("energy of the only rock")
                             : page_text("largest energy of only {rocks} rocks",
                                         {{"rocks", report::grouped(energy.rocks)}});
}

std::string level_in_words(Level level) {
    switch (level) {
        case Level::none:
            break;
        case Level::residual:
            return page_text("residual hazard (yellow and white)");
        case Level::low:
            return page_text("low hazard (yellow)");
        case Level::moderate:
            return page_text("moderate hazard (blue)");
        case Level::high:
            return page_text("high hazard (red)");
    }
    return page_text("no hazard");
}

namespace {

/// Takes targets that no rock hits out of a list, and gives their names: their rows would be dashes alike. A
/// single one, and a list of nothing else, stays.
std::vector<std::string> take_those_without_hits(const HazardResults& results,
                                                 std::vector<std::size_t>& listed) {
    const auto is_hit = [&](std::size_t target) {
        return std::any_of(results.slopes.begin(), results.slopes.end(),
                           [&](const SlopeHazard& slope) { return slope.targets[target].rocks > 0; });
    };
    std::vector<std::size_t> kept = listed;
    const auto first = std::stable_partition(kept.begin(), kept.end(), is_hit);
    std::vector<std::string> names;
    if (first == kept.begin() || kept.end() - first < 2) {
        return names;
    }
    std::transform(first, kept.end(), std::back_inserter(names),
                   [&](std::size_t target) { return results.site.targets[target].name; });
    kept.erase(first, kept.end());
    listed = std::move(kept);
    return names;
}

}  // namespace

PageFields answer_fields(const HazardResults& results, const FewRocksAt& few_rocks) {
    const std::size_t all = results.site.targets.size();
    const std::size_t hit = ranked_targets(results).size();
    std::vector<PageFields> cards;
    for (const std::size_t i : first_targets(results, most_cards)) {
        cards.push_back({{"target", results.site.targets[i].name},
                         {"answers", answers_at(results, i)},
                         {"few_rocks", few_rocks(i)}});
    }
    std::vector<PageFields> rows;
    std::vector<std::size_t> listed = listed_targets(results, most_rows, most_rows_of_all);
    const std::vector<std::string> without_hits = take_those_without_hits(results, listed);
    for (const std::size_t i : listed) {
        rows.push_back({{"target", results.site.targets[i].name},
                        {"answers", answers_at(results, i)},
                        {"arrivals", arrivals_at(results, i)}});
    }
    const bool with_forest = results.slopes.front().cover == Cover::forest;
    return {
        {"has_targets", all > 0},
        {"targets_hit", report::grouped(hit)},
        {"targets_all", report::grouped(all)},
        {"one_target", all == 1},
        {"none_is_hit", hit == 0},
        {"worst_are_shown", hit > most_cards},
        {"worst", report::grouped(std::min(most_cards, hit))},
        {"more_targets", all > listed.size()},
        {"rows_shown", report::grouped(listed.size())},
        {"rows_most", report::grouped(most_rows_of_all)},
        {"cards", cards},
        {"target_rows", rows},
        {"without_hits",
         without_hits.empty()
             ? std::nullopt
             : std::optional{PageFields{{"targets_without_hits", report::join_with_commas(without_hits)}}}},
        {"with_all_is_known",
         std::any_of(results.arrivals.begin(), results.arrivals.end(),
                     [](const PeriodArrivals& arrivals) {
                         return arrivals.with_all_percent[index_of(Cover::bare)].has_value();
                     })},
        {"designs", design_fields(results, listed)},
        {"barriers", barrier_fields(results)},
        {"weak_barriers", weak_barrier_fields(results)},
        {"has_unreached_barriers", !unreached_barriers(results).empty()},
        {"unreached_barriers", unreached_barriers(results)},
        {"takes_percentile", least_rocks(results.scenario.hazard.energy) > 1},
        {"least_rocks", report::grouped(least_rocks(results.scenario.hazard.energy))},
        {"with_forest", with_forest},
        {"forest_changes", changes_in_words(results)},
        {"barrier_changes", changes_by_barriers(results)},
        {"compared_targets", all > 0 ? std::optional{compared_at_targets(results)} : std::nullopt},
        {"compared_map", all > 0 ? std::nullopt : std::optional{compared_on_map(results)}},
        {"by_classes", results.scenario.hazard.rule == HazardRule::cadanav},
        {"by_arrival", results.scenario.hazard.rule == HazardRule::arrival},
        {"by_release", results.scenario.hazard.rule == HazardRule::release},
        {"rocks_are_averaged", results.scenario.hazard.rule != HazardRule::cadanav &&
                                   results.scenario.hazard.energy != HazardEnergy::max}};
}

}  // namespace coupling::hazard
