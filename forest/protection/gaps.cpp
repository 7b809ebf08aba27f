#include "forest/protection/gaps.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>

#include "config/math/elementary.hpp"

namespace forest {

namespace {

/// Neighbours clockwise from north; rows count from the north.
constexpr std::array<config::Cell, 8> around{
    {{0, -1}, {1, -1}, {1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}}};

std::optional<PatchId> neighbour(const PatchGrid& grid, const Patch& patch, std::size_t direction) {
    return grid.at(
        config::Cell{patch.cell.column + around[direction].column, patch.cell.row + around[direction].row});
}

bool faces_out(const PatchGrid& grid, const Patch& patch) {
    if (patch.slope.in_radians() <= 0.0) {
        return false;
    }
    const double eighth = patch.aspect.in_radians() / (0.25 * std::numbers::pi);
    return !neighbour(grid, patch, static_cast<std::size_t>(std::lround(eighth + 8.0)) % 8);
}

double ground_m(const PatchGrid& grid, PatchId from, PatchId to) {
    const double x_m = grid.x_centre_m(from) - grid.x_centre_m(to);
    const double y_m = grid.y_centre_m(from) - grid.y_centre_m(to);
    const double z_m = grid[from].ground_m - grid[to].ground_m;
    return std::sqrt(x_m * x_m + y_m * y_m + z_m * z_m);
}

/// Where a rock goes from a patch; nothing in a hollow, on level ground and at the lower edge.
std::optional<PatchId> next_below(const PatchGrid& grid, PatchId from) {
    const Patch& patch = grid[from];
    std::optional<PatchId> steepest;
    double most = 0.0;
    for (std::size_t direction = 0; direction < around.size(); ++direction) {
        const auto other = neighbour(grid, patch, direction);
        if (!other) {
            continue;
        }
        const double plan_m = direction % 2 == 0 ? patch_side_m : std::numbers::sqrt2 * patch_side_m;
        const double drop = (patch.ground_m - grid[*other].ground_m) / plan_m;
        if (drop > most) {
            most = drop;
            steepest = other;
        }
    }
    return faces_out(grid, patch) ? std::nullopt : steepest;
}

/// Length of a step out of a patch; of the last one straight down its own slope.
double step_m(const PatchGrid& grid, PatchId from, const std::optional<PatchId>& to) {
    return to ? ground_m(grid, from, *to)
              : patch_side_m / config::sin_cos_of(grid[from].slope.in_radians()).cos;
}

double sorted_quantile(const std::vector<double>& sorted, double share) {
    const double at = share * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(at);
    return std::lerp(sorted[below], sorted[std::min(below + 1, sorted.size() - 1)],
                     at - static_cast<double>(below));
}

}  // namespace

std::vector<char> open_patches(const PatchGrid& grid, std::span<const Tree> trees) {
    std::vector<char> open(grid.size(), 1);
    for (const Tree& tree : trees) {
        if (tree.dbh_cm >= closing_dbh_cm) {
            open[index_of(tree.patch)] = 0;
        }
    }
    return open;
}

std::vector<Gap> gaps_along_fall_line(const PatchGrid& grid, std::span<const char> open) {
    assert(open.size() == grid.size());
    std::vector<std::optional<PatchId>> next(grid.size());
    std::vector<char> led_into(grid.size(), 0);
    for (std::uint32_t p = 0; p < grid.size(); ++p) {
        next[p] = next_below(grid, PatchId{p});
        if (open[p] != 0 && next[p]) {
            led_into[index_of(*next[p])] = 1;
        }
    }
    std::vector<Gap> gaps;
    for (std::uint32_t p = 0; p < grid.size(); ++p) {
        if (open[p] == 0 || led_into[p] != 0) {
            continue;
        }
        Gap gap{{}, 0.5 * step_m(grid, PatchId{p}, next[p])};
        std::optional<PatchId> here = PatchId{p};
        while (here && open[index_of(*here)] != 0) {
            gap.patches.push_back(*here);
            const std::optional<PatchId> below = next[index_of(*here)];
            const bool goes_on = below && open[index_of(*below)] != 0;
            gap.length_m += (goes_on ? 1.0 : 0.5) * step_m(grid, *here, below);
            here = below;
        }
        gaps.push_back(std::move(gap));
    }
    return gaps;
}

GapFigures figures_of(const PatchGrid& grid, std::span<const char> open, std::span<const Gap> gaps,
                      const std::function<bool(const Patch&)>& counts) {
    GapFigures figures;
    for (std::uint32_t p = 0; p < grid.size(); ++p) {
        if (counts(grid[PatchId{p}])) {
            ++figures.patches;
            figures.open_patches += open[p] != 0 ? 1 : 0;
        }
    }
    std::vector<double> lengths_m;
    for (const Gap& gap : gaps) {
        if (std::any_of(gap.patches.begin(), gap.patches.end(),
                        [&](PatchId patch) { return counts(grid[patch]); })) {
            lengths_m.push_back(gap.length_m);
        }
    }
    if (!lengths_m.empty()) {
        std::sort(lengths_m.begin(), lengths_m.end());
        figures.gaps = static_cast<std::uint32_t>(lengths_m.size());
        figures.mean_m =
            std::accumulate(lengths_m.begin(), lengths_m.end(), 0.0) / static_cast<double>(lengths_m.size());
        figures.p95_m = sorted_quantile(lengths_m, 0.95);
        figures.max_m = lengths_m.back();
    }
    return figures;
}

}  // namespace forest
