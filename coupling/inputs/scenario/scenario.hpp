#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "config/options/options.hpp"
#include "coupling/inputs/files/input_names.hpp"
#include "coupling/inputs/scenario/block_shapes.hpp"
#include "coupling/inputs/scenario/forest_settings.hpp"
#include "coupling/inputs/scenario/hazard_settings.hpp"
#include "coupling/inputs/scenario/net_settings.hpp"
#include "coupling/inputs/scenario/report_settings.hpp"
#include "rockfall/parameters.hpp"
#include "rockfall/release/release.hpp"

namespace coupling {

/// Which law rock sizes follow.
enum class DiameterKind : std::uint8_t { fixed, classes, uniform, lognormal };

/// How the tables of results are written.
enum class CsvForm : std::uint8_t {
    plain,  ///< commas, decimal points: R, Python and this program read them
    excel,  ///< semicolons, the decimal sign of the page's language, byte-order mark
};

/// Which axis of a mesh points up.
enum class MeshUp : std::uint8_t { z, y };

/// What becomes of faces of a mesh that lie over each other.
enum class MeshOverhangs : std::uint8_t { refuse, keep_upper };

/// What GIS programs and spreadsheets are given beside tables and ESRI ASCII grids.
struct GisFiles {
    bool geopackage = true;  ///< results.gpkg and results.qlr
    bool geotiff = false;    ///< a .tif beside each grid
    bool vtp = false;        ///< trajectories.vtp
    bool workbook = false;   ///< results.xlsx
    CsvForm csv = CsvForm::plain;
};

/// A plane rectangle instead of a map of heights: a plot of which only elevation and slope are known. It
/// begins at x = 0, y = 0.
struct PlaneGround {
    double width_m = 0.0;      ///< along x, eastwards; 0: there is a map
    double length_m = 0.0;     ///< along y, northwards
    double elevation_m = 0.0;  ///< at the middle
    double slope_deg = 0.0;
    double aspect_deg = 0.0;  ///< that it faces downhill, clockwise from north

    [[nodiscard]] bool is_given() const { return width_m > 0.0; }
};

/// The settings of a run as the user wrote them: texts, numbers and file names, not yet opened.
struct Scenario {
    // [run]
    std::uint64_t seed = 1;
    std::uint64_t years = 0;     ///< 0: static assessment of the given stand
    bool strict_inputs = false;  ///< what is only doubtful becomes an error

    std::uint64_t rocks_per_part =
        250'000;  ///< of a static run: so many rocks later its state is saved again

    // [terrain]
    std::string dem;     ///< ESRI ASCII grid, or
    std::string points;  ///< XYZ text, or
    std::string mesh;    ///< PLY, STL, DXF, contours as CSV, or XYZ text
    std::string meshes;  ///< CSV: file, surface; several meshes with a ground type each
    PlaneGround plane;   ///< instead of any of these
    MeshUp mesh_up = MeshUp::z;
    MeshOverhangs mesh_overhangs = MeshOverhangs::refuse;
    double longest_edge_m = 0.0;   ///< for points: longer edges are no terrain; 0 keeps all
    std::string surface;           ///< grid of surface codes, or
    std::string surface_polygons;  ///< CSV with WKT polygons and codes
    std::string surface_types;     ///< CSV: code, label, r_n, r_t, p_stop
    std::string soils;             ///< CSV of soils beside the shipped ones; optional
    std::string stopping;          ///< CSV: code, diameter_m, p_stop; optional
    std::string ground;            ///< name of a shipped surface type for all the terrain; instead of a grid
    std::string slope_grounds;     ///< CSV: from_deg, surface; ground types by slope where no map says
    std::string profile;           ///< CSV: distance_m, height_m, surface; not empty: a two-dimensional run

    // [profile]
    double profile_start_m = 0.0;            ///< distance of the release; the upper end unless it is set
    std::vector<double> profile_stations_m;  ///< distances at which rocks are counted, or
    std::string profile_stations;            ///< CSV: name, distance_m
    double profile_segment_m = 10.0;         ///< length along the slope over which jumps are put together

    // [trees]
    std::string trees;            ///< CSV; empty: none
    std::string logs;             ///< CSV of lying logs; empty: none; without either bare slope only
    bool swap_tree_axes = false;  ///< x_m and y_m of the tree list are exchanged
    bool swap_log_axes = false;   ///< the same of the logs

