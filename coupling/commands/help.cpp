#include "coupling/commands/help.hpp"

#include <omp.h>

#include <Eigen/Core>
#include <algorithm>
#include <boost/version.hpp>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include "config/errors/input_error.hpp"
#include "coupling/inputs/collapse_settings.hpp"
#include "coupling/inputs/scenario.hpp"
#include "coupling/run/ranks.hpp"
#include "coupling/validation/forest_cases/comparison.hpp"
#include "coupling/validation/quantities.hpp"
#include "coupling/version.hpp"

namespace coupling {

namespace {

constexpr std::string_view short_help = R"(bannwald - how well a forest protects from rockfall

  bannwald init DIR [--example NAME]   writes an example project, ready to run: tyrol, profile, forest,
                                       jura, regimes-small, regimes, collapse-small, collapse
  bannwald check SCENARIO              reads everything, prints size, memory and time; writes nothing
  bannwald run SCENARIO                simulates rockfall and writes maps, tables and a report
  bannwald merge SCENARIO DIR...       makes results of a run over years out of its shards
  bannwald vary SCENARIO FACTORS.csv   other settings one by one and crossed: which decide the result
  bannwald compare DIR DIR...          puts finished runs side by side, with which differences are significant
  bannwald collapse SCENARIO           simulates a jointed rock mass that breaks up
  bannwald pack DIR                    makes an archive of a finished run that can be cited and repeated
  bannwald verify FILE.zip             checks such an archive; --rerun repeats the run and compares
  bannwald net try DIR --nets FILE     evaluates other nets without another simulation
  bannwald net place DIR --nets FILE   where along a road nets are needed, and which
  bannwald validate [CASE...|all]      holds the model against published experiments and tables
  bannwald stopping-table [RECIPE]     makes stopping probabilities from virtual surfaces
  bannwald info FILE                   prints what a grid or a table holds; `info tables`: what results hold
  bannwald completion bash             prints what lets the Tab key complete commands, options and settings

Everywhere
  --help                               help of a command: bannwald run --help
  --help-all [SECTION]                 every setting of a scenario, or those of a section: --help-all regimes
  --version                            version, and what it was built with
  -q, --quiet                          only errors, and the warnings once at the end of a run
  -v, --verbose                        every warning and problem one by one, every file of the results

A first run
  bannwald init example
  bannwald run example/scenario.ini

)";

constexpr std::string_view exit_codes = R"(Exit codes
  0   done
  1   a fault of the program
  2   usage or settings
  3   a file is missing, unreadable or cannot be written
  4   the data are not plausible
  5   a validation case lies outside its bounds
  75  interrupted: run again to continue
)";

constexpr std::string_view init_help =
    R"(bannwald init DIR [--example NAME | --from-rockyfor3d FOLDER | --dem FILE ...]

Writes an example project into a new or empty folder, whole or not at all.
  --example NAME        tyrol (default): a real slope of 132 ha, 25 900 artificial trees, a road
                        profile: a synthetic profile, rocks in two dimensions
                        jura: a synthetic gorge road below cliffs, with six soils, nets, return periods
                        forest: a mapped mountain stand grows for a hundred years, without rocks
                        regimes-small: 9 ha under four regimes for thirty years, with rocks
                        regimes: 40 ha under four regimes for a hundred years, ten replicates
                        collapse-small: a SYNTHETIC cliff of 40 m breaks up into about a hundred blocks
                        collapse: a SYNTHETIC cliff of 110 to 140 m, 11 000 blocks; takes half an hour or more
  --from-rockyfor3d FOLDER   instead: a project from the inputs of Rockyfor3D (dem.asc, rockdensity.asc,
                        d1 d2 d3, blshape, soiltype, rg70 rg20 rg10, treefile.txt or nrtrees ...); prints
                        and writes into README.md what became of them and what has no counterpart
  --dem FILE            instead: a project from files of yours, which stay where they are. Prints what is
                        taken for what and marks each guess in scenario.ini. The heights are a grid, GeoTIFF
                        or ESRI ASCII; the others are optional: grids, layers (map.gpkg|roads, .shp, .geojson)
                        or CSV
  --sources FILE        where rocks break off; without it all cells steeper than 55 * size^-0.075 degrees
  --targets FILE        what is to be protected: roads as lines, houses as polygons
  --trees FILE          a list of trees or a layer of points
  --grounds FILE        ground types as a grid or polygons with codes
)";

