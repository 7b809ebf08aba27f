#include "coupling/exchange/stems_and_logs.hpp"

#include <algorithm>
#include <cmath>

#include "forest/deadwood/decay.hpp"
#include "forest/deaths/wounds.hpp"

namespace coupling::exchange {
namespace {

/// A log ends in a point; a rock meets a thickness.
constexpr double least_log_end_cm = 1.0;

rockfall::Stem stem_of(const forest::Tree& tree, double fracture_energy) {
    rockfall::Stem stem{tree.x_m, tree.y_m, tree.dbh_cm, tree.height_m, fracture_energy};
    stem.strength = forest::stem_strength(tree, rockfall::breast_height_m);
    return stem;
}

rockfall::Stem stem_of(const forest::Snag& snag, int year, double fracture_energy) {
    rockfall::Stem stem{snag.x_m, snag.y_m, diameter_left(snag) * snag.dbh_cm, snag.tree_height_m,
                        fracture_energy};
    stem.strength = forest::strength_share(snag, year);
    stem.broken_at_m = snag.height_m < snag.tree_height_m ? snag.height_m : 0.0;
    return stem;
}

rockfall::Log lying_log_of(const forest::Log& log, const forest::Stand& stand, double fracture_energy) {
    const double plan_m = plan_length_m(log, stand.grid());
    rockfall::Log lying;
    lying.x1_m = log.x_m;
    lying.y1_m = log.y_m;
    lying.x2_m = log.x_m + plan_m * std::cos(log.direction_rad);
    lying.y2_m = log.y_m + plan_m * std::sin(log.direction_rad);
    const double left = diameter_left(log);
    lying.diameter1_cm = std::max(left * log.thick_end_cm, least_log_end_cm);
    lying.diameter2_cm = std::max(left * log.thin_end_cm, least_log_end_cm);
    lying.clearance_m = log.clearance_m;
    lying.fracture_energy = fracture_energy;
    lying.strength = forest::strength_share(log, stand.year());
    lying.supported = log.anchored;
    return lying;
}

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

Obstacles living_stems_of(const forest::Stand& stand, std::span<const double> fracture_energy,
                          std::span<const rockfall::Stem> standing) {
    Obstacles obstacles;
    for (const forest::Tree& tree : stand.trees()) {
        if (tree.dbh_cm >= least_obstacle_cm) {
            obstacles.stems.push_back(stem_of(tree, fracture_energy[forest::index_of(tree.species)]));
            obstacles.trees.push_back(&tree);
        }
    }
    obstacles.stems.insert(obstacles.stems.end(), standing.begin(), standing.end());
    obstacles.trees.resize(obstacles.stems.size(), nullptr);
    return obstacles;
}

Obstacles stems_and_logs_of(const forest::Stand& stand, std::span<const double> fracture_energy,
                            std::span<const rockfall::Stem> standing) {
    const auto fracture_energy_of = [&](forest::SpeciesId species) {
        return fracture_energy[forest::index_of(species)];
    };
    Obstacles obstacles;
    for (const forest::Tree& tree : stand.trees()) {
        if (tree.dbh_cm >= least_obstacle_cm) {
            obstacles.stems.push_back(stem_of(tree, fracture_energy_of(tree.species)));
            obstacles.trees.push_back(&tree);
        }
    }
    for (const forest::Snag& snag : stand.dead_wood().snags) {
        obstacles.stems.push_back(stem_of(snag, stand.year(), fracture_energy_of(snag.species)));
    }
    obstacles.stems.insert(obstacles.stems.end(), standing.begin(), standing.end());
    obstacles.trees.resize(obstacles.stems.size(), nullptr);
    for (const forest::Log& log : stand.dead_wood().logs) {
        obstacles.logs.push_back(lying_log_of(log, stand, fracture_energy_of(log.species)));
    }
    return obstacles;
}

}  // namespace coupling::exchange
