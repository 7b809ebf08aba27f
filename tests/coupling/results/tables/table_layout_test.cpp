#include "coupling/results/tables/table_layout.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "coupling/assessments/collapse/collapse_results.hpp"
#include "coupling/assessments/compare/runs/side_by_side.hpp"
#include "coupling/assessments/decades/decade_layouts.hpp"
#include "coupling/assessments/hazard/hazard_results.hpp"
#include "coupling/assessments/models/tables.hpp"
#include "coupling/assessments/nets/net_place.hpp"
#include "coupling/assessments/profile/profile_results.hpp"
#include "coupling/assessments/today/tables.hpp"
#include "coupling/results/tables/data_dictionary.hpp"

namespace coupling::table_layout_test {
namespace {

TEST(TableLayout, IsFoundByItsFile) {
    const std::vector<TableLayout> layouts{{"trees_YEAR.csv", "a tree", {{"tree_id", "-", "", ""}}},
                                           {"runs.csv", "a slope", {{"cover", "text", "", ""}}}};
    EXPECT_EQ(find_layout(layouts, "trees_30.csv"), &layouts[0]);
    EXPECT_EQ(find_layout(layouts, "runs.csv"), &layouts[1]);
    for (const char* other : {"trees_.csv", "trees_x.csv", "trees_30", "trees_3.csv.csv", "run.csv", ""}) {
        EXPECT_EQ(find_layout(layouts, other), nullptr) << other;
    }
}

/// What the end of a name says of its unit.
std::string unit_of(const std::string& name) {
    static const std::map<std::string, std::string> units{
        {"m", "m"},         {"cm", "cm"},       {"mm", "mm"},     {"s", "s"},       {"mps", "m/s"},
        {"mps2", "m/s2"},   {"kmph", "km/h"},   {"kj", "kJ"},     {"percent", "%"}, {"pha", "1/ha"},
        {"m2pha", "m2/ha"}, {"m3pha", "m3/ha"}, {"tpha", "t/ha"}, {"m2", "m2"},     {"m3", "m3"},
        {"ha", "ha"},       {"degc", "degC"},   {"kg", "kg"},     {"kpa", "kPa"},   {"years", "years"},
        {"deg", "deg"},     {"mj", "MJ"}};
    for (const char* interval : {"_low_90", "_high_90", "_low_95", "_high_95"}) {
        if (name.ends_with(interval)) {
            return unit_of(name.substr(0, name.size() - std::string{interval}.size()));
        }
    }
    if (name.ends_with("_yr")) {
        return unit_of(name.substr(0, name.size() - 3)) + "/yr";
    }
    if (name == "eur_per_percent_year") {
        return "EUR/ha/(% yr)";
    }
    if (name.ends_with("_percent_years")) {
        return "% years";
    }
    if (name.ends_with("_hours_pha")) {
        return "h/ha";
    }
    if (name.ends_with("_eur_pha")) {
        return "EUR/ha";
    }
    if (name.ends_with("_per_1000")) {
        return "1/1000";
    }
    if (name.ends_with("_per_m") || name.ends_with("kappa_pm")) {
        return "1/m";
    }
    if (name.ends_with("_ps")) {
        return "1/s";
    }
    const auto found = units.find(name.substr(name.rfind('_') + 1));
    return found == units.end() || name.rfind('_') == std::string::npos ? "" : found->second;
}

bool leaves_unit_to_the_row(const std::string& unit) {
    return unit.starts_with("as the ") && unit.ends_with(" says");
}

/// What a column is said to hold agrees with its unit and its name.
void expect_sound(const Column& column, const std::string& table) {
    const std::string where = table + ' ' + column.name;
    EXPECT_FALSE(column.meaning.empty()) << where;
    EXPECT_FALSE(column.source.empty()) << where;
    const bool has_unit = column.unit != "-" && column.unit != "text" && !leaves_unit_to_the_row(column.unit);
    EXPECT_EQ(has_unit ? column.unit : "", unit_of(column.name)) << where;
    if (column.holds == Holds::text) {
        EXPECT_TRUE(column.unit == "text" || leaves_unit_to_the_row(column.unit)) << where;
    } else {
        EXPECT_NE(column.unit, "text") << where;
    }
    EXPECT_TRUE(column.holds != Holds::whole || column.unit == "-") << where;
}

TEST(TableLayout, DeclaresEachColumnOnceWithUnitMeaningAndSource) {
    std::size_t columns = 0;
    for (const auto* layouts :
         {&static_layouts(), &decades::decade_layouts(), &profile::profile_layouts(),
          &hazard::hazard_layouts(), &hazard::risk::risk_layouts(), &net_command_layouts(),
          &collapse::collapse_layouts(), &compare::compare_layouts(), &models::models_layouts(),
          &dictionary_layouts()}) {
        for (const TableLayout& layout : *layouts) {
            EXPECT_FALSE(layout.row.empty()) << layout.file;
            std::set<std::string> names;
            for (const Column& column : layout.columns) {
                EXPECT_TRUE(names.insert(column.name).second) << column.name << " twice in " << layout.file;
                expect_sound(column, layout.file);
                ++columns;
            }
        }
    }
    EXPECT_GT(columns, 800U);
}

TEST(FolderPattern, ReplacesRegimeAndYear) {
    EXPECT_EQ(folder_pattern("rasters/forest/E_95.asc"), "rasters/forest");
    EXPECT_EQ(folder_pattern("rasters/rockfall/pfm1/year_30/E_max.asc"), "rasters/rockfall/REGIME/year_N");
    EXPECT_EQ(folder_pattern("rasters/rockfall/bare/year_0/E_max.asc"), "rasters/rockfall/bare/year_N");
    EXPECT_EQ(folder_pattern("rasters/forest/none/year_7/stems.asc"), "rasters/forest/REGIME/year_N");
    EXPECT_EQ(folder_pattern("rasters/rockfall/none/warm/year_7/E_max.asc"),
              "rasters/rockfall/REGIME/CLIMATE/year_N");
}

}  // namespace
}  // namespace coupling::table_layout_test
