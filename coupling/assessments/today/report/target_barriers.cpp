#include <algorithm>
#include <optional>
#include <vector>

#include "coupling/assessments/nets/figures/net_quantiles.hpp"
#include "coupling/assessments/nets/figures/net_words.hpp"
#include "coupling/assessments/today/figures/target_design.hpp"
#include "coupling/assessments/today/report/sections.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/figures/most_reached.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::report {
namespace {

/// What to order, or why that cannot be said.
std::string barrier_in_words(const TargetDesign& design, const DesignSettings& settings) {
    if (design.reached == 0) {
        return "–";
    }
    if (!design.design) {
        return page_text("too few rocks: {reached_part} of at least {rocks_to_tell_wanted_share}",
                         {{"reached_part", grouped(design.reached)},
                          {"rocks_to_tell_wanted_share", grouped(rocks_to_tell(settings.share()))}});
    }
    return join_with_semicolons({in_words(*design.design), upper_in_words(*design.design)});
}

}  // namespace

std::optional<PageFields> target_barriers(const RunResults& results) {
    const std::vector<TargetDesign> designs = target_designs(results);
    const DesignSettings& settings = results.scenario.design;
    std::vector<PageFields> rows;
    for (const std::size_t target : most_reached(results.tally.targets, most_targets_shown)) {
        for (const TargetDesign& design : designs) {
            if (design.target != target) {
                continue;
            }
            const std::optional<BarrierDesign>& of = design.design;
            const rockfall::Target& place = results.site.targets[target];
            rows.push_back({{"target", place.name.empty() ? place.id : place.name},
                            {"slope", design.cover == rockfall::Cover::forest ? page_text("with forest")
                                                                              : page_text("bare slope")},
                            {"reached", grouped(design.reached)},
                            {"percentile_energy", of ? three_digits(of->percentile_energy_kj) : "–"},
                            {"design_energy", of ? three_digits(of->design_energy_kj) : "–"},
                            {"percentile_height", of ? three_digits(of->percentile_height_m) : "–"},
                            {"design_height", of ? three_digits(of->design_height_m) : "–"},
                            {"barrier", barrier_in_words(design, settings)}});
        }
    }
    if (rows.empty()) {
        return std::nullopt;
    }
    return PageFields{
        {"rows", rows}, {"percentile", exact(settings.percentile)}, {"rule", design_rule_in_words(settings)}};
}

}  // namespace coupling::report
