#pragma once

#include <cstdint>

#include "config/random/stream.hpp"
#include "forest/climate/series.hpp"

namespace forest {

/// Years of a series, first and last included.
struct YearWindow {
    int first = 0;
    int last = 0;

    [[nodiscard]] int size() const { return last - first + 1; }
};

/// Throws config::InputError (settings) naming the window and the years of the series if it does not lie
/// inside.
void check(const YearWindow& window, const ClimateSeries& series);

/// Which year of a series stands for a simulated year.
///
/// Whole years only, so that months keep their weather together. All places and all scenarios of a comparison
/// get the same years if they get the same window and key.
class YearSequence {
public:
    /// The series' own years, then from its window's first year over and over.
    static YearSequence repeating(const ClimateSeries& series, YearWindow window);
    /// Drawn from the window with equal probability, year by year.
    static YearSequence drawn(YearWindow window, std::uint64_t seed, std::uint32_t replicate);

    /// Requires a year in [0, 65535].
    [[nodiscard]] int source_of(int simulated_year) const;

private:
    enum class Kind { repeating, drawn };
    YearSequence(Kind kind, YearWindow window, YearWindow own, config::StreamKey key)
        : kind_{kind}, window_{window}, own_{own}, key_{key} {}

    Kind kind_;
    YearWindow window_;
    YearWindow own_;  ///< years that stand for themselves
    config::StreamKey key_;
};

}  // namespace forest
