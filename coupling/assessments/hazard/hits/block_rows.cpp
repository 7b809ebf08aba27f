#include "coupling/assessments/hazard/hits/block_rows.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <stdexcept>

namespace coupling::hazard::hits {

using rockfall::ReleaseSource;
using rockfall::StartLaw;

BlockRows::BlockRows(const std::vector<ReleaseSource>& sources, const StartLaw& common) : sources_{sources} {
    std::map<const StartLaw*, std::size_t> known;
    for (const ReleaseSource& source : sources_) {
        const StartLaw& law = source.own_start != nullptr ? *source.own_start : common;
        const auto [entry, is_new] = known.emplace(source.own_start.get(), rows_.size());
        if (is_new) {
            rows_.push_back({0, law.diameter.mean_m()});
        }
        rows_[entry->second].rocks += source.rocks;
        row_of_source_.push_back(entry->second);
    }
}

std::size_t BlockRows::row_of(std::uint64_t rock) const {
    const auto after =
        std::upper_bound(sources_.begin(), sources_.end(), rock,
                         [](std::uint64_t r, const ReleaseSource& s) { return r < s.first_rock; });
    if (after == sources_.begin() || rock >= (after - 1)->first_rock + (after - 1)->rocks) {
        throw std::out_of_range{"a rock that no source released"};
    }
    return row_of_source_[static_cast<std::size_t>(after - 1 - sources_.begin())];
}

double BlockRows::fewest_rocks() const {
    std::uint64_t fewest = std::numeric_limits<std::uint64_t>::max();
    for (const BlockRow& row : rows_) {
        fewest = row.rocks > 0 ? std::min(fewest, row.rocks) : fewest;
    }
    return static_cast<double>(fewest);
}

}  // namespace coupling::hazard::hits
