#include <algorithm>
#include <functional>
#include <limits>

#include "config/text/joined.hpp"
#include "coupling/assessments/collapse/collapse_results.hpp"
#include "coupling/assessments/collapse/series_tables.hpp"
#include "coupling/results/tables/figure_columns.hpp"
#include "rockfall/motion/block_fall.hpp"

namespace coupling::collapse {
namespace {

using config::joined;
using rockfall::rock_mass::BlockStatus;

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

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
    return results.hand_over.was_single(static_cast<std::size_t>(hit.block), hit.time_s);
}

constexpr const char* simulated = "simulated";
constexpr const char* only_handed = "simulated; with collapse.hand_over";

/// Columns that only runs have that hand single blocks over.
template <class Row>
ColumnsOf<Row> if_handed(bool hands_over, const ColumnsOf<Row>& columns) {
    return hands_over ? columns : ColumnsOf<Row>{};
}

/// Easting, northing and height of a place.
ColumnsOf<Eigen::Vector3d> middle_columns(const std::string& infix, const char* easting, const char* source) {
    return {{joined("x", infix, "_m"), 2, easting, source, [](const auto& place) { return place.x(); }},
            {joined("y", infix, "_m"), 2, "northing", source, [](const auto& place) { return place.y(); }},
            {joined("z", infix, "_m"), 2, "height above sea", source,
             [](const auto& place) { return place.z(); }}};
}

Eigen::Vector3d absolute(const CollapseResults& results, const Eigen::Vector3d& place_m) {
    return {place_m.x() + results.site.origin_m.x(), place_m.y() + results.site.origin_m.y(), place_m.z()};
}

using Ledger = decltype(FrameRow::ledger);

ColumnsOf<Ledger> ledger_columns(bool hands_over) {
    const auto energy = [](const char* name, const char* meaning, auto value,
                           const char* source = simulated) {
        return ColumnsOf<Ledger>{name, 6, meaning, source, [value](const Ledger& ledger) {
                                     return std::invoke(value, ledger) / j_per_mj;
                                 }};
    };
    const auto bond = [&](const char* name, const char* meaning, auto part) {
        return energy(name, meaning, [part](const Ledger& ledger) { return ledger.bonds.*part; });
    };
    using Bonds = decltype(Ledger::bonds);
    return {
        energy("translation_mj", "energy of translation", &Ledger::translation_j),
        energy("rotation_mj", "energy of rotation", &Ledger::rotation_j),
        energy("gravity_mj", "energy of height above the start; falls as the mass comes down",
               &Ledger::gravity_j),
        energy("contact_normal_mj", "held by contacts, normal", &Ledger::contact_normal_j),
        energy("contact_shear_mj", "held by contacts, along them", &Ledger::contact_shear_j),
        bond("bond_normal_mj", "held by intact bonds, normal", &Bonds::normal_j),
        bond("bond_shear_mj", "held by intact bonds, shear", &Bonds::shear_j),
        bond("bond_bending_mj", "held by intact bonds, bending", &Bonds::bending_j),
        bond("bond_twist_mj", "held by intact bonds, twist", &Bonds::twist_j),
        energy("friction_mj", "taken by friction so far", &Ledger::friction_j),
        energy("dashpot_mj", "taken by dashpots so far", &Ledger::dashpot_j),
        energy("local_damping_mj", "taken by local damping so far", &Ledger::local_damping_j),
        energy("fracture_mj", "taken by broken bonds so far; never falls", &Ledger::fracture_j),
        energy("trees_mj", "taken by trees so far", &Ledger::trees_j),
        energy("rest_mj", "motion of blocks when they were put to rest", &Ledger::rest_j),
        energy("left_mj", "motion of blocks that left the terrain", &Ledger::left_j),
        if_handed<Ledger>(
            hands_over, {energy("handed_motion_mj", "motion of blocks when they left the mass as single ones",
                                &Ledger::handed_motion_j, only_handed),
                         energy("handed_gravity_mj", "of their height above their start then",
                                &Ledger::handed_gravity_j, only_handed),
                         energy("handed_strain_mj", "held by their contacts with the ground then",
                                &Ledger::handed_strain_j, only_handed),
                         energy("back_motion_mj", "motion of those that came back, when they did",
                                &Ledger::back_motion_j, only_handed),
                         energy("back_gravity_mj", "of their height above their start then",
                                &Ledger::back_gravity_j, only_handed),
                         energy("back_strain_mj", "of their overlaps with other blocks then",
                                &Ledger::back_strain_j, only_handed)}),
        energy("residual_mj", "what the above leave over; 0 in an exact ledger", &Ledger::residual_j)};
}

TableOf<FrameRow> energy_table(bool hands_over) {
    return {
        "energies.csv",
        "Energies, speeds, front and bonds over time.",
        "a time",
        {{"time_s", 3, "time since the start", &FrameRow::time_s},
         {ledger_columns(hands_over), &FrameRow::ledger},
         {"residual_percent", 4, "the same by the energy turned over",
          [](const auto& frame) { return 100.0 * frame.residual_share; }},
         {"mean_speed_mps", 3, "mean speed of the blocks, by mass", &FrameRow::mean_speed_mps},
         {"largest_speed_mps", 3, "largest speed of any block since the row before",
          &FrameRow::largest_speed_mps},
         {"front_m", 2, "largest way in plan of any block from its start", &FrameRow::front_m},
         {"mean_displacement_m", 3, "mean distance of the blocks from their start, by mass",
          &FrameRow::mean_displacement_m},
         {"mean_acceleration_mps2", 3,
          "mean change of the velocity of a block since the row before, by the time between; by mass",
          [](const auto& frame) { return frame.known(frame.mean_acceleration_mps2); }},
         {"largest_acceleration_mps2", 3, "the same of the block with the largest one",
          [](const auto& frame) { return frame.known(frame.largest_acceleration_mps2); }},
         {"moving_percent", 2, "blocks faster than 0.5 m/s",
          [](const auto& frame) { return 100.0 * frame.moving_share; }},
         {"bonds_intact", 0, "bonds that hold", &FrameRow::bonds_intact},
         {"broken_by_tension", 0, "bonds broken so far by tension and bending", &FrameRow::broken_by_tension},
         {"broken_by_shear", 0, "bonds broken so far by shear and twist", &FrameRow::broken_by_shear}}};
}

/// A block at the end.
struct BlockRow {
    const CollapseResults& results;
    std::size_t number;
    SeenBlock seen;
    std::size_t piece;