constexpr std::string_view scenario_options = R"(  --set section.key=value   changes a setting; again for more
  --seed N                  the same as --set run.seed=N
)";

constexpr std::string_view threads_option =
    R"(  --threads N               threads to use; results do not depend on it (default: all of the machine)
)";

constexpr std::string_view check_help = R"(bannwald check SCENARIO [options]

Reads all files of a scenario and lists every problem; prints how large the run is. Writes nothing but the page.
  --page FILE               of a run over years: where its regimes act, as a page with maps (HTML)
  --overwrite               replaces that page if it is there
  --print-settings          every setting with value, unit, default and source
)";

constexpr std::string_view run_help = R"(bannwald run SCENARIO [options]

Simulates rockfall over the slope with its forest and over the bare slope, and writes the results.
With terrain.profile = FILE they fall along a profile in two dimensions instead. With run.years above 0 a forest
grows, is managed, and the rocks fall again year after year.
Interrupted by Ctrl-C it keeps finished parts; the same call continues from there.
  --out DIR                 folder of the results (default: out beside the scenario)
  --overwrite               replaces results or parts that the folder holds
  --shard i/n               of a run over years: simulates only each n-th member (regime and replicate), from the i-th on,
                            and keeps its part; shards may share a folder, the call without --shard then makes the results
Started by `mpirun -n N bannwald run ...` the N processes share the members of a run over years.
)";

constexpr std::string_view merge_help = R"(bannwald merge SCENARIO DIR... [options]

Takes the parts that shards of a run over years left in their folders and makes the results.
The scenario and its settings have to be those of the shards.
  --out DIR                 folder of the results (default: out beside the scenario)
  --overwrite               replaces results or parts that the folder holds
)";

constexpr std::string_view compare_help = R"(bannwald compare DIR DIR... [options]

Puts two or more finished runs side by side: today's protection with today's, or years with years. Shows for each
target the share of rocks that the forest stops, how many arrive and with which energy, with intervals; for runs
over years the means over the years and the worst year of each regime. Tells which settings and inputs differ,
whether a difference to the first run is more than chance, and when runs cannot be compared because their terrain,
targets or rocks differ.
  --out FILE                writes the comparison as a table (CSV) too
  --page FILE               writes it as a page (HTML) too, with distributions and maps of the runs side by side
  --language de             of the page: en, de, fr or it (default: that of the first run)
  --overwrite               replaces these files if they are there
  -q, --quiet               nothing on the screen
)";

constexpr std::string_view vary_help = R"(bannwald vary SCENARIO FACTORS.csv --out DIR [options]

Lets the rocks of a scenario of today fall again and again with other settings, the same rocks as far as the
settings leave them the same, and shows which settings decide the result: a page with a tornado chart for each target,
and all runs as vary.csv. FACTORS.csv has a row a setting:
  setting,values,how
  tree_impact.taper,yes no,alone                   each value alone, all else as in the scenario
  release.diameter_m,0.5 1.0,crossed               with each value of all other crossed settings
With run.years above 0 the chart is about the paired difference of the regimes, and the page says which settings
change their ranking. Any setting may vary, files too: trees.file, terrain.dem; ground.pasture.r_t is a value of a ground type.
  --out DIR                 folder of vary.csv and report.html
  --overwrite               replaces a study that the folder holds
)";

constexpr std::string_view collapse_help = R"(bannwald collapse SCENARIO [options]

Simulates how a jointed rock mass breaks up, runs down the slope and comes to rest: convex blocks between joints or
Voronoi cells, joined by bonds that break. The section [collapse] of the scenario says which rock, which joints and
how strong; terrain, trees and targets are those of any scenario. Writes energies over time with their residual, maps,
tables, a page and, with output.vtp = yes, a series for ParaView. `bannwald check SCENARIO` prints blocks, steps,
memory and time beforehand. Interrupted by Ctrl-C after the first frame it keeps its last state; the same call
continues from there. Without --threads small masses run on fewer threads than the machine has.
  --out DIR                 folder of the results (default: out beside the scenario)
  --overwrite               replaces results or parts that the folder holds
)";

