#include "coupling/inputs/formats/column_names.hpp"

#include <gtest/gtest.h>

#include <tuple>
#include <utility>
#include <vector>

#include "config/text/numbers.hpp"

namespace coupling::column_names_test {
namespace {

using formats::name_columns;

config::Table named(const std::string& text, const std::string& role) {
    config::Table table = config::Table::read(std::string_view{text}, "file");
    name_columns(table, role);
    return table;
}

TEST(NameColumns, KnowsTheWordsOfOtherLanguages) {
    EXPECT_EQ(named("Nr;Rechtswert;Hochwert;Baumart;BHD;Höhe\n1;2;3;Fi;30;20\n", "trees").columns(),
              (std::vector<std::string>{"tree_id", "x_m", "y_m", "species", "dbh_cm", "height_m"}));
    EXPECT_EQ(named("numero;est;nord;essence;dhp;hauteur\n1;2;3;Fi;30;20\n", "trees").columns(),
              (std::vector<std::string>{"tree_id", "x_m", "y_m", "species", "dbh_cm", "height_m"}));
    EXPECT_EQ(named("WKT,id,bezeichnung\na,b,c\n", "targets").columns(),
              (std::vector<std::string>{"wkt", "target_id", "name"}));
}

TEST(NameColumns, LeavesOurOwnNamesAlone) {
    // `id` stays what it is where target_id is there, and `name` is a column of ours.
    EXPECT_EQ(named("target_id,id,name,wkt\na,b,c,d\n", "targets").columns(),
              (std::vector<std::string>{"target_id", "id", "name", "wkt"}));
    EXPECT_EQ(named("bhd,x_m\n1,2\n", "climates").columns(), (std::vector<std::string>{"bhd", "x_m"}));
}

TEST(NameColumns, KnowsNamesThatAShapefileCutOff) {
    EXPECT_EQ(named("clearance_,diameter1_,SPECIES\n1,2,3\n", "logs").columns(),
              (std::vector<std::string>{"clearance_m", "diameter1_cm", "species"}));
}

TEST(NameColumns, ReadsHeadersWithUnits) {
    const std::vector<std::string> trees{"tree_id", "x_m", "y_m", "species", "dbh_cm", "height_m"};
    EXPECT_EQ(named("Baum-Nr;X [m];Y [m];Baumart;BHD [cm];Höhe [m]\n1;2;3;Fi;30;20\n", "trees").columns(),
              trees);
    EXPECT_EQ(
        named("N° arbre;X (m);Y (m);Essence;Diamètre (cm);Hauteur (m)\n1;2;3;a;4;5\n", "trees").columns(),
        trees);
    EXPECT_EQ(named("N. albero;Est (m);Nord (m);Specie;Diametro (cm);Altezza (m)\n1;2;3;a;4;5\n", "trees")
                  .columns(),
              trees);
    // A diameter without a unit may be a radius in m or a girth: it stays what it is.
    EXPECT_EQ(named("Diamètre\n1\n", "trees").columns(), std::vector<std::string>{"Diamètre"});
}

TEST(NameColumns, KnowsThoseOfClimateModels) {
    EXPECT_EQ(named("year,month,tmp_min,tmp_max,prcp,srad\n1,2,3,4,5,6\n", "climate").columns(),
              (std::vector<std::string>{"year", "month", "tmin_c", "tmax_c", "prec_mm", "rad_mj_m2_d"}));
    EXPECT_EQ(
        named("Year,Month,Tmin,Tmax,Precip,Radiation [MJ/m2/d]\n1,2,3,4,5,6\n", "climate warm").columns(),
        (std::vector<std::string>{"year", "month", "tmin_c", "tmax_c", "prec_mm", "rad_mj_m2_d"}));
}

TEST(NameColumns, SaysWhichAreInAnotherUnit) {
    config::Table table = config::Table::read(std::string_view{"BHD [mm],X_M,Höhe [cm]\n1,2,3\n"}, "file");
    const std::vector<config::Problem> problems = name_columns(table, "trees");
    ASSERT_EQ(problems.size(), 2U);
    EXPECT_EQ(
        config::to_string(problems[0]),
        "file: found column 'BHD [mm]', which is in mm, expected dbh_cm, in cm; multiply its numbers by 0.1 "
        "and name the column dbh_cm");
    EXPECT_NE(config::to_string(problems[1]).find("multiply its numbers by 0.01"), std::string::npos);
}

// Each length of a tree list, in each unit of length, in each form of a header.
TEST(TakeOtherUnits, MakesNumbersOursInEachUnitAndForm) {
    const std::vector<std::pair<std::string, double>> metres{
        {"m", 1.0}, {"dm", 0.1}, {"cm", 0.01}, {"mm", 0.001}, {"ft", 0.3048}, {"inches", 0.0254}};
    const std::vector<std::tuple<std::string, std::string, double>> columns{
        {"DBH", "dbh_cm", 0.01},     {"BHD", "dbh_cm", 0.01},     {"Durchmesser", "dbh_cm", 0.01},
        {"dbh", "dbh_cm", 0.01},     {"height", "height_m", 1.0}, {"Höhe", "height_m", 1.0},
        {"hauteur", "height_m", 1.0}};
    for (const auto& [word, column, own_m] : columns) {
        for (const auto& [unit, size_m] : metres) {
            for (const auto& header :
                 {word + " [" + unit + "]", word + "_" + unit, word + " (" + unit + ")", word + "." + unit}) {
                if (unit == "inches" && header.find('_') != std::string::npos) {
                    continue;  // the same unit in brackets is enough
                }
                config::Table table = config::Table::read(
                    std::string_view{"tree," + header + ",x\n1,12.5,7\n2,NA,8\n3,,9\n"}, "file");
                const auto changes = formats::take_other_units(table, "trees");
                name_columns(table, "trees");
                ASSERT_TRUE(table.has(column)) << header;
                EXPECT_NEAR(config::parse_number(table.text(0, column)).value(), 12.5 * size_m / own_m, 1e-9)
                    << header;
                EXPECT_EQ(table.text(1, column), "NA");
                EXPECT_EQ(table.text(2, column), "");
                EXPECT_EQ(changes.size(), size_m == own_m ? 0U : 1U) << header;
                EXPECT_EQ(table.text(0, "x_m"), "7") << "coordinates stay";
            }
        }
    }
}

TEST(TakeOtherUnits, LeavesAColumnAloneThatItCannotMakeOurs) {
    for (const char* text : {"DBH_mm,dbh_cm\n116.8,12\n",  // ours is there
                             "DBH_mm\n116.8\nthick\n",     // no number
                             "DBH_mm\n\"116,8\"\n",        // another form of number
                             "DBH_kg\n116.8\n"}) {         // no length
        config::Table table = config::Table::read(std::string_view{text}, "file");
        EXPECT_TRUE(formats::take_other_units(table, "trees").empty()) << text;
        EXPECT_NE(table.columns().front().find("DBH"), std::string::npos);
    }
}

TEST(TakeOtherUnits, DividesExactly) {
    config::Table table = config::Table::read(std::string_view{"DBH_mm\n116.8\n188.3\n"}, "file");
    const auto changes = formats::take_other_units(table, "trees");
    ASSERT_EQ(changes.size(), 1U);
    EXPECT_EQ(changes[0].found + changes[0].sum + " = " + changes[0].column, "DBH_mm / 10 = dbh_cm");
    EXPECT_EQ(table.text(0, "dbh_cm") + " " + table.text(1, "dbh_cm"), "11.68 18.83");
}

std::vector<std::string> by_part(std::string_view header, std::string_view role, std::string_view wanted,
                                 bool whole_words = false) {
    config::Table table = config::Table::read(header, "file");
    name_columns(table, role);
    return formats::columns_by_part(table, role, wanted, whole_words);
}

TEST(ColumnsByPart, FindsAWordBetweenUnderscoresAndAtACapital) {
    using Found = std::vector<std::string>;
    EXPECT_EQ(by_part("hoehe_gesamt_m,x\n", "trees", "height_m"), Found{"hoehe_gesamt_m"});
    EXPECT_EQ(by_part("totalHeight,x\n", "trees", "height_m"), Found{"totalHeight"});
    EXPECT_EQ(by_part("BlockID,wkt\n", "targets", "target_id"), Found{"BlockID"});
    EXPECT_EQ(by_part("gattung_lat\n", "trees", "species"), Found{"gattung_lat"});
    EXPECT_EQ(by_part("baum nr alt\n", "trees", "tree_id"), Found{"baum nr alt"});
    EXPECT_EQ(by_part("shoehe,xheightx\n", "trees", "height_m"), Found{});
}

TEST(ColumnsByPart, FindsTheLettersAtTheBeginning) {
    using Found = std::vector<std::string>;
    EXPECT_EQ(by_part("baumartlat\n", "trees", "species"), Found{"baumartlat"});
    EXPECT_EQ(by_part("baumartlat\n", "trees", "species", true), Found{});
    EXPECT_EQ(by_part("baumartlat,art_genau\n", "trees", "species"), (Found{"art_genau", "baumartlat"}))
        << "a whole word is likelier";
    EXPECT_EQ(by_part("identity\n", "trees", "tree_id"), Found{});
}

TEST(ColumnsByPart, LeavesOutColumnsThatHaveANameOfOurs) {
    EXPECT_EQ(by_part("Baumart,DBH_cm\n", "trees", "species"), std::vector<std::string>{});
    EXPECT_EQ(by_part("DN,value\n", "surface_polygons", "code"), (std::vector<std::string>{"DN", "value"}));
}

TEST(TakeCoordinates, TakesThemFromPointsAndLines) {
    config::Table points =
        config::Table::read(std::string_view{"wkt\nPOINT (1.5 2)\nMULTIPOINT ((3 4))\n"}, "file");
    EXPECT_EQ(formats::take_coordinates(points, "trees", false), 0U);
    EXPECT_EQ(points.text(0, "x_m") + " " + points.text(1, "y_m"), "1.5 4");
    config::Table lines =
        config::Table::read(std::string_view{"wkt\n\"LINESTRING (1 2, 3 4, 5 6)\"\n"}, "file");
    formats::take_coordinates(lines, "logs", false);
    EXPECT_EQ(lines.text(0, "x1_m") + lines.text(0, "y1_m") + lines.text(0, "x2_m") + lines.text(0, "y2_m"),
              "1256");
}

TEST(TakeCoordinates, LetsShapesOfAGisWinAndCountsWhatMoved) {
    const std::string_view text = "x_m,y_m,wkt\n1,2,POINT (1 2)\n1,2,POINT (10 2)\n";
    config::Table layer = config::Table::read(text, "file");
    EXPECT_EQ(formats::take_coordinates(layer, "trees", true), 1U);
    EXPECT_EQ(layer.text(1, "x_m"), "10");
    config::Table list = config::Table::read(text, "file");
    EXPECT_EQ(formats::take_coordinates(list, "trees", false), 0U);
    EXPECT_EQ(list.text(1, "x_m"), "1");
}

TEST(TakeCoordinates, LeavesRowsWithoutPlaceEmpty) {
    config::Table table = config::Table::read(
        std::string_view{"wkt,a\nPOINT (1 2),x\n,y\n\"MULTIPOINT ((1 2), (3 4))\",z\n"}, "file");
    formats::take_coordinates(table, "trees", true);
    EXPECT_EQ(table.text(1, "x_m"), "");
    EXPECT_EQ(table.text(2, "x_m"), "");
}

}  // namespace
}  // namespace coupling::column_names_test
