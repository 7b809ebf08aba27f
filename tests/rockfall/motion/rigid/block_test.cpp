#include "rockfall/motion/rigid/block.hpp"

#include <gtest/gtest.h>

#include "config/random/stream.hpp"
#include "tests/rockfall/motion/rigid/scene.hpp"

namespace rockfall::rigid {
namespace {

using namespace testing;

Slope rough(double noise_m, double cell_m = 2.0) {
    const config::GridFrame frame{75, 30, 0.0, 0.0, cell_m, cell_m};
    config::RandomStream chance{{3, 0, 0, 1}, config::Purpose::test};
    return rockfall::testing::slope_over(
        rockfall::testing::heights_of(
            frame,
            [&](double x, double) { return 2000.0 - 0.78 * x + noise_m * (2.0 * chance.uniform() - 1.0); }),
        {0.3, 0.8});
}

Body thrown(const Slope& slope, std::uint64_t number) {
    config::RandomStream chance{{5, 0, 0, number}, config::Purpose::test};
    Body body;
    const double x_m = 8.0, y_m = 20.0 + 20.0 * chance.uniform();
    const auto triangle = slope.terrain.locate(x_m, y_m).value();
    body.centre_m = {x_m, y_m, slope.terrain.plane_of(triangle).height_m(x_m, y_m) + 2.0};
    body.velocity_mps = {2.0, 0.0, -1.0};
    body.rotation.attitude = Eigen::Quaterniond{chance.uniform() - 0.5, chance.uniform() - 0.5,
                                                chance.uniform() - 0.5, chance.uniform() - 0.5}
                                 .normalized();
    return body;
}

double energy_j(const Block& block) {
    return block.body().kinetic_j(block.solid()) + block.body().potential_j(block.solid());
}

TEST(RigidBlock, KeepsItsLedgerOnRoughGroundAndNeverGainsEnergy) {
    const Slope slope = rough(0.2);
    for (const double e : {0.0, 0.4}) {
        const Law law = law_of(0.6, e);
        for (const solids::Solid& solid :
             {solids::ball_of(0.6, 2700.0), cube(), solids::solid_of(solids::box({0.8, 0.7, 0.2}), 2700.0)}) {
            BlockScratch scratch;
            for (std::uint64_t number = 0; number < 4; ++number) {
                const Body start = thrown(slope, number);
                Block block{slope,
                            law,
                            solid,
                            start,
                            slope.terrain.locate(start.centre_m.x(), start.centre_m.y()).value(),
                            scratch};
                double time_s = 0.0;
                bool on_ground = false;
                while (time_s < 8.0) {
                    const double before_j = energy_j(block) - block.ledger().correction_j;
                    bool inside = true;
                    if (on_ground) {
                        const Touchdown touchdown = block.step(law.step_s, inside);
                        time_s += law.step_s;
                        on_ground = touchdown.touched && touchdown.lasts;
                    } else {
                        const FreeFlight flight = block.fly();
                        block.go_on(flight.duration_s);
                        time_s += flight.duration_s;
                        inside = flight.end == FlightStop::contact;
                        on_ground = inside && block.strike().lasts;
                    }
                    const double bound_j =
                        1e-9 * std::abs(before_j) + 1e-4 * block.body().rotation.energy_j(solid.inertia_kgm2);
                    ASSERT_LE(energy_j(block) - block.ledger().correction_j, before_j + bound_j);
                    if (!inside) {
                        break;
                    }
                }
                EXPECT_LT(std::abs(block.residual_j()), 1e-3 * block.ledger().dissipated_j()) << number;
            }
        }
    }
}

TEST(RigidBlock, MovesAlikeOnTwoTrianglesAndOnTwentyThousand) {
    constexpr double deg = 30.0;
    const Slope coarse = plane(deg, 100.0, 100.0, 50.0);
    const Slope fine = plane(deg, 100.0, 100.0, 1.0);
    ASSERT_GT(fine.terrain.triangles().size(), 19'000U);
    const solids::Solid box = solids::solid_of(solids::box({0.6, 0.5, 0.4}), 2700.0);
    const auto end_of = [&](const Slope& slope, const solids::Solid& solid, double friction) {
        const Body start = lying(slope, solid, deg, 30.2, 40.3);
        BlockScratch scratch;
        const Law law = law_of(friction, 0.0);
        Block block{slope, law, solid, start, slope.terrain.locate(30.2, 40.3).value(), scratch};
        return Vector3d{moved(block, law, 3.0, true).centre_m - start.centre_m};
    };
    const solids::Solid ball = solids::ball_of(0.5, 2700.0);
    EXPECT_LT((end_of(coarse, ball, 0.6) - end_of(fine, ball, 0.6)).norm(), 1e-6);
    EXPECT_LT((end_of(coarse, box, 0.3) - end_of(fine, box, 0.3)).norm(), 1e-6);

    // A tumbling block over its first five contacts.
    const auto contacts_of = [&](const Slope& slope) {
        Body start = lying(slope, box, deg, 30.2, 40.3, Eigen::Quaterniond{0.8, 0.3, 0.4, 0.33}.normalized());
        start.centre_m.z() += 2.0;
        start.velocity_mps = {4.0, 0.5, 0.0};
        BlockScratch scratch;
        const Law law = law_of(0.4, 0.7);
        Block block{slope, law, box, start, slope.terrain.locate(30.2, 40.3).value(), scratch};
        std::vector<Vector3d> places;
        while (places.size() < 5) {
            block.go_on(block.fly().duration_s);
            places.emplace_back(block.body().centre_m - start.centre_m);
            if (block.strike().lasts) {
                break;
            }
        }
        return places;
    };
    const auto a = contacts_of(coarse), b = contacts_of(fine);
    ASSERT_EQ(a.size(), 5U);
    ASSERT_EQ(b.size(), 5U);
    for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_LT((a[i] - b[i]).norm(), 1e-6) << i;
    }
}

TEST(RigidBlock, RestsOnARidgeThatLiesBetweenItsCorners) {
    // A roof: the plate's corners hang free, its face lies on the ridge. Vertices alone would fall through.
    const config::GridFrame frame{41, 41, -20.5, -20.5, 1.0, 1.0};
    const Slope roof = rockfall::testing::slope_over(
        rockfall::testing::heights_of(frame, [](double, double y) { return 100.0 - 0.5 * std::abs(y); }),
        {0.3, 0.8});
    const solids::Solid plate = solids::solid_of(solids::box({1.6, 1.6, 0.2}), 2700.0);
    const Eigen::Vector2d place = Eigen::Vector2d{0.3, 0.0} - roof.terrain.origin_m();
    Body start;
    start.rotation.attitude = plate.from_given.conjugate();
    start.centre_m = {place.x(), place.y(), 100.4};
    BlockScratch scratch;
    const Law law = law_of(0.8, 0.0);
    Block block{roof, law, plate, start, roof.terrain.locate(place.x(), place.y()).value(), scratch};
    const Body end = moved(block, law, 1.0, false);
    EXPECT_NEAR(end.centre_m.z(), 100.1, 0.01);
}

TEST(RigidBlock, SlidesOnWithoutJumpsOverEdgesOfOnePlane) {
    // Flat neighbours give no ghost hits: nothing but friction is lost.
    const Slope fine = plane(20.0, 100.0, 100.0, 1.0);
    const solids::Solid block = cube();
    Body start = lying(fine, block, 20.0, 10.0, 50.0);
    start.velocity_mps = 12.0 * Vector3d{std::cos(radians(20.0)), 0.0, -std::sin(radians(20.0))};
    BlockScratch scratch;
    const Law law = law_of(0.4, 0.3);
    Block sliding{fine, law, block, start, fine.terrain.locate(10.0, 50.0).value(), scratch};
    moved(sliding, law, 3.0, true);
    EXPECT_LT(sliding.ledger().normal_j, 1e-6 * sliding.ledger().friction_j);
    EXPECT_EQ(sliding.unsolved(), 0U);
}

}  // namespace
}  // namespace rockfall::rigid
