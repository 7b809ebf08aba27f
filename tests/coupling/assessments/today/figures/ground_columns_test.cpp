#include "coupling/assessments/today/figures/ground_columns.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <stdexcept>
#include <string>

#include "rockfall/motion/models.hpp"

namespace coupling::ground_columns_test {
namespace {

const Column& column_of(const std::vector<Column>& columns, const std::string& name) {
    return *std::find_if(columns.begin(), columns.end(), [&](const Column& c) { return c.name == name; });
}

TEST(GroundColumns, HoldEveryFigureThatAMotionModelUses) {
    for (const rockfall::MotionModel model : rockfall::all_models()) {
        for (const rockfall::GroundColumnText& column : rockfall::ground_columns_of(model)) {
            EXPECT_NO_THROW(static_cast<void>(ground_column(column.name)))
                << rockfall::description_of(model).name << " uses " << column.name;
        }
    }
    EXPECT_THROW(static_cast<void>(ground_column("colour")), std::logic_error);
}

TEST(GroundColumns, AreEachUsedByAMotionModel) {
    std::set<std::string_view> used;
    for (const rockfall::MotionModel model : rockfall::all_models()) {
        for (const rockfall::GroundColumnText& column : rockfall::ground_columns_of(model)) {
            used.insert(column.name);
        }
    }
    for (const GroundColumn& column : ground_columns()) {
        EXPECT_TRUE(used.contains(column.name)) << column.name;
    }
}

TEST(GroundColumns, SayWhichMotionModelsUseThemAndWhereTheyComeFrom) {
    const std::vector<Column> columns = ground_table_columns();
    const Column& r_n = column_of(columns, "r_n");
    EXPECT_EQ(r_n.meaning,
              "coefficient of normal restitution, of the soil for pir3d; picus, pir3d, classical");
    EXPECT_EQ(r_n.source,
              "terrain.surface_types, or the shipped type; pir3d: terrain.soils, or the shipped soil");
    const Column& friction = column_of(columns, "friction");
    EXPECT_EQ(friction.meaning,
              "coefficient of sliding friction, at the start of a slip for rigid; pir3d, classical, rigid");
    EXPECT_EQ(friction.source,
              "pir3d: the soil; classical: (1 - r_t) / r_t, classical.friction_angle_deg or the ground type; "
              "rigid: rigid_ground or the column of terrain.surface_types, or [rigid]");
    EXPECT_EQ(column_of(columns, "threshold_deg").source, "terrain.soils, or the shipped soil");
}

}  // namespace
}  // namespace coupling::ground_columns_test
