#include "coupling/results/tables/data_dictionary.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "config/table/table.hpp"
#include "config/text/numbers.hpp"
#include "coupling/assessments/decades/decade_layouts.hpp"
#include "coupling/assessments/profile/profile_results.hpp"
#include "coupling/assessments/today/tables.hpp"
#include "coupling/inputs/own_files/own_rows.hpp"
#include "tests/runs/program.hpp"

namespace coupling::data_dictionary_test {
namespace {

namespace fs = std::filesystem;

constexpr const char* what_to_do =
    "A column is declared once, in the TableOf of its table (coupling/results/tables/table_of.hpp); a table "
    "stands in the list of its kind of run: static_layouts, decade_layouts, profile_layouts. Rasters: "
    "raster_kinds() or patch_raster_columns().";

using Columns = std::map<std::string, std::vector<std::string>>;
using Rasters = std::set<std::pair<std::string, std::string>>;

config::Table named_table(const SampleProject& project, const std::string& name) {
    std::istringstream in{project.read(name)};
    return config::Table::read(in, name);
}

/// First lines of all tables of a run.
Columns columns_in_files(const SampleProject& project, const std::string& out) {
    Columns columns;
    for (const auto& entry : fs::directory_iterator{project.file(out) / "tables"}) {
        const std::string name = entry.path().filename().string();
        std::istringstream line{project.read(out + "/tables/" + name)};
        std::string first;
        std::getline(line, first);
        std::istringstream words{first};
        for (std::string word; std::getline(words, word, ',');) {
            columns[name].push_back(word);
        }
    }
    return columns;
}

Columns columns_in_dictionary(const SampleProject& project, const std::string& out) {
    const config::Table dictionary = named_table(project, out + "/tables/data_dictionary.csv");
    Columns columns;
    for (std::size_t row = 0; row < dictionary.rows(); ++row) {
        columns[dictionary.text(row, "table")].push_back(dictionary.text(row, "column"));
        for (const std::string word : {"unit", "meaning", "source"}) {
            EXPECT_FALSE(dictionary.text(row, word).empty()) << dictionary.text(row, "column");
        }
    }
    return columns;
}

Rasters rasters_in_files(const SampleProject& project, const std::string& out) {
    Rasters rasters;
    for (const auto& entry : fs::recursive_directory_iterator{project.file(out) / "rasters"}) {
        if (entry.path().extension() == ".asc") {
            const std::string path = fs::relative(entry.path(), project.file(out)).generic_string();
            rasters.emplace(folder_pattern(path), entry.path().stem().string());
        }
    }
    return rasters;
}

Rasters rasters_in_dictionary(const SampleProject& project, const std::string& out) {
    const config::Table dictionary = named_table(project, out + "/tables/raster_dictionary.csv");
    Rasters rasters;
    for (std::size_t row = 0; row < dictionary.rows(); ++row) {
        rasters.emplace(dictionary.text(row, "folder"), dictionary.text(row, "raster"));
        EXPECT_FALSE(dictionary.text(row, "unit").empty()) << dictionary.text(row, "raster");
    }
    EXPECT_EQ(rasters.size(), dictionary.rows()) << "a raster is described twice";
    return rasters;
}

/// The values of each column are what it is declared to hold: GeoPackage and workbook rely on it.
void expect_values_as_declared(const SampleProject& project, const std::string& out,
                               const std::vector<TableLayout>& layouts) {
    for (const auto& [name, names] : columns_in_files(project, out)) {
        const TableLayout* layout = find_layout(layouts, name);
        if (layout == nullptr) {
            continue;
        }
        const std::string text = project.read(out + "/tables/" + name);
        OwnRows rows{text, name};
        std::set<std::string> others;
        while (rows.next()) {
            for (std::size_t i = 0; i < names.size(); ++i) {
                const std::string field{rows.fields()[i]};
                const Holds holds = layout->columns[i].holds;
                // Words may look like numbers: the classes of nets are "1" to "8".
                const bool fits = field.empty() || holds == Holds::text ||
                                  (holds == Holds::whole ? config::parse_whole(field).has_value()
                                                         : config::parse_number(field).has_value());
                if (!fits) {
                    others.insert(layout->columns[i].name);
                }
            }
        }
        EXPECT_EQ(others, std::set<std::string>{}) << name;
    }
}

/// Every declared table is among those that were written, so that none is declared in vain.
void expect_all_written(const std::vector<TableLayout>& layouts, const Columns& written) {
    for (const TableLayout& layout : layouts) {
        bool found = false;
        for (const auto& [name, columns] : written) {
            found = found || find_layout({layout}, name) != nullptr;
        }
        EXPECT_TRUE(found) << layout.file << " is declared, but no run of this test writes it. "
                           << what_to_do;
    }
}

/// Columns of mesh_left_out.csv, from a run on ground with a roof over a part of it.
Columns columns_of_left_out_faces() {
    const SampleProject project;
    project.write("m.ply",
                  "ply\nformat ascii 1.0\nelement vertex 8\nproperty double x\nproperty double y\n"
                  "property double z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n"
                  "1000 2000 400\n1120 2000 340\n1120 2100 340\n1000 2100 400\n"
                  "1050 2040 390\n1070 2040 380\n1070 2060 380\n1050 2060 390\n"
                  "3 0 1 2\n3 0 2 3\n3 4 5 6\n3 4 6 7\n");
    project.write("sources.csv", "wkt,blocks\nPOINT (1060 2050),5\n");
    project.write("scenario.ini",
                  "[terrain]\nmesh = m.ply\nmesh_overhangs = keep_upper\nground = forest_soil_coarse_debris\n"
                  "[release]\nsource_shapes = sources.csv\n[output]\ncell_size_m = 5\n");
    const Outcome outcome = call(project, "run scenario.ini --quiet --out out");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    const Columns files = columns_in_files(project, "out");
    EXPECT_EQ(columns_in_dictionary(project, "out"), files) << what_to_do;
    return files;
}

/// Columns of forest_bounds.csv, from a run with trees of which only heights are known.
Columns columns_of_forest_bounds() {
    const SampleProject project;
    project.write("tops.csv", "x_m,y_m,species,height_m\n1060,2050,PIAB,18\n1065,2055,PIAB,12\n");
    const Outcome outcome = call(project, "run scenario.ini --quiet --set trees.file=tops.csv --out out");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    const Columns files = columns_in_files(project, "out");
    EXPECT_EQ(columns_in_dictionary(project, "out"), files) << what_to_do;
    return files;
}

/// Columns of path_series.csv and path_means.csv, from a run of blocks with a shape.
Columns columns_of_path_series() {
    const SampleProject project;
    const Outcome outcome = call(project, "run scenario.ini --quiet --set rockfall.motion=rigid --out out");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    const Columns files = columns_in_files(project, "out");
    EXPECT_EQ(columns_in_dictionary(project, "out"), files) << what_to_do;
    expect_values_as_declared(project, "out", static_layouts());
    return files;
}

TEST(DataDictionary, NamesTheColumnsOfTheStaticExample) {
    const SampleProject project;
    ASSERT_EQ(call(project, "init tyrol --quiet").code, 0);
    project.write("tyrol/logs.csv",
                  "log_id,x1_m,y1_m,x2_m,y2_m,species,dbh_cm\nbeam,177700,377500,177712,377510,PIAB,40\n");
    project.write("tyrol/stops.csv", "x_m,y_m\n177700,377500\n");
    project.write("tyrol/passages.csv", "target_id,speed_mps\nroad,8.5\n");
    const Outcome outcome = call(project,
                                 "run tyrol/scenario.ini --quiet --out out --set run.parameter_draws=yes "
                                 "--set trees.logs=logs.csv "
                                 "--set nets.file=nets.csv --set works.file=works.csv --set design.rule=own "
                                 "--set design.freeboard_m=0.5 "
                                 "--set release.rocks_per_source=1 --set output.tree_hit_table=yes "
                                 "--set output.impact_table=yes --set observed.stops=stops.csv "
                                 "--set observed.passages=passages.csv");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const Columns files = columns_in_files(project, "out");
    EXPECT_EQ(columns_in_dictionary(project, "out"), files) << what_to_do;
    EXPECT_EQ(rasters_in_dictionary(project, "out"), rasters_in_files(project, "out")) << what_to_do;
    Columns written = files;
    written.merge(columns_of_left_out_faces());
    written.merge(columns_of_forest_bounds());
    written.merge(columns_of_path_series());
    expect_values_as_declared(project, "out", static_layouts());
    expect_all_written(static_layouts(), written);
    expect_all_written(dictionary_layouts(), files);
}

TEST(DataDictionary, NamesTheColumnsOfACalibration) {
    const SampleProject project;
    std::string stops = "x_m,y_m\n";
    for (int i = 0; i < 20; ++i) {
        stops += std::to_string(1050 + 2 * i) + ",2050\n";
    }
    project.write("stops.csv", stops);
    const Outcome outcome = call(
        project,
        "calibrate scenario.ini --quiet --out out --set observed.stops=stops.csv --set calibrate.sets=50 "
        "--set calibrate.first_sets=64 --set calibrate.most_sets=300 --set calibrate.rocks=50");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(columns_in_dictionary(project, "out"), columns_in_files(project, "out")) << what_to_do;
}

TEST(DataDictionary, NamesTheColumnsOfTheCoupledExample) {
    const SampleProject project;
    ASSERT_EQ(call(project, "init years --example regimes-small --quiet").code, 0);
    project.write(
        "years/road.csv",
        "target_id,wkt,vehicles_per_day,speed_kmph,persons_per_vehicle\nroad,\"LINESTRING (177702 377854, "
        "177761 377869, 177811 377859, 177861 377869, 177960 377894, 177999 377903)\",3000,60,1.6\n");
    const Outcome outcome =
        call(project,
             "run years/scenario.ini --quiet --out out --set run.years=2 --set run.replicates=2 "
             "--set run.rockfall_every=1 "
             "--set release.rocks=300 --set \"regimes.list=none, single_tree_selection\" "
             "--set \"output.map_years=0, 2\" --set climate.variants=climates.csv --set feedback.on=yes "
             "--set disturbance.wind=yes "
             "--set feedback.rocks_per_year=300 --set targets.file=road.csv --set risk.assess=yes "
             "--set risk.currency=EUR");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const Columns files = columns_in_files(project, "out");
    EXPECT_EQ(columns_in_dictionary(project, "out"), files) << what_to_do;
    EXPECT_EQ(rasters_in_dictionary(project, "out"), rasters_in_files(project, "out")) << what_to_do;
    expect_values_as_declared(project, "out", decades::decade_layouts());
    expect_all_written(decades::decade_layouts(), files);
}

TEST(DataDictionary, NamesTheColumnsOfTheProfileExample) {
    const SampleProject project;
    ASSERT_EQ(call(project, "init profile --example profile --quiet").code, 0);
    const Outcome outcome =
        call(project, "run profile/scenario.ini --quiet --out out --set release.rocks=100");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const Columns files = columns_in_files(project, "out");
    EXPECT_EQ(columns_in_dictionary(project, "out"), files) << what_to_do;
    expect_values_as_declared(project, "out", profile::profile_layouts());
    expect_all_written(profile::profile_layouts(), files);
}

TEST(DataDictionary, IsPrintedByTheProgram) {
    const SampleProject project;
    EXPECT_NE(call(project, "info tables").out.find("regimes_by_year.csv"), std::string::npos);
    const Outcome trees = call(project, "info tables trees_30.csv");
    EXPECT_NE(trees.out.find("crown_radius_m"), std::string::npos) << trees.out << trees.err;
    const Outcome wrong = call(project, "info tables targest");
    EXPECT_EQ(wrong.code, 2);
    EXPECT_EQ(wrong.err, "bannwald: found table 'targest', expected 'targets'\n");
}

}  // namespace
}  // namespace coupling::data_dictionary_test
