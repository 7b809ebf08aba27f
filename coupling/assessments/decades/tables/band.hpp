#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace coupling::decades {

/// What a figure can be: intervals leave out what it cannot.
struct Bounds {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
};
inline constexpr Bounds not_negative{0.0, std::numeric_limits<double>::infinity()};

/// Share of intervals of a mean that hold what infinitely many replicates would give.
inline constexpr double interval_share = 0.90;

/// From so many replicates on their 5th and 95th percentile are shown; of fewer they are close to the
/// extremes and no estimate of what nine in ten would do [choice].
inline constexpr std::size_t least_for_percentiles = 10;

/// From so many replicates on their skewness is estimated [choice].
inline constexpr std::size_t least_for_skewness = 5;

/// A figure over replicates. NaN is unknown.
///
/// Student's interval alone holds the mean of skewed figures too seldom: of one that is 0 in two thirds of
/// the replicates in 77 to 81 % of runs of 5 to 20, as stops by few logs are. From five replicates on the
/// ends are those that Hall's transformation (1992) gives; of symmetric figures they are Student's.
struct Band {
    double mean = 0.0;
    double low = 0.0;   ///< of the 90 % interval of the mean, unknown for one replicate and
                        ///< where all agree: equal values say nothing about chance
    double high = 0.0;  ///< of the same
    double p05 = 0.0;   ///< 5th percentile of ten and more replicates, linearly interpolated
    double p95 = 0.0;
    double least = 0.0;  ///< of the replicates
    double most = 0.0;
    [[nodiscard]] bool has_interval() const { return low <= high; }
};

/// Of nothing.
inline constexpr double no_figure = std::numeric_limits<double>::quiet_NaN();
inline constexpr Band unknown_band{no_figure, no_figure, no_figure, no_figure,
                                   no_figure, no_figure, no_figure};

/// Requires at least one value.
Band band_of(std::vector<double> values, const Bounds& bounds = {});

/// The law of the mean over replicates that the interval of a Band comes from.
class MeanLaw {
public:
    /// Requires a value.
    explicit MeanLaw(std::span<const double> values);
    [[nodiscard]] double mean() const { return mean_; }
    /// False of one value and of equal ones: they say nothing about chance.
    [[nodiscard]] bool has_width() const { return deviation_ > 0.0; }
    /// The value that the mean is below with this probability, in (0, 1).
    [[nodiscard]] double at(double probability) const;
    /// The same from the quantile of Student's t, of as many degrees of freedom as there are values less one.
    [[nodiscard]] double at_students(double t) const;

private:
    double n_ = 0.0;
    double mean_ = 0.0;
    double deviation_ = 0.0;  ///< of the values; 0: none
    double skewness_ = 0.0;   ///< 0 of fewer than least_for_skewness
};

/// The replicates with which a mean paired difference of this size and this standard deviation of the pairs
/// would be known to differ from 0 (95 %, Student's t). Nothing for a difference of 0 and for more than
/// 100 000.
std::optional<std::size_t> replicates_needed(double mean, double deviation);

}  // namespace coupling::decades
