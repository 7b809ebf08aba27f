#pragma once

#include <vector>

namespace coupling::decades {

/// A figure over replicates: their mean and where nine in ten of them lie.
struct Band {
    double mean = 0.0;
    double low = 0.0;   ///< 5th percentile, straight between order statistics; the value itself of one
    double high = 0.0;  ///< 95th
};

/// Requires at least one value.
Band band_of(std::vector<double> values);

}  // namespace coupling::decades
