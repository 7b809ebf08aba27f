#include "coupling/program/actions/init_from_files.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <set>
#include <sstream>
#include <utility>

#include "config/data/shipped_tables.hpp"
#include "config/errors/input_error.hpp"
#include "config/geometry/wkt.hpp"
#include "config/grid/ascii_grid.hpp"
#include "config/table/table.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/files/file_bytes.hpp"
#include "coupling/inputs/files/files_beside.hpp"
#include "coupling/inputs/forest/species_table.hpp"
#include "coupling/inputs/formats/read_file.hpp"
#include "coupling/inputs/plausible/heights.hpp"
#include "coupling/inputs/reading/reading.hpp"
#include "coupling/inputs/systems/same_system.hpp"
#include "coupling/inputs/tables/prepare.hpp"

namespace coupling {
namespace {

using config::joined;

/// The ground that is taken where nobody says anything, and which types codes may stand for [choice].
constexpr const char* usual_ground = "fine_debris_and_soil";

/// A file of the user, opened.
class GivenFile {
public:
    explicit GivenFile(std::string name)
        : name_{std::move(name)},
          layer_{formats::split_layer_name(name_)},
          bytes_{open_file(layer_.file, {}, "a file of yours")},
          beside_{layer_.file} {}

    [[nodiscard]] const std::string& name() const { return name_; }
    [[nodiscard]] bool is_grid() const {
        return formats::is_gis_raster(bytes_.text()) || config::most_grid_bytes(bytes_.text()).has_value();
    }
    [[nodiscard]] formats::PlacedGrid grid() {
        return formats::read_grid_file(bytes_.text(), name_, beside_.bytes());
    }
    [[nodiscard]] formats::ReadLayer layer() {
        return formats::read_layer_file(bytes_.text(), layer_.layer, name_, beside_.bytes());
    }
    /// The name as the scenario in another folder needs it.
    [[nodiscard]] std::string name_from(const std::filesystem::path& folder) const {
        namespace fs = std::filesystem;
        std::error_code ignored;
        const fs::path here = fs::weakly_canonical(fs::absolute(layer_.file, ignored), ignored);
        const fs::path there = fs::weakly_canonical(fs::absolute(folder, ignored), ignored);
        const fs::path relative = here.lexically_relative(there);
        const std::string file = relative.empty() ? here.string() : relative.generic_string();
        return layer_.layer.empty() ? file : joined(file, "|", layer_.layer);
    }

private:
    std::string name_;
    formats::LayerName layer_;
    FileBytes bytes_;
    FilesBeside beside_;
};

/// The shipped widths of what is not known; more on grounds, whose types `init` cannot know.
std::string widths_of_guessed_ground() {
    constexpr const char* of_guess = "0.35";  // [choice] in parameter_widths.csv
    std::string text =
        "# What is not known, as factors on the laws of the fall; width: standard deviation of ln(factor), "
        "0: known.\n"
        "# ground_guess: write 0 once you have checked the ground types.\nparameter,width,acts_on\n";
    const config::Table table = config::read_shipped_table("parameter_widths.csv");
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const std::string& parameter = table.text(row, "parameter");
        text += joined(parameter, ",", parameter == "ground_guess" ? of_guess : table.text(row, "width"), ",",
                       table.text(row, "acts_on"), "\n");
    }
    return text;
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
            "[targets]\n", targets_);
        project_.files.push_back({"scenario.ini", std::move(text)});
        project_.files.push_back({"parameters.csv", widths_of_guessed_ground()});
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

    [[nodiscard]] std::string setting(const std::string& key, const GivenFile& file,
                                      const char* comment) const {
        return joined(key, " = ", file.name_from(folder_), "    ; ", comment, "\n");
    }

    void check_system(const GivenFile& file, const std::string& system) {
        if (plausible::compare_systems(system_, system) == plausible::Sameness::other) {
            config::fail(config::ExitCode::data, {file.name()},
                         joined("coordinates in ", plausible::name_of_system(system)),
                         joined("those of ", given_.dem, ", ", plausible::name_of_system(system_)),
                         "transform one of them (QGIS: Reproject layer, Warp): nothing is reprojected here");
        }
    }

