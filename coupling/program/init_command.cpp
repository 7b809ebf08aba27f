#include <iostream>

#include "config/text/shell_word.hpp"
#include "coupling/examples/embedded.hpp"
#include "coupling/program/actions/drawing_layers.hpp"
#include "coupling/program/actions/init.hpp"
#include "coupling/program/commands.hpp"
#include "coupling/program/line/arguments.hpp"
#include "coupling/run/messages.hpp"

namespace coupling {
namespace {

constexpr const char* init_help =
    R"(bannwald init DIR [--example NAME | --from-rockyfor3d FOLDER | --dem FILE ...]

Writes an example project into a new or empty folder, whole or not at all.
  --example NAME        tyrol (default): a real slope of 132 ha, 25 900 artificial trees, a road
                        profile: a synthetic profile, rocks in two dimensions
                        jura: a synthetic gorge road below cliffs, with six soils, nets, return periods
                        forest: a mapped mountain stand grows for a hundred years, without rocks
                        calibrate: the slope of tyrol with SYNTHETIC deposits and scars, for `bannwald calibrate`
                        calibrate-sites: its west and its east with SYNTHETIC deposits, fitted together
                        calibrate-tschamut: the throws of an experiment; two blocks fitted, the third predicted
                        regimes-small: 9 ha under four regimes for thirty years, with rocks
                        regimes: 40 ha under four regimes for a hundred years, ten replicates
                        collapse-small: a SYNTHETIC cliff of 40 m breaks up into about a hundred blocks
                        collapse: a SYNTHETIC cliff of 110 to 140 m, 11 000 blocks; takes half an hour or more
  --from-rockyfor3d FOLDER   instead: a project from the inputs of Rockyfor3D (dem.asc, rockdensity.asc,
                        d1 d2 d3, blshape, soiltype, rg70 rg20 rg10, treefile.txt or nrtrees ...); prints
                        and writes into README.md what became of them and what has no counterpart
  --dem FILE            instead: a project from files of yours, which stay where they are. Prints what is
                        taken for what and marks each guess in scenario.ini. The heights are a grid (GeoTIFF,
                        ESRI ASCII, .flt with .hdr, XYZ), a folder, list or VRT of tiles, points, a mesh or
                        contours (DXF). The others are optional: grids, layers (map.gpkg|roads, .shp, .geojson) or
                        CSV. All options but --trees and --stands may come several times: --targets road.shp --targets
                        houses.gpkg
  --draw                beside --dem: drawing.gpkg with empty layers for what is not given (sources, roads,
                        houses, nets, cable corridors, stands, grounds), and drawing.qgs, which shows them in QGIS
                        over a hillshade. Draw, save, run: layers that are still empty count as not given
  --sources FILE        where rocks break off; without it all cells steeper than 55 * size^-0.075 degrees
  --targets FILE        what is to be protected: roads as lines, houses as polygons
  --trees FILE          a list of trees, a layer of points, or a canopy-height model: a grid of vegetation
                        heights above the ground in cells of 2 m at most, of which tree tops are taken
  --stands FILE         instead: polygons of stands with stand, species and two of stems_pha, basal_area_m2pha,
                        mean_dbh_cm; a row for each species of a stand
  --grounds FILE        ground types as a grid or polygons with codes or names; surface_types.csv then says
                        which shipped type each of them is like
  --nets FILE           rockfall nets that stand already, as lines
  --works FILE          dams, ditches, walls and galleries that stand already: lines or polygons with kind and
                        height_m; `bannwald info inputs works` lists the columns
  --stops FILE          where rocks were seen to rest, for `bannwald calibrate`
  --scars FILE          wounds that were seen on stems: height_m; perhaps x_m, y_m, dbh_cm
  --climate FILE        over years, too: months or days of one place, as services deliver them; beside --trees or
                        --stands. The scenario gets two regimes to edit
  --years N             how many years; without it 40
)";

GivenFiles given_files(const Arguments& arguments) {
    GivenFiles given;
    given.dem = arguments.texts("dem");
    given.sources = arguments.texts("sources");
    given.targets = arguments.texts("targets");
    given.trees = arguments.text("trees");
    given.stands = arguments.text("stands");
    given.grounds = arguments.texts("grounds");
    given.nets = arguments.texts("nets");
    given.works = arguments.texts("works");
    given.stops = arguments.text("stops");
    given.scars = arguments.text("scars");
    given.climate = arguments.text("climate");
    constexpr long long most_years = 1000;  // as run.years
    given.years = static_cast<std::uint32_t>(arguments.whole("years", 1, most_years).value_or(0));
    given.draw = arguments.has("draw");
    if (given.dem.empty() && given.draw) {
        refuse_usage("--draw without --dem", "--dem with the ground heights that are drawn on");
    }
    const bool is_any =
        !(given.sources.empty() && given.targets.empty() && given.trees.empty() && given.stands.empty() &&
          given.grounds.empty() && given.nets.empty() && given.works.empty() && given.stops.empty() &&
          given.scars.empty() && given.climate.empty());
    if (given.dem.empty() && is_any) {
        refuse_usage("files for a project without --dem", "--dem with the ground heights as well");
    }
    if (given.years > 0 && given.climate.empty()) {
        refuse_usage("--years without --climate", "--climate with the weather of some years as well");
    }
    if (!given.climate.empty() && given.trees.empty() && given.stands.empty()) {
        refuse_usage("--climate without a forest", "--trees or --stands with the forest of today as well");
    }
    if (!given.trees.empty() && !given.stands.empty()) {
        refuse_usage("--stands beside --trees", "one of the two: trees that were mapped, or stands");
    }
    if (int{arguments.has("example")} + int{arguments.has("from-rockyfor3d")} + int{arguments.has("dem")} >
        1) {
        refuse_usage("several of --example, --from-rockyfor3d and --dem", "only one of them");
    }
    return given;
}

/// An option that names a file and may come several times.
CommandOption option_with_files(const char* name) {
    return {.name = name, .completion = {Completion::Names::files}, .may_come_again = true};
}

int init(const Arguments& arguments, const Call& call) {
    const std::filesystem::path folder = arguments.only_word();
    const GivenFiles given = given_files(arguments);
    const std::string example = arguments.has("example") ? arguments.text("example") : "tyrol";
    MadeProject made;
    if (!given.dem.empty()) {
        made = write_from_files(folder, given);
    } else if (arguments.has("from-rockyfor3d")) {
        made = write_from_rockyfor3d(folder, arguments.text("from-rockyfor3d"));
    } else {
        write_example(folder, example);
    }
    const std::string scenario = (folder / "scenario.ini").string();
    call.out << scenario << '\n';
    if (!arguments.quiet()) {
        for (const std::string& remark : made.remarks) {
            std::cerr << "- " << remark << '\n';
        }
    }
    print_warnings(made.warnings, arguments.verbose());
    if (!arguments.quiet()) {
        const bool is_calibration =
            example.starts_with("calibrate") || !given.stops.empty() || !given.scars.empty();
        if (given.draw) {
            std::cerr << "next: draw in " << (folder / drawing_map_file).string() << " (QGIS), then\n";
        }
        std::cerr << "next: bannwald "
                  << (example.starts_with("collapse") ? "collapse "
                      : is_calibration                ? "calibrate "
                                                      : "run ")
                  << config::shell_word(scenario) << '\n';
    }
    return static_cast<int>(config::ExitCode::done);
}

}  // namespace

Command init_command() {
    return {
        .name = "init",
        .overview =
            R"(  bannwald init DIR [--example NAME]   writes an example project, ready to run: tyrol, profile, forest,
                                       jura, calibrate, calibrate-sites, calibrate-tschamut,
                                       regimes-small, regimes, collapse-small, collapse
)",
        .help = init_help,
        .argument = "a folder",
        .options = {option_with_value("example", {.words = example_names}),
                    option_with_value("from-rockyfor3d", {Completion::Names::folders}),
                    option_with_files("dem"), option_with_files("sources"), option_with_files("targets"),
                    option_with_value("trees", {Completion::Names::files}),
                    option_with_value("stands", {Completion::Names::files}), option_with_files("grounds"),
                    option_with_files("nets"), option_with_files("works"),
                    option_with_value("stops", {Completion::Names::files}),
                    option_with_value("scars", {Completion::Names::files}),
                    option_with_value("climate", {Completion::Names::files}), option_with_value("years", {}),
                    switch_option("draw")},
        .completion = {Completion::Names::folders},
        .run = init};
}

}  // namespace coupling
