#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace rockfall {

/// Counts in bins of which most are empty: takes memory for those that hold something, and for all of them
/// once that is less. Single counts wait in a short list, so that adding one costs the same however many bins
/// are filled.
class BinCounts {
public:
    struct Filled {
        std::uint64_t bin;
        std::uint64_t count;
        friend bool operator==(const Filled&, const Filled&) = default;
    };

    explicit BinCounts(std::size_t bins) : bins_{bins} {}

    [[nodiscard]] std::size_t bins() const { return bins_; }
    /// Requires bin < bins().
    void add(std::size_t bin, std::uint64_t count = 1);
    /// Requires as many bins.
    void add(const BinCounts& other);

    /// Those that hold something, in rising order.
    [[nodiscard]] std::vector<Filled> filled() const;
    /// All of them.
    [[nodiscard]] std::vector<std::uint64_t> all() const;
    [[nodiscard]] std::size_t bytes() const {
        return few_.capacity() * sizeof(Few) + dense_.capacity() * sizeof(std::uint64_t) +
               waiting_.capacity() * sizeof(std::uint32_t);
    }
    friend bool operator==(const BinCounts& a, const BinCounts& b) {
        return a.bins_ == b.bins_ && a.filled() == b.filled();
    }

private:
    /// Half the size of `Filled`.
    struct Few {
        std::uint32_t bin;
        std::uint32_t count;
    };
    void make_dense();
    /// Adds counts of bins in rising order.
    void take(std::span<const Filled> more);
    /// Those that wait, as counts in rising order.
    [[nodiscard]] std::vector<Filled> sorted_waiting() const;

    std::size_t bins_;
    std::vector<std::uint32_t> waiting_;  ///< bins of single counts that `few_` does not have yet
    std::vector<Few> few_;                ///< while few bins are filled, in rising order
    std::vector<std::uint64_t> dense_;    ///< then
};

}  // namespace rockfall
