#include "coupling/inputs/plausible/terrain/crowns.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/plausible/terrain/limits.hpp"

namespace coupling::plausible::terrain {
namespace {

using config::joined;

double height_at(const config::Raster<double>& heights, double x_m, double y_m) {
    const config::Cell cell = heights.frame.cell_at(x_m, y_m);
    return heights.frame.contains(cell) ? heights.at(cell) : std::nan("");
}

/// NaN where a height around is not known.
double bump_m(const config::Raster<double>& heights, const ListedTree& tree) {
    const double largest_cell_m = std::max(heights.frame.cell_width_m, heights.frame.cell_height_m);
    const double radius_m = std::max(limits::around_m, 2.0 * largest_cell_m);
    double sum_m = 0.0;
    for (int k = 0; k < 8; ++k) {
        const double angle = k * M_PI / 4.0;
        sum_m +=
            height_at(heights, tree.x_m + radius_m * std::cos(angle), tree.y_m + radius_m * std::sin(angle));
    }
    return height_at(heights, tree.x_m, tree.y_m) - sum_m / 8.0;
}

double median_of_trees(std::vector<double>& values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

}  // namespace

Bumps bumps_at(const config::Raster<double>& heights, std::span<const ListedTree> trees) {
    std::vector<double> bumps_m;
    std::vector<double> shares;
    for (const ListedTree& tree : trees) {
        if (tree.height_m < limits::least_tree_m) {
            continue;
        }
        const double bump = bump_m(heights, tree);
        if (!std::isnan(bump)) {
            bumps_m.push_back(bump);
            shares.push_back(bump / tree.height_m);
        }
    }
    if (bumps_m.size() < limits::fewest_trees) {
        return {};
    }
    return {bumps_m.size(), median_of_trees(bumps_m), median_of_trees(shares)};
}

std::optional<Finding> judge_crowns(const config::Raster<double>& heights,
                                    std::span<const ListedTree> trees) {
    const Bumps bumps = bumps_at(heights, trees);
    if (bumps.median_share < limits::bump_warning || bumps.median_m < limits::bump_warning_m) {
        return std::nullopt;
    }
    return Finding{
        bumps.median_share >= limits::bump_error && bumps.median_m >= limits::bump_error_m,
        joined("heights that stand up by ", config::to_text(std::round(10.0 * bumps.median_m) / 10.0),
               " m at half of ", std::to_string(bumps.trees), " listed trees"),
        "the bare ground under the trees",
        "this looks like a surface model with crowns and roofs: take the terrain model, which is the "
        "bare ground"};
}

}  // namespace coupling::plausible::terrain
