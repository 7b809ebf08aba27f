#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "forest/stand/tree.hpp"

namespace forest {

/// How much trees of one species, size and place differ in growth for life: by their kind and their ground.
///
/// Without it trees of one size grew alike: over 54 years their growth differed by 1 cm (standard deviation
/// in a class of starting diameter) where a measured plot has 4 to 6 cm (forest_hauersteig).
struct TreeDifferences {
    double growth = 0.3;  ///< [0, 1], standard deviation of the logarithm of a tree's share of production
};

/// Trees of this diameter stand for themselves [choice]; thinner ones are groups (forest/stand/tree.hpp).
inline constexpr double single_tree_cm = 5.0;

/// The lasting factor of each tree on its share of production: log-normal with mean 1 over trees, the same in
/// every year of its life. Trees below single_tree_cm have 1: a group of them is their mean.
///
/// It is a function of seed, replicate and identity alone, so nothing has to be stored: a continued run, any
/// order of trees and all regimes and climates of a replicate have the same. A tree that is written to a list
/// and read again has a new identity, and with it another factor. The factor does not depend on the size that
/// a tree of a starting stand has already reached [choice].
std::vector<double> growth_factors(std::span<const Tree> trees, const TreeDifferences& law,
                                   std::uint64_t seed, std::uint32_t replicate);

}  // namespace forest