    void take_heights() {
        GivenFile file{given_.dem};
        formats::PlacedGrid grid = file.grid();
        take_remarks(file, grid.remarks);
        system_ = std::move(grid.projection);
        heights_ = std::move(grid.raster);
        plausible::refuse_wrong_heights(heights_, system_, file.name());
        remark(joined(file.name(), ": ground heights, ", to_string(heights_.frame), ", ",
                      system_.empty() ? "no coordinate system" : plausible::name_of_system(system_)));
        terrain_ = setting("dem", file, "ground heights in m");
    }

    void take_grounds() {
        if (given_.grounds.empty()) {
            terrain_ += joined("ground = ", usual_ground,
                               "    ; GUESS: one ground everywhere; bannwald info surfaces lists others\n");
            remark(joined("no ground types given: ", usual_ground, " everywhere is a guess"));
            return;
        }
        GivenFile file{given_.grounds};
        std::set<long long> codes;
        if (file.is_grid()) {
            const formats::PlacedGrid grid = file.grid();
            take_remarks(file, grid.remarks);
            check_system(file, grid.projection);
            for (const double code : grid.raster.values) {
                if (!std::isnan(code) && codes.size() < 256) {
                    codes.insert(std::llround(code));
                }
            }
            terrain_ += setting("surface", file, "code of the ground type of each cell");
        } else {
            formats::ReadLayer read = layer_of(file);
            check_system(file, read.layer.projection);
            prepare(read, "surface_polygons");
            config::Problems problems;
            read.layer.table.require({"code", "wkt"}, problems);
            for (std::size_t row = 0; problems.empty() && row < read.layer.table.rows(); ++row) {
                if (const auto code = read.layer.table.whole(row, "code", {.low = 0.0}, problems)) {
                    codes.insert(*code);
                }
            }
            problems.throw_if_any();
            terrain_ += setting("surface_polygons", file, "polygons of ground types, later ones on top");
            terrain_ += joined("ground = ", usual_ground, "    ; GUESS: where no polygon lies\n");
        }
        std::string table =
            "# GUESS: every code is taken like one shipped type. Replace the names in `like` by those of\n"
            "# bannwald info surfaces, or give r_n, r_t and p_stop of your own.\ncode,label,like\n";
        std::string listed;
        for (const long long code : codes) {
            table += joined(std::to_string(code), ",code ", std::to_string(code), ",", usual_ground, "\n");
            listed += joined(listed.empty() ? "" : ", ", std::to_string(code));
        }
        project_.files.push_back({"surface_types.csv", std::move(table)});
        terrain_ += "surface_types = surface_types.csv    ; GUESS: what the codes mean\n";
        remark(joined(file.name(), ": ground types, codes ", listed, "; what they mean is a guess in ",
                      "surface_types.csv"));
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
        if (given_.trees.empty()) {
            trees_ = ";file = trees.csv           ; none were given: the bare slope alone\n";
            remark("no trees given: the bare slope alone");
            return;
        }
        GivenFile file{given_.trees};
        formats::ReadLayer read = layer_of(file);
        config::Table& table = read.layer.table;
        if (read.has_shapes_of_its_own && table.find("wkt")) {
            check_system(file, read.layer.projection);
        }
        prepare(read, "trees");
        config::Problems problems;
        table.require({"x_m", "y_m", "species", "dbh_cm"}, problems);
        problems.throw_if_any();
        trees_ = setting("file", file, "living trees");
        remark(
            joined(file.name(), ": ", counted(table.rows(), "tree"),
                   table.has("height_m") ? "" : ", heights unknown: at least five measured ones are needed"));
    }