    [[nodiscard]] const auto& block() const { return results.mass.blocks()[number]; }
    [[nodiscard]] const Eigen::Vector3d& start_m() const { return results.site.blocks[number].centre_m; }
};

TableOf<BlockRow> block_table(bool hands_over) {
    return {
        "blocks.csv",
        "Every block: size, start, end, largest speed and energy, piece.",
        "a block",
        {{"block", "number of the block", &BlockRow::number},
         {"volume_m3", 3, "its volume", [](const auto& row) { return row.block().volume_m3; }},
         {"mass_factor", 3, "its mass in the simulation by that of its volume (collapse.mass_scaling)",
          [](const auto& row) { return row.block().mass_factor; }},
         {"size_m", 3, "side of the cube of equal volume",
          [](const auto& row) { return 2.0 * row.block().half_side_m; }},
         {middle_columns("_start", "easting of its middle at the start", simulated),
          [](const auto& row) { return absolute(row.results, row.start_m()); }},
         {middle_columns("", "easting of its middle at the end", simulated),
          [](const auto& row) { return absolute(row.results, row.seen.centre_m); }},
         {"run_out_m", 2, "way in plan from start to end",
          [](const auto& row) { return (row.seen.centre_m - row.start_m()).template head<2>().norm(); }},
         {"largest_speed_mps", 3, "its largest speed",
          [](const auto& row) { return row.results.record.block_speed_mps[row.number]; }},
         {"largest_energy_kj", 3, "its largest kinetic energy, translation and rotation",
          [](const auto& row) { return row.results.record.block_energy_j[row.number] / 1e3; }},
         {"state", "moving, at_rest or left (the terrain) at the end",
          [](const auto& row) { return state_of(row.seen); }},
         {"piece", "number of the piece that it is part of at the end: blocks whose bonds hold",
          &BlockRow::piece},
         if_handed<BlockRow>(
             hands_over, {{"model", "mass, or the motion model of a block that left it as a single one",
                           only_handed, [](const auto& row) { return model_of(row.seen.is_handed); }},
                          {"handed_over_s", 3, "when it left the mass", only_handed,
                           [](const auto& row) {
                               return row.seen.is_handed ? row.results.hand_over.handed_at_s(row.number)
                                                         : no_number;
                           }},
                          {"returns", "how often it came back into the mass", only_handed,
                           [](const auto& row) { return row.results.hand_over.returns_of(row.number); }}})}};
}

/// What reached a target.
struct ReachedTarget {
    TargetName name;
    std::size_t blocks = 0;
    std::size_t alone = 0;
    double volume_m3 = 0.0;
    double first_s = no_number;
    double largest_j = 0.0;
    double speed_mps = 0.0;
    double energy_j = 0.0;
};

ReachedTarget reached_target(const CollapseResults& results, std::size_t target) {
    ReachedTarget reached{{results.site.targets[target].id, results.site.targets[target].name}};
    for (const TargetHit& hit : results.record.hits) {
        if (hit.target == static_cast<double>(target)) {
            reached.first_s = reached.blocks++ == 0 ? hit.time_s : reached.first_s;
            reached.alone += came_alone(results, hit) ? 1 : 0;
            reached.volume_m3 += hit.volume_m3;
            reached.energy_j += hit.energy_j;
            reached.largest_j = std::max(reached.largest_j, hit.energy_j);
            reached.speed_mps = std::max(reached.speed_mps, hit.speed_mps);
        }
    }
    return reached;
}

Column target_column() {
    return {"target_id", "text", "id of the target", "input targets.file"};
}

TableOf<ReachedTarget> target_table(bool hands_over) {
    return {
        "collapse_targets.csv",
        "What reached the targets.",
        "a target",
        {{target_column(), [](const auto& of) { return of.name.id; }},
         {"name", "its name", "input targets.file", [](const auto& of) { return of.name.name; }},
         {"blocks", "blocks that reached it", &ReachedTarget::blocks},
         {"volume_m3", 2, "their volume", &ReachedTarget::volume_m3},
         {"first_s", 2, "when the first one did", &ReachedTarget::first_s},
         {"largest_energy_kj", 2, "largest kinetic energy of a block when it first reached it",
          [](const auto& of) { return of.largest_j / 1e3; }},
         {"largest_speed_mps", 3, "largest speed then", &ReachedTarget::speed_mps},
         {"energy_sum_mj", 4, "sum of these energies", [](const auto& of) { return of.energy_j / j_per_mj; }},
         if_handed<ReachedTarget>(hands_over, {"single_blocks", "blocks among them that came as single ones",
                                               only_handed, &ReachedTarget::alone})}};
}

struct HitOfBlock : TargetHit {
    const CollapseResults& results;
};

TableOf<HitOfBlock> hit_table(bool hands_over) {
    return {
        "target_hits.csv",
        "Every block that reached a target.",
        "a block that reached a target",
        {{target_column(),
          [](const auto& row) { return row.results.site.targets[static_cast<std::size_t>(row.target)].id; }},
         {"block", 0, "number of the block", &TargetHit::block},
         {"time_s", 3, "time since the start", &TargetHit::time_s},
         {"x_m", 2, "easting of its middle", &TargetHit::x_m},
         {"y_m", 2, "northing", &TargetHit::y_m},
         {"volume_m3", 3, "its volume", &TargetHit::volume_m3},
         {"speed_mps", 3, "its speed", &TargetHit::speed_mps},
         {"energy_kj", 3, "its kinetic energy, translation and rotation",
          [](const auto& hit) { return hit.energy_j / 1e3; }},
         {"translational_kj", 3, "that of translation",
          [](const auto& hit) { return hit.translational_j / 1e3; }},
         {"wall", "number of the side at which it did, from 0; empty for lines",
          [](const auto& hit) {
              return hit.wall >= 0.0 ? std::optional{static_cast<std::uint64_t>(hit.wall)} : std::nullopt;
          }},
         if_handed<HitOfBlock>(
             hands_over,
             {"model", "mass, or the motion model of a block that came as a single one", only_handed,
              [](const auto& row) { return model_of(came_alone(row.results, row)); }})}};
}

/// A tree that blocks touched.
struct TouchedTree {
    const CollapseResults& results;
    std::size_t number;

