#include "rockfall/tally/bin_counts.hpp"

#include <algorithm>
#include <cassert>
#include <limits>

namespace rockfall {

void BinCounts::add(std::size_t bin, std::uint64_t count) {
    assert(bin < bins_);
    if (!dense_.empty()) {
        dense_[bin] += count;
        return;
    }
    constexpr std::uint64_t most = std::numeric_limits<std::uint32_t>::max();
    const auto place = std::lower_bound(few_.begin(), few_.end(), bin,
                                        [](const Few& f, std::size_t wanted) { return f.bin < wanted; });
    const bool is_there = place != few_.end() && place->bin == bin;
    // A list that grows doubles its memory, so of half the bins it may take as much as all of them in a row.
    if (count + (is_there ? place->count : 0U) > most || (!is_there && few_.size() + 1 > bins_ / 2)) {
        make_dense();
        dense_[bin] += count;
    } else if (is_there) {
        place->count += static_cast<std::uint32_t>(count);
    } else {
        few_.insert(place, {static_cast<std::uint32_t>(bin), static_cast<std::uint32_t>(count)});
    }
}

void BinCounts::make_dense() {
    dense_ = all();
    std::vector<Few>{}.swap(few_);  // an assignment would keep the memory
}

void BinCounts::add(const BinCounts& other) {
    assert(bins_ == other.bins_);
    for (const Filled& f : other.filled()) {
        add(static_cast<std::size_t>(f.bin), f.count);
    }
}

std::vector<BinCounts::Filled> BinCounts::filled() const {
    std::vector<Filled> found;
    found.reserve(few_.size());
    for (const Few& f : few_) {
        found.push_back({f.bin, f.count});
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
    return counts;
}

}  // namespace rockfall
