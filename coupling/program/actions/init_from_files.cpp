#include "coupling/program/actions/init_from_files.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <sstream>
#include <tuple>
#include <utility>

#include "config/errors/input_error.hpp"
#include "config/geometry/wkt.hpp"
#include "config/grid/ascii_grid.hpp"
#include "config/table/table.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/files/path_checks.hpp"
#include "coupling/inputs/forest/species_table.hpp"
#include "coupling/inputs/formats/file_kinds.hpp"
#include "coupling/inputs/formats/mesh_file.hpp"
#include "coupling/inputs/formats/read_file.hpp"
#include "coupling/inputs/grids/grid_file.hpp"
#include "coupling/inputs/grids/tiles.hpp"
#include "coupling/inputs/grids/xyz_grid.hpp"
#include "coupling/inputs/parameters/guessed_widths.hpp"
#include "coupling/inputs/plausible/heights.hpp"
#include "coupling/inputs/reading/reading.hpp"
#include "coupling/inputs/systems/same_system.hpp"
#include "coupling/inputs/tables/needed_columns.hpp"
#include "coupling/inputs/tables/point_file.hpp"
#include "coupling/inputs/tables/prepare.hpp"
#include "coupling/inputs/terrain/terrain_input.hpp"
#include "coupling/program/actions/given_files.hpp"
#include "coupling/program/actions/given_trees.hpp"
#include "coupling/program/actions/ground_proposals.hpp"
#include "coupling/program/actions/offered_sections.hpp"
#include "coupling/program/actions/steep_cells.hpp"

namespace coupling {
namespace {

using config::joined;

/// The ground that is taken where nobody says anything, and which types codes may stand for [choice].
constexpr const char* usual_ground = "fine_debris_and_soil";

/// "a.shp, b.shp".
std::string listed(const std::vector<std::string>& names) {
    std::string all;
    for (const std::string& name : names) {
        all += joined(all.empty() ? "" : ", ", name);
    }
    return all;
}

/// A project while it is put together.
class Maker {
public:
    Maker(const GivenFiles& given, const std::filesystem::path& folder) : given_{given}, folder_{folder} {}

    GivenProject make() {
        take_heights();
        take_grounds();
        take_trees();
        take_sources();
        take_targets();
        take_nets();
        take_observed();
        std::string text = joined(
            "# Made by bannwald init from files of yours, which stay where they are. Lines marked GUESS are "
            "to be checked:\n"
            "# take the word out of those that you have checked; run and page name the others.\n"
            "#   bannwald check scenario.ini     reads everything and prints what the run will take\n"
            "#   bannwald run scenario.ini       writes maps, tables and report.html into the folder out\n"
            "# `bannwald --help-all` lists every setting with unit, range and source.\n\n"
            "[run]\nseed = 1                    ; the same seed gives the same results\n",
            "parameters = parameters.csv ; what is not known of ground and trees, and how wide\n\n",
            "[terrain]\n", terrain_, "\n[trees]\n", trees_, "\n[release]\n", release_,
            "diameter_kind = classes     ; GUESS: sizes of the rocks in m and their shares\n"
            "diameter_classes_m = 0.5, 0.75, 1.0, 1.5    ; GUESS\n"
            "diameter_shares = 40, 30, 20, 10             ; GUESS\n"
            "density_kgpm3 = 2700        ; GUESS: that of granite and gneiss; limestone about 2600\n\n",
            "[targets]\n", targets_, stands_, nets_, observed_);
        project_.files.push_back({"scenario.ini", std::move(text)});
        project_.files.push_back({"parameters.csv", text_of_guessed_widths()});
        remark("sizes, density and start of the rocks are guesses: see [release] of scenario.ini");
        return std::move(project_);
    }

private:
    void remark(std::string sentence) { project_.remarks.push_back(std::move(sentence)); }
    void take_remarks(const GivenFile& file, const std::vector<std::string>& remarks) {
        for (const std::string& sentence : remarks) {
            remark(joined(file.name(), ": ", sentence));
        }
    }
    /// Reads a layer; how it was read becomes a remark.
    formats::ReadLayer layer_of(GivenFile& file) {
        formats::ReadLayer read = file.layer();
        if (!read.remark.empty()) {
            remark(joined(file.name(), ": ", read.remark));
        }
        return read;
    }

    [[nodiscard]] std::string setting(const std::string& key, const std::vector<std::string>& names,
                                      const char* comment) const {
        std::string value;
        for (const std::string& name : names) {
            value += joined(value.empty() ? "" : ", ", name_from(folder_, name));
        }
        return joined(key, " = ", value, "    ; ", comment, "\n");
    }