    [[nodiscard]] const auto& stem() const { return results.mass.stems()[number]; }
};

TableOf<TouchedTree> tree_table(bool hands_over) {
    constexpr const char* from_list = "input trees.file, or drawn from stands.records";
    return {
        "tree_energies.csv",
        "Trees that blocks touched, with the energy that they took.",
        "a tree that blocks touched",
        {{"tree_id", "id of the tree", from_list,
          [](const auto& row) { return row.results.site.trees[row.number].id; }},
         {"x_m", 2, "easting", from_list,
          [](const auto& row) { return row.stem().x_m + row.results.site.origin_m.x(); }},
         {"y_m", 2, "northing", from_list,
          [](const auto& row) { return row.stem().y_m + row.results.site.origin_m.y(); }},
         {"strength_kj", 3, "energy that breaks it", "Rammer et al. 2010, Eq. 1",
          [](const auto& row) { return row.stem().strength_j / 1e3; }},
         {"energy_kj", 3, "energy that it took", [](const auto& row) { return row.stem().taken_j / 1e3; }},
         if_handed<TouchedTree>(
             hands_over,
             {"single_kj", 3, "part of it that single blocks gave", only_handed,
              [](const auto& row) {
                  return row.results.hand_over.given_to_stem_j(row.number, row.results.mass.time_s()) / 1e3;
              }}),
         {"broken", "yes or no", [](const auto& row) { return row.stem().is_broken(); }}}};
}

struct HandedRow {
    const CollapseResults& results;
    std::size_t number;

