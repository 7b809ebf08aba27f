#include "coupling/inputs/forest/tops/bound_trees.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <utility>

#include "config/random/stream.hpp"
#include "forest/start/diameter_of_height.hpp"

namespace coupling {
namespace {

/// Of a normal law 90 % lie within so many standard deviations.
constexpr double deviations_of_bounds = 1.645;
/// Of stems: 15 % is a usual standard error of the inventory of a stand [choice].
constexpr double share_off_in_records = deviations_of_bounds * 0.15;
constexpr double next_to_m = 10.0;  ///< how far a tree that is added stands from its model [choice]
constexpr double around_m = 15.0;   ///< whose tops tell how high the canopy is [choice]

config::FourUniforms uniforms_of(std::uint64_t seed, std::size_t tree, std::uint32_t event) {
    return config::RandomStream{{seed, 0, 0, tree}, config::Purpose::unseen_tree}.uniforms_of(event);
}

/// A tree of the same size, anywhere within 10 m.
rockfall::Stem next_to(const rockfall::Stem& stem, double uniform, double other_uniform) {
    rockfall::Stem moved = stem;
    const double distance_m = next_to_m * std::sqrt(uniform);
    const double azimuth = 2.0 * std::numbers::pi * other_uniform;
    moved.x_m += distance_m * std::cos(azimuth);
    moved.y_m += distance_m * std::sin(azimuth);
    return moved;
}

/// The height of the highest tree within 15 m of each, itself among them.
std::vector<double> highest_around_m(std::span<const TreeRecord> trees) {
    using Square = std::pair<std::int64_t, std::int64_t>;
    const auto square_of = [](const rockfall::Stem& stem) {
        return Square{std::llround(std::floor(stem.x_m / around_m)),
                      std::llround(std::floor(stem.y_m / around_m))};
    };
    std::map<Square, std::vector<std::size_t>> squares;
    for (std::size_t i = 0; i < trees.size(); ++i) {
        squares[square_of(trees[i].stem)].push_back(i);
    }
    std::vector<double> highest_m(trees.size(), 0.0);
    for (std::size_t i = 0; i < trees.size(); ++i) {
        const rockfall::Stem& stem = trees[i].stem;
        const Square own = square_of(stem);
        for (std::int64_t dx = -1; dx <= 1; ++dx) {
            for (std::int64_t dy = -1; dy <= 1; ++dy) {
                const auto square = squares.find({own.first + dx, own.second + dy});
                if (square == squares.end()) {
                    continue;
                }
                for (const std::size_t other : square->second) {
                    const rockfall::Stem& there = trees[other].stem;
                    if (std::hypot(there.x_m - stem.x_m, there.y_m - stem.y_m) <= around_m) {
                        highest_m[i] = std::max(highest_m[i], there.height_m);
                    }
                }
            }
        }
    }
    return highest_m;
}

}  // namespace

double share_found(double height_share) {
    return height_share < 1.0 / 3.0   ? 4.0 / 18.0
           : height_share < 1.0 / 2.0 ? 9.0 / 31.0
           : height_share < 2.0 / 3.0 ? 17.0 / 28.0
                                      : 21.0 / 26.0;
}

BoundTrees bounds_of_tops(std::span<const TreeRecord> trees, std::uint64_t seed) {
    const double factor = std::exp(deviations_of_bounds * forest::diameter_of_height_width);
    const std::vector<double> highest_m = highest_around_m(trees);
    BoundTrees bounds;
    for (std::size_t i = 0; i < trees.size(); ++i) {
        rockfall::Stem thin = trees[i].stem;
        rockfall::Stem thick = thin;
        if (trees[i].has_derived_dbh) {
            thin.dbh_cm /= factor;
            thick.dbh_cm *= factor;
        }
        bounds.thin.push_back(thin);
        bounds.thick.push_back(thick);
        const double missed = 1.0 / share_found(trees[i].stem.height_m / highest_m[i]) - 1.0;
        const auto more = static_cast<std::uint32_t>(missed + uniforms_of(seed, i, 0)[0]);
        for (std::uint32_t k = 1; k <= more; ++k) {
            const config::FourUniforms uniforms = uniforms_of(seed, i, k);
            bounds.thick.push_back(next_to(thick, uniforms[0], uniforms[1]));
        }
    }
    return bounds;
}

BoundTrees bounds_of_records(std::span<const TreeRecord> trees, std::uint64_t seed) {
    BoundTrees bounds;
    for (std::size_t i = 0; i < trees.size(); ++i) {
        const config::FourUniforms uniforms = uniforms_of(seed, i, 0);
        bounds.thick.push_back(trees[i].stem);
        if (uniforms[0] < share_off_in_records) {
            bounds.thick.push_back(next_to(trees[i].stem, uniforms[1], uniforms[2]));
        } else {
            bounds.thin.push_back(trees[i].stem);
        }
    }
    return bounds;
}

}  // namespace coupling
