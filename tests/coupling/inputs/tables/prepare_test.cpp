#include "coupling/inputs/tables/prepare.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <random>

#include "config/text/numbers.hpp"
#include "tests/coupling/inputs/opened.hpp"

namespace coupling::tables_test {
namespace {

/// Every table that users hand over, with the columns that its reader knows.
const std::map<std::string, std::vector<std::string>>& all_tables() {
    static const std::map<std::string, std::vector<std::string>> tables{
        {"trees",
         {"tree_id", "x_m", "y_m", "species", "dbh_cm", "height_m", "age_years", "state", "strength",
          "broken_at_m"}},
        {"logs",
         {"log_id", "species", "x1_m", "y1_m", "x2_m", "y2_m", "dbh_cm", "diameter1_cm", "diameter2_cm",
          "length_m", "azimuth_deg", "clearance_m", "strength", "anchored"}},
        {"targets", {"target_id", "name", "wkt"}},
        {"nets", {"name", "height_m", "capacity_kj", "class", "gap_m", "wkt"}},
        {"source_shapes",
         {"wkt", "zone", "blocks", "speed_mps", "azimuth_deg", "fall_height_m", "diameter_m", "mass_t",
          "volume_m3", "density_kgpm3", "shape", "side_a_m", "side_b_m", "side_c_m", "sides_scatter",
          "shape_file"}},
        {"observed_stops", {"x_m", "y_m", "zone", "group", "x_release_m", "y_release_m"}},
        {"observed_passages",
         {"target_id", "speed_mps", "height_m", "energy_kj", "translational_kj", "group"}},
        {"observed_impacts",
         {"speed_in_mps", "speed_out_mps", "angle_in_deg", "angle_out_deg", "ground", "x_m", "y_m", "track",
          "group"}},
        {"surface_polygons", {"code", "wkt"}},
        {"surface_types",
         {"code", "label", "r_n", "r_t", "p_stop", "rolling_stops_per_m", "rolling_friction",
          "sliding_friction", "jump_angle_factor", "like", "soil", "rigid_ground"}},
        {"soils", {"name", "r_n", "r_t", "friction", "like"}},
        {"stopping", {"code", "diameter_m", "p_stop", "rolling_stops_per_m"}},
        {"slope_grounds", {"from_deg", "surface"}},
        {"meshes", {"file", "surface"}},
        {"mesh", {"wkt", "height_m"}},
        {"profile", {"distance_m", "height_m", "surface"}},
        {"stations", {"name", "distance_m"}},
        {"stands", {"stand", "wkt"}},
        {"stand_records",
         {"stand", "species", "stems_pha", "basal_area_m2pha", "mean_dbh_cm", "mean_height_m", "age_years",
          "structure"}},
        {"tree_area", {"wkt"}},
        {"dead_wood",
         {"stand", "species", "kind", "volume_m3pha", "dbh_cm", "length_m", "decay_class", "log_angle_deg",
          "anchored"}},
        {"saplings",
         {"stand", "species", "stems_pha", "height_m", "height_class", "age_years", "browsed_percent"}},
        {"dbh_classes",
         {"stand", "species", "dbh_from_cm", "dbh_to_cm", "stems_pha", "height_m", "age_years"}},
        {"target_profile", {"stand", "site_type", "hazard", "criterion", "minimal", "ideal"}},
        {"soil_types",
         {"code", "water_capacity_mm", "texture_class", "fertility", "nitrogen_kg_per_ha_year", "ph"}},
        {"climate",
         {"year", "month", "tmin_c", "tmax_c", "tave_c", "prec_mm", "rad_mj_m2_d", "vpd_kpa", "frost_days",
          "gdd55_c_d", "abs_tmin_c", "elev_m"}},
        {"climate_change", {"month", "temperature_k", "precipitation"}},
        {"climates",
         {"name", "file", "elevation_m", "window_first_year", "window_last_year", "change",
          "temperature_change_k", "precipitation_change", "change_years", "co2_ppm"}},
        {"return_periods",
         {"return_period_years", "zone", "blocks", "diameter_m", "mass_t", "volume_m3", "density_kgpm3",
          "speed_mps", "azimuth_deg", "fall_height_m"}},
        {"joint_sets", {"dip_deg", "dip_direction_deg", "spacing_m"}}};
    return tables;
}

/// How people write units in headers.
std::string unit_in_brackets(const std::string& unit) {
    static const std::map<std::string, std::string> written{
        {"c", "°C"},        {"deg", "°"},         {"mps", "m/s"},     {"kgpm3", "kg/m³"},
        {"m2pha", "m²/ha"}, {"pha", "1/ha"},      {"m3pha", "m3/ha"}, {"years", "a"},
        {"percent", "%"},   {"mjm2d", "MJ/m2/d"}, {"k", "K"}};
    const auto found = written.find(unit);
    return found == written.end() ? unit : found->second;
}

/// A column as somebody else may write it: capitals, other signs between words, the unit in brackets.
std::string written_otherwise(const std::string& column, std::mt19937& random) {
    const config::ColumnForm form = config::form_of(column);
    std::string name = column;
    std::string unit;
    if (!form.unit.empty() && random() % 2 == 0) {
        // What is left without the unit still has the letters of the quantity.
        while (config::form_of(name).letters != form.quantity) {
            name.pop_back();
        }
        while (!name.empty() && name.back() == '_') {
            name.pop_back();
        }
        unit = random() % 2 == 0 ? " [" + unit_in_brackets(form.unit) + "]"
                                 : " (" + unit_in_brackets(form.unit) + ")";
    }
    constexpr std::string_view between = "_ .-";
    for (char& c : name) {
        if (c == '_') {
            c = between[random() % between.size()];
        } else if (random() % 2 == 0) {
            c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
        }
    }
    return name + unit;
}

TEST(Prepare, GivesTheSameTableWhateverTheFormOfItsHeader) {
    std::mt19937 random{38};
    for (int trial = 0; trial < 20; ++trial) {
        for (const auto& [role, columns] : all_tables()) {
            std::string header = "";
            std::string row = "";
            const bool has_row_names = random() % 3 == 0;
            if (has_row_names) {
                header = "\"\";";
                row = "1;";
            }
            std::vector<std::string> written;
            for (std::size_t i = 0; i < columns.size(); ++i) {
                written.push_back(written_otherwise(columns[i], random));
                header += (i == 0 ? "\"" : ";\"") + written.back() + "\"";
                // Shapes have to be shapes, and coordinates numbers.
                row += (i == 0 ? "" : ";") + (columns[i] == "wkt" ? "POINT (1 2)" : std::to_string(100 + i));
            }
            config::Table table = config::Table::read(std::string_view{header + "\n" + row + "\n"}, "t.csv",
                                                      config::FirstColumn::may_lack_name);
            const tables::Findings findings = tables::prepare(table, role, false);
            EXPECT_TRUE(findings.errors.empty()) << role << ": " << header;
            EXPECT_EQ(findings.notes.size(), has_row_names ? 1U : 0U) << role << ": " << header;
            for (std::size_t i = 0; i < columns.size(); ++i) {
                ASSERT_TRUE(table.has(columns[i])) << role << ", " << columns[i] << " in " << header;
                EXPECT_EQ(table.text(0, columns[i]),
                          columns[i] == "wkt" ? "POINT (1 2)" : std::to_string(100 + i))
                    << role << ": " << header;
            }
            const tables::Findings use = tables::findings_of_use(*table.use());
            EXPECT_TRUE(use.notes.empty()) << use.notes.front();
            EXPECT_TRUE(use.errors.empty());
        }
    }
}

TEST(Prepare, NamesEachColumnThatNobodyReadsOnce) {
    for (const auto& [role, columns] : all_tables()) {
        std::string header;
        std::string row;
        for (const std::string& column : columns) {
            header += column + ",";
            row += (column == "wkt" ? "POINT (1 2)" : "1") + std::string{","};
        }
        config::Table table =
            config::Table::read(std::string_view{header + "qwxyz,Other [kg]\n" + row + "1,2\n"}, "t.csv");
        tables::prepare(table, role, false);
        for (const std::string& column : columns) {
            EXPECT_TRUE(table.has(column));
        }
        const tables::Findings use = tables::findings_of_use(*table.use());
        EXPECT_EQ(use.notes,
                  std::vector<std::string>{"t.csv: columns that are not read: 'qwxyz', 'Other [kg]'"})
            << role;
    }
}

TEST(Prepare, ConvertsOrRefusesEachColumnInAnotherUnit) {
    std::size_t converted = 0;
    for (const auto& [role, columns] : all_tables()) {
        for (const std::string& column : columns) {
            const config::ColumnForm form = config::form_of(column);
            if (form.unit != "m" && form.unit != "cm") {
                continue;
            }
            const std::string name = column.substr(0, column.size() - form.unit.size()) + "ft";
            config::Table table = config::Table::read(std::string_view{name + "\n10\n"}, "t.csv");
            const tables::Findings findings = tables::prepare(table, role, false);
            EXPECT_TRUE(findings.errors.empty());
            const bool is_ours = table.has(column);
            const std::size_t errors = tables::findings_of_use(*table.use()).errors.size();
            EXPECT_EQ(errors, is_ours ? 0U : 1U) << role << ": " << name;
            if (is_ours) {
                ++converted;
                EXPECT_EQ(table.text(0, column), form.unit == "m" ? "3.048" : "304.8")
                    << role << ": " << name;
                ASSERT_EQ(findings.notes.size(), 1U);
                EXPECT_NE(findings.notes[0].find("numbers in other units: " + column + " = '" + name + "'"),
                          std::string::npos);
            }
        }
    }
    EXPECT_GT(converted, 10U);
}

TEST(Prepare, ReadsWhatSaysThatThereIsNoValueAsEmpty) {
    config::Table table = config::Table::read(
        std::string_view{"name,dbh_cm,height_m\nNA,1,NA\n-,#N/A,n/a\nc,#NV,-\nd,-3,4\n"}, "t.csv");
    const tables::Findings findings = tables::prepare(table, "trees", false);
    ASSERT_EQ(findings.notes.size(), 1U);
    EXPECT_EQ(findings.notes[0], "t.csv: 5 fields with '#N/A', '#NV', '-', 'NA', 'n/a' read as empty");
    EXPECT_EQ(table.text(0, "name"), "NA");  // a name is what it is
    EXPECT_EQ(table.text(0, "height_m"), "");
    EXPECT_EQ(table.text(3, "dbh_cm"), "-3");
    config::Problems problems;
    table.number(1, "dbh_cm", {}, problems);
    EXPECT_EQ(config::to_string(problems.list()[0]), "t.csv:3:3: found dbh_cm '#N/A', expected a number");
}

config::Table layer_of(std::vector<std::vector<std::string>> cells) {
    config::Features features{
        .file = "roads.gpkg", .columns = {"id", "wkt"}, .cells = std::move(cells), .numbers = {}};
    for (std::size_t i = 0; i < features.cells.size(); ++i) {
        features.numbers.push_back(static_cast<std::uint32_t>(i + 1));
    }
    return config::Table::of(std::move(features));
}

TEST(Prepare, LeavesFeaturesWithoutAShapeOutAndSaysWhich) {
    config::Table table = layer_of({{"a", "LINESTRING (1 2, 3 4)"}, {"b", ""}, {"c", "LINESTRING EMPTY"}});
    const tables::Findings findings = tables::prepare(table, "targets", true);
    ASSERT_EQ(findings.warnings.size(), 1U);
    EXPECT_EQ(
        config::to_string(findings.warnings[0]),
        "roads.gpkg: found features 2, 3 without a shape: left out, expected a shape in each row; draw the "
        "shape, or delete the row");
    ASSERT_EQ(table.rows(), 1U);
    EXPECT_EQ(table.text(0, "target_id"), "a");
}

TEST(Prepare, NumbersTargetsWithoutAnId) {
    config::Table empty = layer_of({{"", "POINT (1 2)"}, {"", "POINT (1 2)"}});
    EXPECT_EQ(tables::prepare(empty, "targets", true).notes,
              std::vector<std::string>{
                  "roads.gpkg: 2 rows without target_id: the numbers of the features are taken"});
    EXPECT_EQ(empty.text(1, "target_id"), "2");
    config::Table one = layer_of({{"2", "POINT (1 2)"}, {"", "POINT (1 2)"}});
    tables::prepare(one, "targets", true);
    EXPECT_EQ(one.text(1, "target_id"), "feature_2");  // 2 is taken
}

TEST(Prepare, MakesPointsOfXAndY) {
    config::Table table = config::Table::read(std::string_view{"Easting;Northing;id\n1,5;2;a\n"}, "t.csv");
    tables::prepare(table, "targets", false);
    EXPECT_EQ(table.text(0, "wkt"), "POINT (1.5 2)");
    config::Table wrong = config::Table::read(std::string_view{"x,y\n1,two\n"}, "t.csv");
    EXPECT_THROW(tables::prepare(wrong, "source_shapes", false), config::InputError);
}

TEST(OpenSite, ReadsTablesAsROrASpreadsheetWriteThem) {
    const SampleProject project;
    project.write(
        "trees.csv",
        "\"\";\"Baum-Nr\";\"X [m]\";\"Y [m]\";\"Baumart\";\"BHD [cm]\";\"Höhe [m]\";\"Bemerkung\"\n"
        "1;1;1060;2050;ABAL;32,5;25;a\n2;2;1070;2042;piab;20;18;b\n3;3;1080;2061;Fagus sylvatica;41;28;c\n");
    const SampleProject plain;
    const Opened other = open(project);
    ASSERT_TRUE(other.site) << other.errors;
    const Opened usual = open(plain);
    ASSERT_EQ(other.site->trees.size(), usual.site->trees.size());
    for (std::size_t i = 0; i < usual.site->trees.size(); ++i) {
        EXPECT_EQ(other.site->trees[i].id, usual.site->trees[i].id);
        EXPECT_EQ(other.site->trees[i].stem.x_m, usual.site->trees[i].stem.x_m);
        EXPECT_EQ(other.site->trees[i].stem.dbh_cm, usual.site->trees[i].stem.dbh_cm);
        EXPECT_EQ(other.site->trees[i].stem.height_m, usual.site->trees[i].stem.height_m);
    }
    const auto count = [&](const std::string& part) {
        return std::count_if(other.warnings.begin(), other.warnings.end(), [&](const std::string& sentence) {
            return sentence.find(part) != std::string::npos;
        });
    };
    EXPECT_EQ(count("'Bemerkung'"), 1);
    EXPECT_EQ(count("'BHD [cm]' = dbh_cm, 'Höhe [m]' = height_m"), 1);
    EXPECT_EQ(count("the first column has no name"), 1);
}

TEST(OpenSite, KeepsEveryTextOfANameAsItStands) {
    const std::vector<std::string> names{
        "Gasthof \"Post\"", "a, b; c", "Straße\nnach Süden", "  blanks  ", "'single'", "=x", "NA", "-", "#1",
        "Été à l’Alpe"};
    for (const std::string& name : names) {
        const SampleProject project;
        project.write("targets.csv", "target_id,name,wkt\n" + config::csv_field(name) + "," +
                                         config::csv_field(name) +
                                         ",\"LINESTRING (1105 2010, 1105 2090)\"\n");
        const Opened opened = open(project);
        ASSERT_TRUE(opened.site) << opened.errors;
        EXPECT_EQ(opened.site->targets[0].id, name);
        EXPECT_EQ(opened.site->targets[0].name, name);
    }
}

// Exports of cruises and spreadsheets repeat columns; what nobody reads may stand twice.
TEST(RepeatedColumns, AreRefusedOnlyWhereTheyAreRead) {
    const auto findings_of = [](const char* text, const char* read) {
        config::Table table =
            config::Table::read(std::string_view{text}, "file", config::FirstColumn::may_lack_name);
        tables::prepare(table, "trees", false);
        static_cast<void>(table.text(0, read));
        static_cast<void>(table.has(read));
        return tables::findings_of_use(*table.use());
    };
    const char* repeated = "x_m,Log Grade,dbh_cm,Log Grade,Log Grade\n1,a,30,b,c\n";
    EXPECT_TRUE(findings_of(repeated, "dbh_cm").errors.empty());
    const tables::Findings read = findings_of("x_m,dbh_cm,dbh_cm\n1,30,3\n", "dbh_cm");
    ASSERT_EQ(read.errors.size(), 1U);
    EXPECT_EQ(read.errors[0].found, "column 'dbh_cm' a second time");
    EXPECT_THROW(config::Table::read(std::string_view{"a,a\n1,2\n"}, "shipped"), config::InputError);
}

}  // namespace
}  // namespace coupling::tables_test
