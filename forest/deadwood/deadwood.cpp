#include "forest/deadwood/deadwood.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <utility>

#include "config/random/stream.hpp"
#include "config/units/constants.hpp"
#include "forest/deadwood/decay.hpp"

namespace forest {

namespace {

constexpr double fall_scatter_deg = 60.0;
/// Small stems lose their branches as they fall.
constexpr double broken_clearance_m = 0.2;

constexpr double weak_log = 0.3;
constexpr double rolling_slope_deg = 35.0;
constexpr double rolling_chance = 0.01;

bool stands_after(Cause cause) {
    return cause != Cause::felled && cause != Cause::wind && cause != Cause::snow && cause != Cause::rock &&
           cause != Cause::browsing;
}

/// Place and climate of one piece of dead wood.
struct Bed {
    double speed = 0.0;  ///< of decay
    double slope_deg = 0.0;
    double down_rad = 0.0;  ///< direction of the fall line, counter-clockwise from east
};

class Beds {
public:
    Beds(const Stand& stand, const Site& site, std::span<const ClimateYear> weather)
        : stand_{stand}, site_{site} {
        for (const ClimateYear& year : weather) {
            speeds_.push_back(decay_speed(year));
        }
    }
    [[nodiscard]] Bed at(double x_m, double y_m) const {
        const std::optional<PatchId> patch = stand_.grid().at(x_m, y_m);
        if (!patch) {
            return {speeds_.empty() ? 0.0 : speeds_.front(), 0.0, 0.0};
        }
        const Patch& ground = stand_.grid()[*patch];
        return {speeds_[site_.unit_of(*patch)], ground.slope.in_degrees(),
                0.5 * std::numbers::pi - ground.aspect.in_radians()};
    }

private:
    const Stand& stand_;
    const Site& site_;
    std::vector<double> speeds_;
};

struct YearChance {
    std::uint64_t seed = 0;
    std::uint32_t replicate = 0;
    int year = 0;

