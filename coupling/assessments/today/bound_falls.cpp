#include "coupling/assessments/today/bound_falls.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "config/text/joined.hpp"
#include "config/units/constants.hpp"
#include "coupling/inputs/forest/tops/bound_trees.hpp"
#include "coupling/inputs/reading/stands_of_today.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/inputs/site_draws.hpp"
#include "coupling/results/figures/few_rocks.hpp"
#include "coupling/results/tables/figure_columns.hpp"
#include "coupling/run/fall_rocks.hpp"
#include "coupling/run/interrupt.hpp"

namespace coupling {
namespace {

using config::joined;
using rockfall::EnsembleTally;

constexpr std::uint64_t least_bound_rocks = 3000;
constexpr std::uint64_t share_of_bound_rocks = 10;  ///< one in so many
/// Of the sample, over the bare slope: a bound of fewer is a matter of a few rocks [choice].
constexpr std::uint64_t least_arrivals_for_bounds = 30;

/// Marks of rocks that are spread evenly over all of them.
std::vector<bool> marks_of_sample(std::uint64_t rocks, std::uint64_t wanted) {
    std::vector<bool> marks(rocks);
    for (std::uint64_t rock = 0; rock < rocks; ++rock) {
        marks[rock] = (rock + 1) * wanted / rocks > rock * wanted / rocks;
    }
    return marks;
}

std::optional<BoundTrees> bounds_of_trees(const Scenario& scenario, const Site& site) {
    if (!scenario.trees.bounds || site.trees.empty()) {
        return std::nullopt;
    }
    if (has_stands_of_today(scenario.run, scenario.trees, scenario.forest)) {
        return bounds_of_records(site.trees, scenario.run.seed);
    }
    const bool are_derived = std::any_of(site.trees.begin(), site.trees.end(),
                                         [](const TreeRecord& tree) { return tree.has_derived_dbh; });
    return are_derived ? std::optional{bounds_of_tops(site.trees, scenario.run.seed)} : std::nullopt;
}

/// Falls of the same marked rocks past other forests.
class SampledFalls {
public:
    SampledFalls(const Scenario& scenario, const Site& site, const SiteFalls& falls,
                 const std::vector<bool>& marks, int threads)
        : scenario_{scenario},
          site_{site},
          falls_{falls},
          marks_{marks},
          threads_{threads},
          chunks_{rockfall::plan_chunks(site.sources,
                                        rockfall::rocks_of_chunk(falls.assessment.law.motion.model))},
          largest_radius_m_{largest_radius_m(falls.start, site.sources, falls.draws)} {}

