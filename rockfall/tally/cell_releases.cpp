#include "rockfall/tally/cell_releases.hpp"

#include <map>

namespace rockfall {

void CellReleases::add(std::uint64_t weight, float energy_j) {
    for (std::size_t i = 0; i < from_j.size() && energy_j >= from_j[i]; ++i) {
        weights[i] += weight;
    }
}

void CellReleases::add(const CellReleases& other) {
    for (std::size_t i = 0; i < weights.size(); ++i) {
        weights[i] += other.weights[i];
    }
}

std::vector<std::uint64_t> release_weights(std::span<const ReleaseSource> sources) {
    std::map<const StartLaw*, std::uint64_t> rocks;
    for (const ReleaseSource& source : sources) {
        rocks[source.own_start.get()] += source.rocks;
    }
    std::vector<std::uint64_t> weights;
    weights.reserve(sources.size());
    for (const ReleaseSource& source : sources) {
        const std::uint64_t of_start = rocks[source.own_start.get()];
        weights.push_back(of_start == 0 ? 0 : (CellReleases::one_release + of_start / 2) / of_start);
    }
    return weights;
}

}  // namespace rockfall
