#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace rockfall {

/// Bins of nearly equal relative width: 2^fineness to each doubling, read off the bits of a float.
///
/// With fineness 4 a bin is 3.1 to 6.3 % wide, so its middle is at most 3.2 % from any value in it; each step
/// of fineness halves that. The first bin takes everything below `low` (zero included), the last everything
/// above `high`. Integer counts in such bins add up in any order.
class LogBins {
public:
    /// Requires 0 < low < high and a fineness of 0 to 23.
    constexpr LogBins(float low, float high, int fineness)
        : shift_{23 - fineness},  // a float has 23 bits of mantissa
          first_{key_of(low)},
          count_{static_cast<std::size_t>(key_of(high) - first_) + 2} {}

    [[nodiscard]] constexpr std::size_t count() const { return count_; }

    /// Requires a finite value that is not negative.
    [[nodiscard]] constexpr std::size_t bin_of(float value) const {
        const std::uint32_t key = key_of(value);
        return key < first_ ? 0 : std::min<std::size_t>(key - first_ + 1, count_ - 1);
    }
    /// Lower limit of a bin; 0 for the first.
    [[nodiscard]] constexpr double low_of(std::size_t bin) const {
        return bin == 0 ? 0.0
                        : static_cast<double>(
                              std::bit_cast<float>((first_ + static_cast<std::uint32_t>(bin) - 1) << shift_));
    }
    /// Upper limit of a bin; of the last one too, although it takes more.
    [[nodiscard]] constexpr double high_of(std::size_t bin) const { return low_of(bin + 1); }

private:
    [[nodiscard]] constexpr std::uint32_t key_of(float value) const {
        return std::bit_cast<std::uint32_t>(value) >> shift_;
    }

    int shift_;
    std::uint32_t first_;
    std::size_t count_;
};

/// Kinetic energy in joules, 62 J to 1 GJ.
inline constexpr LogBins energy_bins{62.5F, 1.0e9F, 4};
/// Speed in m/s.
inline constexpr LogBins speed_bins{0.25F, 128.0F, 4};
/// Height above ground in metres.
inline constexpr LogBins height_bins{0.0625F, 128.0F, 4};

/// The same quantities at targets, where few numbers decide: bins at most 0.8 % wide.
inline constexpr LogBins fine_energy_bins{62.5F, 1.0e9F, 7};
inline constexpr LogBins fine_speed_bins{0.25F, 128.0F, 7};
inline constexpr LogBins fine_height_bins{0.0625F, 128.0F, 7};

/// Value below which a share of the counts lies, straight inside its bin; 0 without counts.
template <class Counts>
double quantile(const LogBins& bins, const Counts& counts, double share) {
    std::uint64_t total = 0;
    for (std::size_t bin = 0; bin < bins.count(); ++bin) {
        total += counts[bin];
    }
    const double wanted = share * static_cast<double>(total);
    double below = 0.0;
    for (std::size_t bin = 0; bin < bins.count(); ++bin) {
        const auto here = static_cast<double>(counts[bin]);
        if (here > 0.0 && below + here >= wanted) {
            return bins.low_of(bin) + (wanted - below) / here * (bins.high_of(bin) - bins.low_of(bin));
        }
        below += here;
    }
    return 0.0;
}

}  // namespace rockfall
