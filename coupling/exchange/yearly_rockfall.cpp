#include "coupling/exchange/yearly_rockfall.hpp"

#include <utility>

#include "coupling/exchange/stems_and_logs.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/inputs/site_draws.hpp"
#include "coupling/results/figures/figures.hpp"
#include "coupling/run/fall_rocks.hpp"

namespace coupling::exchange {
namespace {

/// Enters an arrival through trees with the same rock's over the bare slope.
void count_arrival(const rockfall::ArrivalRecord& arrived, const BareYear& bare,
                   std::vector<PairedCounts>& counts) {
    PairedCounts& of_target = counts[arrived.target];
    ++(bare.has_arrived(arrived.rock, arrived.target) ? of_target.both : of_target.only_forest);
}

/// Marks the rocks that had dead wood in their way. One that reaches a stem or log without energy leans on it
/// without a hit; as the record does not say on which, it is marked.
template <class IsDeadWood>
void mark_dead_wood(const rockfall::ChunkRows& rows, const IsDeadWood& is_dead_wood,
                    std::vector<bool>& marks) {
    auto at = rows.tree_hits.begin();
    for (const rockfall::RockRecord& fall : rows.rocks[index_of(Cover::forest)]) {
        bool met = fall.log_hits > 0 || fall.reason == rockfall::StopReason::log;
        bool held = false;
        for (; at != rows.tree_hits.end() && at->first == fall.rock; ++at) {
            met = met || is_dead_wood(at->second.stem);
            held = held || at->second.stopped;
        }
        marks[fall.rock] = met || (fall.reason == rockfall::StopReason::tree && !held);
    }
}

}  // namespace

YearlyRockfall::YearlyRockfall(const Scenario& scenario, const Site& site,
                               std::vector<double> fracture_energy, std::vector<rockfall::Stem> standing)
    : scenario_{scenario},
      site_{site},
      frame_{site.map_frame_on_terrain()},
      start_{start_law(scenario.release)},
      chunks_{
          rockfall::plan_chunks(site.sources, rockfall::rocks_of_chunk(scenario.rockfall.fall.motion.model))},
      fracture_energy_{std::move(fracture_energy)},
      standing_{std::move(standing)},
      distances_{site.targets.begin(), site.targets.end()},
      nets_{site.standing_nets()},
      rocks_{site.rocks()} {}

rockfall::Assessment YearlyRockfall::assessment(const rockfall::StemIndex& stems, const ParameterDraws& draws,
                                                std::uint32_t replicate, std::int32_t year,
                                                bool with_cells) const {
    rockfall::Assessment assessment{site_.slope,
                                    stems,
                                    site_.sources,
                                    site_.targets,
                                    start_,
                                    scenario_.rockfall.fall,
                                    with_cells ? frame_ : config::GridFrame{},
                                    scenario_.run.seed};
    assessment.nets = &nets_;
    assessment.draws = draws.falls;  // of one draw all rocks are the stratum
    assessment.replicate = replicate;
    assessment.year = static_cast<std::uint16_t>(year);
    return assessment;
}

forest::ForestFactors YearlyRockfall::forest_of(std::uint32_t replicate) const {
    const ParameterDraws draws = draw_of_replicate_on(scenario_, site_, replicate);
    return draws.forests.empty() ? forest::ForestFactors{} : draws.forests.front();
}

BareYear YearlyRockfall::simulate_bare(std::uint32_t replicate, std::int32_t year, bool with_cells,
                                       int threads) const {
    const rockfall::StemIndex none;
    const ParameterDraws draws = draw_of_replicate_on(scenario_, site_, replicate);
    const rockfall::Assessment falls = assessment(none, draws, replicate, year, with_cells);
    BareYear bare;
    bare.year = year;
    bare.targets.resize(site_.targets.size());
    bare.at_targets.resize(site_.targets.size());
    bare.arrived.resize((rocks_ * site_.targets.size() + 63) / 64);
    const auto keep_arrivals = [&](const rockfall::ChunkRows& rows) {
        for (const rockfall::ArrivalRecord& arrived : rows.arrivals[index_of(Cover::bare)]) {
            bare.mark_arrived(arrived.rock, arrived.target);
        }
        add_rocks_at_targets(rows, Cover::bare, bare.at_targets);
    };
    rockfall::EnsembleTally tally{falls.map_frame, site_.targets.size(), 0};
    if (fall_rocks_over(Cover::bare, falls, chunks_, threads, tally, keep_arrivals) == Ended::interrupted) {
        throw Interrupted{};
    }
    bare.run = std::move(tally.runs[index_of(Cover::bare)]);
    for (std::size_t target = 0; target < bare.targets.size(); ++target) {
        bare.targets[target] = std::move(tally.targets[target].by_cover[index_of(Cover::bare)]);
    }
    bare.cells = std::move(tally.cells[index_of(Cover::bare)].cells);
    return bare;
}

std::vector<PairedCounts> YearlyRockfall::simulate_living(const forest::Stand& stand, const BareYear& bare,
                                                          const YearFalls& falls, std::uint32_t replicate,
                                                          int threads) const {
    const Obstacles obstacles = living_stems_of(stand, fracture_energy_, standing_);
    const ParameterDraws draws = draw_of_replicate_on(scenario_, site_, replicate);
    const rockfall::StemIndex stems{obstacles.stems, site_.slope.terrain,
                                    largest_radius_m(start_, site_.sources, draws),
                                    scenario_.rockfall.fall.tree.taper};
    rockfall::Assessment through_trees = assessment(stems, draws, replicate, bare.year, false);
    std::vector<PairedCounts> counts(site_.targets.size());
    if (through_trees.only_bare()) {
        for (std::size_t target = 0; target < counts.size(); ++target) {
            counts[target].both = bare.targets[target].reached;
        }
        return counts;
    }
    counts = falls.past_dead_wood;
    through_trees.only_rocks = &falls.met_dead_wood;
    rockfall::EnsembleTally tally{through_trees.map_frame, site_.targets.size(), stems.placed().size()};
    const auto count = [&](const rockfall::ChunkRows& rows) {
        for (const rockfall::ArrivalRecord& arrived : rows.arrivals[index_of(Cover::forest)]) {
            count_arrival(arrived, bare, counts);
        }
    };
    if (fall_rocks_over(Cover::forest, through_trees, chunks_, threads, tally, count) == Ended::interrupted) {
        throw Interrupted{};
    }
    for (std::size_t target = 0; target < counts.size(); ++target) {
        counts[target].only_bare = bare.targets[target].reached - counts[target].both;
    }
    return counts;
}

YearFalls YearlyRockfall::simulate(const forest::Stand& stand, const BareYear& bare, std::uint32_t replicate,
                                   bool with_paths, int threads) const {
    const Obstacles obstacles = stems_and_logs_of(stand, fracture_energy_, standing_);
    const ParameterDraws draws = draw_of_replicate_on(scenario_, site_, replicate);
    const double radius_m = largest_radius_m(start_, site_.sources, draws);
    const rockfall::StemIndex stems{obstacles.stems, site_.slope.terrain, radius_m,
                                    scenario_.rockfall.fall.tree.taper};
    const rockfall::LogIndex logs{obstacles.logs, site_.slope.terrain, radius_m,
                                  scenario_.rockfall.fall.log.loose_share};
    rockfall::Assessment through_forest = assessment(stems, draws, replicate, bare.year, !bare.cells.empty());
    through_forest.logs = &logs;
    through_forest.path_every = with_paths ? (rocks_ + most_paths - 1) / most_paths : 0;

    YearFalls falls{
        .tally = {through_forest.map_frame, site_.targets.size(), stems.placed().size(), logs.count()},
        .at_targets = RocksAtTargets(site_.targets.size()),
        .at_targets_bare = bare.at_targets,
        .loads = {},
        .hits = {},
        .paths = {},
        .living = {}};
    falls.with_forest = !through_forest.only_bare();
    falls.met_dead_wood.resize(rocks_);
    falls.past_dead_wood.resize(site_.targets.size());
    // Stems that do not grow are the last ones.
    const std::size_t growing = obstacles.trees.size() - standing_.size();
    const auto is_dead_wood = [&](std::uint32_t stem) {
        return stem < growing && obstacles.trees[stem] == nullptr;
    };
    StoppingPlaceCounter stopping{distances_, stand.grid(), site_.origin_m(), stems.placed()};
    const auto keep_hits = [&](const rockfall::ChunkRows& rows) {
        stopping.add(rows, bare);
        falls.paths.insert(falls.paths.end(), rows.paths.begin(), rows.paths.end());
        const auto& rocks = rows.rocks[index_of(Cover::forest)];
        mark_dead_wood(rows, is_dead_wood, falls.met_dead_wood);
        add_rocks_at_targets(rows, Cover::forest, falls.at_targets);
        for (const rockfall::ArrivalRecord& arrived : rows.arrivals[index_of(Cover::forest)]) {
            const bool both = bare.has_arrived(arrived.rock, arrived.target);
            falls.tally.targets[arrived.target].reached_both += both ? 1 : 0;
            if (!falls.met_dead_wood[arrived.rock]) {
                count_arrival(arrived, bare, falls.past_dead_wood);
            }
        }
        auto rock = rocks.begin();
        for (const auto& [number, hit] : rows.tree_hits) {
            while (rock->rock != number) {
                ++rock;
            }
            const forest::Tree* tree = obstacles.trees[hit.stem];
            if (tree == nullptr) {
                continue;
            }
            falls.hits.push_back({number, impact_on(*tree, hit, stems.placed()[hit.stem], *rock,
                                                    fracture_energy_[forest::index_of(tree->species)])});
        }
    };
    if (falls.with_forest && fall_rocks_over(Cover::forest, through_forest, chunks_, threads, falls.tally,
                                             keep_hits) == Ended::interrupted) {
        throw Interrupted{};
    }
    falls.stopping = stopping.take();
    falls.tally.runs[index_of(Cover::bare)] = bare.run;
    for (std::size_t target = 0; target < bare.targets.size(); ++target) {
        falls.tally.targets[target].by_cover[index_of(Cover::bare)] = bare.targets[target];
    }
    falls.tally.cells[index_of(Cover::bare)].cells = bare.cells;
    for (std::size_t i = 0; i < obstacles.trees.size(); ++i) {
        if (obstacles.trees[i] != nullptr && falls.tally.stems[i].hits > 0) {
            falls.loads.push_back({obstacles.trees[i]->id, falls.tally.stems[i]});
        }
    }
    return falls;
}

}  // namespace coupling::exchange
