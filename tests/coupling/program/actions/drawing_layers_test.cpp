#include "coupling/program/actions/drawing_layers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <set>

#include "coupling/inputs/formats/geopackage_layer.hpp"
#include "coupling/program/actions/input_tables.hpp"
#include "coupling/results/geopackage/database.hpp"
#include "tests/coupling/inputs/sample_project.hpp"

namespace coupling::drawing_layers_test {
namespace {

using geopackage::Database;

std::vector<const DrawingLayer*> all_layers() {
    std::vector<const DrawingLayer*> layers;
    for (const DrawingLayer& layer : drawing_layers()) {
        layers.push_back(&layer);
    }
    return layers;
}

/// The drawing in a file of its own.
struct Drawing {
    SampleProject project;
    std::filesystem::path file = project.file("drawing.gpkg");
    Drawing() { project.write("drawing.gpkg", empty_drawing(all_layers(), "")); }

    /// The first column of all rows, a line each.
    [[nodiscard]] std::vector<std::string> rows(const std::string& sql) const {
        Database database{file, Database::Open::to_read};
        geopackage::Statement statement = database.prepare(sql);
        std::vector<std::string> rows;
        while (statement.step()) {
            rows.push_back(statement.text(0));
        }
        return rows;
    }
};

std::vector<const config::TableSchema*> tables_of(const DrawingLayer& layer) {
    std::vector<const config::TableSchema*> tables;
    for (const config::TableSchema* schema : input_tables()) {
        if (std::count(layer.roles.begin(), layer.roles.end(), schema->rules().role) > 0) {
            tables.push_back(schema);
        }
    }
    return tables;
}

TEST(DrawingLayers, HaveTheColumnsThatTheirReadersDeclareAndNoOthers) {
    const Drawing drawing;
    for (const DrawingLayer& layer : drawing_layers()) {
        const std::string name{layer.name};
        EXPECT_EQ(tables_of(layer).size(), layer.roles.size()) << name;
        std::set<std::string> declared{"fid", "geom"};
        for (const config::TableSchema* schema : tables_of(layer)) {
            for (const config::ColumnRules& column : schema->columns()) {
                declared.insert(column.kind == config::FieldKind::shape ? "geom" : column.name);
            }
        }
        const auto columns = drawing.rows("SELECT name FROM pragma_table_info('" + name + "')");
        EXPECT_EQ(std::set<std::string>(columns.begin(), columns.end()), declared) << name;
        EXPECT_EQ(columns.size(), declared.size()) << name;
    }
}

TEST(DrawingLayers, SayWhatTheyAndEachOfTheirColumnsMean) {
    const Drawing drawing;
    for (const DrawingLayer& layer : drawing_layers()) {
        const std::string of = " WHERE table_name = '" + std::string{layer.name} + "'";
        EXPECT_EQ(drawing.rows("SELECT description FROM gpkg_contents" + of),
                  std::vector{std::string{layer.sentence}});
        const auto described =
            drawing.rows("SELECT column_name FROM gpkg_data_columns" + of + " AND description != ''");
        EXPECT_EQ(described.size(), drawing_columns(layer).size()) << layer.name;
    }
    EXPECT_EQ(drawing.rows(
                  "SELECT table_name FROM gpkg_extensions WHERE extension_name = 'gpkg_schema' ORDER BY 1"),
              (std::vector<std::string>{"gpkg_data_column_constraints", "gpkg_data_columns"}));
}

TEST(DrawingLayers, AreAWholeDatabaseThatIsTheSameEachTime) {
    const Drawing drawing;
    EXPECT_EQ(drawing.rows("PRAGMA integrity_check"), std::vector<std::string>{"ok"});
    EXPECT_TRUE(drawing.rows("PRAGMA foreign_key_check").empty());
    EXPECT_EQ(drawing.rows("PRAGMA application_id"), std::vector<std::string>{"1196444487"});  // GPKG
    EXPECT_EQ(empty_drawing(all_layers(), ""), drawing.project.read("drawing.gpkg"));
}

TEST(DrawingLayers, AreTakenByTheirReadersAsTheyAre) {
    const Drawing drawing;
    const std::string bytes = drawing.project.read("drawing.gpkg");
    for (const DrawingLayer& layer : drawing_layers()) {
        const auto read = formats::read_geopackage(bytes, std::string{layer.name}, "drawing.gpkg");
        EXPECT_EQ(read.layer.table.rows(), 0U);
        for (const config::TableSchema* schema : tables_of(layer)) {
            EXPECT_NO_THROW(schema->require(read.layer.table)) << layer.name;
        }
    }
    std::set<std::string> names;
    for (const DrawingLayer& layer : drawing_layers()) {
        names.insert(std::string{layer.name});
    }
    const auto empty = formats::empty_layers_of(bytes, "drawing.gpkg");
    EXPECT_EQ(std::set<std::string>(empty.begin(), empty.end()), names);
}

}  // namespace
}  // namespace coupling::drawing_layers_test
