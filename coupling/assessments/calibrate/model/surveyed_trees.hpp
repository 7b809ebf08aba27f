#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "coupling/inputs/site.hpp"

namespace coupling::calibrate {

/// Stems that were searched for wounds, as stems of the model: each row is the nearest one within a metre.
class SurveyedTrees {
public:
    struct Tree {
        Eigen::Vector2d stem_m;  ///< of the model, in coordinates of the terrain
        double dbh_cm = 0.0;     ///< of the model
        std::uint64_t scars = 0;
    };

    /// Stems thinner than `least_dbh_cm` are left out.
    SurveyedTrees(const Site& site, double least_dbh_cm);

    [[nodiscard]] std::span<const Tree> trees() const { return trees_; }
    /// Those whose mark is `wanted`. `marks`: of each of `trees()`.
    [[nodiscard]] SurveyedTrees with_mark(const std::vector<bool>& marks, bool wanted) const;
    /// Wounds of all of them.
    [[nodiscard]] std::uint64_t scars() const;
    /// The tree whose stem stands at just this place.
    [[nodiscard]] std::optional<std::size_t> find(const Eigen::Vector2d& stem_m) const;

    /// Lines of rows that were left out: no stem stands there.
    [[nodiscard]] std::span<const std::size_t> without_stem() const { return without_stem_; }
    /// Lines of rows that were left out: the stem is that of an earlier row.
    [[nodiscard]] std::span<const std::size_t> repeated() const { return repeated_; }
    /// Lines of rows whose diameter is not within a third of that of the stem.
    [[nodiscard]] std::span<const std::size_t> of_other_size() const { return of_other_size_; }

private:
    std::vector<Tree> trees_;  ///< by place
    std::vector<std::size_t> without_stem_;
    std::vector<std::size_t> repeated_;
    std::vector<std::size_t> of_other_size_;
};

}  // namespace coupling::calibrate
