#include "coupling/assessments/hazard/few_rocks_page.hpp"

#include <string>
#include <vector>

#include "coupling/assessments/hazard/hazard_answers.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/messages.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::hazard {
namespace {

using report::message_text;
using report::page_text;
using report::PageFields;

/// That a frequency of so few rocks is not known well, on which slopes.
std::optional<PageFields> warning_of_few_in_class(const HazardResults& results, std::size_t target) {
    std::vector<std::string> few;
    for (const SlopeHazard& slope : results.slopes) {
        for (const FewRocks& of_class : slope.targets[target].few_rocks) {
            const std::string& slope_name = slope_words(slope.cover);
            const std::string rocks = report::grouped(of_class.rocks);
            few.push_back(of_class.even_rocks == of_class.rocks
                              ? page_text("{words_of_slope}: {rocks}",
                                          {{"words_of_slope", slope_name}, {"rocks", rocks}})
                              : page_text("{words_of_slope}: {rocks}, worth {even} of the same weight",
                                          {{"words_of_slope", slope_name},
                                           {"rocks", rocks},
                                           {"even", report::grouped(of_class.even_rocks)}}));
        }
    }
    if (few.empty()) {
        return std::nullopt;
    }
    return PageFields{
        {"warning",
         page_text(
             "How often rocks of a class hit is known from about {least_rocks} rocks of the same weight on. "
             "Fewer give the level here ({few_by_slope}): it may be too low or too high; raise "
             "release.rocks for more.",
             {{"least_rocks", report::grouped(least_rocks_of_class)},
              {"few_by_slope", report::join_with_commas(few)}})}};
}

/// "high hazard (red) at 3 (2 of them by fewer than 5 rocks), not hit 2", the highest first.
std::string levels_of_targets(const SlopeHazard& slope) {
    std::vector<std::string> parts;
    for (std::size_t level = levels; level-- > 0;) {
        std::uint64_t targets = 0;
        std::uint64_t few = 0;
        for (const TargetHazard& target : slope.targets) {
            const bool is_here = target.ruled.level == static_cast<Level>(level);
            targets += is_here ? 1 : 0;
            few += is_here && target.ruled.rests_on_chance() ? 1 : 0;
        }
        if (targets == 0) {
            continue;
        }
        if (level == 0) {
            parts.push_back(page_text("not hit {targets}", {{"targets", report::grouped(targets)}}));
            continue;
        }
        const std::string name = level_in_words(static_cast<Level>(level));
        parts.push_back(
            few == 0
                ? page_text("{level} at {targets}", {{"level", name}, {"targets", report::grouped(targets)}})
                : page_text("{level} at {targets} ({few} of them by fewer than {least} rocks)",
                            {{"level", name},
                             {"targets", report::grouped(targets)},
                             {"few", report::grouped(few)},
                             {"least", least_of_level()}}));
    }
    return report::join_with_commas(parts);
}

/// "12.04 ha high (2.1 ha of it by fewer than 5 rocks), 3.10 ha low", the highest first; nothing where the
/// map has no level.
std::string levels_of_map(const SlopeHazard& slope, const Site& site) {
    std::vector<std::string> parts;
    for (std::size_t level = levels; level-- > 1;) {
        const double area_ha = level_area_ha(slope.map.level, site, static_cast<Level>(level));
        const double few_ha = chance_area_ha(slope.map, static_cast<Level>(level));
        if (!(area_ha > 0.0)) {
            continue;
        }
        const std::string& name = message_text(level_names[level]);
        parts.push_back(
            few_ha == 0.0
                ? page_text("{area} ha {level}", {{"area", report::hectares(area_ha)}, {"level", name}})
                : page_text("{area} ha {level} ({few_area} ha of it by fewer than {least} rocks)",
                            {{"area", report::hectares(area_ha)},
                             {"level", name},
                             {"few_area", report::hectares(few_ha)},
                             {"least", least_of_level()}}));
    }
    return parts.empty() ? page_text("no level") : report::join_with_commas(parts);
}

}  // namespace

std::vector<PageFields> state_of_slopes(const HazardResults& results) {
    std::vector<PageFields> slopes;
    for (const SlopeHazard& slope : results.slopes) {
        slopes.push_back({{"slope", page_text(slope.cover == Cover::forest ? "With forest" : "Bare slope")},
                          {"at_targets", levels_of_targets(slope)},
                          {"targets_all", report::grouped(slope.targets.size())},
                          {"on_map", levels_of_map(slope, results.site)}});
    }
    return slopes;
}

std::optional<PageFields> warning_of_few(const HazardResults& results, std::size_t target) {
    const HazardSettings& settings = results.scenario.hazard;
    if (settings.rule == HazardRule::cadanav) {
        return warning_of_few_in_class(results, target);
    }
    std::vector<std::string> few;
    for (const SlopeHazard& slope : results.slopes) {
        for (const FewRocks& of_period : slope.targets[target].few_rocks) {
            few.push_back(page_text("{years} years {words_of_slope}: {rocks}",
                                    {{"years", report::exact(of_period.return_period_years)},
                                     {"words_of_slope", slope_words(slope.cover)},
                                     {"rocks", report::grouped(of_period.rocks)}}));
        }
    }
    if (few.empty()) {
        return std::nullopt;
    }
    return PageFields{
        {"warning", page_text("{energy_words}: needs at least {least_rocks} rocks; fewer hit in these return "
                              "periods: {few_by_period}. The level may be too low or too high; raise "
                              "release.rocks for more.",
                              {{"energy_words", energy_in_words(settings.energy)},
                               {"least_rocks", report::grouped(least_rocks(settings.energy))},
                               {"few_by_period", report::join_with_commas(few)}})}};
}

}  // namespace coupling::hazard