constexpr std::string_view pack_help = R"(bannwald pack DIR [options]

Puts a finished run into a zip file that can be cited and repeated: scenario, all inputs, all results, version and
commit of the program, the command, SHA-256 of every file, descriptions by RO-Crate 1.1 and DataCite 4. Inputs and
settings have to be those of the run still. The same folder gives the same bytes. Inputs from outside of the folder
of the scenario come into the folder `outside` of the archive, and the packed scenario names them there.
  --out FILE                the archive (default: DIR.zip)
  --scenario FILE           the scenario of the run (default: the file of its name beside DIR)
  --set section.key=value   where the run got a file from outside of the project folder by --set: the same again,
                            as results hold no paths
  --title TEXT              what the archive is called
  --creator NAME            who made it; again for more
  --licence NAME            of inputs and results, such as CC-BY-4.0
  --date YYYY-MM-DD         when it was made (default: the day on which the run ended)
  --overwrite               replaces an archive of that name
)";

constexpr std::string_view verify_help = R"(bannwald verify FILE.zip [options]

Reads every file of an archive of `bannwald pack` and compares its SHA-256 with the list in the archive. Ends with
exit code 4 if anything is damaged, missing or added.
  --rerun                   repeats the run with this program and compares every file of its results; ends with exit
                            code 5 if one differs, with 4 if the run would read a file outside of the archive
  --out DIR                 folder of the repeated run (default: FILE-rerun); stays
)";

constexpr std::string_view completion_help = R"help(bannwald completion bash

Prints a script for the shell bash: the Tab key then completes commands, options, examples, settings and files.
For this session:       eval "$(bannwald completion bash)"
For all to come:        bannwald completion bash > ~/.local/share/bash-completion/completions/bannwald
)help";

constexpr std::string_view validate_help = R"(bannwald validate [CASE...|all] [options]

Lets the rocks of published experiments fall with the settings of the paper (strict) and with ours (default),
prints every figure beside what was observed and published, and says which criteria are met. Cases forest_... hold
parts of the forest model against other programs and tables; they have one set of settings (default).
Ends with exit code 5 if strict or default misses a criterion of any case, with 0 otherwise.
  --list                    the cases, one a line
  --out DIR                 folder of report.html, summary.md and the tables (default: validation-results)
  --overwrite               replaces results that the folder holds
  --cases DIR               cases of this folder instead of the built-in ones
  --profile FILE            takes the place of the profile of the one case named: a surveyed slope
  --rocks N                 rocks of the large ensemble; series and moved choices shrink with it. It and settings
                            of rocks change nothing in a case of the forest, which says so
  --set section.key=value   changes a setting of case.ini, [rockfall] or [tree_impact]; again for more. Those of
                            cases of the forest: `bannwald --help-all light`, also remeasured, yield, belts
  --seed N                  the same as --set series.seed=N
  --threads N               threads to use; results do not depend on it (default: all of the machine)
)";

constexpr std::string_view stopping_table_help = R"(bannwald stopping-table [RECIPE.csv] --out DIR [options]

Lays blocks on virtual surfaces as the recipe describes them (default: the shipped ground types), throws
rocks at them and writes stopping.csv: the chance that an impact stops a rock, by surface and diameter, with
standard errors. A recipe with a column `code` makes a table for terrain.stopping of a scenario.
`bannwald info stopping_recipe` prints the shipped recipe, to be changed.
  --out DIR                 folder of stopping.csv and the pictures
  --surface NAME            only this surface of the recipe; again for more
  --diameters 0.5,1,2       diameters of the rocks, m
  --throws N                throws of each diameter at each surface (default: 20000)
  --surfaces N              surfaces of each description, all different (default: 32)
  --seed N                  other random numbers (default: 1)
  --threads N               threads to use; results do not depend on it (default: all of the machine)
  --pictures                draws the first surface of each description (SVG) and its triangles (PLY)
  --overwrite               replaces a table and pictures that the folder holds
)";

