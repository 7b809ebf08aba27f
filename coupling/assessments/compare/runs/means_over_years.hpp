#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "coupling/assessments/compare/runs/figure.hpp"

namespace coupling::compare {

/// Means over the years of each replicate in which a figure is known, then over the replicates; in the order
/// in which regimes come.
class MeansOverYears {
public:
    explicit MeansOverYears(std::vector<Figure>& figures) : figures_{figures} {}

    /// `value`: NaN if it is not known in a year; `why_none`: said of a figure that no year knows.
    void add(const FigureKey& key, const std::string& replicate, double value,
             const std::string& why_none = "");

    /// The figures of a key are parts of a whole (`Figure::is_part`).
    void mark_as_part(const FigureKey& key);

    /// Appends the figures and forgets their sums.
    void finish();

private:
    std::vector<Figure>& figures_;
    std::vector<std::pair<FigureKey, std::map<long long, std::pair<double, std::size_t>>>> sums_;
    std::map<std::ptrdiff_t, std::string> why_none_;  ///< by place in sums_
    std::vector<FigureKey> parts_;
};

}  // namespace coupling::compare
