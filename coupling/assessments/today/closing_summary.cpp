#include "coupling/assessments/today/closing_summary.hpp"

#include <cmath>
#include <cstdio>
#include <iostream>
#include <string>
#include <vector>

#include "config/text/joined.hpp"
#include "coupling/assessments/nets/figures/net_tables.hpp"
#include "coupling/assessments/nets/figures/net_words.hpp"
#include "coupling/assessments/works/work_tables.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/figures/departures.hpp"
#include "coupling/results/figures/drawn_words.hpp"
#include "coupling/results/figures/effect_words.hpp"
#include "coupling/results/figures/fall_doubts.hpp"
#include "coupling/results/figures/few_rocks.hpp"
#include "coupling/results/figures/indicators.hpp"
#include "coupling/results/figures/most_reached.hpp"
#include "coupling/results/tables/text_layout.hpp"
#include "coupling/results/text/markup.hpp"

namespace coupling {
namespace {

using config::joined;

constexpr auto forest = static_cast<std::size_t>(rockfall::Cover::forest);
constexpr auto bare = static_cast<std::size_t>(rockfall::Cover::bare);

double share_in(std::uint64_t part, std::uint64_t whole) {
    return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0.0;
}

/// "1.91 % to 5.47 %".
std::string range_in_percent(const Interval& interval) {
    return joined(report::percent(interval.low), " to ", report::percent(interval.high));
}

std::string range_in_m(const Interval& interval) {
    return joined(report::three_digits(interval.low), " to ", report::three_digits(interval.high), " m");
}

/// Rocks above energies with and without forest: a percentile of those that arrive rises where a forest
/// stops the weak ones.
void print_strong_rocks(const RunResults& results, std::size_t i) {
    const rockfall::TargetTally& tally = results.tally.targets[i];
    std::string text;
    for (std::size_t energy = 0; energy < rockfall::counted_energies_j.size(); ++energy) {
        const auto rate = [&](std::size_t cover) {
            return rate_per_1000(share_in(tally.by_cover[cover].above[energy], results.rocks));
        };
        text += joined(text.empty() ? "" : "; ", kj_text(energy), " kJ: ", rate(bare),
                       results.with_forest ? joined(" bare, ", rate(forest), " with forest") : "");
    }
    if (tally.by_cover[bare].reached + tally.by_cover[forest].reached > 0) {
        std::printf("    rocks above an energy, per 1000 released: %s\n", text.c_str());
    }
}

void print_target(const RunResults& results, std::size_t i) {
    const rockfall::TargetTally& tally = results.tally.targets[i];
    const std::uint64_t arrived_bare = tally.by_cover[bare].reached;
    std::printf("  %s: %s of the rocks arrive over the bare slope", results.site.targets[i].name.c_str(),
                report::percent(share_in(arrived_bare, results.rocks)).c_str());
    if (results.with_forest) {
        const std::uint64_t arrived_forest = tally.by_cover[forest].reached;
        std::printf(", %s through the forest",
                    report::percent(share_in(arrived_forest, results.rocks)).c_str());
        const PairedCounts paired = paired_counts(tally);
        const auto effect = protection_at(results.tally, i);
        if (too_few_for_protection(paired)) {
            std::printf("; %s", too_few_in_words(paired.bare()).c_str());
        } else if (effect) {
            std::printf("; the forest stops %s (95 %% interval %s)", report::percent(effect->value).c_str(),
                        range_in_percent(effect->interval).c_str());
        }
    }
    std::printf("\n");
    print_strong_rocks(results, i);
}

/// What the figures of a target may be once all that is not known counts.
void print_drawn(const RunResults& results, const DrawnFigures& figures, std::size_t i) {
    const DrawnTarget& target = figures.targets[i];
    const Cover cover = results.with_forest ? Cover::forest : Cover::bare;
    if (results.tally.targets[i].by_cover[index_of(cover)].reached == 0 && !target.protection) {
        return;  // no rock, of which nothing more is known
    }
    const std::optional<DrawnFigure>& share = target.by_cover[index_of(cover)].share;
    const std::optional<DrawnFigure>& main = target.leading(cover);
    if (!main) {
        std::printf(
            "    so few rocks do not show how far what is not known of ground and trees may move this\n");
        return;
    }
    std::printf("    with what is not known of ground and trees: ");
    if (share) {
        std::printf("%s arrive", range_in_percent(share->of_all).c_str());
    }
    if (target.protection) {
        std::printf("%sthe forest stops %s", share ? "; " : "",
                    range_in_percent(target.protection->of_all).c_str());
    }
    const std::string causes = main_causes_in_words(*main, *results.draws);
    const bool is_hidden = target.has_hidden_spread(cover);
    std::printf("%s%s\n", causes.empty() ? "" : joined(" (mostly by ", causes, ")").c_str(),
                is_hidden ? " (where draws show no spread, one that chance could hide)" : "");
}

/// Where rocks end decides what all other figures count.
void print_departures(const RunResults& results) {
    std::printf("  %s\n", in_words(departures_of(results, Cover::bare), "over the bare slope").c_str());
    if (results.with_forest) {
        std::printf("  %s\n", in_words(departures_of(results, Cover::forest), "with forest").c_str());
    }
}

void print_run_out(const RunResults& results, const std::optional<DrawnFigures>& drawn) {
    for (const Cover cover : {Cover::bare, Cover::forest}) {
        if (cover == Cover::forest && !results.with_forest) {
            continue;
        }
        const SlopeFigures slope = figures_of(results.tally.runs[index_of(cover)]);
        std::printf("  run-out %s: mean %s m", cover == Cover::bare ? "over the bare slope" : "with forest",
                    report::three_digits(slope.run_out_m.mean).c_str());
        if (slope.stopped.value < 1.0) {
            std::printf(" of the %s of the rocks that stop on the terrain; of all rocks at least %s m",
                        report::percent(slope.stopped.value).c_str(),
                        report::three_digits(slope.run_out_at_least_m.mean).c_str());
        }
        if (drawn && drawn->run_outs[index_of(cover)].mean_m) {
            const DrawnFigure& mean_m = *drawn->run_outs[index_of(cover)].mean_m;
            std::printf("; with what is not known of ground and trees %s", range_in_m(mean_m.of_all).c_str());
        }
        std::printf("\n");
    }
}

/// What a user who gave observed stops wants to see first.
void print_observed(const std::vector<observed::StopComparison>& comparisons) {
    for (const observed::StopComparison& one : comparisons) {
        std::printf(
            "  run-out of %s: observed %s ± %s m (%s stops), simulated %s ± %s m; KS %.2f (by chance %.2f)",
            one.group.empty() ? "all stops" : one.group.c_str(),
            report::three_digits(one.observed.mean_m).c_str(),
            report::three_digits(one.observed.deviation_m).c_str(),
            report::grouped(one.observed.rocks).c_str(), report::three_digits(one.simulated.mean_m).c_str(),
            report::three_digits(one.simulated.deviation_m).c_str(), one.largest_distance,
            one.distance_by_chance);
        if (one.simulated.left_terrain > 0.0) {
            std::printf("; %s of the simulated rocks left the terrain: their run-out is a lower bound",
                        report::percent(one.simulated.left_terrain).c_str());
        }
        std::printf("\n");
    }
}

void print_observed(const std::vector<observed::EventComparison>& comparisons) {
    for (const observed::EventComparison& one : comparisons) {
        std::printf("  %s: observed %s (%s), simulated %s (%s) %s", one.name().c_str(),
                    report::three_digits(one.observed.mean).c_str(),
                    report::grouped(one.observed.count).c_str(),
                    report::three_digits(one.simulated.mean).c_str(),
                    report::grouped(one.simulated.count).c_str(), one.unit.c_str());
        if (std::isfinite(one.largest_distance)) {
            std::printf("; KS %.2f (by chance %.2f)", one.largest_distance, one.distance_by_chance);
        }
        std::printf("\n");
    }
}

}  // namespace

void print_summary(const RunResults& results) {
    std::printf("%s rocks from %s sources%s\n", report::grouped(results.rocks).c_str(),
                report::grouped(results.site.sources.size()).c_str(),
                results.with_forest ? ", each with forest and without" : ", bare slope");
    print_departures(results);
    const std::optional<DrawnFigures> drawn = figures_of(results).drawn;
    const std::vector<std::size_t> shown = most_reached(results.tally.targets, most_targets_shown);
    if (shown.size() < results.site.targets.size()) {
        std::printf(
            "  the %zu of %zu targets that most rocks reach over the bare slope; tables/targets.csv has "
            "all:\n",
            shown.size(), results.site.targets.size());
    }
    for (const std::size_t i : shown) {
        print_target(results, i);
        if (drawn) {
            print_drawn(results, *drawn, i);
        }
    }
    print_run_out(results, drawn);
    const std::vector<NetFigures> nets = net_figures(results);
    for (const NetFigures& figures : nets) {
        std::printf("  net %s\n",
                    in_words(results.site.nets[figures.net], figures, results.scenario.design).c_str());
    }
    if (!nets.empty()) {
        std::fflush(stdout);
        print_wrapped(std::cout, "  ", design_rule_in_words(results.scenario.design));
        std::cout.flush();
    }
    for (const WorkFigures& figures : work_figures(results)) {
        const WorkRecord& work = results.site.works[figures.work];
        std::printf("  %s %s\n", name_of(work.kind), in_words(work, figures).c_str());
    }
    print_observed(results.observed_stops);
    print_observed(results.observed_events);
}

}  // namespace coupling
