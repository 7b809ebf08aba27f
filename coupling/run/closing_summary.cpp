#include "coupling/run/closing_summary.hpp"

#include <cstdio>

#include "coupling/nets/net_tables.hpp"
#include "coupling/nets/net_words.hpp"
#include "coupling/results/few_rocks.hpp"
#include "coupling/results/indicators.hpp"
#include "coupling/run/telling.hpp"

namespace coupling {
namespace {

constexpr auto forest = static_cast<std::size_t>(rockfall::Cover::forest);
constexpr auto bare = static_cast<std::size_t>(rockfall::Cover::bare);

double percent(std::uint64_t part, std::uint64_t whole) {
    return whole > 0 ? 100.0 * static_cast<double>(part) / static_cast<double>(whole) : 0.0;
}

void print_target(const RunResults& results, std::size_t i) {
    const rockfall::TargetTally& tally = results.tally.targets[i];
    const std::uint64_t arrived_bare = tally.by_cover[bare].reached;
    std::printf("  %s: %.2f %% of the rocks arrive over the bare slope", results.site.targets[i].name.c_str(),
                percent(arrived_bare, results.rocks));
    if (results.with_forest) {
        const std::uint64_t arrived_forest = tally.by_cover[forest].reached;
        std::printf(", %.2f %% through the forest", percent(arrived_forest, results.rocks));
        const PairedCounts paired{tally.reached_both, arrived_forest - tally.reached_both,
                                  arrived_bare - tally.reached_both};
        const auto effect = protection_effect(paired);
        if (too_few_to_tell(paired)) {
            std::printf("; too few rocks arrive to tell what the forest keeps away: %llu",
                        static_cast<unsigned long long>(paired.bare()));
        } else if (effect) {
            std::printf("; the forest keeps away %.1f %% (95 %% interval %.1f to %.1f)",
                        100.0 * effect->value, 100.0 * effect->interval.low, 100.0 * effect->interval.high);
        }
    }
    std::printf("\n");
}

}  // namespace

void print_summary(const RunResults& results, const std::filesystem::path& folder,
                   const std::vector<WrittenFile>& written, bool verbose) {
    std::printf("%llu rocks from %zu sources%s\n", static_cast<unsigned long long>(results.rocks),
                results.site.sources.size(),
                results.with_forest ? ", each with forest and without" : ", bare slope");
    for (std::size_t i = 0; i < results.site.targets.size(); ++i) {
        print_target(results, i);
    }
    for (const NetFigures& figures : net_figures(results)) {
        std::printf(
            "  net %s\n",
            in_words(results.site.nets[figures.net], figures, results.scenario.nets.wanted_share).c_str());
    }
    print_files(folder, written, verbose);
}

}  // namespace coupling