    /// The same of a setting that takes several files: a comma and a blank in a name would part it.
    [[nodiscard]] std::string list(const std::string& key, const std::vector<std::string>& names,
                                   const char* comment) const {
        for (const std::string& name : names) {
            if (name_from(folder_, name).find(", ") != std::string::npos) {
                config::fail(config::ExitCode::data, {name}, "a comma and a blank in a name",
                             "a name without them: they stand between two files of a setting",
                             "give the file or its folder another name");
            }
        }
        return setting(key, names, comment);
    }

    /// Of grids: shapes are transformed when the project is checked.
    void check_system(const GivenFile& file, const std::string& system) {
        if (plausible::compare_systems(system_, system) == plausible::Sameness::other) {
            config::fail(
                config::ExitCode::data, {file.name()},
                joined("coordinates in ", plausible::name_of_system(system)),
                joined("those of ", given_.dem.front(), ", ", plausible::name_of_system(system_)),
                "transform one of them (QGIS: Warp; gdalwarp -t_srs): grids are never resampled here");
        }
    }

    /// A mesh, a drawing of contours or points in no rows and columns: the terrain is made of them. False for
    /// what is a grid or tiles.
    bool take_heights_without_cells() {
        if (given_.dem.size() != 1 || is_folder(formats::split_layer_name(given_.dem.front()).file)) {
            return false;
        }
        GivenFile file{given_.dem.front()};
        const bool is_mesh = formats::mesh_kind(file.bytes(), file.name()) != nullptr;
        const bool is_points = !file.is_grid() && !is_mesh && !formats::is_gis_layer(file.bytes()) &&
                               formats::is_list_of_points(file.bytes());
        std::vector<Eigen::Vector3d> points;
        if (is_points) {
            points = tables::read_point_file(file.bytes(), file.name()).points;
            if (grids::grid_of_points(points)) {
                return false;
            }
        } else if (is_mesh) {
            points = meshes::read_mesh_file(file.bytes(), file.name()).points_m;
        } else {
            return false;
        }
        system_ = file.system_beside();
        if (points.size() >= 3) {
            const config::GridFrame frame = frame_over(points, 0.0);
            spacing_m_ = std::max(frame.cell_width_m, frame.cell_height_m);
        }
        remark(
            joined(file.name(), ": ground heights, ", is_mesh ? "a mesh or contours of " : "",
                   counted(points.size(), "point"), ", ",
                   system_.empty() ? "no coordinate system beside it" : plausible::name_of_system(system_)));
        terrain_ = setting(is_points ? "points" : "mesh", given_.dem, "ground heights in m");
        return true;
    }

    void take_heights() {
        if (take_heights_without_cells()) {
            return;
        }
        HeightFiles files;
        grids::ReadGrid read =
            grids::read_grid(given_.dem, {}, grids::GridValues::heights, std::nullopt, files.files());
        if (!read.is_mosaic) {
            project_.remarks.insert(project_.remarks.end(), read.notes.begin(), read.notes.end());
        }
        system_ = std::move(read.projection);
        heights_ = std::move(read.raster);
        has_grid_ = true;
        spacing_m_ = std::max(heights_.frame.cell_width_m, heights_.frame.cell_height_m);
        plausible::refuse_wrong_heights(heights_, system_, given_.dem.front());
        remark(joined(listed(given_.dem), ": ground heights, ", read.is_mosaic ? "tiles of together " : "",
                      to_string(heights_.frame), ", ",
                      system_.empty() ? "no coordinate system" : plausible::name_of_system(system_)));
        terrain_ = list("dem", given_.dem, "ground heights in m");
    }

    /// The codes or names of grounds in the order in which they occur, and whether they are names.
    struct Grounds {
        std::set<long long> codes;
        std::vector<std::string> names;
    };

    Grounds grounds_of_layers() {
        Grounds grounds;
        for (const std::string& name : given_.grounds) {
            GivenFile file{name};
            if (file.is_grid()) {
                config::fail(config::ExitCode::data, {name},
                             "a grid of ground types beside other files of them",
                             "one grid, or layers of polygons alone", "name the grid alone");
            }
            formats::ReadLayer read = layer_of(file);
            prepare(read, "surface_polygons");
            const config::Table& table = read.layer.table;
            config::Problems problems;
            require_columns(table, "surface_polygons", {"code", "wkt"}, problems);
            problems.throw_if_any();
            for (std::size_t row = 0; row < table.rows(); ++row) {
                const std::string& text = table.text(row, "code");
                if (const auto code = config::parse_whole(text); code && *code >= 0) {
                    grounds.codes.insert(*code);
                } else if (std::find(grounds.names.begin(), grounds.names.end(), text) ==
                           grounds.names.end()) {
                    grounds.names.push_back(text);
                }
            }
        }
        return grounds;
    }

