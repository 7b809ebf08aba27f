#include "coupling/assessments/collapse/collapse_site.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "config/text/joined.hpp"
#include "coupling/assessments/collapse/source_body.hpp"
#include "coupling/inputs/forest/tree_input.hpp"
#include "coupling/inputs/picture/ground_picture.hpp"
#include "coupling/inputs/places/target_input.hpp"
#include "coupling/inputs/reading/declared_tables.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/inputs/terrain/terrain_input.hpp"
#include "rockfall/obstacles/tree_energy.hpp"
#include "rockfall/rock_mass/interfaces.hpp"
#include "rockfall/rock_mass/voronoi_cells.hpp"

namespace coupling::collapse {
namespace {

using config::joined;
using Eigen::Vector3d;
using namespace rockfall::rock_mass;

/// Blocks of which a run takes too long for one machine.
constexpr std::size_t most_blocks = 200'000;
/// Pieces that the box around the body may be cut into, of which many lie outside of it: 2 GB or so.
constexpr double most_pieces = 1e6;

/// Refuses joints or cells so narrow that their pieces would fill the memory before they can be counted.
void check_pieces(const CollapseScenario& scenario, const std::vector<JointSet>& sets, const Vector3d& low_m,
                  const Vector3d& high_m) {
    const CollapseSettings& s = scenario.settings;
    const double volume_m3 = (high_m - low_m).prod();
    const bool is_voronoi = s.blocks == BlockKind::voronoi;
    const double pieces = is_voronoi ? volume_m3 / (s.block_size_m * s.block_size_m * s.block_size_m)
                                     : expected_pieces(volume_m3, sets, s.least_block_m);
    if (pieces > most_pieces) {
        config::fail(
            config::ExitCode::data,
            scenario.scenario.options->place_of(is_voronoi ? "collapse.block_size_m" : "collapse.joint_sets"),
            joined("about ", std::to_string(std::llround(pieces)),
                   " blocks in the box around the rock mass (", std::to_string(std::llround(volume_m3)),
                   " m3)"),
            joined("at most ", std::to_string(std::llround(most_pieces))),
            is_voronoi ? "a larger collapse.block_size_m, or a smaller body"
                       : "larger spacings of the joint sets, a larger collapse.least_block_m, or a smaller "
                         "body");
    }
}

/// Cells over the box of the body and what lies around it.
std::vector<ConvexCell> cells_over(const CollapseScenario& scenario, const std::vector<JointSet>& sets,
                                   const Vector3d& low_m, const Vector3d& high_m) {
    const CollapseSettings& s = scenario.settings;
    if (s.blocks == BlockKind::voronoi) {
        return voronoi_cells(low_m, high_m, s.block_size_m, scenario.scenario.run.seed);
    }
    return cut_by_joints(box_cell(low_m, high_m, made_by_border), sets, s.least_block_m,
                         scenario.scenario.run.seed);
}

double volume_of(const std::vector<ConvexCell>& cells) {
    double sum = 0.0;
    for (const ConvexCell& cell : cells) {
        sum += volume_and_centre(cell).volume_m3;
    }
    return sum;
}

/// The terrain lowered to the lowest point of the blocks over each of its triangles: what carries them is the
/// fixed rock around them, and below that this.
rockfall::Terrain lowered(const rockfall::Terrain& terrain, const std::vector<ConvexCell>& blocks) {
    std::vector<rockfall::Vertex> vertices{terrain.vertices().begin(), terrain.vertices().end()};
    std::vector<rockfall::Triangle> triangles{terrain.triangles().begin(), terrain.triangles().end()};
    const Ground ground{terrain};
    for (const ConvexCell& block : blocks) {
        const Span1 x = extent_along(block, Vector3d::UnitX()), y = extent_along(block, Vector3d::UnitY());
        const double low_m = extent_along(block, Vector3d::UnitZ()).low;
        for (const std::uint32_t number : ground.prisms_in({x.low, y.low}, {x.high, y.high})) {
            for (const std::uint32_t corner : triangles[number].corners) {
                vertices[corner].z_m = std::min(vertices[corner].z_m, low_m);
            }
        }
    }
    for (rockfall::Triangle& triangle : triangles) {
        triangle.normal_z = 0.0F;  // computed again
    }
    return rockfall::Terrain{terrain.origin_m(), std::move(vertices), std::move(triangles)};
}

/// Rock that stays: pieces below the terrain that fill what was dug out around the body.
std::vector<ConvexCell> rock_around(std::vector<ConvexCell> outside, const rockfall::Terrain& before,
                                    const rockfall::Terrain& after, double least_m3) {
    std::vector<ConvexCell> fixed;
    for (ConvexCell& cell : outside) {
        const Vector3d centre = volume_and_centre(cell).centre_m;
        const auto triangle = before.locate(centre.x(), centre.y());
        const auto floor_m = after.height_m(centre.x(), centre.y());
        if (!triangle || !floor_m || extent_along(cell, Vector3d::UnitZ()).high < *floor_m) {
            continue;
        }
        const rockfall::Plane plane = before.plane_of(*triangle);
        const Vector3d normal = plane.normal();
        ConvexCell below = part_below(cell, {normal, normal.dot(plane.corner_m)}, made_by_border);
        if (!below.faces.empty() && volume_and_centre(below).volume_m3 > 0.05 * least_m3) {
            fixed.push_back(std::move(below));
        }
    }
    return fixed;
}

/// Bonds over the shared faces: those of a joint are open by its persistence, others are intact rock.
void join(const CollapseScenario& scenario, const std::vector<JointSet>& sets,
          const std::vector<ConvexCell>& cells, CollapseSite& site) {
    const CollapseSettings& s = scenario.settings;
    const BondStrength intact{1e6 * s.tensile_mpa * s.strength_factor, 1e6 * s.shear_mpa * s.strength_factor};
    std::uint64_t number = 0;
    for (Interface& face : shared_faces(cells)) {
        config::RandomStream draws{{scenario.scenario.run.seed, 1, 0, number++}, config::Purpose::block};
        const bool at_base = face.second >= site.count.free;
        if (face.first >= site.count.free) {
            continue;
        }
        const auto set = static_cast<std::size_t>(std::max(face.made_by, 0));
        const bool is_joint = face.made_by >= 0 && s.blocks == BlockKind::joints;
        const double open_share = at_base                        ? s.base_persistence
                                  : is_joint                     ? sets[set].persistence
                                  : face.made_by == made_by_cell ? s.persistence
                                                                 : 0.0;
        if (draws.uniform() < open_share) {
            ++site.count.open_faces;
            continue;
        }
        site.bonds.push_back({face.first, face.second, std::move(face.polygon_m), face.normal,
                              is_joint && !at_base ? sets[set].strength : intact});
    }
    site.count.bonds = site.bonds.size();
}

void add_blocks(const std::vector<ConvexCell>& cells, std::size_t free, double density_kgpm3,
                CollapseSite& site, Reading& reading) {
    std::size_t failed = 0;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        try {
            site.blocks.push_back(
                block_of(rockfall::solids::convex_hull(corners_of(cells[i])), density_kgpm3, i >= free));
        } catch (const rockfall::solids::NoSolid&) {
            ++failed;
        }
    }
    if (failed > 0) {
        reading.refuse({reading.settings().file.string()},
                       joined(std::to_string(failed), " blocks without thickness"), "blocks with a volume",
                       "a larger collapse.least_block_m merges them");
    }
}

void add_stems(const rockfall::Terrain& terrain, CollapseSite& site) {
    for (const TreeRecord& tree : site.trees) {
        const double x = tree.stem.x_m - terrain.origin_m().x(), y = tree.stem.y_m - terrain.origin_m().y();
        const auto ground_m = terrain.height_m(x, y);
        if (ground_m) {
            const double top_m = tree.stem.broken_at_m > 0.0 ? tree.stem.broken_at_m : tree.stem.height_m;
            site.stems.push_back({x, y, *ground_m, *ground_m + top_m, 0.005 * tree.stem.dbh_cm,
                                  rockfall::largest_energy_j(tree.stem.dbh_cm, tree.stem.fracture_energy) *
                                      tree.stem.strength});
        }
    }
}

double largest_radius_m(const CollapseSite& site) {
    double largest_m = 0.0;
    for (std::size_t i = 0; i < site.count.free; ++i) {
        largest_m = std::max(largest_m, site.blocks[i].solid.bounding_radius_m);
    }
    return largest_m;
}

/// Cuts the mass out of the terrain and divides it into blocks. Returns the terrain without the mass.
rockfall::Terrain cut_mass(const CollapseScenario& scenario, const rockfall::Terrain& terrain,
                           Reading& reading, CollapseSite& site) {
    const CollapseSettings& s = scenario.settings;
    std::vector<JointSet> sets;
    if (s.blocks == BlockKind::joints) {
        sets = joint_sets_of(table_of(joint_set_columns(), s.joint_sets, reading), s);
    }
    const SourceBody source = read_source(scenario, terrain, reading);
    double around_m = s.block_size_m;
    for (const JointSet& set : sets) {
        around_m = std::max(around_m, set.spacing_m);
    }
    around_m = 2.0 * around_m + 1.5 * site.map_frame.cell_width_m;
    const Vector3d low = source.low_m.array() - around_m, high = source.high_m.array() + around_m;
    check_pieces(scenario, sets, low, high);
    const FacetIndex index{source.body, std::max(around_m, 1.0)};
    std::vector<ConvexCell> inside, outside;
    for (const ConvexCell& cell : cells_over(scenario, sets, low, high)) {
        Division division = divide(cell, source.body, index.near(cell), made_by_border);
        std::move(division.inside.begin(), division.inside.end(), std::back_inserter(inside));
        std::move(division.outside.begin(), division.outside.end(), std::back_inserter(outside));
    }
    site.count.body_m3 = volume_of(inside);
    Merged merged = merge_slivers(std::move(inside), s.least_block_m);
    site.count.left_out_m3 = merged.left_out_m3;
    site.count.merged = merged.merged;
    std::vector<ConvexCell> cells = std::move(merged.cells);
    site.count.free = cells.size();
    site.count.blocks_m3 = volume_of(cells);
    if (cells.empty() || cells.size() > most_blocks) {
        config::fail(config::ExitCode::data, {scenario.scenario.file.string()},
                     joined(std::to_string(cells.size()), " blocks"),
                     joined("1 to ", std::to_string(most_blocks)),
                     "check the body, the spacings and the block size");
    }
    rockfall::Terrain floor = lowered(terrain, cells);
    const double least_m3 = s.least_block_m * s.least_block_m * s.least_block_m;
    std::vector<ConvexCell> around = rock_around(std::move(outside), terrain, floor, least_m3);
    site.count.fixed = around.size();
    std::move(around.begin(), around.end(), std::back_inserter(cells));
    add_blocks(cells, site.count.free, s.density_kgpm3, site, reading);
    join(scenario, sets, cells, site);
    site.ground = Ground{floor};
    return floor;
}

}  // namespace