    // [release]
    std::string source;             ///< grid: 0 no source, k > 0 release zone k, or
    std::string source_shapes;      ///< CSV with WKT points, lines or polygons, or
    double steeper_than_deg = 0.0;  ///< > 0: only cells steeper than this; alone: all of them
    std::uint64_t rocks = 0;        ///< in all; 0: rocks_per_source times the number of sources
    std::uint64_t rocks_per_source = 10;
    DiameterKind diameter_kind = DiameterKind::fixed;
    double diameter_m = 1.0;  ///< fixed, or mean of the log-normal law
    double diameter_deviation_m = 0.0;
    double diameter_low_m = 0.0;
    double diameter_high_m = 0.0;
    std::vector<double> diameter_classes_m;
    std::vector<double> diameter_shares;
    double density_kgpm3 = 2700.0;
    double start_height_m = 1.5;
    double start_speed_mps = 3.0;
    double start_dip_deg = 30.0;
    double start_scatter_deg = 0.0;
    double fall_height_m = 0.0;  ///< > 0: dropped from this height at rest instead
    bool random_place = true;
    ShapeSettings shapes;                                 ///< as written
    std::shared_ptr<const rockfall::ShapeLaw> shape_law;  ///< what they say; null: spheres

    // [targets]
    std::string targets;  ///< CSV with WKT lines and polygons: target_id, name, wkt

    // [observed]: an event in the field, each file empty where nothing is known
    std::string observed_stops;        ///< where rocks came to rest
    std::string observed_passages;     ///< rocks seen at targets: speed, height, energy
    std::string observed_impacts;      ///< single impacts on the ground: speeds and angles
    std::uint64_t observed_rocks = 0;  ///< rocks that were released; 0: unknown

    NetSettings nets;       ///< [nets]
    HazardSettings hazard;  ///< [hazard]
    ReportSettings report;  ///< [report]

    // [output]
    double cell_size_m = 0.0;  ///< of the maps; 0: that of the DEM
    bool percentiles = true;   ///< percentile maps
    bool rock_table = true;
    bool arrival_table = true;
    bool tree_hit_table = true;
    bool impact_table = false;
    std::uint64_t repeats = 0;  ///< rocks are shared out among so many repeats; 0: none
    std::uint64_t sample_paths = 500;
    std::vector<double> path_rocks;  ///< numbers of rocks whose paths are kept too
    GisFiles gis;

    // [rockfall], [tree_impact]
    std::string preset = "default";
    rockfall::Parameters rockfall;

    // what a simulation over years asks for: [forest], [stands], [soil], [climate] and parts of [run],
    // [output]
    ForestSettings forest;

    std::filesystem::path file;                ///< the scenario file itself
    std::filesystem::path inputs_within;       ///< not empty: files elsewhere are refused
    std::shared_ptr<config::Options> options;  ///< all of the above as declared, for listings and messages
    std::shared_ptr<InputNames> names = std::make_shared<InputNames>();

    [[nodiscard]] bool has_mesh() const { return !mesh.empty() || !meshes.empty(); }
    /// Where a file that the scenario names lies, from the working directory. Throws InputError (data) for
    /// one outside of `inputs_within`.
    [[nodiscard]] std::filesystem::path resolve(const std::string& name) const;
    /// The name of a file for results and messages in them: see InputNames.
    [[nodiscard]] std::string shown(const std::string& name) const;
    /// The same of a place in a file of the run, or in the scenario itself.
    [[nodiscard]] config::Place shown(config::Place place) const;
    /// The settings as results show them: files by their name for results. Empty without options.
    [[nodiscard]] std::vector<config::ParameterRow> shown_settings() const;
    /// The settings of the command line, "section.key=value", likewise.
    [[nodiscard]] std::vector<std::string> shown_overrides() const;

    /// Runs what reads inputs. Places of the problems that it throws name files for results; they leave as
    /// paths from the working directory, so that whoever called the program finds them.
    template <class Step>
    auto with_paths(Step step) const -> decltype(step()) {
        try {
            return step();
        } catch (const config::InputError& error) {
            throw config::InputError{paths_in(error.problems())};
        }
    }

private:
    [[nodiscard]] std::vector<config::Problem> paths_in(std::vector<config::Problem> problems) const;
};

/// The texts of a setting that names files, split at commas where it may name several; entries without a dot
/// are no files.
std::vector<std::string> files_in(const std::string& value, config::NamesFiles files);

/// Gives every file of the settings its name for results, in the order of the settings: so it depends on no
/// reader. Throws InputError (data) for files outside of `inputs_within`.
void name_inputs(const Scenario& scenario);

/// Declares every setting of a scenario. The options keep references into it: it must not move after.
void declare(config::Options& options, Scenario& scenario);

/// Reads a scenario file and `section.key=value` overrides. Throws InputError with every problem found, such
/// as (data) files outside of `inputs_within` unless that is empty.
std::unique_ptr<Scenario> read_scenario(const std::filesystem::path& file,
                                        const std::vector<std::string>& overrides,
                                        const std::filesystem::path& inputs_within = {});

/// Whether a run lets the rocks of all return periods fall, for a hazard map.
bool wants_hazard_map(const Scenario& scenario);

/// Whether rocks fall: always today, over years unless run.rockfall_every is 0.
bool has_rocks(const Scenario& scenario);

/// Whether the chosen motion model gives rocks a shape (release.shape).
bool rocks_have_shapes(const Scenario& scenario);

/// Start of the rocks as the rockfall room wants it.
rockfall::StartLaw start_law(const Scenario& scenario);

}  // namespace coupling