    void take_grounds() {
        if (given_.grounds.empty()) {
            terrain_ += joined("ground = ", usual_ground,
                               "    ; GUESS: one ground everywhere; bannwald info surfaces lists others\n");
            remark(joined("no ground types given: ", usual_ground, " everywhere is a guess"));
            return;
        }
        Grounds grounds;
        GivenFile file{given_.grounds.front()};
        if (given_.grounds.size() == 1 && file.is_grid()) {
            const formats::PlacedGrid grid = file.grid();
            take_remarks(file, grid.remarks);
            check_system(file, grid.projection);
            for (const double code : grid.raster.values) {
                if (!std::isnan(code) && grounds.codes.size() < 256) {
                    grounds.codes.insert(std::llround(code));
                }
            }
            terrain_ += setting("surface", given_.grounds, "code of the ground type of each cell");
        } else {
            grounds = grounds_of_layers();
            terrain_ +=
                list("surface_polygons", given_.grounds, "polygons of ground types, later ones on top");
            terrain_ += joined("ground = ", usual_ground, "    ; GUESS: where no polygon lies\n");
        }
        write_ground_types(grounds);
    }

    /// The table that says what codes and names mean, with a proposal for each name.
    void write_ground_types(const Grounds& grounds) {
        ProposedTypes types = proposed_types(grounds.codes, grounds.names, usual_ground);
        project_.files.push_back({"surface_types.csv", std::move(types.table)});
        terrain_ += "surface_types = surface_types.csv    ; GUESS: what the codes mean\n";
        remark(joined(listed(given_.grounds), ": ground types",
                      types.codes.empty() ? "" : joined(", codes ", types.codes),
                      types.names.empty() ? "" : joined(", ", types.names),
                      "; what they mean is a guess in surface_types.csv"));
    }

    /// As the reader of the project will have it; what there is to say is said when the project is checked.
    static void prepare(formats::ReadLayer& read, const std::string& role) {
        config::Problems problems;
        for (const config::Problem& problem :
             tables::prepare(read.layer.table, role, read.has_shapes_of_its_own).errors) {
            problems.add(problem);
        }
        problems.throw_if_any();
    }

    void take_trees() {
        if (!given_.stands.empty()) {
            take_stands();
            return;
        }
        if (given_.trees.empty()) {
            trees_ = ";file = trees.csv           ; none were given: the bare slope alone\n";
            remark("no trees given: the bare slope alone");
            return;
        }
        GivenFile file{given_.trees};
        formats::ReadLayer read = layer_of(file);
        prepare(read, "trees");
        const GivenTrees trees = given_trees(read.layer.table);
        trees_ = setting("file", {given_.trees}, "living trees") + trees.settings;
        remark(joined(file.name(), ": ", trees.remark));
    }

    /// A layer of polygons with stems, basal area and mean diameter: one file for the map and for the
    /// records.
    void take_stands() {
        GivenFile file{given_.stands};
        formats::ReadLayer polygons = layer_of(file);
        prepare(polygons, "stands");
        formats::ReadLayer records = file.layer();
        prepare(records, "stand_records");
        trees_ = ";file = trees.csv           ; none were given: they come from [stands]\n";
        stands_ = joined("\n[stands]\n", setting("polygons", {given_.stands}, "which stand grows where"),
                         setting("records", {given_.stands}, "stems, basal area, diameter of its species"));
        remark(joined(file.name(), ": ", given_stands(polygons.layer.table, records.layer.table)));
    }

    void take_sources() {
        if (given_.sources.empty()) {
            take_sources_by_slope();
            return;
        }
        GivenFile file{given_.sources.front()};
        if (given_.sources.size() == 1 && file.is_grid()) {
            const formats::PlacedGrid grid = file.grid();
            take_remarks(file, grid.remarks);
            check_system(file, grid.projection);
            release_ = setting("source", given_.sources, "0 no source, k > 0 release zone k");
            remark(joined(file.name(), ": sources as a grid of release zones"));
        } else {
            std::size_t shapes = 0;
            for (const std::string& name : given_.sources) {
                GivenFile each{name};
                formats::ReadLayer read = layer_of(each);
                prepare(read, "source_shapes");
                shapes += read.layer.table.rows();
            }
            release_ = list("source_shapes", given_.sources, "where rocks break off");
            remark(joined(listed(given_.sources), ": ", counted(shapes, "shape"), " as sources"));
        }
        release_ += "rocks_per_source = 10       ; on average, of each cell, point or piece of a line\n";
    }

