#include <algorithm>
#include <limits>

#include "config/text/joined.hpp"
#include "coupling/assessments/collapse/collapse_results.hpp"
#include "coupling/results/figures/figures.hpp"
#include "rockfall/motion/block_fall.hpp"

namespace coupling::collapse {
namespace {

using rockfall::rock_mass::BlockStatus;

constexpr double j_per_mj = 1e6;
constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

void write_energies(std::ostream& out, const CollapseResults& results) {
    TableRows row{out, layouts_of(results), "energies.csv"};
    for (const FrameRow& frame : results.record.rows) {
        const auto& l = frame.ledger;
        row.number<3>(frame.time_s);
        const auto energies = [&](std::initializer_list<double> list_j) {
            for (const double energy_j : list_j) {
                row.number<6>(energy_j / j_per_mj);
            }
        };
        energies({l.translation_j, l.rotation_j, l.gravity_j, l.contact_normal_j, l.contact_shear_j,
                  l.bonds.normal_j, l.bonds.shear_j, l.bonds.bending_j, l.bonds.twist_j, l.friction_j,
                  l.dashpot_j, l.local_damping_j, l.fracture_j, l.trees_j, l.rest_j, l.left_j});
        if (results.hands_over()) {
            energies({l.handed_motion_j, l.handed_gravity_j, l.handed_strain_j});
        }
        energies({l.residual_j()});
        row.number<4>(100.0 * frame.residual_share).number<3>(frame.mean_speed_mps);
        row.number<3>(frame.largest_speed_mps).number<2>(frame.front_m).number<2>(100.0 * frame.moving_share);
        row.number<0>(frame.bonds_intact).number<0>(frame.broken_by_tension).number<0>(frame.broken_by_shear);
        row.end();
    }
}

const char* state_of(const SeenBlock& block) {
    return block.status == BlockStatus::left     ? "left"
           : block.status == BlockStatus::moving ? "moving"
                                                 : "at_rest";
}

std::string_view model_of(bool is_handed) {
    return is_handed ? rockfall::BlockModel::description().name : std::string_view{"mass"};
}

/// Whether a block came to a target as a single one.
bool came_alone(const CollapseResults& results, const TargetHit& hit) {
    const auto block = static_cast<std::size_t>(hit.block);
    return results.hand_over.fall_of(block) != nullptr && hit.time_s >= results.hand_over.handed_at_s(block);
}

void write_blocks(std::ostream& out, const CollapseResults& results) {
    TableRows row{out, layouts_of(results), "blocks.csv"};
    const std::vector<std::size_t> pieces = pieces_of(results);
    const Eigen::Vector2d origin = results.site.origin_m;
    for (std::size_t i = 0; i < results.site.count.free; ++i) {
        const SeenBlock block = results.seen(i);
        const Eigen::Vector3d& start = results.site.blocks[i].centre_m;
        row.whole(i).number<3>(results.mass.blocks()[i].volume_m3);
        row.number<3>(2.0 * results.mass.blocks()[i].half_side_m);
        row.number<2>(start.x() + origin.x()).number<2>(start.y() + origin.y()).number<2>(start.z());
        row.number<2>(block.centre_m.x() + origin.x()).number<2>(block.centre_m.y() + origin.y());
        row.number<2>(block.centre_m.z());
        row.number<2>((block.centre_m - start).head<2>().norm());
        row.number<3>(results.record.block_speed_mps[i]).number<3>(results.record.block_energy_j[i] / 1e3);
        row.text(state_of(block)).whole(pieces[i]);
        if (results.hands_over()) {
            row.text(model_of(block.is_handed));
            row.number<3>(block.is_handed ? results.hand_over.handed_at_s(i) : no_number);
        }
        row.end();
    }
}

void write_targets(std::ostream& out, const CollapseResults& results) {
    TableRows row{out, layouts_of(results), "collapse_targets.csv"};
    for (std::size_t t = 0; t < results.site.targets.size(); ++t) {
        double volume_m3 = 0.0, energy_j = 0.0, largest_j = 0.0, speed_mps = 0.0;
        double first_s = no_number;
        std::size_t blocks = 0, alone = 0;
        for (const TargetHit& hit : results.record.hits) {
            if (hit.target == static_cast<double>(t)) {
                first_s = blocks++ == 0 ? hit.time_s : first_s;
                alone += came_alone(results, hit) ? 1 : 0;
                volume_m3 += hit.volume_m3;
                energy_j += hit.energy_j;
                largest_j = std::max(largest_j, hit.energy_j);
                speed_mps = std::max(speed_mps, hit.speed_mps);
            }
        }
        row.text(results.site.targets[t].id).text(results.site.targets[t].name).whole(blocks);
        row.number<2>(volume_m3).number<2>(first_s).number<2>(largest_j / 1e3).number<3>(speed_mps);
        row.number<4>(energy_j / j_per_mj);
        if (results.hands_over()) {
            row.whole(alone);
        }
        row.end();
    }
}

void write_hits(std::ostream& out, const CollapseResults& results) {
    TableRows row{out, layouts_of(results), "target_hits.csv"};
    for (const TargetHit& hit : results.record.hits) {
        row.text(results.site.targets[static_cast<std::size_t>(hit.target)].id);
        row.number<0>(hit.block).number<3>(hit.time_s).number<2>(hit.x_m).number<2>(hit.y_m);
        row.number<3>(hit.volume_m3).number<3>(hit.speed_mps).number<3>(hit.energy_j / 1e3);
        row.number<3>(hit.translational_j / 1e3);
        if (results.hands_over()) {
            row.text(model_of(came_alone(results, hit)));
        }
        row.end();
    }
}

void write_trees(std::ostream& out, const CollapseResults& results) {
    TableRows row{out, layouts_of(results), "tree_energies.csv"};
    // Stems stand in the order of the trees; those without ground below have none.
    for (std::size_t k = 0; k < results.mass.stems().size() && k < results.site.trees.size(); ++k) {
        const auto& stem = results.mass.stems()[k];
        if (stem.taken_j > 0.0) {
            row.text(results.site.trees[k].id).number<2>(stem.x_m + results.site.origin_m.x());
            row.number<2>(stem.y_m + results.site.origin_m.y()).number<3>(stem.strength_j / 1e3);
            row.number<3>(stem.taken_j / 1e3);
            if (results.hands_over()) {
                row.number<3>(results.hand_over.given_to_stem_j(k, results.mass.time_s()) / 1e3);
            }
            row.text(stem.is_broken() ? "yes" : "no");
            row.end();
        }
    }
}

void write_handed_falls(std::ostream& out, const CollapseResults& results) {
    TableRows row{out, layouts_of(results), "handed_falls.csv"};
    const Eigen::Vector2d origin = results.site.origin_m;
    for (std::size_t f = 0; f < results.hand_over.falls().size(); ++f) {
        const HandedFall& fall = results.hand_over.falls()[f];
        const Eigen::Vector3d& from_m = fall.block.centre_m;
        row.whole(fall.block.number).number<3>(results.mass.blocks()[fall.block.number].volume_m3);
        row.number<3>(results.hand_over.start_s(f));
        row.number<2>(from_m.x() + origin.x()).number<2>(from_m.y() + origin.y()).number<2>(from_m.z());
        row.number<3>(fall.block.motion_j / 1e3).number<3>(fall.block.strain_j / 1e3);
        row.number<3>(fall.duration_s);
        row.number<2>((fall.moments.back().centre_m - from_m).head<2>().norm());
        row.whole(fall.end.ground_impacts).whole(fall.end.tree_hits).number<3>(fall.start_j / 1e3);
        row.number<3>(fall.end.dissipated_j / 1e3).number<3>(fall.end.corrected_j / 1e3);
        row.number<6>(fall.end.residual_j / 1e3).whole(fall.end.unsolved).text(name_of(fall.end.reason));
        row.end();
    }
}

}  // namespace

void write_tables(const CollapseResults& results, const std::filesystem::path& folder,
                  const WriteWatch& watch, std::vector<WrittenFile>& files) {
    const auto table = [&](const char* name, const char* sentence, const auto& write) {
        watch(name, 0.0);
        files.push_back(write_table(folder, name, sentence, [&](std::ostream& out) { write(out, results); }));
    };
    table("energies.csv", "Energies, speeds, front and bonds over time.", write_energies);
    table("blocks.csv", "Every block: size, start, end, largest speed and energy, piece.", write_blocks);
    if (!results.site.targets.empty()) {
        table("collapse_targets.csv", "What reached the targets.", write_targets);
        table("target_hits.csv", "Every block that reached a target.", write_hits);
    }
    if (!results.site.trees.empty()) {
        table("tree_energies.csv", "Trees that blocks touched, with the energy that they took.", write_trees);
    }
    if (results.hands_over()) {
        table("handed_falls.csv", "Blocks that left the mass and went on as single ones.",
              write_handed_falls);
    }
}

}  // namespace coupling::collapse