namespace {

CollapseSite site_of(const CollapseScenario& scenario, Reading& reading) {
    std::optional<HeightInput> heights = read_heights(reading);
    reading.problems().throw_if_any();
    const bool hands_over = scenario.settings.hand_over != HandOverTo::none;
    GroundOfBlocks of_blocks;
    if (hands_over) {
        of_blocks = read_ground_of_blocks(scenario, *heights, reading);
    }
    rockfall::GroundLaw as_it_is;
    as_it_is.as_it_is = true;
    constexpr double no_rock_m = 0.0;  // so its mean diameter plays no part
    const rockfall::Terrain terrain =
        build_terrain(*heights, as_it_is, no_rock_m, scenario.scenario.terrain.longest_edge_m, reading);
    CollapseSite site;
    site.origin_m = terrain.origin_m();
    site.map_frame = heights->map_frame;
    site.heights = heights_on_map(*heights, terrain);
    site.projection = heights->projection;
    site.picture = read_ground_picture(heights->map_frame, reading);
    if (auto targets = read_targets(reading)) {
        site.targets = on_terrain(std::move(*targets), terrain, reading);
    }
    if (auto trees = read_trees(reading)) {
        site.trees = on_terrain(std::move(*trees), terrain, reading);
    }
    const auto floor = reading.attempt([&] { return cut_mass(scenario, terrain, reading, site); });
    std::optional<rockfall::Slope> slope;
    if (hands_over) {
        slope = slope_of_blocks(std::move(of_blocks), *heights, terrain, reading);
    }
    reading.check_systems();
    reading.finish();
    add_stems(terrain, site);
    if (slope) {
        site.handed_ground = std::make_shared<const HandedGround>(std::move(*slope), *floor, site.trees,
                                                                  largest_radius_m(site),
                                                                  scenario.scenario.rockfall.fall.tree.taper);
    }
    site.inputs = reading.inputs();
    if (site.count.left_out_m3 > 0.0) {
        reading.note(joined("slivers that fit no neighbour were left out: ",
                            std::to_string(std::llround(site.count.left_out_m3)), " m3 of ",
                            std::to_string(std::llround(site.count.body_m3)),
                            "; a smaller "
                            "collapse.least_block_m keeps more of them"));
    }
    return site;
}

}  // namespace

CollapseSite open_collapse(const CollapseScenario& scenario, config::Warnings& warnings) {
    Reading reading{scenario.scenario, warnings};
    return scenario.scenario.with_paths([&] { return site_of(scenario, reading); });
}

}  // namespace coupling::collapse
