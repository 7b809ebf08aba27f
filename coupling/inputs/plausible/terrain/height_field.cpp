#include "coupling/inputs/plausible/terrain/height_field.hpp"

#include <algorithm>
#include <limits>
#include <unordered_set>
#include <vector>

namespace coupling::plausible::terrain {

Values values_of(const HeightField& field) {
    Values values{.known = 0,
                  .low_m = std::numeric_limits<double>::infinity(),
                  .high_m = -std::numeric_limits<double>::infinity(),
                  .all_whole = true};
    for (std::size_t i = 0; i < field.size(); ++i) {
        const double height_m = field.heights_m[i];
        if (std::isnan(height_m)) {
            continue;
        }
        ++values.known;
        values.low_m = std::min(values.low_m, height_m);
        values.high_m = std::max(values.high_m, height_m);
        values.all_whole = values.all_whole && height_m == std::floor(height_m);
    }
    values.all_whole = values.all_whole && values.known > 0;
    return values;
}

double step_of_heights_m(const HeightField& field) {
    constexpr std::size_t most = 5000;
    std::unordered_set<double> different;
    for (std::size_t i = 0; i < field.size(); ++i) {
        if (!std::isnan(field.heights_m[i])) {
            different.insert(field.heights_m[i]);
            if (different.size() > most) {
                return 0.0;
            }
        }
    }
    std::vector<double> sorted(different.begin(), different.end());
    std::sort(sorted.begin(), sorted.end());
    double step_m = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < sorted.size(); ++i) {
        step_m = std::min(step_m, sorted[i] - sorted[i - 1]);
    }
    if (!(step_m >= 0.499) || !std::isfinite(step_m)) {
        return 0.0;
    }
    for (std::size_t i = 1; i < sorted.size(); ++i) {
        const double steps = (sorted[i] - sorted.front()) / step_m;
        if (std::abs(steps - std::round(steps)) > 1e-2) {
            return 0.0;
        }
    }
    return std::round(1000.0 * step_m) / 1000.0;
}

}  // namespace coupling::plausible::terrain
