#include "coupling/inputs/rockyfor3d/project.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "config/grid/ascii_grid.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/rockyfor3d/blocks.hpp"
#include "coupling/inputs/rockyfor3d/forest.hpp"
#include "coupling/inputs/rockyfor3d/grounds.hpp"
#include "coupling/inputs/rockyfor3d/nets.hpp"
#include "coupling/inputs/tables/csv_row.hpp"
#include "rockfall/motion/models.hpp"

namespace coupling::rockyfor3d {
namespace {

/// The motion model whose rocks have the shapes of the blocks.
std::string_view model_with_shapes() {
    for (const rockfall::MotionModel model : rockfall::all_models()) {
        const rockfall::ModelDescription& description = rockfall::description_of(model);
        if (description.has_shape) {
            return description.name;
        }
    }
    return {};
}

using config::joined;
using config::to_text;

std::string text_of(const config::Raster<double>& raster) {
    std::ostringstream out;
    config::write_ascii_grid(out, raster);
    return out.str();
}

std::string two_digits(double value) {
    std::ostringstream out;
    CsvRow{out}.number<2>(value).end();
    std::string text = out.str();
    text.pop_back();
    return text;
}

std::string list(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) {
        text += joined(text.empty() ? "" : ", ", word);
    }
    return text;
}

std::string surface_types(const Grounds& grounds) {
    std::ostringstream out;
    out << "# Made from soiltype and rg70, rg20, rg10 of Rockyfor3D; README.md says how. Stopping is that of "
           "the shipped type in `like`.\n"
           "code,label,like,r_n,r_t,p_stop,roughness_m,soil_type,rg70_m,rg20_m,rg10_m,cells\n";
    CsvRow row{out};
    for (const Ground& ground : grounds.types) {
        row.whole(static_cast<std::uint32_t>(ground.code));
        row.text(joined("soil type ", std::to_string(ground.soil_type), ", roughness ",
                        two_digits(ground.rg70_m), " ", two_digits(ground.rg20_m), " ",
                        two_digits(ground.rg10_m), " m"));
        row.text(ground.like).number<3>(ground.r_n).number<3>(ground.r_t);
        ground.stops_all ? row.number<0>(1.0) : row.empty();
        row.number<3>(ground.roughness_m());
        row.whole(static_cast<std::uint32_t>(ground.soil_type));
        row.number<2>(ground.rg70_m).number<2>(ground.rg20_m).number<2>(ground.rg10_m).whole(ground.cells);
        row.end();
    }
    return out.str();
}

std::string trees_csv(const Forest& forest) {
    std::ostringstream out;
    out << "tree_id,x_m,y_m,species,dbh_cm,height_m\n";
    CsvRow row{out};
    for (std::size_t i = 0; i < forest.trees.size(); ++i) {
        const Tree& tree = forest.trees[i];
        row.whole(i + 1).number<2>(tree.x_m).number<2>(tree.y_m).text(tree.species);
        row.number<1>(tree.dbh_cm).number<1>(tree.height_m);
        row.end();
    }
    return out.str();
}

std::string nets_csv(const Nets& nets) {
    std::ostringstream out;
    out << "# From net_number, net_energy and net_height of Rockyfor3D.\nname,height_m,capacity_kj,wkt\n";
    CsvRow row{out};
    for (const Net& net : nets.nets) {
        std::string line;
        for (const config::Point2& corner : net.line) {
            line += joined(line.empty() ? "" : ", ", two_digits(corner.x_m), " ", two_digits(corner.y_m));
        }
        row.text(net.name).number<2>(net.height_m).number<1>(net.capacity_kj);
        row.text(joined("LINESTRING (", line, ")"));
        row.end();
    }
    return out.str();
}

/// The sources of [release]: a grid where all blocks are alike, else a row of polygons for each kind.
std::string release(const Blocks& blocks) {
    if (blocks.are_equal_spheres()) {
        return joined("source = source.asc\nrocks_per_source = 10\ndiameter_kind = fixed\ndiameter_m = ",
                      to_text(blocks.classes.front().diameter_m), "\n");
    }
    return "source_shapes = sources.csv  ; a row for each kind of block: its cells, size, density and shape\n"
           "rocks_per_source = 10        ; on average, of each cell\n";
}

std::string scenario(const Blocks& blocks, const Forest& forest, const Nets& nets) {
    return joined(
        "# Made from a Rockyfor3D folder by `bannwald init --from-rockyfor3d`; README.md says what became "
        "of each file.\n"
        "#   bannwald check scenario.ini     reads everything and prints what the run will take\n"
        "#   bannwald run scenario.ini       writes maps, tables and report.html into the folder out\n"
        "# `bannwald --help-all` lists every setting with unit, range and source.\n\n"
        "[run]\nseed = 1\n\n"
        "[terrain]\ndem = dem.asc\nsurface = surface.asc\nsurface_types = surface_types.csv\n\n",
        forest.trees.empty() ? "" : "[trees]\nfile = trees.csv\n\n", "[release]\n", release(blocks),
        "density_kgpm3 = ", to_text(std::round(blocks.density_kgpm3)),
        "\n;fall_height_m = 2          ; the initial fall height of Rockyfor3D, a setting there and in no "
        "file\n\n",
        nets.nets.empty() ? "" : "[nets]\nfile = nets.csv\n\n", "[rockfall]\n;motion = ", model_with_shapes(),
        "             ; the shapes themselves; without it spheres of the same volume\n\n"
        ";[targets]\n;file = targets.csv        ; what is to be protected: target_id, name, wkt\n");
}

std::string sizes_in_words(const Blocks& blocks) {
    const std::string smallest = two_digits(blocks.classes.front().diameter_m);
    if (blocks.classes.size() == 1) {
        return joined(smallest, " m");
    }
    return joined(std::to_string(blocks.classes.size()), " sizes from ", smallest, " to ",
                  two_digits(blocks.classes.back().diameter_m), " m",
                  blocks.class_width_m > 0.0
                      ? joined(" (classes of ", two_digits(blocks.class_width_m), " m)")
                      : std::string{});
}

void remark_blocks(const Blocks& blocks, std::vector<std::string>& remarks) {
    remarks.push_back(
        joined("Sources: ", std::to_string(blocks.cells()), " cells with rockdensity above 0",
               blocks.left_out == 0
                   ? std::string{}
                   : joined("; ", std::to_string(blocks.left_out),
                            " more in the two outer rows and columns are left out, as Rockyfor3D does"),
               "."));
    if (blocks.are_equal_spheres()) {
        remarks.push_back(joined("Blocks: spheres of ", sizes_in_words(blocks), "."));
        return;
    }
    remarks.push_back(joined("Blocks (blshape, d1, d2, d3, rockdensity): ", sizes_in_words(blocks),
                             " as spheres of the same volume, ", std::to_string(blocks.classes.size()),
                             blocks.classes.size() == 1 ? " kind" : " kinds",
                             " in sources.csv, each from its own cells."));
    remarks.push_back(joined(
        "Shapes stand in sources.csv: box, ellipsoid, sphere, and hulls for discs. `--set rockfall.motion=",
        model_with_shapes(),
        "` simulates them; other models take spheres of the same volume, as Rockyfor3D does at contacts."));
    if (blocks.largest_density_kgpm3 > blocks.least_density_kgpm3) {
        remarks.push_back(joined("rockdensity varies from ", to_text(blocks.least_density_kgpm3), " to ",
                                 to_text(blocks.largest_density_kgpm3),
                                 " kg/m3: each kind of block has the mean of its cells."));
    }
}

void remark_grounds(const Grounds& grounds, double rock_radius_m, std::vector<std::string>& remarks) {
    remarks.push_back(
        joined("Ground: ", std::to_string(grounds.types.size()), " types from soiltype and roughness",
               grounds.step_m > 0.0 ? joined(", roughness rounded to ", to_text(grounds.step_m), " m")
                                    : std::string{},
               ". r_n is the middle of the soil type's range; its spread, drawn at each contact in "
               "Rockyfor3D, is left out."));
    remarks.push_back(joined("r_t comes from rg70, rg20, rg10 for a rock of ",
                             two_digits(2.0 * rock_radius_m),
                             " m: sqrt((0.4 + e) / 1.4), e the mean of 1 / (1 + MOH / R). The depth of "
                             "penetration and the dependence on the size of the "
                             "rock are left out."));
    remarks.emplace_back(
        "Stopping has no file in Rockyfor3D: each type borrows it from a shipped type of like origin and "
        "roughness (`like` in "
        "surface_types.csv), a choice. Soil type 0 and rg70 = 100 stop every rock. `bannwald stopping-table` "
        "makes your own.");
    const bool any_stops_all = std::any_of(grounds.types.begin(), grounds.types.end(),
                                           [](const Ground& ground) { return ground.stops_all; });
    if (any_stops_all) {
        remarks.push_back(
            "Soil type 0 and roughness of 100 m stop every rock: r_n = r_t = 0 and p_stop = 1. Models of "
            "motion that use the column soil or rigid_ground in their place do not stop rocks there.");
    }
}

void remark_forest(const Folder& folder, const Forest& forest, std::vector<std::string>& remarks) {
    if (forest.trees.empty()) {
        remarks.emplace_back("No trees: only the bare slope is assessed.");
        return;
    }
    if (forest.generated) {
        remarks.push_back(
            joined("Trees: ", std::to_string(forest.trees.size()),
                   " drawn once from nrtrees (taken as stems per hectare), dbhmean and dbhstd (gamma "
                   "distribution), with seed ",
                   std::to_string(forest_seed),
                   "; Rockyfor3D draws others in each run. Places and diameters are artificial."));
    } else {
        remarks.push_back(joined(
            "Trees: ", std::to_string(forest.trees.size()), " from treefile.txt",
            folder.behind_trees.empty()
                ? std::string{}
                : joined(", which goes before ", list(folder.behind_trees), " as it does in Rockyfor3D"),
            "."));
    }
    if (forest.too_thin + forest.outside > 0) {
        remarks.push_back(joined("Left out: ", std::to_string(forest.too_thin), " trees below 5 cm and ",
                                 std::to_string(forest.outside),
                                 " off the terrain, which ends half a cell inside the DEM."));
    }
    remarks.push_back(
        joined(forest.all_conifers
                   ? std::string{"Species: conif_percent is missing, so every tree counts as a conifer"}
                   : std::string{"Species: a tree is a conifer with the chance of conif_percent at its "
                                 "place, drawn once"},
               "; spruce (PIAB) stands for conifers, beech (FASY) for broadleaved trees."));
    remarks.emplace_back(
        "Heights of trees have no file in Rockyfor3D: they follow one curve through 108 trees of a mixed "
        "mountain stand.");
}

void remark_nets(const Nets& nets, std::vector<std::string>& remarks) {
    if (nets.nets.empty() && nets.left_out == 0) {
        return;
    }
    remarks.push_back(
        joined("Nets: ", std::to_string(nets.nets.size()),
               " in nets.csv, lines along the middle of the cells of net_number, with their "
               "net_height and net_energy. A rock that flies higher passes, a weaker one is held, "
               "a stronger one loses net_energy, as in Rockyfor3D."));
    if (nets.left_out > 0) {
        remarks.push_back(
            joined(std::to_string(nets.left_out),
                   " cells of nets at the border of the terrain or beside NODATA are left out."));
    }
    for (const Net& net : nets.nets) {
        if (net.varies) {
            remarks.push_back(
                joined(net.name, ": net_height or net_energy varies along it; the smallest are taken, ",
                       two_digits(net.height_m), " m and ", two_digits(net.capacity_kj), " kJ."));
        }
        if (net.off_line > 0) {
            remarks.push_back(joined(net.name, ": ", std::to_string(net.off_line),
                                     " of its cells lie beside the line; draw it in nets.csv as it stands."));
        }
    }
}

void remark_rest(const Folder& folder, std::vector<std::string>& remarks) {
    if (!folder.not_read.empty()) {
        remarks.push_back(joined("Not read, no counterpart: ", list(folder.not_read), "."));
    }
    remarks.emplace_back(
        "Settings of Rockyfor3D that stand in no file (number of simulations, initial fall height, variation "
        "of the volume, forest "
        "or not) are not taken over: rocks_per_source, fall_height_m and the diameter settings of "
        "scenario.ini are their place. "
        "Both slopes, with forest and bare, are always assessed.");
    remarks.emplace_back(
        "There are no targets yet: add [targets] with lines and polygons, where Rockyfor3D has calculation "
        "screens.");
}

std::string readme(const Folder& folder, const Blocks& blocks, const std::vector<std::string>& remarks) {
    std::string text = joined("# A project made from a Rockyfor3D folder\n\nRead: ", list(folder.files),
                              ".\n\n## What became of it, and what has no counterpart\n\n");
    for (const std::string& remark : remarks) {
        text += joined("- ", remark, "\n");
    }
    text +=
        "\n## Release zones\n\n| zone | shape | diameter, m | sides, m | source cells "
        "|\n|---|---|---|---|---|\n";
    for (std::size_t k = 0; k < blocks.classes.size(); ++k) {
        const BlockClass& block = blocks.classes[k];
        text += joined("| ", std::to_string(k + 1), " | ",
                       block.form == BlockForm::disc ? "disc" : name_of(block.form), " | ",
                       two_digits(block.diameter_m), " | ", two_digits(block.sides_m[0]), " x ",
                       two_digits(block.sides_m[1]), " x ", two_digits(block.sides_m[2]), " | ",
                       std::to_string(block.cells), " |\n");
    }
    text +=
        "\nBannwald and Rockyfor3D are different models: rebound, stopping and tree impacts follow other "
        "laws, so maps of the same "
        "names will differ. Calibrate against traces before you decide on anything.\n";
    return text;
}

void add_sources(const Blocks& blocks, std::vector<Project::File>& files) {
    if (blocks.are_equal_spheres()) {
        files.push_back({"source.asc", text_of(blocks.zones)});
        return;
    }
    files.push_back({"sources.csv", sources_csv(blocks)});
    for (std::size_t k = 0; k < blocks.classes.size(); ++k) {
        if (blocks.classes[k].form == BlockForm::disc) {
            files.push_back(
                {joined("disc_", std::to_string(k + 1), ".csv"), disc_hull(blocks.classes[k].sides_m)});
        }
    }
}

}  // namespace

