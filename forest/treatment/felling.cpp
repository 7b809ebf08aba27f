#include "forest/treatment/felling.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <utility>

#include "config/random/stream.hpp"
#include "forest/deadwood/decay.hpp"
#include "forest/deaths/wounds.hpp"
#include "forest/stand/allometry.hpp"

namespace forest {

namespace {

constexpr double least_left_cm = 15.0;
constexpr double clearance_without_branches = 0.5;
constexpr double damage_reach_m = 5.0;
/// A hit that leaves an ellipse of 200 cm2 on a thick stem and goes through the bark: rot may follow.
constexpr double damage_height_m = 0.5;
constexpr double damage_energy_share = 0.3;
constexpr double damage_body_m = 0.29;

config::FourUniforms chance_of(const Stand& stand, TreeId tree, std::uint32_t event, std::uint64_t seed,
                               std::uint32_t replicate) {
    return config::RandomStream{{seed, replicate, static_cast<std::uint16_t>(stand.year()), number_of(tree)},
                                config::Purpose::treatment}
        .uniforms_of(event);
}

Timber empty_timber(const SpeciesTable& species) {
    return {std::vector<std::array<TimberClass, dbh_classes>>(species.size())};
}

Snag stump_of(const Tree& tree, double height_m, int year) {
    return {.tree = tree.id,
            .x_m = tree.x_m,
            .y_m = tree.y_m,
            .species = tree.species,
            .cut = true,
            .dbh_cm = tree.dbh_cm,
            .tree_height_m = tree.height_m,
            .height_m = std::min(height_m, tree.height_m),
            .year = year,
            .sound_kg = tree.stem_kg * stem_part(tree.height_m, 0.0, height_m)};
}

/// Obliquely to one side of the fall line or the other.
double across_rad(const Patch& patch, const Felling& how, double side) {
    const double turn_rad = how.to_fall_line.in_radians() * (side < 0.5 ? -1.0 : 1.0);
    return 0.5 * std::numbers::pi - patch.aspect.in_radians() + turn_rad;
}

/// The log that is left of a felled tree, obliquely to one side of the fall line or the other.
Log left_log(const Patch& patch, const Snag& stem, const Felling& how, double side) {
    const double to_m = how.log_length_m > 0.0
                            ? std::min(stem.height_m, how.stump_height_m + how.log_length_m)
                            : stem.height_m;
    Log log = log_of_piece(stem, how.stump_height_m, to_m, across_rad(patch, how, side));
    log.clearance_m = clearance_without_branches * fresh_clearance_m;
    log.origin = LogOrigin::felled_crosswise;
    log.anchored = how.anchored;
    return log;
}

/// Hits of standing trees near felled ones.
std::vector<Impact> damage(const Stand& stand, std::span<const std::size_t> picks,
                           std::span<const char> felled, double share, std::uint64_t seed,
                           std::uint32_t replicate) {
    std::vector<std::vector<std::size_t>> felled_on(stand.grid().size());
    for (const std::size_t place : picks) {
        felled_on[index_of(stand.trees()[place].patch)].push_back(place);
    }
    std::vector<Impact> hits;
    for (std::size_t i = 0; i < stand.trees().size(); ++i) {
        const Tree& tree = stand.trees()[i];
        if (felled[i] != 0 || tree.stems > 1 || chance_of(stand, tree.id, 1, seed, replicate)[2] >= share) {
            continue;
        }
        const config::Cell cell = stand.grid()[tree.patch].cell;
        bool near = false;
        for (int k = 0; k < 9; ++k) {
            const auto patch = stand.grid().at(config::Cell{cell.column + k % 3 - 1, cell.row + k / 3 - 1});
            for (const std::size_t other : patch ? felled_on[index_of(*patch)] : std::vector<std::size_t>{}) {
                const double dx = stand.trees()[other].x_m - tree.x_m;
                const double dy = stand.trees()[other].y_m - tree.y_m;
                near = near || dx * dx + dy * dy <= damage_reach_m * damage_reach_m;
            }
        }
        if (near) {
            hits.push_back({.tree = tree.id,
                            .height_m = damage_height_m,
                            .energy_share = damage_energy_share,
                            .rock_diameter_m = damage_body_m});
        }
    }
    return hits;
}

}  // namespace

TimberClass Timber::total() const {
    TimberClass sum;
    for (const auto& classes : by_species) {
        for (const TimberClass& one : classes) {
            sum.stems += one.stems;
            sum.taken_m3 += one.taken_m3;
            sum.left_m3 += one.left_m3;
        }
    }
    return sum;
}

Timber& Timber::operator+=(const Timber& other) {
    if (by_species.empty()) {
        by_species.resize(other.by_species.size());
    }
    assert(other.by_species.empty() || by_species.size() == other.by_species.size());
    for (std::size_t s = 0; s < other.by_species.size(); ++s) {
        for (std::size_t c = 0; c < dbh_classes; ++c) {
            by_species[s][c].stems += other.by_species[s][c].stems;
            by_species[s][c].taken_m3 += other.by_species[s][c].taken_m3;
            by_species[s][c].left_m3 += other.by_species[s][c].left_m3;
        }
    }
    return *this;
}

Timber fell(Stand& stand, const SpeciesTable& species, std::span<const std::size_t> picks, const Felling& how,
            std::uint64_t seed, std::uint32_t replicate) {
    Timber timber = empty_timber(species);
    std::vector<Removal> removals;
    std::vector<Snag> stumps;
    std::vector<Log> logs;
    std::vector<char> felled(stand.trees().size(), 0);
    for (const std::size_t place : picks) {
        const Tree& tree = stand.trees()[place];
        felled[place] = 1;
        removals.push_back({tree.id, Cause::felled});
        TimberClass& sum = timber.by_species[index_of(tree.species)][dbh_class_of(tree.dbh_cm)];
        const double stem_m3 = stem_volume_m3(species[tree.species].allometry, tree.dbh_cm, tree.height_m);
        sum.stems += tree.stems;
        if (tree.dbh_cm < least_dead_wood_cm) {
            sum.left_m3 += tree.stems * stem_m3;  // too thin to be worth hauling, or to be followed
            continue;
        }
        if (how.girdled) {
            stumps.push_back(stump_of(tree, tree.height_m, stand.year()));
            stumps.back().cut = false;
            sum.left_m3 += tree.stems * stem_m3;
            continue;
        }
        double left_share = stem_part(tree.height_m, 0.0, how.stump_height_m);
        stumps.push_back(stump_of(tree, how.stump_height_m, stand.year()));
        const config::FourUniforms u = chance_of(stand, tree.id, 1, seed, replicate);
        if (tree.dbh_cm >= least_left_cm && u[0] < how.left_share && how.stump_height_m < tree.height_m) {
            logs.push_back(
                left_log(stand.grid()[tree.patch], stump_of(tree, tree.height_m, stand.year()), how, u[1]));
            left_share +=
                stem_part(tree.height_m, how.stump_height_m, how.stump_height_m + logs.back().length_m);
        }
        sum.left_m3 += tree.stems * left_share * stem_m3;
        sum.taken_m3 += tree.stems * (1.0 - left_share) * stem_m3;
    }
    std::vector<Impact> hits;
    if (how.damage_share > 0.0) {
        hits = damage(stand, picks, felled, how.damage_share, seed, replicate);
    }
    stand.remove_trees(removals);
    stand.add_snags(stumps);
    stand.add_logs(logs);
    wound(stand, species, hits, {}, seed, replicate);
    return timber;
}

Salvaged salvage(Stand& stand, const SpeciesTable& species, const TreatmentArea& area, double share,
                 int oldest_years, const Felling& how, std::uint64_t seed, std::uint32_t replicate) {
    Salvaged done{empty_timber(species)};
    Timber& timber = done.timber;
    const auto taken = [&](TreeId tree, double x_m, double y_m, int year) {
        return stand.year() - year <= oldest_years && belongs(area, stand.grid(), x_m, y_m) &&
               chance_of(stand, tree, 2, seed, replicate)[0] < share;
    };
    const auto is_left = [&](const config::FourUniforms& u, double thick_cm) {
        return thick_cm >= least_left_cm && u[1] < how.left_share;
    };
    const auto patch_at = [&](double x_m, double y_m) {
        done.patches.push_back(
            *stand.grid().at(x_m, y_m));  // belongs() has left out what lies off the patches
        return done.patches.back();
    };
    SnagsAndLogs left;
    DeadWoodLoss loss;
    for (const Snag& snag : stand.dead_wood().snags) {
        if (snag.cut || !taken(snag.tree, snag.x_m, snag.y_m, snag.year)) {
            left.snags.push_back(snag);
            continue;
        }
        const PatchId patch = patch_at(snag.x_m, snag.y_m);
        TimberClass& sum = timber.by_species[index_of(snag.species)][dbh_class_of(snag.dbh_cm)];
        sum.stems += 1.0;
        const double whole_kg = mass_kg(snag);
        double left_kg = 0.0;
        const auto keep = [&](const auto& piece) {
            sum.left_m3 += volume_m3(piece, species);
            left_kg += mass_kg(piece);
        };
        if (how.stump_height_m > 0.0) {
            Snag stump = snag;
            stump.cut = true;
            stump.height_m = std::min(snag.height_m, how.stump_height_m);
            stump.sound_kg = snag.sound_kg * stem_part(snag.tree_height_m, 0.0, stump.height_m) /
                             stem_part(snag.tree_height_m, 0.0, snag.height_m);
            keep(stump);
            left.snags.push_back(stump);
        }
        const config::FourUniforms u = chance_of(stand, snag.tree, 2, seed, replicate);
        if (is_left(u, snag.dbh_cm) && how.stump_height_m < snag.height_m) {
            left.logs.push_back(left_log(stand.grid()[patch], snag, how, u[2]));
            left.logs.back().year = stand.year();
            keep(left.logs.back());
        }
        sum.taken_m3 += volume_m3(snag, species) * (1.0 - left_kg / whole_kg);
        loss.taken_kg += whole_kg - left_kg;
    }
    for (const Log& log : stand.dead_wood().logs) {
        if (log.origin == LogOrigin::felled_crosswise || !taken(log.tree, log.x_m, log.y_m, log.year)) {
            left.logs.push_back(log);
            continue;
        }
        const PatchId patch = patch_at(log.x_m, log.y_m);
        TimberClass& sum = timber.by_species[index_of(log.species)][dbh_class_of(log.thick_end_cm)];
        sum.stems += 1.0;
        const config::FourUniforms u = chance_of(stand, log.tree, 2, seed, replicate);
        if (is_left(u, log.thick_end_cm)) {
            Log turned = log;
            turned.direction_rad = across_rad(stand.grid()[patch], how, u[2]);
            turned.clearance_m = clearance_without_branches * fresh_clearance_m;
            turned.origin = LogOrigin::felled_crosswise;
            turned.anchored = how.anchored;
            sum.left_m3 += volume_m3(turned, species);
            left.logs.push_back(turned);
            continue;
        }
        sum.taken_m3 += volume_m3(log, species);
        loss.taken_kg += mass_kg(log);
    }
    stand.set_dead_wood(std::move(left), loss);
    std::sort(done.patches.begin(), done.patches.end());
    done.patches.erase(std::unique(done.patches.begin(), done.patches.end()), done.patches.end());
    return done;
}

}  // namespace forest
