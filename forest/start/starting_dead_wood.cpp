#include "forest/start/starting_dead_wood.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "config/math/elementary.hpp"
#include "config/random/stream.hpp"
#include "forest/deadwood/deadwood.hpp"
#include "forest/deadwood/decay.hpp"
#include "forest/stand/allometry.hpp"
#include "forest/start/height_curve.hpp"

namespace forest {
namespace {

constexpr std::uint64_t first_dead_id = std::uint64_t{1} << 47U;
constexpr std::uint64_t first_cohort_id = std::uint64_t{1} << 46U;
constexpr double log_scatter_rad = std::numbers::pi / 3.0;  // as stems fall (deadwood)
constexpr double fresh_log_clearance_m = 0.2;               // branches are broken

config::RandomStream stream_of(std::uint64_t id, std::uint64_t seed, std::uint32_t replicate) {
    return {{seed, replicate, 0, id}, config::Purpose::starting_tree};
}

/// A whole number whose mean is the value.
std::uint64_t rounded_by_chance(double value, double u) {
    return static_cast<std::uint64_t>(value + u);
}

/// Years in which decay brings sound wood to this density at 10 degC.
int years_to(double density_share, double rate_pyear) {
    return rate_pyear > 0.0 ? static_cast<int>(std::lround(-config::ln_of(density_share) / rate_pyear)) : 0;
}

/// What stands or lies of one tree.
Snag stem_of(const DeadWoodRecord& record, const Species& kind, double degree_days, int year) {
    Snag stem;
    stem.species = record.species;
    stem.dbh_cm = record.dbh_cm;
    stem.tree_height_m = height_by_growth(kind, record.dbh_cm, degree_days);
    stem.height_m = std::min(record.length_m.value_or(stem.tree_height_m), stem.tree_height_m);
    stem.cut = record.kind == DeadWoodKind::stump;
    stem.density_share = density_of_decay_class[static_cast<std::size_t>(record.decay_class - 1)];
    stem.year = year - years_to(stem.density_share, record.kind == DeadWoodKind::snag
                                                        ? kind.deadwood.snag_decay_pyear
                                                        : lying_decay_pyear(kind.deadwood));
    stem.sound_kg = stem_volume_m3(kind.allometry, stem.dbh_cm, stem.tree_height_m) *
                    kind.allometry.stem_density_kgpm3 * stem_part(stem.tree_height_m, 0.0, stem.height_m);
    return stem;
}

Log log_of(const Snag& stem, const DeadWoodRecord& record, const Patch& patch, double u) {
    const double down_rad = 0.5 * std::numbers::pi - patch.aspect.in_radians();
    const double turn_rad = record.to_fall_line_deg
                                ? (u < 0.5 ? -1.0 : 1.0) * *record.to_fall_line_deg * std::numbers::pi / 180.0
                                : (2.0 * u - 1.0) * log_scatter_rad;
    Log log = log_of_piece(stem, 0.0, stem.height_m, down_rad + turn_rad);
    log.clearance_m = record.decay_class == 1 ? fresh_log_clearance_m : 0.0;
    log.origin = record.to_fall_line_deg && record.anchored ? LogOrigin::felled_crosswise : LogOrigin::fallen;
    log.anchored = record.anchored;
    return log;
}

}  // namespace

SnagsAndLogs dead_wood_from_records(std::span<const OnPatches<DeadWoodRecord>> stands, const PatchGrid& grid,
                                    const SpeciesTable& species, int year, std::uint64_t seed,
                                    std::uint32_t replicate) {
    SnagsAndLogs wood;
    std::uint64_t id = first_dead_id;
    for (const OnPatches<DeadWoodRecord>& stand : stands) {
        const double area_ha = static_cast<double>(stand.patches.size()) * patch_side_m * patch_side_m /
                               square_metres_per_hectare;
        for (const DeadWoodRecord& record : stand.records) {
            assert(record.decay_class >= 1 && record.decay_class <= 5 && !stand.patches.empty());
            const Snag stem = stem_of(record, species[record.species], stand.degree_days, year);
            const double pieces = record.volume_m3pha * area_ha / volume_m3(stem, species);
            const std::uint64_t count =
                rounded_by_chance(pieces, stream_of(id++, seed, replicate).uniforms_of(0)[0]);
            for (std::uint64_t i = 0; i < count; ++i, ++id) {
                const config::FourUniforms u = stream_of(id, seed, replicate).uniforms_of(0);
                const std::size_t place =
                    std::min(static_cast<std::size_t>(u[0] * static_cast<double>(stand.patches.size())),
                             stand.patches.size() - 1);
                const PatchId patch = stand.patches[place];
                Snag piece = stem;
                piece.tree = TreeId{id};
                piece.x_m = grid.x_centre_m(patch) + (u[1] - 0.5) * patch_side_m;
                piece.y_m = grid.y_centre_m(patch) + (u[2] - 0.5) * patch_side_m;
                if (record.kind == DeadWoodKind::log) {
                    wood.logs.push_back(log_of(piece, record, grid[patch], u[3]));
                } else {
                    wood.snags.push_back(piece);
                }
            }
        }
    }
    return wood;
}

std::vector<Cohort> cohorts_from_records(std::span<const OnPatches<SaplingRecord>> stands, std::uint64_t seed,
                                         std::uint32_t replicate) {
    constexpr double patch_ha = patch_side_m * patch_side_m / square_metres_per_hectare;
    std::vector<Cohort> cohorts;
    std::uint64_t id = first_cohort_id;
    for (const OnPatches<SaplingRecord>& stand : stands) {
        for (const SaplingRecord& record : stand.records) {
            for (const PatchId patch : stand.patches) {
                const std::uint64_t stems = rounded_by_chance(
                    record.stems_pha * patch_ha, stream_of(id++, seed, replicate).uniforms_of(0)[0]);
                if (stems > 0) {
                    cohorts.push_back({.patch = patch,
                                       .species = record.species,
                                       .origin = Origin::seed,
                                       .stems = static_cast<std::uint32_t>(stems),
                                       .height_m = record.height_m,
                                       .age_years = static_cast<std::uint16_t>(record.age_years)});
                }
            }
        }
    }
    return cohorts;
}

}  // namespace forest
