#include "coupling/assessments/compare/runs/means_over_years.hpp"

#include <algorithm>
#include <cmath>

#include "config/text/numbers.hpp"
#include "coupling/results/figures/few_rocks.hpp"

namespace coupling::compare {
namespace {

bool is_protection(const FigureKey& key) {
    return key.quantity.starts_with("protection");
}

}  // namespace

void MeansOverYears::add(const FigureKey& key, const std::string& replicate, double value,
                         const std::string& why_none) {
    auto found = std::find_if(sums_.begin(), sums_.end(), [&](const auto& sum) { return sum.first == key; });
    if (found == sums_.end()) {
        found = sums_.insert(sums_.end(), {key, {}});
    }
    if (std::isnan(value)) {
        why_none_.try_emplace(found - sums_.begin(), why_none);
        return;
    }
    auto& [sum, count] = found->second[config::parse_whole(replicate).value_or(0)];
    sum += value;
    ++count;
}

void MeansOverYears::mark_as_part(const FigureKey& key) {
    if (std::find(parts_.begin(), parts_.end(), key) == parts_.end()) {
        parts_.push_back(key);
    }
}

void MeansOverYears::finish() {
    for (std::size_t i = 0; i < sums_.size(); ++i) {
        auto& [key, replicates] = sums_[i];
        std::map<long long, double> means;
        for (const auto& [replicate, sum] : replicates) {
            means[replicate] = sum.first / static_cast<double>(sum.second);
        }
        figures_.push_back(over_replicates(key, std::move(means)));
        figures_.back().is_part = std::find(parts_.begin(), parts_.end(), key) != parts_.end();
        if (std::isnan(figures_.back().value)) {
            figures_.back().why_none = why_none_[static_cast<std::ptrdiff_t>(i)];
        } else if (is_protection(figures_.back().key) &&
                   says_nothing(figures_.back().low, figures_.back().high)) {
            figures_.back() = {
                .key = figures_.back().key,
                .why_none = "too few rocks arrive over the bare slope for a protection figure"};
        }
    }
    sums_.clear();
    why_none_.clear();
    parts_.clear();
}

}  // namespace coupling::compare
