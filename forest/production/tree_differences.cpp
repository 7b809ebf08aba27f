#include "forest/production/tree_differences.hpp"

#include "config/math/elementary.hpp"
#include "config/random/distributions.hpp"
#include "config/random/stream.hpp"

namespace forest {

std::vector<double> growth_factors(std::span<const Tree> trees, const TreeDifferences& law,
                                   std::uint64_t seed, std::uint32_t replicate) {
    std::vector<double> factors(trees.size(), 1.0);
    if (!(law.growth > 0.0)) {
        return factors;
    }
    // The mean of a log-normal value is its median times exp(deviation^2 / 2).
    const double median = config::exp_of(-0.5 * law.growth * law.growth);
    constexpr std::uint16_t for_life = 0;
    for (std::size_t i = 0; i < trees.size(); ++i) {
        if (trees[i].dbh_cm < single_tree_cm) {
            continue;
        }
        config::RandomStream stream{{seed, replicate, for_life, number_of(trees[i].id)},
                                    config::Purpose::tree_kind};
        factors[i] = config::lognormal(stream.uniform(), median, law.growth);
    }
    return factors;
}

}  // namespace forest
