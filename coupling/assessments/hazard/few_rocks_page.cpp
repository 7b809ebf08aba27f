#include "coupling/assessments/hazard/few_rocks_page.hpp"

#include <string>
#include <vector>

#include "coupling/assessments/hazard/hazard_answers.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::hazard {
namespace {

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

}  // namespace

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
