#include "coupling/results/report/map/map_colours.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace coupling::report {

config::Raster<float> without_zeros(config::Raster<float> raster) {
    std::replace(raster.values.begin(), raster.values.end(), 0.0F, std::numeric_limits<float>::quiet_NaN());
    return raster;
}

double bulk_of(const config::Raster<float>& raster) {
    std::vector<float> sizes;
    for (const float value : raster.values) {
        if (!std::isnan(value) && value != 0.0F) {
            sizes.push_back(std::abs(value));
        }
    }
    if (sizes.empty()) {
        return 0.0;
    }
    const auto place =
        sizes.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(sizes.size() - 1));
    std::nth_element(sizes.begin(), place, sizes.end());
    return static_cast<double>(*place);
}

ColourScale scale_for(const RasterKind& kind, ValueRange range) {
    const auto high = static_cast<double>(range.high);
    switch (kind.style) {
        case RasterStyle::energy_classes:
            return ColourScale::energy_classes();
        case RasterStyle::logarithmic:
            return ColourScale::logarithmic(kind.palette, 1.0, high, std::string{kind.unit});
        case RasterStyle::linear:
            break;
    }
    if (kind.stem != "Reach_probability") {
        return ColourScale::linear(kind.palette, high, std::string{kind.unit});
    }
    // The fewest rocks that can show: one of those from a single source.
    const double low = std::clamp(
        std::pow(10.0, std::floor(std::log10(std::max(1e-3, static_cast<double>(range.low))))), 0.01, 10.0);
    return ColourScale::logarithmic(kind.palette, low, high, std::string{kind.unit});
}

}  // namespace coupling::report