Project project_of(const std::filesystem::path& path) {
    const Folder folder = read_folder(path);
    const Blocks blocks = blocks_of(folder);
    const double rock_radius_m = 0.5 * blocks.mean_diameter_m();
    const Grounds grounds = grounds_of(folder, rock_radius_m);
    const Forest forest = forest_of(folder);
    const Nets nets = nets_of(folder);

    Project project;
    remark_blocks(blocks, project.remarks);
    remark_grounds(grounds, rock_radius_m, project.remarks);
    remark_forest(folder, forest, project.remarks);
    remark_nets(nets, project.remarks);
    project.remarks.insert(project.remarks.end(), folder.remarks.begin(), folder.remarks.end());
    remark_rest(folder, project.remarks);
    project.files = {{"scenario.ini", scenario(blocks, forest, nets)},
                     {"dem.asc", text_of(folder.dem)},
                     {"surface.asc", text_of(grounds.codes)},
                     {"surface_types.csv", surface_types(grounds)},
                     {"README.md", readme(folder, blocks, project.remarks)}};
    add_sources(blocks, project.files);
    if (!nets.nets.empty()) {
        project.files.push_back({"nets.csv", nets_csv(nets)});
    }
    if (!folder.projection.empty()) {
        project.files.push_back({"dem.prj", folder.projection});
    }
    if (!forest.trees.empty()) {
        project.files.push_back({"trees.csv", trees_csv(forest)});
    }
    return project;
}

}  // namespace coupling::rockyfor3d
