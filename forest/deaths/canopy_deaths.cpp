#include "forest/deaths/canopy_deaths.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "config/math/elementary.hpp"
#include "config/random/stream.hpp"

namespace forest {

namespace {

constexpr double struck_from_cm = 10.0;
constexpr double reach_m = 10.0;
constexpr std::size_t most_neighbours = 3;
/// Far behind the events that decide whether the stems of a tree die.
constexpr std::uint32_t event_of_fall = 0xF0'0000;

/// A unit vector on the map.
struct FallDirection {
    double east;
    double north;
};

/// The direction at a share of a full turn [0, 1).
FallDirection fall_direction_at(double turn) {
    const double quarters = 4.0 * turn;
    const auto quarter = static_cast<int>(quarters);
    const config::SinCos rest = config::sin_cos_of(0.5 * std::numbers::pi * (quarters - quarter));
    switch (quarter) {
        case 0:
            return {rest.cos, rest.sin};
        case 1:
            return {-rest.sin, rest.cos};
        case 2:
            return {-rest.cos, -rest.sin};
        default:
            return {rest.sin, -rest.cos};
    }
}

/// Thinner trees on which a fallen one comes to lie, the nearest first: in a strip as wide as its crown.
std::vector<std::pair<double, std::size_t>> under_fall(std::span<const Tree> trees, std::size_t fallen,
                                                       const FallDirection& direction) {
    const Tree& tree = trees[fallen];
    std::vector<std::pair<double, std::size_t>> found;
    for (std::size_t i = 0; i < trees.size(); ++i) {
        const Tree& other = trees[i];
        const double east_m = other.x_m - tree.x_m;
        const double north_m = other.y_m - tree.y_m;
        if (std::abs(east_m) > reach_m || std::abs(north_m) > reach_m || i == fallen ||
            other.dbh_cm < struck_from_cm || other.dbh_cm >= tree.dbh_cm) {
            continue;
        }
        const double along_m = east_m * direction.east + north_m * direction.north;
        const double aside_m = std::abs(north_m * direction.east - east_m * direction.north);
        if (along_m >= 0.0 && along_m <= reach_m && aside_m <= tree.crown.radius_m) {
            found.emplace_back(along_m, i);
        }
    }
    std::sort(found.begin(), found.end());
    return found;
}

}  // namespace

double canopy_death(const Species& species, double dbh_cm, double age_years, const CanopyPlace& place,
                    const CanopyDeaths& law, bool storms) {
    constexpr double last_years = 0.83;  // of the greatest age
    const double greatest_years = species.mortality.max_age_years;
    const double of_rank =
        law.at_any_age / greatest_years * config::exp_of(place.larger_m2pha / law.larger_m2pha);

    const double aged = age_years / (law.half_old * greatest_years);
    const double aged4 = aged * aged * aged * aged;
    const double of_years = law.when_old * place.crowding * aged4 / (1.0 + aged4);

    const double dbh_m = 0.01 * dbh_cm;
    const double dbh2_m2 = dbh_m * dbh_m;
    const double of_size =
        law.by_size * (species.conifer ? 1.0 : law.broadleaves) * dbh2_m2 * dbh2_m2 * dbh2_m2;

    const double scale_years = last_years * greatest_years;
    const double share = age_years / scale_years;
    const double share3 = share * share * share;
    const double of_greatest_age = 8.0 / scale_years * share3 * share3 * share;
    return std::min(1.0, (storms ? law.beside_storms : 1.0) * place.warmth * (of_rank + of_years + of_size) +
                             of_greatest_age);
}

double canopy_crowding(double basal_area_m2pha, const CanopyDeaths& law) {
    constexpr double least_m2pha = 0.01;
    const double ratio = std::max(basal_area_m2pha, least_m2pha) / law.usual_m2pha;
    return law.alone + std::min(config::pow_of(ratio, law.by_density), law.most_crowding);
}

double canopy_warmth(double usual_degree_days, const CanopyDeaths& law) {
    return std::clamp(1.0 + law.by_warmth * 0.01 * (usual_degree_days - law.usual_degree_days), law.coldest,
                      law.warmest);
}

std::vector<Removal> taken_along(const Stand& stand, std::span<const std::size_t> dead, std::uint64_t seed,
                                 std::uint32_t replicate) {
    const std::span<const Tree> trees = stand.trees();
    std::vector<Removal> taken;
    for (const std::size_t i : dead) {
        const config::RandomStream stream{
            {seed, replicate, static_cast<std::uint16_t>(stand.year()), number_of(trees[i].id)},
            config::Purpose::tree_death};
        const config::FourUniforms drawn = stream.uniforms_of(event_of_fall);
        if (drawn[1] >= falls_alive_share) {
            continue;
        }
        const FallDirection direction = fall_direction_at(drawn[0]);
        const std::vector<std::pair<double, std::size_t>> near = under_fall(trees, i, direction);
        for (std::size_t k = 0; k < std::min(most_neighbours, near.size()); ++k) {
            taken.push_back({trees[near[k].second].id, Cause::background, 0});
        }
    }
    return taken;
}

}  // namespace forest