constexpr std::string_view net_help = R"(bannwald net try DIR --nets FILE

Looks at the nets of a table (as nets.file of a scenario) with the paths that a run with nets.keep_paths = yes
has stored in DIR/net_paths.bin, and writes nets.csv, net_needs.csv and net_crossings.csv of them. Paths are
those of a slope without nets: what nets hold or let pass is that of a run with them, row by row. Behind a net
that a rock breaks nothing is known: these rocks stand in net_inexact.csv, and inexact_rocks counts those that
may reach a net.
  --nets FILE           table of nets
  --out DIR             folder of the tables (default: DIR/net_try)
  --overwrite           replaces tables that the folder holds

bannwald net place DIR --nets FILE [--distances 0,10,20] [--azimuth 270]

Says where along lines to protect, such as a road, nets are needed, and which: stretches, candidates upslope
of them with energy class, height and length, and what is left below. FILE is a table or layer of lines as it
is (targets.csv, roads.gpkg|layer, roads.shp); nothing about nets needs to stand in it. Writes report.html with
map and curve, net_stretches.csv, net_candidates.csv, net_along.csv, net_place.gpkg, and nets.csv with the best
net of each stretch, ready for nets.file.
With columns of nets (height_m, capacity_kj or class) the net of each line is also moved upslope as a whole:
net_places.csv says for each place which rocks it would keep from the line, and nets.csv has the best place.
  --nets FILE           table or layer of lines to protect
  --distances 0,10,20   in plan, m (default: 10 to 150 in steps of 10)
  --azimuth DEG         the way upslope, clockwise from north (default: against the mean direction of the
                        rocks that reach the line; where none does, along the gradient of the ground)
  --out DIR             folder of the results (default: DIR/net_place)
  --overwrite           replaces files that the folder holds
)";

constexpr std::string_view info_help = R"(bannwald info FILE
bannwald info tables [TABLE]

Tells what an ESRI ASCII grid (frame, range, NODATA, projection) or a CSV table (columns, rows, units)
holds. The name of a shipped table prints that table:
  bannwald info surfaces           ground types with restitution
  bannwald info stopping           their stopping probabilities by rock diameter
  bannwald info pir3d_soils        soils of the ground types, for motion models that use them
  bannwald info rigid_grounds      classes of ground for models whose rocks have a shape
  bannwald info net_classes        energy classes of rockfall nets
  bannwald info hazard_matrix      hazard levels by energy and return period
  bannwald info tree_resistance    species with the energy they take
  bannwald info timber_prices      what wood brings and costs; also work_costs
  bannwald info regimes            names of the shipped regimes and the columns of a regime
The tables that a run writes, with unit, meaning and source of every column:
  bannwald info tables             all of them
  bannwald info tables targets     the columns of targets.csv
)";

/// Declares every setting that a scenario file may have: those of all kinds of run.
void declare_all(config::Options& options, Scenario& scenario, collapse::CollapseSettings& of_collapse) {
    declare(options, scenario);
    collapse::declare(options, of_collapse);
}

/// Calls `use` with the settings of each kind of case of the forest, and the sections that only case.ini has.
template <class Use>
void for_each_kind_of_forest_case(const Use& use) {
    using validation::CaseKind;
    for (const auto& [kind, section] :
         {std::pair{CaseKind::forest_light, "light"}, std::pair{CaseKind::forest_yield, "yield"},
          std::pair{CaseKind::forest_belts, "belts"}, std::pair{CaseKind::forest_demography, "demography"},
          std::pair{CaseKind::forest_remeasured, "remeasured"}}) {
        validation::forest_cases::Settings settings;
        config::Options options;
        validation::forest_cases::declare(options, settings, kind);
        use(options, section);
    }
}