    /// Heights without cells: the program finds the steep places of the terrain that it makes of them.
    void take_steep_places() {
        const double limit_deg = std::round(10.0 * source_slope_deg(spacing_m_)) / 10.0;
        release_ = joined("steeper_than_deg = ", config::to_text(limit_deg),
                          "    ; GUESS: all places steeper than this\nrocks_per_source = 10\n");
        remark(joined("no sources given: all places steeper than ", config::to_text(limit_deg),
                      " degrees are a guess; draw the cliffs that you know instead"));
    }

    void take_sources_by_slope() {
        if (!has_grid_) {
            take_steep_places();
            return;
        }
        const double limit_deg =
            source_slope_deg(std::max(heights_.frame.cell_width_m, heights_.frame.cell_height_m));
        const SteepCells steep = cells_steeper_than(limit_deg, heights_);
        const std::string limit = config::to_text(std::round(10.0 * limit_deg) / 10.0);
        if (steep.count == 0) {
            project_.no_sources = config::Problem{
                config::ExitCode::data,
                {given_.dem.front()},
                joined("no cell steeper than ", limit, " degrees to take as a source of rocks"),
                "a slope with cliffs, or --sources",
                "name a layer of sources with --sources"};
        }
        std::ostringstream text;
        config::write_ascii_grid(text, steep.marks);
        project_.files.push_back({"source.asc", text.str()});
        if (!system_.empty()) {
            project_.files.push_back({"source.prj", system_ + "\n"});
        }
        release_ = joined("source = source.asc         ; GUESS: all cells steeper than ", limit, " degrees\n",
                          "rocks_per_source = ", steep.count > 20'000 ? "1" : "10", "\n");
        remark(joined("no sources given: ", counted(steep.count, "cell"), " steeper than ", limit,
                      " degrees (source.asc) are a guess; draw the cliffs that you know instead"));
    }

    void take_targets() {
        if (given_.targets.empty()) {
            targets_ = ";file = targets.csv         ; none were given: lines (roads) and areas (houses)\n";
            remark("no targets given: maps only, no protection of a road or house");
            return;
        }
        std::size_t targets = 0;
        for (const std::string& name : given_.targets) {
            GivenFile file{name};
            formats::ReadLayer read = layer_of(file);
            prepare(read, "targets");
            config::Problems problems;
            read.layer.table.require({"wkt"}, problems);
            problems.throw_if_any();
            targets += read.layer.table.rows();
        }
        targets_ = list("file", given_.targets, "what is to be protected");
        remark(joined(listed(given_.targets), ": ", counted(targets, "target")));
    }

    /// What was seen in the field, for `bannwald calibrate`.
    void take_observed() {
        for (const auto& [names, key, role, what] :
             {std::tuple{&given_.stops, "stops", "observed_stops", "stop"},
              std::tuple{&given_.scars, "scars", "observed_scars", "scar"}}) {
            if (names->empty()) {
                continue;
            }
            GivenFile file{*names};
            formats::ReadLayer read = layer_of(file);
            prepare(read, role);
            observed_ +=
                setting(key, {*names}, "seen in the field; bannwald calibrate scenario.ini fits to it");
            remark(joined(file.name(), ": ", counted(read.layer.table.rows(), what), " seen in the field"));
        }
        if (!observed_.empty()) {
            observed_ = joined("\n[observed]\n", observed_);
        }
    }

    void take_nets() {
        nets_ = "\n[nets]\n";
        if (!given_.nets.empty()) {
            nets_ += list("file", given_.nets, "nets that stand already");
            remark(joined(listed(given_.nets), ": rockfall nets"));
        }
        nets_ += offered_sections;
    }

    const GivenFiles& given_;
    const std::filesystem::path& folder_;
    GivenProject project_;
    config::Raster<double> heights_;
    bool has_grid_ = false;
    double spacing_m_ = 5.0;  ///< of the heights; of contours nobody knows
    std::string system_;
    std::string terrain_;
    std::string trees_;
    std::string release_;
    std::string targets_;
    std::string stands_;
    std::string nets_;
    std::string observed_;
};

}  // namespace

GivenProject project_from_files(const GivenFiles& given, const std::filesystem::path& folder) {
    return Maker{given, folder}.make();
}

}  // namespace coupling
