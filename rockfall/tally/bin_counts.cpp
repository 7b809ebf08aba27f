#include "rockfall/tally/bin_counts.hpp"

#include <algorithm>
#include <cassert>
#include <limits>

namespace rockfall {
namespace {

/// Two lists in rising order of their bins as one.
std::vector<BinCounts::Filled> merged(std::span<const BinCounts::Filled> a,
                                      std::span<const BinCounts::Filled> b) {
    std::vector<BinCounts::Filled> all;
    all.reserve(a.size() + b.size());
    std::size_t i = 0;
    std::size_t k = 0;
    while (i < a.size() || k < b.size()) {
        const bool of_a = i < a.size() && (k == b.size() || a[i].bin <= b[k].bin);
        const bool of_b = k < b.size() && (i == a.size() || b[k].bin <= a[i].bin);
        all.push_back({of_a ? a[i].bin : b[k].bin, (of_a ? a[i].count : 0) + (of_b ? b[k].count : 0)});
        i += of_a ? 1 : 0;
        k += of_b ? 1 : 0;
    }
    return all;
}

}  // namespace

void BinCounts::add(std::size_t bin, std::uint64_t count) {
    constexpr std::size_t most_waiting = 32;
    assert(bin < bins_);
    if (!dense_.empty()) {
        dense_[bin] += count;
        return;
    }
    if (count != 1) {
        const Filled one{bin, count};
        take({&one, 1});
        return;
    }
    waiting_.push_back(static_cast<std::uint32_t>(bin));
    if (waiting_.size() >= most_waiting) {
        const std::vector<Filled> more = sorted_waiting();
        waiting_.clear();
        take(more);
    }
}

void BinCounts::add(const BinCounts& other) {
    assert(bins_ == other.bins_);
    take(other.filled());
}

std::vector<BinCounts::Filled> BinCounts::sorted_waiting() const {
    std::vector<std::uint32_t> sorted = waiting_;
    std::sort(sorted.begin(), sorted.end());
    std::vector<Filled> counts;
    for (const std::uint32_t bin : sorted) {
        if (counts.empty() || counts.back().bin != bin) {
            counts.push_back({bin, 0});
        }
        ++counts.back().count;
    }
    return counts;
}

void BinCounts::take(std::span<const Filled> more) {
    constexpr std::uint64_t most = std::numeric_limits<std::uint32_t>::max();
    if (dense_.empty()) {
        std::vector<Filled> held;
        held.reserve(few_.size());
        for (const Few& f : few_) {
            held.push_back({f.bin, f.count});
        }
        const std::vector<Filled> together = merged(held, more);
        const bool fits =
            std::all_of(together.begin(), together.end(), [](const Filled& f) { return f.count <= most; });
        if (fits && together.size() <= bins_ / 2) {
            std::vector<Few> few;
            few.reserve(together.size());
            for (const Filled& f : together) {
                few.push_back({static_cast<std::uint32_t>(f.bin), static_cast<std::uint32_t>(f.count)});
            }
            few_ = std::move(few);
            return;
        }
        make_dense();
    }
    for (const Filled& f : more) {
        dense_[static_cast<std::size_t>(f.bin)] += f.count;
    }
}

void BinCounts::make_dense() {
    dense_ = all();
    std::vector<Few>{}.swap(few_);  // an assignment would keep the memory
    std::vector<std::uint32_t>{}.swap(waiting_);
}

std::vector<BinCounts::Filled> BinCounts::filled() const {
    std::vector<Filled> found;
    found.reserve(few_.size());
    for (const Few& f : few_) {
        found.push_back({f.bin, f.count});
    }
    if (!waiting_.empty()) {
        found = merged(found, sorted_waiting());
    }
    for (std::size_t bin = 0; bin < dense_.size(); ++bin) {
        if (dense_[bin] > 0) {
            found.push_back({bin, dense_[bin]});
        }
    }
    return found;
}

std::vector<std::uint64_t> BinCounts::all() const {
    if (!dense_.empty()) {
        return dense_;
    }
    std::vector<std::uint64_t> counts(bins_, 0);
    for (const Few& f : few_) {
        counts[f.bin] = f.count;
    }
    for (const std::uint32_t bin : waiting_) {
        ++counts[bin];
    }
    return counts;
}

}  // namespace rockfall
