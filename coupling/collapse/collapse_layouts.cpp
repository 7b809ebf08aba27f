#include "coupling/collapse/collapse_results.hpp"

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

}  // namespace

const std::vector<TableLayout>& collapse_layouts() {
    static const std::vector<TableLayout> layouts{energies(), blocks(), targets(), target_hits(), trees()};
    return layouts;
}

}  // namespace coupling::collapse
