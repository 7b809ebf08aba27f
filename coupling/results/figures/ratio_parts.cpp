#include "coupling/results/figures/ratio_parts.hpp"

#include <cassert>
#include <cstddef>
#include <numeric>

namespace coupling {

std::vector<double> parts_of_ratio(std::span<const double> values, std::span<const double> weights) {
    assert(!values.empty() && values.size() == weights.size());
    const double whole = std::accumulate(weights.begin(), weights.end(), 0.0);
    const double ratio = std::inner_product(values.begin(), values.end(), weights.begin(), 0.0) / whole;
    const double mean_weight = whole / static_cast<double>(values.size());
    std::vector<double> parts;
    for (std::size_t i = 0; i < values.size(); ++i) {
        parts.push_back(ratio + weights[i] / mean_weight * (values[i] - ratio));
    }
    return parts;
}

}  // namespace coupling
