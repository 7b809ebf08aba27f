#include <algorithm>

#include "coupling/assessments/collapse/collapse_results.hpp"

namespace coupling::collapse {
namespace {

constexpr const char* simulated = "simulated";

TableLayout energies() {
    return {
        "energies.csv",
        "a time",
        {{"time_s", "s", "time since the start", simulated},
         {"translation_mj", "MJ", "energy of translation", simulated},
         {"rotation_mj", "MJ", "energy of rotation", simulated},
         {"gravity_mj", "MJ", "energy of height above the start; falls as the mass comes down", simulated},
         {"contact_normal_mj", "MJ", "held by contacts, normal", simulated},
         {"contact_shear_mj", "MJ", "held by contacts, along them", simulated},
         {"bond_normal_mj", "MJ", "held by intact bonds, normal", simulated},
         {"bond_shear_mj", "MJ", "held by intact bonds, shear", simulated},
         {"bond_bending_mj", "MJ", "held by intact bonds, bending", simulated},
         {"bond_twist_mj", "MJ", "held by intact bonds, twist", simulated},
         {"friction_mj", "MJ", "taken by friction so far", simulated},
         {"dashpot_mj", "MJ", "taken by dashpots so far", simulated},
         {"local_damping_mj", "MJ", "taken by local damping so far", simulated},
         {"fracture_mj", "MJ", "taken by broken bonds so far; never falls", simulated},
         {"trees_mj", "MJ", "taken by trees so far", simulated},
         {"rest_mj", "MJ", "motion of blocks when they were put to rest", simulated},
         {"left_mj", "MJ", "motion of blocks that left the terrain", simulated},
         {"residual_mj", "MJ", "what the above leave over; 0 in an exact ledger", simulated},
         {"residual_percent", "%", "the same by the energy turned over", simulated},
         {"mean_speed_mps", "m/s", "mean speed of the blocks, by mass", simulated},
         {"largest_speed_mps", "m/s", "largest speed of any block since the row before", simulated},
         {"front_m", "m", "largest way in plan of any block from its start", simulated},
         {"moving_percent", "%", "blocks faster than 0.5 m/s", simulated},
         {"bonds_intact", "-", "bonds that hold", simulated},
         {"broken_by_tension", "-", "bonds broken so far by tension and bending", simulated},
         {"broken_by_shear", "-", "bonds broken so far by shear and twist", simulated}}};
}

TableLayout blocks() {
    return {"blocks.csv",
            "a block",
            {{"block", "-", "number of the block", simulated},
             {"volume_m3", "m3", "its volume", simulated},
             {"size_m", "m", "side of the cube of equal volume", simulated},
             {"x_start_m", "m", "easting of its middle at the start", simulated},
             {"y_start_m", "m", "northing", simulated},
             {"z_start_m", "m", "height above sea", simulated},
             {"x_m", "m", "easting of its middle at the end", simulated},
             {"y_m", "m", "northing", simulated},
             {"z_m", "m", "height above sea", simulated},
             {"run_out_m", "m", "way in plan from start to end", simulated},
             {"largest_speed_mps", "m/s", "its largest speed", simulated},
             {"largest_energy_kj", "kJ", "its largest kinetic energy, translation and rotation", simulated},
             {"state", "text", "moving, at_rest or left (the terrain) at the end", simulated},
             {"piece", "-", "number of the piece that it is part of at the end: blocks whose bonds hold",
              simulated}}};
}

TableLayout targets() {
    return {
        "collapse_targets.csv",
        "a target",
        {{"target_id", "text", "id of the target", "input targets.file"},
         {"name", "text", "its name", "input targets.file"},
         {"blocks", "-", "blocks that reached it", simulated},
         {"volume_m3", "m3", "their volume", simulated},
         {"first_s", "s", "when the first one did", simulated},
         {"largest_energy_kj", "kJ", "largest kinetic energy of a block when it first reached it", simulated},
         {"largest_speed_mps", "m/s", "largest speed then", simulated},
         {"energy_sum_mj", "MJ", "sum of these energies", simulated}}};
}

TableLayout target_hits() {
    return {"target_hits.csv",
            "a block that reached a target",
            {{"target_id", "text", "id of the target", "input targets.file"},
             {"block", "-", "number of the block", simulated},
             {"time_s", "s", "time since the start", simulated},
             {"x_m", "m", "easting of its middle", simulated},
             {"y_m", "m", "northing", simulated},
             {"volume_m3", "m3", "its volume", simulated},
             {"speed_mps", "m/s", "its speed", simulated},
             {"energy_kj", "kJ", "its kinetic energy, translation and rotation", simulated},
             {"translational_kj", "kJ", "that of translation", simulated}}};
}

TableLayout trees() {
    return {"tree_energies.csv",
            "a tree that blocks touched",
            {{"tree_id", "text", "id of the tree", "input trees.file"},
             {"x_m", "m", "easting", "input trees.file"},
             {"y_m", "m", "northing", "input trees.file"},
             {"strength_kj", "kJ", "energy that breaks it", "Rammer et al. 2010, Eq. 1"},
             {"energy_kj", "kJ", "energy that it took", simulated},
             {"broken", "text", "yes or no", simulated}}};
}

constexpr const char* only_handed = "simulated; with collapse.hand_over";

/// Columns behind the one of that name; behind all of them where none is named.
void insert_behind(TableLayout& layout, std::string_view name, const std::vector<Column>& columns) {
    auto at = std::find_if(layout.columns.begin(), layout.columns.end(),
                           [&](const Column& column) { return column.name == name; });
    at = at == layout.columns.end() ? at : at + 1;
    layout.columns.insert(at, columns.begin(), columns.end());
}

TableLayout handed_falls() {
    return {
        "handed_falls.csv",
        "a block that left the mass and went on as a single one",
        {{"block", "-", "number of the block", only_handed},
         {"volume_m3", "m3", "its volume", only_handed},
         {"handed_over_s", "s", "when it left the mass", only_handed},
         {"x_m", "m", "easting of its middle then", only_handed},
         {"y_m", "m", "northing", only_handed},
         {"z_m", "m", "height above sea", only_handed},
         {"motion_kj", "kJ", "translation and rotation that went with it", only_handed},
         {"strain_kj", "kJ", "held by its contact with the ground, lost then", only_handed},
         {"duration_s", "s", "from then to its end, which may lie behind that of the run", only_handed},
         {"way_m", "m", "way in plan from then to its end", only_handed},
         {"ground_impacts", "-", "impacts on the ground", only_handed},
         {"tree_hits", "-", "hits of trees", only_handed},
         {"given_kj", "kJ", "motion and height above its end with which it began", only_handed},
         {"dissipated_kj", "kJ", "taken by ground and trees up to its end", only_handed},
         {"corrected_kj", "kJ", "work done on it where overlaps with the ground are taken out", only_handed},
         {"residual_kj", "kJ", "what its ledger leaves over; 0 in an exact one", only_handed},
         {"unsolved", "-", "percussions whose solver met its limit", only_handed},
         {"end", "text", "at_rest, caught, tree, log, net, left_terrain or gave_up", only_handed}}};
}

std::vector<TableLayout> without_hand_over() {
    return {energies(), blocks(), targets(), target_hits(), trees()};
}

std::vector<TableLayout> with_hand_over() {
    std::vector<TableLayout> layouts = without_hand_over();
    insert_behind(
        layouts[0], "left_mj",
        {{"handed_motion_mj", "MJ", "motion of blocks when they left the mass as single ones", only_handed},
         {"handed_gravity_mj", "MJ", "of their height above their start then", only_handed},
         {"handed_strain_mj", "MJ", "held by their contacts with the ground then", only_handed}});
    insert_behind(
        layouts[1], "piece",
        {{"model", "text", "mass, or the motion model of a block that left it as a single one", only_handed},
         {"handed_over_s", "s", "when it left the mass", only_handed}});
    insert_behind(layouts[2], "energy_sum_mj",
                  {{"single_blocks", "-", "blocks among them that came as single ones", only_handed}});
    insert_behind(
        layouts[3], "translational_kj",
        {{"model", "text", "mass, or the motion model of a block that came as a single one", only_handed}});
    insert_behind(layouts[4], "energy_kj",
                  {{"single_kj", "kJ", "part of it that single blocks gave", only_handed}});
    layouts.push_back(handed_falls());
    return layouts;
}

}  // namespace

const std::vector<TableLayout>& collapse_layouts() {
    static const std::vector<TableLayout> layouts = with_hand_over();
    return layouts;
}

const std::vector<TableLayout>& layouts_of(const CollapseResults& results) {
    static const std::vector<TableLayout> layouts = without_hand_over();
    return results.hands_over() ? collapse_layouts() : layouts;
}

}  // namespace coupling::collapse
