#include "forest/treatment/groups.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

#include "forest/stand/allometry.hpp"

namespace forest {

namespace {

/// A hole that could be cut.
struct Hole {
    PatchId middle{};
    double wood_m3 = 0.0;
};

std::vector<double> wood_by_patch(const Stand& stand, const SpeciesTable& species,
                                  std::span<const std::size_t> candidates) {
    std::vector<double> wood_m3(stand.grid().size(), 0.0);
    for (const std::size_t place : candidates) {
        const Tree& tree = stand.trees()[place];
        wood_m3[index_of(tree.patch)] +=
            tree.stems * stem_volume_m3(species[tree.species].allometry, tree.dbh_cm, tree.height_m);
    }
    return wood_m3;
}

}  // namespace

std::vector<config::Shape> ripest_groups(const Stand& stand, const SpeciesTable& species,
                                         std::span<const std::size_t> candidates, const TreatmentArea& area,
                                         const Groups& groups) {
    assert(groups.side_m > 0.0);
    const PatchGrid& grid = stand.grid();
    const std::vector<double> wood_m3 = wood_by_patch(stand, species, candidates);
    const std::vector<PatchId> patches = patches_in(grid, area);
    std::vector<char> inside(grid.size(), 0);
    for (const PatchId patch : patches) {
        inside[index_of(patch)] = 1;
    }
    // Patches whose middles lie in a hole around another's middle.
    const int reach = static_cast<int>(std::floor(0.5 * groups.side_m / patch_side_m));
    std::vector<Hole> holes;
    for (const PatchId middle : patches) {
        Hole hole{middle, 0.0};
        bool whole = true;
        for (int row = -reach; row <= reach; ++row) {
            for (int column = -reach; column <= reach; ++column) {
                const config::Cell cell = grid[middle].cell;
                const std::optional<PatchId> patch =
                    grid.at(config::Cell{cell.column + column, cell.row + row});
                whole = whole && patch && inside[index_of(*patch)] != 0;
                hole.wood_m3 += patch ? wood_m3[index_of(*patch)] : 0.0;
            }
        }
        if (whole && hole.wood_m3 > 0.0) {
            holes.push_back(hole);
        }
    }
    std::stable_sort(holes.begin(), holes.end(),
                     [](const Hole& a, const Hole& b) { return a.wood_m3 > b.wood_m3; });

    const double hole_m2 = groups.side_m * groups.side_m;
    double room_m2 = groups.area_share * static_cast<double>(patches.size()) * patch_area_m2;
    std::vector<config::Point2> middles;
    std::vector<config::Shape> shapes;
    for (const Hole& hole : holes) {
        if (room_m2 < hole_m2) {
            break;
        }
        const config::Point2 middle{grid.x_centre_m(hole.middle), grid.y_centre_m(hole.middle)};
        const bool free = std::none_of(middles.begin(), middles.end(), [&](config::Point2 other) {
            return std::max(std::abs(middle.x_m - other.x_m), std::abs(middle.y_m - other.y_m)) <
                   2.0 * groups.side_m;
        });
        if (free) {
            room_m2 -= hole_m2;
            middles.push_back(middle);
            shapes.push_back(rectangle(middle, groups.side_m, groups.side_m, {}));
        }
    }
    return shapes;
}

}  // namespace forest
