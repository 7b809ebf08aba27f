#include "forest/stand/species.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "config/data/shipped_tables.hpp"
#include "forest/stand/species_fields.hpp"

namespace forest::species_test {
namespace {

config::Table table_of(const std::string& text, const std::string& file = "species.csv") {
    std::istringstream in{text};
    return config::Table::read(in, file);
}

std::string shipped_text() {
    return std::string{config::shipped_table("species.csv")};
}

TEST(SpeciesTable, ShipsElevenSpecies) {
    const SpeciesTable table = SpeciesTable::shipped();
    EXPECT_EQ(table.size(), 11U);
    const Species& fir = table[table.find("ABAL").value()];
    EXPECT_EQ(fir.latin_name, "Abies alba");
    EXPECT_TRUE(fir.conifer);
    EXPECT_TRUE(fir.evergreen);
    EXPECT_EQ(fir.crown.shape, CrownShape::paraboloid);
    EXPECT_DOUBLE_EQ(fir.allometry.foliage.factor, 0.065);
    EXPECT_DOUBLE_EQ(fir.three_pg.quantum_efficiency, 0.0289);
    EXPECT_DOUBLE_EQ(fir.light.sla_m2pkg, 7.0);
    EXPECT_DOUBLE_EQ(fir.vigour.power, 8.0);
    EXPECT_DOUBLE_EQ(fir.deadwood.log_decay_pyear, 0.035);
}

TEST(SpeciesTable, FindsByCodeAndLatinNameInAnyCase) {
    const SpeciesTable table = SpeciesTable::shipped();
    EXPECT_EQ(table.find("fasy"), table.find("FAGUS sylvatica"));
    EXPECT_FALSE(table.find("Buche im Quadrat"));
}

TEST(SpeciesTable, NamesTheNearestSpeciesForAnUnknownOne) {
    config::Problems problems;
    EXPECT_FALSE(SpeciesTable::shipped().find("Abies albo", {"trees.csv", 7, 3}, problems));
    ASSERT_EQ(problems.list().size(), 1U);
    EXPECT_EQ(to_string(problems.list().front()),
              "trees.csv:7:3: found species 'Abies albo', expected 'Abies alba'");
}

TEST(SpeciesTable, MatchesItsDictionaryInNamesAndUnits) {
    const config::Table dictionary =
        table_of(std::string{config::shipped_table("species_dictionary.csv")}, "species_dictionary.csv");
    std::set<std::string> described;
    for (std::size_t row = 0; row < dictionary.rows(); ++row) {
        described.insert(dictionary.text(row, "parameter") + " " + dictionary.text(row, "unit"));
        const std::string& mark = dictionary.text(row, "mark");
        EXPECT_TRUE(mark == "[lit]" || mark == "[choice]" || mark == "[lit] [choice]") << mark;
        EXPECT_FALSE(dictionary.text(row, "meaning").empty()) << row;
    }
    for (const config::ColumnRules& column : species_columns().columns()) {
        EXPECT_TRUE(column.kind != config::FieldKind::number ||
                    described.contains(column.name + " " + column.unit()))
            << column.name;
    }
    const config::Table species = table_of(shipped_text());
    EXPECT_EQ(dictionary.rows() + 2, species.columns().size()) << "all but code and source";
}

/// The bytes in which two species differ that are alike but for one number; strings lie elsewhere in each.
std::set<std::size_t> bytes_of(const std::string& column, double one, double other) {
    config::Table table = table_of(shipped_text());
    table.remove_rows([](std::size_t row) { return row > 1; });
    for (const std::string& name : table.columns()) {
        table.set_text(1, name, table.text(0, name));
    }
    if (!column.empty()) {
        table.set_text(0, column, config::to_text(one));
        table.set_text(1, column, config::to_text(other));
    }
    const auto rows = species_columns().all(table);
    std::set<std::size_t> differ;
    const auto* const a = reinterpret_cast<const unsigned char*>(&rows.at(0));
    const auto* const b = reinterpret_cast<const unsigned char*>(&rows.at(1));
    for (std::size_t i = 0; i < sizeof(rows.at(0)); ++i) {
        if (a[i] != b[i]) {
            differ.insert(i);
        }
    }
    return differ;
}

TEST(SpeciesTable, FillsEachFieldOfItsOwn) {
    std::set<std::size_t> taken = bytes_of("", 0.0, 0.0);
    for (const config::ColumnRules& column : species_columns().columns()) {
        if (column.kind != config::FieldKind::number) {
            continue;
        }
        const config::NumberRange& range = column.rules.range;
        const double width = range.high - range.low;
        std::size_t own = 0;
        for (const std::size_t byte :
             bytes_of(column.name, range.low + 0.313712930171 * width, range.low + 0.771938470313 * width)) {
            own += taken.insert(byte).second ? 1 : 0;
        }
        EXPECT_GE(own, 5U) << column.name << " fills the field of another column";
    }
}

TEST(Light, HangsLeavesFromMayToOctoberOnBeech) {
    const SpeciesTable table = SpeciesTable::shipped();
    const Light& beech = table[table.find("fasy").value()].light;
    for (int month = 1; month <= 12; ++month) {
        EXPECT_EQ(beech.in_leaf(month), month >= 5 && month <= 10) << month;
        EXPECT_TRUE(table[table.find("piab").value()].light.in_leaf(month));
    }
}

}  // namespace
}  // namespace forest::species_test
