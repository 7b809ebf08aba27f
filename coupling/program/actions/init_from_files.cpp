#include "coupling/program/actions/init_from_files.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
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
#include "coupling/inputs/forest/species_table.hpp"
#include "coupling/inputs/formats/read_file.hpp"
#include "coupling/inputs/grids/grid_file.hpp"
#include "coupling/inputs/parameters/guessed_widths.hpp"
#include "coupling/inputs/reading/reading.hpp"
#include "coupling/inputs/systems/same_system.hpp"
#include "coupling/inputs/tables/needed_columns.hpp"
#include "coupling/inputs/tables/prepare.hpp"
#include "coupling/program/actions/drawing_project.hpp"
#include "coupling/program/actions/given_files.hpp"
#include "coupling/program/actions/given_heights.hpp"
#include "coupling/program/actions/given_trees.hpp"
#include "coupling/program/actions/given_years.hpp"
#include "coupling/program/actions/ground_proposals.hpp"
#include "coupling/program/actions/offered_sections.hpp"
#include "coupling/program/actions/steep_cells.hpp"

namespace coupling {
namespace {

using config::joined;

/// The ground that is taken where nobody says anything, and which types codes may stand for [choice].
constexpr const char* usual_ground = "fine_debris_and_soil";

/// A project while it is put together.
class Maker {
public:
    Maker(const GivenFiles& given, const std::filesystem::path& folder) : given_{given}, folder_{folder} {}