/// Settings of a section, which may stand in brackets.
void write_help_of_section(std::ostream& out, std::string section) {
    if (section.starts_with('[') && section.ends_with(']')) {
        section = section.substr(1, section.size() - 2);
    }
    Scenario scenario;
    collapse::CollapseSettings of_collapse;
    config::Options options;
    declare_all(options, scenario, of_collapse);
    std::vector<std::string> sections;
    for (const config::ParameterRow& row : options.rows()) {
        sections.push_back(row.key.substr(0, row.key.rfind('.')));
    }
    bool is_of_a_case = false;
    for_each_kind_of_forest_case([&](const config::Options& of_case, const std::string& own) {
        sections.push_back(own);
        if (own == section) {
            of_case.write_help(out, section);
            is_of_a_case = true;
        }
    });
    if (is_of_a_case) {
        return;
    }
    if (std::find(sections.begin(), sections.end(), section) == sections.end()) {
        sections.erase(std::unique(sections.begin(), sections.end()), sections.end());
        const std::string nearest = config::nearest_word(section, sections);
        std::string all;
        for (const std::string& name : sections) {
            all += (all.empty() ? "" : ", ") + name;
        }
        config::fail(config::ExitCode::settings, {}, "section " + config::in_quotes(section),
                     nearest.empty() ? "one of " + all : config::in_quotes(nearest));
    }
    options.write_help(out, section);
}

}  // namespace

void write_help(std::ostream& out, const std::string& command) {
    const std::map<std::string, std::string_view> texts{
        {"init", init_help},         {"check", check_help},
        {"run", run_help},           {"merge", merge_help},
        {"compare", compare_help},   {"completion", completion_help},
        {"vary", vary_help},         {"collapse", collapse_help},
        {"pack", pack_help},         {"verify", verify_help},
        {"validate", validate_help}, {"stopping-table", stopping_table_help},
        {"info", info_help},         {"net", net_help}};
    const auto text = texts.find(command);
    if (text == texts.end()) {
        out << short_help << exit_codes;
        return;
    }
    out << text->second;
    if (command == "check" || command == "run" || command == "merge" || command == "vary" ||
        command == "collapse") {
        out << scenario_options;
    }
    if (command == "check" || command == "run" || command == "vary" || command == "collapse" ||
        command == "verify") {
        out << threads_option;
    }
    if (command == "validate") {
        out << "\nFigures that a case may observe, publish or set a criterion for; with a stand also "
               "open.FIGURE (bare\nslope) and reduction.FIGURE (1 - forest / open):\n";
        validation::write_quantities(out);
    }
}

void write_help_all(std::ostream& out, std::string section) {
    if (!section.empty()) {
        write_help_of_section(out, std::move(section));
        return;
    }
    out << short_help;
    for (const std::string_view text :
         {init_help, check_help, run_help, threads_option, merge_help, scenario_options, compare_help,
          vary_help, collapse_help, pack_help, verify_help, net_help, validate_help, stopping_table_help,
          info_help, completion_help}) {
        out << text << '\n';
    }
    out << exit_codes << "\nSettings of a scenario file\n\n";
    Scenario scenario;
    collapse::CollapseSettings of_collapse;
    config::Options options;
    declare_all(options, scenario, of_collapse);
    options.write_help(out);
    out << "\nSettings of case.ini of the forest (bannwald validate); its sections [forest] and "
           "[disturbance] "
           "are those above\n\n";
    for_each_kind_of_forest_case(
        [&](const config::Options& of_case, const std::string& own) { of_case.write_help(out, own); });
}

void write_version(std::ostream& out) {
    out << "bannwald " << version();
    if (!commit().empty()) {
        out << " (" << commit() << ')';
    }
    out << "\nbuilt with " << BANNWALD_COMPILER << "; CGAL " << BANNWALD_CGAL << ", Eigen "
        << EIGEN_WORLD_VERSION << '.' << EIGEN_MAJOR_VERSION << '.' << EIGEN_MINOR_VERSION << ", Boost "
        << BOOST_VERSION / 100000 << '.' << BOOST_VERSION / 100 % 1000 << ", OpenMP " << _OPENMP << ", "
        << mpi_in_words() << "\nlicence GPL-3.0-or-later; no warranty, to the extent permitted by law\n";
}

}  // namespace coupling
