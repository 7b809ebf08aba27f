#include "coupling/decades/year_falls.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "coupling/run/fall_rocks.hpp"
#include "forest/deadwood/decay.hpp"
#include "rockfall/obstacles/tree_energy.hpp"

namespace coupling::decades {
namespace {

/// A log ends in a point; rocks want a thickness.
constexpr double least_log_end_cm = 1.0;

}  // namespace

double plan_length_m(const forest::Log& log, const forest::PatchGrid& grid) {
    const auto place = grid.at(log.x_m, log.y_m);
    if (!place) {
        return log.length_m;
    }
    const forest::Patch& patch = grid[*place];
    const double east = std::sin(patch.aspect.in_radians());  // of the fall line
    const double north = std::cos(patch.aspect.in_radians());
    const double drop = std::tan(patch.slope.in_radians()) *
                        (east * std::cos(log.direction_rad) + north * std::sin(log.direction_rad));
    return log.length_m / std::sqrt(1.0 + drop * drop);
}

RockSeason::RockSeason(const Scenario& scenario, const Site& site, std::vector<double> fracture_energy,
                       std::vector<rockfall::Stem> standing)
    : scenario_{scenario},
      site_{site},
      frame_{site.map_frame_on_terrain()},
      start_{start_law(scenario)},
      chunks_{rockfall::plan_chunks(site.sources)},
      fracture_energy_{std::move(fracture_energy)},
      standing_{std::move(standing)},
      nets_{site.standing_nets()},
      rocks_{site.sources.empty() ? 0 : site.sources.back().first_rock + site.sources.back().rocks} {}

RockSeason::Obstacles RockSeason::obstacles_of(const forest::Stand& stand) const {
    Obstacles obstacles;
    for (const forest::Tree& tree : stand.trees()) {
        if (tree.dbh_cm >= least_obstacle_cm) {
            rockfall::Stem stem{tree.x_m, tree.y_m, tree.dbh_cm, tree.height_m,
                                fracture_energy(tree.species)};
            stem.strength = forest::stem_strength(tree, rockfall::breast_height_m);
            obstacles.stems.push_back(stem);
            obstacles.trees.push_back(&tree);
        }
    }
    for (const forest::Snag& snag : stand.dead_wood().snags) {
        rockfall::Stem stem{snag.x_m, snag.y_m, snag.dbh_cm, snag.tree_height_m,
                            fracture_energy(snag.species)};
        stem.strength = forest::strength_share(snag, stand.year());
        stem.broken_at_m = snag.height_m < snag.tree_height_m ? snag.height_m : 0.0;
        obstacles.stems.push_back(stem);
    }
    obstacles.stems.insert(obstacles.stems.end(), standing_.begin(), standing_.end());
    obstacles.trees.resize(obstacles.stems.size(), nullptr);
    for (const forest::Log& log : stand.dead_wood().logs) {
        const double plan_m = plan_length_m(log, stand.grid());
        rockfall::Log lying;
        lying.x1_m = log.x_m;
        lying.y1_m = log.y_m;
        lying.x2_m = log.x_m + plan_m * std::cos(log.direction_rad);
        lying.y2_m = log.y_m + plan_m * std::sin(log.direction_rad);
        lying.diameter1_cm = log.thick_end_cm;
        lying.diameter2_cm = std::max(log.thin_end_cm, least_log_end_cm);
        lying.clearance_m = log.clearance_m;
        lying.fracture_energy = fracture_energy(log.species);
        lying.strength = forest::strength_share(log, stand.year());
        lying.supported = log.anchored;
        obstacles.logs.push_back(lying);
    }
    return obstacles;
}

rockfall::Assessment RockSeason::assessment(const rockfall::StemIndex& stems, std::uint32_t replicate,
                                            std::int32_t year) const {
    rockfall::Assessment assessment{site_.slope,   stems,         site_.sources,
                                    site_.targets, start_,        scenario_.rockfall.fall,
                                    frame_,        scenario_.seed};
    assessment.nets = &nets_;
    assessment.replicate = replicate;
    assessment.year = static_cast<std::uint16_t>(year);
    return assessment;
}

BareYear RockSeason::fall_bare(std::uint32_t replicate, std::int32_t year, bool with_cells,
                               int threads) const {
    const rockfall::StemIndex none;
    const rockfall::Assessment falls = assessment(none, replicate, year);
    BareYear bare;
    bare.year = year;
    bare.targets.resize(site_.targets.size());
    bare.arrived.resize((rocks_ * site_.targets.size() + 63) / 64);
    const auto keep_arrivals = [&](const rockfall::ChunkRows& rows) {
        auto arrival = rows.arrivals[index_of(Cover::bare)].begin();
        for (const rockfall::RockRecord& rock : rows.rocks[index_of(Cover::bare)]) {
            for (std::size_t target = 0; target < bare.targets.size(); ++target, ++arrival) {
                if (arrival->reached) {
                    bare.mark_arrived(rock.rock, target);
                }
            }
        }
    };
    rockfall::EnsembleTally tally{frame_, site_.targets.size(), 0};
    if (fall_rocks_over(Cover::bare, falls, chunks_, threads, tally, keep_arrivals) == Ended::interrupted) {
        throw Interrupted{};
    }
    bare.run = std::move(tally.runs[index_of(Cover::bare)]);
    for (std::size_t target = 0; target < bare.targets.size(); ++target) {
        bare.targets[target] = std::move(tally.targets[target].by_cover[index_of(Cover::bare)]);
    }
    if (with_cells) {
        bare.cells = std::move(tally.cells[index_of(Cover::bare)].cells);
    }
    return bare;
}

FallsOfYear RockSeason::fall(const forest::Stand& stand, const BareYear& bare, std::uint32_t replicate,
                             bool with_paths, int threads) const {
    const Obstacles obstacles = obstacles_of(stand);
    const double largest_radius_m = 0.5 * rockfall::diameter_range(start_, site_.sources).largest_m;
    const rockfall::StemIndex stems{obstacles.stems, site_.slope.terrain, largest_radius_m,
                                    scenario_.rockfall.fall.tree.taper};
    const rockfall::LogIndex logs{obstacles.logs, site_.slope.terrain, largest_radius_m,
                                  scenario_.rockfall.fall.log.loose_share};
    rockfall::Assessment through_forest = assessment(stems, replicate, bare.year);
    through_forest.logs = &logs;
    through_forest.path_every = with_paths ? (rocks_ + most_paths - 1) / most_paths : 0;

    FallsOfYear falls{.tally = {frame_, site_.targets.size(), stems.placed().size(), logs.count()},
                      .takes = {},
                      .hits = {},
                      .paths = {}};
    falls.with_forest = !through_forest.only_bare();
    const auto keep_hits = [&](const rockfall::ChunkRows& rows) {
        falls.paths.insert(falls.paths.end(), rows.paths.begin(), rows.paths.end());
        const auto& rocks = rows.rocks[index_of(Cover::forest)];
        auto arrival = rows.arrivals[index_of(Cover::forest)].begin();
        for (const rockfall::RockRecord& fallen : rocks) {
            for (std::size_t target = 0; target < bare.targets.size(); ++target, ++arrival) {
                const bool both = arrival->reached && bare.has_arrived(fallen.rock, target);
                falls.tally.targets[target].reached_both += both ? 1 : 0;
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
            const rockfall::PlacedStem& stem = stems.placed()[hit.stem];
            // Of a sound stem: the forest itself knows how rotten the tree is.
            const double sound_j = rockfall::largest_energy_j(tree->dbh_cm, fracture_energy(tree->species));
            falls.hits.push_back({number,
                                  {.tree = tree->id,
                                   .height_m = std::max(0.0, static_cast<double>(hit.height_m)),
                                   .energy_share = hit.energy_j / sound_j,
                                   .frontal = hit.type == rockfall::HitType::frontal,
                                   .rock_diameter_m = rock->diameter_m,
                                   .direction_rad = std::atan2(stem.y_m - hit.position_m.y(),
                                                               stem.x_m - hit.position_m.x())}});
        }
    };
    if (falls.with_forest && fall_rocks_over(Cover::forest, through_forest, chunks_, threads, falls.tally,
                                             keep_hits) == Ended::interrupted) {
        throw Interrupted{};
    }
    falls.tally.runs[index_of(Cover::bare)] = bare.run;
    for (std::size_t target = 0; target < bare.targets.size(); ++target) {
        falls.tally.targets[target].by_cover[index_of(Cover::bare)] = bare.targets[target];
    }
    falls.tally.cells[index_of(Cover::bare)].cells = bare.cells;
    for (std::size_t i = 0; i < obstacles.trees.size(); ++i) {
        if (obstacles.trees[i] != nullptr && falls.tally.stems[i].hits > 0) {
            falls.takes.push_back({obstacles.trees[i]->id, falls.tally.stems[i]});
        }
    }
    return falls;
}

void record_falls(const FallsOfYear& falls, std::int32_t year, MemberYears& kept) {
    const auto bare = static_cast<std::size_t>(Cover::bare);
    // Without a single stem the slope with forest is the bare slope.
    const std::size_t forest = falls.with_forest ? static_cast<std::size_t>(Cover::forest) : bare;
    for (const auto& [cover, counted] : {std::pair{Cover::forest, forest}, std::pair{Cover::bare, bare}}) {
        kept.slopes.push_back({year, cover, figures_of(falls.tally.runs[counted])});
    }
    const std::uint64_t rocks = falls.tally.runs[bare].rocks;
    for (std::uint32_t t = 0; t < falls.tally.targets.size(); ++t) {
        const rockfall::TargetTally& target = falls.tally.targets[t];
        TargetRow row;
        row.year = year;
        row.target = t;
        const std::uint64_t with = target.by_cover[forest].reached;
        const std::uint64_t without = target.by_cover[bare].reached;
        const std::uint64_t both = falls.with_forest ? target.reached_both : without;
        row.paired = {both, with - both, without - both};
        row.forest = figures_of(target.by_cover[forest], rocks);
        row.bare = figures_of(target.by_cover[bare], rocks);
        kept.targets.push_back(row);
    }
}

void record_cells(const FallsOfYear& falls, std::int32_t year, MemberYears& kept) {
    const auto bare = static_cast<std::size_t>(Cover::bare);
    const std::size_t forest = falls.with_forest ? static_cast<std::size_t>(Cover::forest) : bare;
    kept.maps.push_back({year, Cover::forest, falls.tally.cells[forest].cells});
    kept.maps.push_back({year, Cover::bare, falls.tally.cells[bare].cells});
}

void record_paths(const FallsOfYear& falls, std::int32_t year, MemberYears& kept) {
    for (const rockfall::PathRecord& path : falls.paths) {
        for (const rockfall::PathPoint& point : path.points) {
            kept.paths.push_back({year, point.energy_j / 1000.0F, path.rock, point.position_m.x(),
                                  point.position_m.y(), point.position_m.z()});
        }
    }
}

}  // namespace coupling::decades