    [[nodiscard]] config::FourUniforms of(TreeId tree, std::uint32_t event) const {
        return config::RandomStream{{seed, replicate, static_cast<std::uint16_t>(year), number_of(tree)},
                                    config::Purpose::dead_wood}
            .uniforms_of(event);
    }
};

double direction_of_fall_rad(const Bed& bed, double u) {
    const double scatter_rad = fall_scatter_deg * std::numbers::pi / 180.0;
    return bed.down_rad + (2.0 * u - 1.0) * scatter_rad;
}

Log fallen_piece(const Snag& snag, double from_m, const Bed& bed, double u, int year) {
    Log log = log_of_piece(snag, from_m, snag.height_m, direction_of_fall_rad(bed, u));
    log.clearance_m = snag.density_share > 0.7 ? broken_clearance_m : 0.0;
    log.year = year;
    return log;
}

/// A year of decay; what it took [kg].
template <class Piece>
double rot(Piece& piece, double density_left) {
    const double before_kg = mass_kg(piece);
    piece.density_share *= density_left;
    return before_kg - mass_kg(piece);
}

/// What a year makes of the snags; what falls is added to the logs.
std::vector<Snag> age_snags(const Stand& stand, const SpeciesTable& species, const Beds& beds,
                            const YearChance& chance, std::vector<Log>& logs, DeadWoodLoss& loss) {
    std::vector<Snag> left;
    left.reserve(stand.dead_wood().snags.size());
    for (Snag snag : stand.dead_wood().snags) {
        if (snag.year == stand.year()) {
            left.push_back(snag);
            continue;
        }
        const Deadwood& law = species[snag.species].deadwood;
        const Bed bed = beds.at(snag.x_m, snag.y_m);
        const double rate_pyear = snag.cut ? lying_decay_pyear(law) : law.snag_decay_pyear;
        loss.decayed_kg += rot(snag, yearly_density_left(rate_pyear, bed.speed));
        if (snag.density_share < soil_density) {
            loss.soil_kg += mass_kg(snag);
            continue;
        }
        const config::FourUniforms u = chance.of(snag.tree, 0);
        if (!snag.cut && u[0] < fall_chance(law, snag.dbh_cm, bed.speed)) {
            logs.push_back(fallen_piece(snag, 0.0, bed, u[3], stand.year()));
            continue;
        }
        if (u[1] < breakage_chance(snag, stand.year(), bed.speed)) {
            const double break_m = 1.0 + 4.0 * u[2];
            if (break_m < snag.height_m) {
                logs.push_back(fallen_piece(snag, break_m, bed, u[3], stand.year()));
                snag.sound_kg -= logs.back().sound_kg;
                snag.height_m = break_m;
            }
        }
        left.push_back(snag);
    }
    return left;
}

std::vector<Log> age_logs(const Stand& stand, const SpeciesTable& species, const Beds& beds,
                          const YearChance& chance, DeadWoodLoss& loss) {
    std::vector<Log> left;
    left.reserve(stand.dead_wood().logs.size());
    for (Log log : stand.dead_wood().logs) {
        if (log.year == stand.year()) {
            left.push_back(log);
            continue;
        }
        const Bed bed = beds.at(log.x_m, log.y_m);
        loss.decayed_kg +=
            rot(log, yearly_density_left(lying_decay_pyear(species[log.species].deadwood), bed.speed));
        const double age_years = stand.year() - log.year;
        const double before = clearance_m(1.0, age_years - 1.0);
        log.clearance_m *= before > 0.0 ? clearance_m(1.0, age_years) / before : 0.0;
        const bool may_roll = log.origin == LogOrigin::felled_crosswise && !log.anchored &&
                              bed.slope_deg > rolling_slope_deg &&
                              strength_share(log, stand.year()) < weak_log;
        const bool rolls = may_roll && chance.of(log.tree, 1)[0] < rolling_chance;
        if (log.density_share >= soil_density && !rolls) {
            left.push_back(log);
        } else {
            loss.soil_kg += mass_kg(log);
        }
    }
    return left;
}

Snag snag_of(const Tree& tree, int year) {
    return {.tree = tree.id,
            .x_m = tree.x_m,
            .y_m = tree.y_m,
            .species = tree.species,
            .dbh_cm = tree.dbh_cm,
            .tree_height_m = tree.height_m,
            .height_m = tree.height_m,
            .year = year,
            .sound_kg = tree.stem_kg};
}

}  // namespace

std::vector<Snag> snags_of_deaths(const Stand& stand) {
    std::vector<Snag> snags;
    for (const DeadTree& dead : stand.deaths()) {
        const Tree& tree = dead.tree;
        if (tree.dbh_cm < least_dead_wood_cm || !stands_after(dead.cause)) {
            continue;
        }
        snags.push_back(snag_of(tree, stand.year()));
    }
    return snags;
}

double stem_diameter_cm(double dbh_cm, double tree_height_m, double height_m) {
    using config::breast_height_m;
    const double taper = (tree_height_m - height_m) / (tree_height_m - breast_height_m);
    return dbh_cm * std::max(0.0, taper);
}

double stem_part(double tree_height_m, double from_m, double to_m) {
    const double base = (tree_height_m - from_m) / tree_height_m;
    const double top = (tree_height_m - std::min(to_m, tree_height_m)) / tree_height_m;
    return base * base * base - top * top * top;
}

Log log_of_piece(const Snag& stem, double from_m, double to_m, double direction_rad) {
    assert(from_m < to_m);
    return {.tree = stem.tree,
            .x_m = stem.x_m,
            .y_m = stem.y_m,
            .direction_rad = direction_rad,
            .length_m = to_m - from_m,
            .thick_end_cm = stem_diameter_cm(stem.dbh_cm, stem.tree_height_m, from_m),
            .thin_end_cm = stem_diameter_cm(stem.dbh_cm, stem.tree_height_m, to_m),
            .density_share = stem.density_share,
            .species = stem.species,
            .year = stem.year,
            .sound_kg = stem.sound_kg * stem_part(stem.tree_height_m, from_m, to_m) /
                        stem_part(stem.tree_height_m, 0.0, stem.height_m)};
}

double diameter_left(const Snag& snag) {
    return std::sqrt(volume_left(snag.density_share));
}

double diameter_left(const Log& log) {
    return std::sqrt(volume_left(log.density_share));
}

double volume_m3(const Snag& snag, const SpeciesTable& species) {
    return volume_left(snag.density_share) * snag.sound_kg /
           species[snag.species].allometry.stem_density_kgpm3;
}

double volume_m3(const Log& log, const SpeciesTable& species) {
    return volume_left(log.density_share) * log.sound_kg / species[log.species].allometry.stem_density_kgpm3;
}

Wreck wreck_of(const Tree& tree, double break_m, double direction_rad, LogOrigin origin, int year) {
    assert(break_m >= 0.0 && break_m < tree.height_m);
    Snag stem = snag_of(tree, year);
    Wreck wreck{std::nullopt, log_of_piece(stem, break_m, tree.height_m, direction_rad)};
    wreck.log.clearance_m = fresh_clearance_m;
    wreck.log.origin = origin;
    if (break_m > 0.0) {
        stem.height_m = break_m;
        stem.sound_kg -= wreck.log.sound_kg;
        wreck.stump = stem;
    }
    return wreck;
}

void age_dead_wood(Stand& stand, const Site& site, const SpeciesTable& species,
                   std::span<const ClimateYear> weather, std::uint64_t seed, std::uint32_t replicate) {
    assert(weather.size() == site.units().size());
    const Beds beds{stand, site, weather};
    const YearChance chance{seed, replicate, stand.year()};
    SnagsAndLogs wood;
    DeadWoodLoss loss;
    wood.logs = age_logs(stand, species, beds, chance, loss);
    wood.snags = age_snags(stand, species, beds, chance, wood.logs, loss);
    stand.set_dead_wood(std::move(wood), loss);
    stand.add_snags(snags_of_deaths(stand));
}

}  // namespace forest
