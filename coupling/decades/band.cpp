#include "coupling/decades/band.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

namespace coupling::decades {
namespace {

/// Requires sorted values.
double quantile(const std::vector<double>& sorted, double share) {
    const double at = share * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(at);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return std::lerp(sorted[below], sorted[above], at - static_cast<double>(below));
}

}  // namespace

Band band_of(std::vector<double> values) {
    assert(!values.empty());
    const double sum = std::accumulate(values.begin(), values.end(), 0.0);
    std::sort(values.begin(), values.end());
    return {sum / static_cast<double>(values.size()), quantile(values, 0.05), quantile(values, 0.95)};
}

}  // namespace coupling::decades