    [[nodiscard]] const HandedFall& fall() const { return results.hand_over.falls()[number]; }
    [[nodiscard]] const auto& back() const { return results.hand_over.return_of(number); }
};

ColumnsOf<HandedFall> handed_motion_columns() {
    const auto kj = [](const char* name, const char* meaning, int decimals, auto value_j) {
        return ColumnsOf<HandedFall>{name, decimals, meaning, only_handed,
                                     [value_j](const HandedFall& fall) { return value_j(fall) / 1e3; }};
    };
    return {kj("motion_kj", "translation and rotation that went with it", 3,
               [](const auto& fall) { return fall.block.motion_j; }),
            kj("strain_kj", "held by its contact with the ground, lost then", 3,
               [](const auto& fall) { return fall.block.strain_j; }),
            {"duration_s", 3,
             "from then to its end, which may lie behind that of the run, or to its return on its way",
             only_handed, &HandedFall::duration_s},
            {"way_m", 2, "way in plan from then to its end", only_handed,
             [](const auto& fall) {
                 return (fall.moments.back().centre_m - fall.block.centre_m).template head<2>().norm();
             }},
            {"ground_impacts", "impacts on the ground", only_handed,
             [](const auto& fall) { return fall.end.ground_impacts; }},
            {"tree_hits", "hits of trees", only_handed, [](const auto& fall) { return fall.end.tree_hits; }},
            kj("given_kj", "motion and height above its end with which it began", 3,
               [](const auto& fall) { return fall.start_j; }),
            kj("dissipated_kj", "taken by ground and trees up to its end", 3,
               [](const auto& fall) { return fall.end.dissipated_j; }),
            kj("motion_end_kj",
               "translation and rotation that it has left then, above 0 if it returns on its way", 3,
               [](const auto& fall) { return fall.motion_end_j; }),
            kj("corrected_kj", "work done on it where overlaps with the ground are taken out", 3,
               [](const auto& fall) { return fall.end.corrected_j; }),
            kj("residual_kj", "what its ledger leaves over; 0 in an exact one", 6,
               [](const auto& fall) { return fall.end.residual_j; }),
            {"unsolved", "percussions whose solver met its limit", only_handed,
             [](const auto& fall) { return fall.end.unsolved; }},
            {"end", "at_rest, caught, tree, log, net, left_terrain or gave_up; on_way: it returned before",
             only_handed, [](const auto& fall) {
                 return fall.has_ended ? name_of(fall.end.reason) : std::string_view{"on_way"};
             }}};
}

TableOf<HandedRow> handed_table() {
    return {"handed_falls.csv",
            "Blocks that left the mass and went on as single ones.",
            "a block that left the mass and went on as a single one",
            {{"block", "number of the block", only_handed,
              [](const auto& row) { return row.fall().block.number; }},
             {"volume_m3", 3, "its volume", only_handed,
              [](const auto& row) { return row.results.mass.blocks()[row.fall().block.number].volume_m3; }},
             {"handed_over_s", 3, "when it left the mass", only_handed,
              [](const auto& row) { return row.results.hand_over.start_s(row.number); }},
             {middle_columns("", "easting of its middle then", only_handed),
              [](const auto& row) { return absolute(row.results, row.fall().block.centre_m); }},
             {handed_motion_columns(), &HandedRow::fall},
             {"returned_s", 3,
              "when it came back into the mass, as another block could touch it or the terrain was dug out; "
              "empty: it did not",
              only_handed, [](const auto& row) { return row.back() ? row.back()->time_s : no_number; }},
             {"lifted_m", 3, "how far it was lifted out of the ground of the mass then", only_handed,
              [](const auto& row) { return row.back() ? row.back()->taken.lift_m : no_number; }}}};
}

/// Stems stand in the order of the trees; those without ground below have none.
void add_trees(auto& rows, const CollapseResults& results) {
    for (std::size_t k = 0; k < results.mass.stems().size() && k < results.site.trees.size(); ++k) {
        if (results.mass.stems()[k].taken_j > 0.0) {
            rows.add({results, k});
        }
    }
}

std::vector<TableLayout> tables_of(bool hands_over) {
    std::vector<TableLayout> tables{energy_table(hands_over), block_table(hands_over),
                                    target_table(hands_over), hit_table(hands_over), tree_table(hands_over)};
    if (hands_over) {
        tables.push_back(handed_table());
    }
    const std::vector<TableLayout> series = series_layouts();
    tables.insert(tables.end(), series.begin(), series.end());
    return tables;
}

}  // namespace