    [[nodiscard]] EnsembleTally past(Cover cover, std::span<const rockfall::Stem> trees) const {
        const rockfall::StemIndex stems{trees, site_.slope.terrain, largest_radius_m_,
                                        scenario_.rockfall.fall.tree.taper};
        rockfall::Assessment falls{
            site_.slope,           stems, site_.sources,     site_.targets, falls_.start,
            falls_.assessment.law, {},    scenario_.run.seed};
        falls.logs = &falls_.logs;
        falls.nets = &falls_.nets;
        falls.draws = falls_.draws.falls;
        falls.only_rocks = &marks_;
        EnsembleTally tally{falls.map_frame, site_.targets.size(), stems.placed().size(),
                            falls_.logs.count()};
        if (fall_rocks_over(cover, falls, chunks_, threads_, tally, [](const rockfall::ChunkRows&) {}) ==
            Ended::interrupted) {
            throw Interrupted{};
        }
        return tally;
    }

private:
    const Scenario& scenario_;
    const Site& site_;
    const SiteFalls& falls_;
    const std::vector<bool>& marks_;
    int threads_;
    std::vector<rockfall::Chunk> chunks_;
    double largest_radius_m_;
};

double run_out_m(const EnsembleTally& tally) {
    return figures_of(tally.runs[index_of(Cover::forest)]).run_out_at_least_m.mean;
}

std::uint64_t reached(const EnsembleTally& tally, std::size_t target, Cover cover) {
    return tally.targets[target].by_cover[index_of(cover)].reached;
}

struct BoundRow {
    std::string target_id;
    const char* quantity;
    const char* unit;
    double factor;
    std::uint64_t rocks;
    const ForestBounds::Figure& figure;
};

TableOf<BoundRow> bounds_table() {
    constexpr const char* by_falls = "falls past the bounds of the forest";
    const auto scaled = [](double ForestBounds::Figure::*of) {
        return [of](const BoundRow& row) { return row.factor * row.figure.*of; };
    };
    return {"forest_bounds.csv",
            "What the forest stops where derived trees are the thinnest or the thickest that they may be.",
            "a figure of a target, or of all rocks of a slope",
            {{"target_id", "short name of the target; empty: all rocks", "input targets.file",
              &BoundRow::target_id},
             {"quantity", "protection, or run_out of all rocks, a lower bound for those that left", by_falls,
              &BoundRow::quantity},
             {"unit", "% or m", by_falls, &BoundRow::unit},
             {"derived", 3, "with the trees as they are derived", "counted over the simulated rocks",
              scaled(&ForestBounds::Figure::derived)},
             {"thin", 3, "with the thinnest forest that they may be", by_falls,
              scaled(&ForestBounds::Figure::thin)},
             {"thick", 3, "with the thickest", by_falls, scaled(&ForestBounds::Figure::thick)},
             {"rocks", "rocks that fell past the bounds", by_falls, &BoundRow::rocks}}};
}

}  // namespace

std::optional<ForestBounds> bounds_of_forest(const Scenario& scenario, const Site& site,
                                             const SiteFalls& falls, const EnsembleTally& total,
                                             int threads) {
    const std::optional<BoundTrees> trees = bounds_of_trees(scenario, site);
    if (!trees) {
        return std::nullopt;
    }
    const std::uint64_t rocks = site.rocks();
    const std::uint64_t wanted = std::min(rocks, std::max(least_bound_rocks, rocks / share_of_bound_rocks));
    const std::vector<bool> marks = marks_of_sample(rocks, wanted);
    const SampledFalls sample{scenario, site, falls, marks, threads};
    const EnsembleTally bare = sample.past(Cover::bare, {});
    const EnsembleTally derived = sample.past(Cover::forest, site.stems());
    const EnsembleTally thin = sample.past(Cover::forest, trees->thin);
    const EnsembleTally thick = sample.past(Cover::forest, trees->thick);

    ForestBounds bounds{has_stands_of_today(scenario.run, scenario.trees, scenario.forest), wanted, {}};
    for (std::size_t target = 0; target < site.targets.size(); ++target) {
        const PairedCounts paired = paired_counts(total.targets[target]);
        const std::optional<ProtectionEffect> effect = protection_effect(paired);
        const std::uint64_t at_target = reached(bare, target, Cover::bare);
        if (!effect || too_few_for_protection(paired) || at_target < least_arrivals_for_bounds) {
            continue;
        }
        const auto with = [&](const EnsembleTally& bound) {
            const double more = static_cast<double>(reached(bound, target, Cover::forest)) -
                                static_cast<double>(reached(derived, target, Cover::forest));
            return std::min(1.0, effect->value - more / static_cast<double>(at_target));
        };
        bounds.figures.push_back({target, effect->value, with(thin), with(thick)});
    }
    const double mean_m = run_out_m(total);
    bounds.figures.push_back({std::nullopt, mean_m, mean_m + run_out_m(thin) - run_out_m(derived),
                              mean_m + run_out_m(thick) - run_out_m(derived)});
    return bounds;
}

void warn_of_bounds(const ForestBounds& bounds, const Site& site, const EnsembleTally& total,
                    config::Warnings& warnings) {
    const ForestBounds::Figure* shown = nullptr;
    std::uint64_t most = 0;
    for (const ForestBounds::Figure& figure : bounds.figures) {
        const std::uint64_t arrive = figure.target ? paired_counts(total.targets[*figure.target]).bare() : 0;
        if (shown == nullptr || arrive > most) {
            shown = &figure;
            most = arrive;
        }
    }
    const char* assumption =
        bounds.are_of_records
            ? "trees are drawn from records: with 25 % fewer or more stems"
            : "trees are taken from their tops: with diameters 30 % thinner, or 44 % thicker and the trees "
              "that a scan misses,";
    const double factor = shown->target ? config::percent : 1.0;
    // Other trees stand in the way in each of them, so that few rocks may put the derived ones beside both.
    const auto [low, high] = std::minmax({shown->thin, shown->derived, shown->thick});
    const bool is_narrow = std::llround(factor * low) == std::llround(factor * high);
    const double steps = is_narrow ? 100.0 : 1.0;  // a range that is none in whole numbers
    const auto rounded = [&](double value) {
        return config::to_text(std::round(factor * value * steps) / steps);
    };
    const std::string range = joined(rounded(low), " to ", rounded(high));
    if (shown->target) {
        const rockfall::Target& target = site.targets[*shown->target];
        warnings.add(joined(assumption, " the forest stops ", range, " % of the rocks at ",
                            target.name.empty() ? target.id : target.name),
                     config::Effect::answer);
    } else {
        warnings.add(joined(assumption, " the mean run-out is ", range, " m"), config::Effect::answer);
    }
}

std::vector<WrittenFile> write_bounds(const RunResults& results, const std::filesystem::path& folder) {
    if (!results.bounds) {
        return {};
    }
    return {bounds_table().write(folder, [&](auto& rows) {
        for (const ForestBounds::Figure& figure : results.bounds->figures) {
            rows.add(figure.target ? BoundRow{results.site.targets[*figure.target].id, "protection", "%",
                                              config::percent, results.bounds->rocks, figure}
                                   : BoundRow{"", "run_out", "m", 1.0, results.bounds->rocks, figure});
        }
    })};
}

TableLayout bounds_layout() {
    return bounds_table();
}

}  // namespace coupling
