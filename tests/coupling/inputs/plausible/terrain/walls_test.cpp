#include "coupling/inputs/plausible/terrain/walls.hpp"

#include <gtest/gtest.h>

#include "tests/coupling/inputs/plausible/terrain/wrong_terrains.hpp"

namespace coupling::plausible::terrain {
namespace {

TEST(NarrowWalls, AreFoundWhereCellsLeanThem) {
    const Ground real = mountainside();
    EXPECT_LT(narrow_walls(real.field(), 0.0), 10u);
    const Ground cut = real.changed([](double z, int row, int) { return row < 60 ? z - 20.0 : z; });
    const std::size_t found = narrow_walls(cut.field(), 0.0);
    EXPECT_GT(found, 100u);
    EXPECT_EQ(narrow_walls(cut.turned().field(), 0.0), found);
    EXPECT_EQ(narrow_walls(cut.mirrored().field(), 0.0), found);
    EXPECT_EQ(narrow_walls(cut.field(), 3.0), 0u) << "noise may be that large";
}

TEST(NarrowWalls, AreKeptByFineCells) {
    const Ground fine{60, 60, 1.0, [](int row, int) { return row < 30 ? 100.0 : 90.0; }};
    EXPECT_EQ(narrow_walls(fine.field(), 0.0), 0u);
}

}  // namespace
}  // namespace coupling::plausible::terrain