const std::vector<TableLayout>& collapse_layouts() {
    static const std::vector<TableLayout> layouts = tables_of(true);
    return layouts;
}

const std::vector<TableLayout>& layouts_of(const CollapseResults& results) {
    static const std::vector<TableLayout> layouts = tables_of(false);
    return results.hands_over() ? collapse_layouts() : layouts;
}

void write_tables(const CollapseResults& results, const std::filesystem::path& folder,
                  const WriteWatch& watch, std::vector<WrittenFile>& files) {
    const bool handed = results.hands_over();
    const auto write = [&](const auto& table, const auto& fill) {
        watch(table.file, 0.0);
        files.push_back(table.write(folder, fill));
    };
    write(energy_table(handed), [&](auto& rows) { rows.add_all(results.record.rows); });
    write(block_table(handed), [&](auto& rows) {
        const std::vector<std::size_t> pieces = pieces_of(results);
        for (std::size_t i = 0; i < results.site.count.free; ++i) {
            rows.add({results, i, results.seen(i), pieces[i]});
        }
    });
    if (!results.site.targets.empty()) {
        write(target_table(handed), [&](auto& rows) {
            for (std::size_t target = 0; target < results.site.targets.size(); ++target) {
                rows.add(reached_target(results, target));
            }
        });
        write(hit_table(handed), [&](auto& rows) {
            for (const TargetHit& hit : results.record.hits) {
                rows.add({hit, results});
            }
        });
    }
    if (!results.site.trees.empty()) {
        write(tree_table(handed), [&](auto& rows) { add_trees(rows, results); });
    }
    write_series_tables(results, folder, watch, files);
    if (handed) {
        write(handed_table(), [&](auto& rows) {
            for (std::size_t fall = 0; fall < results.hand_over.falls().size(); ++fall) {
                rows.add({results, fall});
            }
        });
    }
}

}  // namespace coupling::collapse