    void take_sources() {
        if (given_.sources.empty()) {
            take_sources_by_slope();
            return;
        }
        GivenFile file{given_.sources};
        if (file.is_grid()) {
            const formats::PlacedGrid grid = file.grid();
            take_remarks(file, grid.remarks);
            check_system(file, grid.projection);
            release_ = setting("source", file, "0 no source, k > 0 release zone k");
            remark(joined(file.name(), ": sources as a grid of release zones"));
        } else {
            formats::ReadLayer read = layer_of(file);
            check_system(file, read.layer.projection);
            prepare(read, "source_shapes");
            release_ = setting("source_shapes", file, "where rocks break off");
            remark(joined(file.name(), ": ", counted(read.layer.table.rows(), "shape"), " as sources"));
        }
        release_ += "rocks_per_source = 10       ; on average, of each cell, point or piece of a line\n";
    }

    void take_sources_by_slope() {
        const config::GridFrame& frame = heights_.frame;
        const double limit_deg = source_slope_deg(std::max(frame.cell_width_m, frame.cell_height_m));
        const double least_rise = std::tan(limit_deg * std::numbers::pi / 180.0);
        config::Raster<double> sources{frame, 0.0};
        std::size_t cells = 0;
        for (int row = 1; row + 1 < frame.rows; ++row) {
            for (int column = 1; column + 1 < frame.columns; ++column) {
                const double east = heights_.at({column + 1, row}) - heights_.at({column - 1, row});
                const double north = heights_.at({column, row - 1}) - heights_.at({column, row + 1});
                const double rise =
                    std::hypot(east / (2.0 * frame.cell_width_m), north / (2.0 * frame.cell_height_m));
                if (rise > least_rise && !std::isnan(heights_.at({column, row}))) {  // false where unknown
                    sources.at({column, row}) = 1.0;
                    ++cells;
                }
            }
        }
        const std::string limit = config::to_text(std::round(10.0 * limit_deg) / 10.0);
        if (cells == 0) {
            project_.no_sources = config::Problem{
                config::ExitCode::data,
                {given_.dem},
                joined("no cell steeper than ", limit, " degrees to take as a source of rocks"),
                "a slope with cliffs, or --sources",
                "name a layer of sources with --sources"};
        }
        std::ostringstream text;
        config::write_ascii_grid(text, sources);
        project_.files.push_back({"source.asc", text.str()});
        if (!system_.empty()) {
            project_.files.push_back({"source.prj", system_ + "\n"});
        }
        release_ = joined("source = source.asc         ; GUESS: all cells steeper than ", limit, " degrees\n",
                          "rocks_per_source = ", cells > 20'000 ? "1" : "10", "\n");
        remark(joined("no sources given: ", counted(cells, "cell"), " steeper than ", limit,
                      " degrees (source.asc) are a guess; draw the cliffs that you know instead"));
    }

    void take_targets() {
        if (given_.targets.empty()) {
            targets_ = ";file = targets.csv         ; none were given: lines (roads) and areas (houses)\n";
            remark("no targets given: maps only, no protection of a road or house");
            return;
        }
        GivenFile file{given_.targets};
        formats::ReadLayer read = layer_of(file);
        if (read.has_shapes_of_its_own) {
            check_system(file, read.layer.projection);
        }
        prepare(read, "targets");
        config::Problems problems;
        read.layer.table.require({"wkt"}, problems);
        problems.throw_if_any();
        targets_ = setting("file", file, "what is to be protected");
        remark(joined(file.name(), ": ", counted(read.layer.table.rows(), "target")));
    }

    const GivenFiles& given_;
    const std::filesystem::path& folder_;
    GivenProject project_;
    config::Raster<double> heights_;
    std::string system_;
    std::string terrain_;
    std::string trees_;
    std::string release_;
    std::string targets_;
};

}  // namespace

double source_slope_deg(double cell_size_m) {
    return 55.0 * std::pow(cell_size_m, -0.075);
}

GivenProject project_from_files(const GivenFiles& given, const std::filesystem::path& folder) {
    return Maker{given, folder}.make();
}

}  // namespace coupling
