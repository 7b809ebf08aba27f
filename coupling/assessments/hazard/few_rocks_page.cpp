#include "coupling/assessments/hazard/few_rocks_page.hpp"

#include <algorithm>
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

/// How many rocks of the class of energy that gives a level by `cadanav` hit a target.
std::uint64_t rocks_of_class(const HazardResults& results, std::size_t target, const SlopeHazard& slope) {
    const RuledLevel& ruled = slope.targets[target].ruled;
    const auto found =
        std::find_if(results.arrivals.begin(), results.arrivals.end(), [&](const PeriodArrivals& arrivals) {
            return arrivals.target == target && arrivals.return_period_years == ruled.release_years;
        });
    if (found == results.arrivals.end()) {
        return 0;
    }
    const TargetHits& hits = found->hits[index_of(slope.cover)];
    return ruled.intensity < hits.rocks_above.size() ? hits.rocks_above[ruled.intensity] : hits.rocks;
}

/// That a frequency of so few rocks is not known well, on which slopes.
std::optional<PageFields> warning_of_few_in_class(const HazardResults& results, std::size_t target) {
    constexpr std::uint64_t least_rocks_of_class = 20;  // [choice] the 95 % interval of 20 is 12 to 31
    std::vector<std::string> few;
    for (const SlopeHazard& slope : results.slopes) {
        const std::uint64_t rocks = rocks_of_class(results, target, slope);
        if (!slope.targets[target].ruled.is_free() && rocks < least_rocks_of_class) {
            few.push_back(
                page_text("{words_of_slope}: {rocks}",
                          {{"words_of_slope", slope_words(slope.cover)}, {"rocks", report::grouped(rocks)}}));
        }
    }
    if (few.empty()) {
        return std::nullopt;
    }
    return PageFields{
        {"warning",
         page_text(
             "How often rocks of a class hit is known from about {least_rocks} rocks on. Fewer give the "
             "level here ({few_by_slope}): it may be too low or too high; raise "
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
        {"warning", page_text("{energy_words}: known from {least_rocks} rocks on. Fewer hit of single return "
                              "periods ({few_by_period}): the level may be too low, less often too "
                              "high; raise release.rocks for "
                              "more.",
                              {{"energy_words", energy_in_words(settings.energy)},
                               {"least_rocks", report::grouped(least_rocks(settings.energy))},
                               {"few_by_period", report::join_with_commas(few)}})}};
}

}  // namespace coupling::hazard