    GivenProject make() {
        take_heights();
        take_years();
        take_grounds();
        take_trees();
        take_sources();
        take_targets();
        take_nets();
        take_observed();
        take_drawing();
        std::string text = joined(
            "# Made by bannwald init from files of yours, which stay where they are. Lines marked GUESS are "
            "to be checked:\n"
            "# take the word out of those that you have checked; run and page name the others.\n"
            "#   bannwald check scenario.ini     reads everything and prints what the run will take\n"
            "#   bannwald run scenario.ini       writes maps, tables and report.html into the folder out\n"
            "# `bannwald --help-all` lists every setting with unit, range and source.\n\n"
            "[run]\nseed = 1                    ; the same seed gives the same results\n",
            "parameters = parameters.csv ; what is not known of ground and trees, and how wide\n", run_,
            "\n[terrain]\n", terrain_, "\n[trees]\n", trees_, "\n[release]\n", release_,
            "diameter_kind = classes     ; GUESS: sizes of the rocks in m and their shares\n"
            "diameter_classes_m = 0.5, 0.75, 1.0, 1.5    ; GUESS\n"
            "diameter_shares = 40, 30, 20, 10             ; GUESS\n"
            "density_kgpm3 = 2700        ; GUESS: that of granite and gneiss; limestone about 2600\n\n",
            "[targets]\n", targets_, stands_, forest_, nets_, observed_);
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

    void take_heights() {
        heights_ = given_heights(given_.dem);
        for (std::string& sentence : heights_.remarks) {
            remark(std::move(sentence));
        }
        terrain_ = list(heights_.setting, given_.dem, "ground heights in m");
    }

    void take_years() {
        if (given_.climate.empty()) {
            return;
        }
        GivenYears years = given_years(
            {given_.climate, given_.years, heights_.system, heights_.extent, heights_.mean_height_m},
            folder_);
        for (std::string& sentence : years.remarks) {
            remark(std::move(sentence));
        }
        run_ = std::move(years.run);
        forest_ = std::move(years.sections);
    }

    /// How many rocks of all sources: in a run over years few in every year tell more than many in a few.
    [[nodiscard]] std::string rocks_line(const char* of_each_source) const {
        return given_.climate.empty() ? of_each_source
                                      : "rocks = 250                 ; a year, of all sources\n";
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
            refuse_other_system(file, grid.projection, given_.dem.front(), heights_.system);
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
        if (const std::optional<GivenCanopy> canopy = given_canopy(file)) {
            refuse_other_system(file, canopy->system, given_.dem.front(), heights_.system);
            trees_ = setting("canopy", {given_.trees}, "heights of the vegetation") + canopy->trees.settings;
            remark(joined(file.name(), ": ", canopy->trees.remark));
            return;
        }
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
            refuse_other_system(file, grid.projection, given_.dem.front(), heights_.system);
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
        release_ +=
            rocks_line("rocks_per_source = 10       ; on average, of each cell, point or piece of a line\n");
    }

    void refuse_gentle_slope(const std::string& limit_deg) {
        project_.no_sources = config::Problem{
            config::ExitCode::data,
            {given_.dem.front()},
            joined("no cell steeper than ", limit_deg, " degrees to take as a source of rocks"),
            "a slope with cliffs, or --sources",
            "name a layer of sources with --sources, or draw them: add --draw to this command"};
    }

    /// Heights without cells: the program finds the steep places of the terrain that it makes of them.
    void take_steep_places() {
        const double limit_deg = std::round(10.0 * source_slope_deg(heights_.spacing_m)) / 10.0;
        constexpr double smoothed = 0.5;  // means of cells are gentler than faces [choice]
        if (!heights_.raster.values.empty() &&
            cells_steeper_than(smoothed * limit_deg, heights_.raster).count == 0) {
            refuse_gentle_slope(config::to_text(limit_deg));
        }
        release_ =
            joined("steeper_than_deg = ", config::to_text(limit_deg),
                   "    ; GUESS: all places steeper than this\n", rocks_line("rocks_per_source = 10\n"));
        remark(joined("no sources given: all places steeper than ", config::to_text(limit_deg),
                      " degrees are a guess; draw the cliffs that you know instead"));
    }

    /// Layers to draw in stand for what no file was given for.
    void take_drawing() {
        DrawnProject drawn =
            drawn_project(given_, folder_,
                          {heights_.system, heights_.raster.values.empty() ? nullptr : &heights_.raster,
                           !heights_.has_grid, heights_.spacing_m});
        run_ += drawn.run;
        terrain_ += drawn.terrain;
        for (const auto& [section, lines] :
             {std::pair{&release_, &drawn.release}, std::pair{&targets_, &drawn.targets},
              std::pair{&stands_, &drawn.stands}}) {
            *section = lines->empty() ? *section : *lines;
        }
        nets_.insert(nets_.find(']') + 2, drawn.nets);
        std::move(drawn.files.begin(), drawn.files.end(), std::back_inserter(project_.files));
        std::for_each(drawn.printed.begin(), drawn.printed.end(), [&](const auto& each) { remark(each); });
    }

    void take_sources_by_slope() {
        if (given_.draw) {
            return;  // until some are drawn, the program finds the steep cells
        }
        if (!heights_.has_grid) {
            take_steep_places();
            return;
        }
        const double limit_deg = source_slope_deg(
            std::max(heights_.raster.frame.cell_width_m, heights_.raster.frame.cell_height_m));
        const SteepCells steep = cells_steeper_than(limit_deg, heights_.raster);
        const std::string limit = config::to_text(std::round(10.0 * limit_deg) / 10.0);
        if (steep.count == 0) {
            refuse_gentle_slope(limit);
        }
        std::ostringstream text;
        config::write_ascii_grid(text, steep.marks);
        project_.files.push_back({"source.asc", text.str()});
        if (!heights_.system.empty()) {
            project_.files.push_back({"source.prj", heights_.system + "\n"});
        }
        release_ =
            joined("source = source.asc         ; GUESS: all cells steeper than ", limit, " degrees\n",
                   rocks_line(steep.count > 20'000 ? "rocks_per_source = 1\n" : "rocks_per_source = 10\n"));
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
        nets_ += joined(offered_of_nets, "\n[works]\n");
        if (given_.works.empty()) {
            nets_ += offered_works;
        } else {
            nets_ += list("file", given_.works, "dams, ditches, walls, galleries that stand already");
            remark(joined(listed(given_.works), ": dams, ditches, walls or galleries"));
        }
        nets_ += offered_sections;
    }

    const GivenFiles& given_;
    const std::filesystem::path& folder_;
    GivenProject project_;
    GivenHeights heights_;
    std::string run_;
    std::string forest_;  ///< sections of a run over years
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
