#include "coupling/results/figures/most_reached.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "coupling/results/figures/figures.hpp"

namespace coupling {

std::vector<std::size_t> most_reached(std::span<const rockfall::TargetTally> tallies,
                                      std::vector<std::size_t> targets, std::size_t most) {
    if (targets.size() > most) {
        const auto reached = [&](std::size_t target) {
            return tallies[target].by_cover[index_of(Cover::bare)].reached;
        };
        std::stable_sort(targets.begin(), targets.end(),
                         [&](std::size_t a, std::size_t b) { return reached(a) > reached(b); });
        targets.resize(most);
    }
    return targets;
}

std::vector<std::size_t> most_reached(std::span<const rockfall::TargetTally> tallies, std::size_t most) {
    std::vector<std::size_t> all(tallies.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    return most_reached(tallies, std::move(all), most);
}

}  // namespace coupling
