#include "rockfall/solids/block_shape.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "rockfall/solids/shapes.hpp"

namespace rockfall {
namespace {

TEST(BlockShapes, HaveTheVolumeOfTheDiameterWhateverTheirSides) {
    for (const std::string& name : named_shapes()) {
        const ShapeLaw law{{{name, hull_of_shape(name), false, 1.0}}, 0.2, std::nullopt};
        const DrawnBlock block = law.draw(0.8, 2600.0, {1, 0, 0, 5});
        EXPECT_NEAR(block.solid->volume_m3, std::numbers::pi / 6.0 * 0.512, 1e-9) << name;
        EXPECT_LE(block.solid->bounding_radius_m, law.largest_radius_m(0.8) * (1.0 + 1e-12)) << name;
        EXPECT_NEAR(block.attitude.norm(), 1.0, 1e-12);
    }
}

TEST(BlockShapes, ClassesBelongToThemselves) {
    for (const std::string& name : named_shapes()) {
        const auto hull = hull_of_shape(name);
        if (!hull ||
            name.find("compact") + name.find("platy") + name.find("bladed") == 3 * std::string::npos) {
            continue;
        }
        Eigen::Vector3d low = hull->vertices_m[0], high = low;
        for (const Eigen::Vector3d& vertex : hull->vertices_m) {
            low = low.cwiseMin(vertex);
            high = high.cwiseMax(vertex);
        }
        const std::string of_class{solids::name_of(solids::form_class(high - low))};
        if (name != "equant" && name != "plate" && name != "column" && name != "cube" &&
            name != "octahedron" && name != "ellipsoid") {
            EXPECT_EQ(of_class, name);
        }
    }
}

TEST(BlockShapes, AreDrawnByTheirShares) {
    const ShapeLaw law{
        {{"cube", hull_of_shape("cube"), false, 3.0}, {"plate", hull_of_shape("plate"), false, 1.0}},
        0.0,
        std::nullopt};
    constexpr int draws = 4000;
    int cubes = 0;
    for (std::uint64_t rock = 0; rock < draws; ++rock) {
        const DrawnBlock block = law.draw(1.0, 2700.0, {1, 0, 0, rock});
        cubes += block.solid->inertia_kgm2.x() > 0.99 * block.solid->inertia_kgm2.z() ? 1 : 0;
    }
    EXPECT_NEAR(cubes / double{draws}, 0.75, 4.0 * std::sqrt(0.75 * 0.25 / draws));
}

TEST(BlockShapes, KeepTheirOwnSizeAndAGivenAttitude) {
    const Eigen::Quaterniond given{0.6, 0.8, 0.0, 0.0};
    const ShapeLaw law{{{"box", solids::box({0.5, 0.4, 0.2}), true, 1.0}}, 0.0, given};
    const DrawnBlock block = law.draw(3.0, 2000.0, {1, 0, 0, 1});
    EXPECT_NEAR(block.solid->mass_kg, 80.0, 1e-9);
    EXPECT_EQ(block.attitude.w(), 0.6);
    EXPECT_FALSE(law.at_random());
}

}  // namespace
}  // namespace rockfall
