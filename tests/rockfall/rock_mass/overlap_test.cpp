#include "rockfall/rock_mass/overlap.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "config/random/stream.hpp"
#include "rockfall/rock_mass/convex_cell.hpp"
#include "rockfall/rock_mass/ground.hpp"
#include "rockfall/rock_mass/rock_mass.hpp"
#include "rockfall/rock_mass/vertex_sides.hpp"
#include "tests/rockfall/rock_mass/scenes.hpp"

namespace rockfall::rock_mass {
namespace {

using Eigen::Vector3d;

/// Two blocks of any place, looked at by a mass that never moves them.
class TwoBlocks {
public:
    TwoBlocks(const solids::Hull& first, const solids::Hull& second)
        : mass_{scenes::lossless(), starts(first, second), {}, Ground{}} {}
    [[nodiscard]] PlacedBlock first() const { return mass_.placed(0); }
    [[nodiscard]] PlacedBlock second() const { return mass_.placed(1); }
    [[nodiscard]] Overlap overlap() const {
        SeparatingFace known;
        return overlap_of(first(), second(), mass_.blocks()[1].centre_m, known);
    }
    [[nodiscard]] double energy_m4() const { return overlap_energy_m4(first(), second()); }

private:
    static std::vector<BlockStart> starts(const solids::Hull& first, const solids::Hull& second) {
        return {block_of(first, 1.0, false), block_of(second, 1.0, false)};
    }
    RockMass mass_;
};

const solids::Hull unit_cube = solids::box(Vector3d::Ones());

solids::Hull moved(const solids::Hull& hull, const Vector3d& by_m, const Vector3d& turn = Vector3d::Zero()) {
    return solids::placed(hull, Eigen::Quaterniond{Eigen::AngleAxisd{turn.norm(), turn.stableNormalized()}},
                          by_m);
}

TEST(Overlap, OfFacesIsAreaTimesDepth) {
    // Two cubes on each other, shifted: 0.7 m x 1 m overlap by 1 cm.
    const TwoBlocks pair{unit_cube, moved(unit_cube, {0.3, 0.0, 0.99})};
    const Overlap overlap = pair.overlap();
    // The pressure loses what the slanted rim of the field takes: of the order of depth by width.
    EXPECT_NEAR(overlap.force_m3.z(), 0.7 * 0.01, 0.7 * 0.01 * 0.03);
    EXPECT_NEAR(overlap.area_m2.z(), 0.7, 1e-12);
    EXPECT_NEAR(pair.energy_m4(), 0.5 * 0.7 * 0.01 * 0.01, 0.5 * 0.7 * 1e-4 * 0.03);
    EXPECT_NEAR((overlap.pressure_centre_m() - Vector3d(-0.15, 0.0, -0.49)).norm(), 0.0, 0.01);
}

TEST(SeparatingAxis, IsFoundWhereNoFaceKeepsBlocksApart) {
    // Cubes of any attitude beside each other. Where an axis is found both lie on their sides of it, and
    // clipping finds nothing; force and moment are the same either way.
    config::RandomStream draws{{47, 0, 0, 1}, config::Purpose::test};
    int found = 0, by_no_face = 0;
    for (int trial = 0; trial < 400; ++trial) {
        const auto number = [&] { return 2.0 * draws.uniform() - 1.0; };
        const Vector3d turn{3.0 * number(), 3.0 * number(), 3.0 * number()};
        const Vector3d place = Vector3d{number(), number(), number()}.normalized() * (1.3 + 0.3 * number());
        const TwoBlocks pair{unit_cube, moved(unit_cube, place, turn)};
        SeparatingFace known;
        const Overlap plain = overlap_of(pair.first(), pair.second(), place, known);
        SeparatingFace with_axis;
        const Overlap apart = overlap_of(pair.first(), pair.second(), place, with_axis, nullptr, true);
        ASSERT_EQ(plain.is_none(), apart.is_none());
        ASSERT_EQ(plain.force_m3, apart.force_m3);
        if (with_axis.has_axis()) {
            ++by_no_face;
            EXPECT_EQ(known.face, SeparatingFace::none);
            EXPECT_GT(apart.gap_m, 0.0);
            EXPECT_NEAR(with_axis.axis.norm(), 1.0, 1e-12);
            EXPECT_EQ(separation_m(with_axis, pair.first(), pair.second()), apart.gap_m);
            with_axis.reverse();
            EXPECT_NEAR(separation_m(with_axis, pair.second(), pair.first()), apart.gap_m, 1e-12);
        }
        const auto axis = find_separating_axis(place.normalized(), pair.first(), pair.second());
        found += axis ? 1 : 0;
        ASSERT_TRUE(!axis || plain.is_none());
        if (axis) {
            for (const Vector3d& a_m : pair.first().vertices_m) {
                for (const Vector3d& b_m : pair.second().vertices_m) {
                    ASSERT_GE(axis->axis.dot(b_m - a_m), axis->gap_m - 1e-12);
                }
            }
        }
    }
    EXPECT_GT(found, 100);
    EXPECT_GT(by_no_face, 5);
}

/// Cubes that just pass each other at edges, in any attitude and nearly along each other: as far as they may
/// go into each other, in any direction, their force stays below what does not matter.
TEST(SeparatingAxis, LetsNoForceGrowUnseenWhereEdgesPass) {
    constexpr double slack_m3 = 3e-7;
    config::RandomStream draws{{47, 0, 0, 2}, config::Purpose::test};
    const auto direction = [&] {
        const auto number = [&] { return 2.0 * draws.uniform() - 1.0; };
        return Vector3d{Vector3d{number(), number(), number()}.normalized()};
    };
    int edges = 0;
    for (const double most_turn : {3.0, 0.1, 0.01, 1e-3}) {
        for (int trial = 0; trial < 150; ++trial) {
            const Vector3d turn = most_turn * draws.uniform() * direction(), towards = direction();
            const auto placed_at = [&](const Vector3d& place_m) {
                return TwoBlocks{unit_cube, moved(unit_cube, place_m, turn)};
            };
            double near_m = 0.0, far_m = 3.0;
            for (int k = 0; k < 40; ++k) {
                const double middle_m = 0.5 * (near_m + far_m);
                (placed_at(middle_m * towards).overlap().is_none() ? far_m : near_m) = middle_m;
            }
            far_m += std::pow(10.0, -7.0 + 4.0 * draws.uniform());
            const TwoBlocks pair = placed_at(far_m * towards);
            SeparatingFace known;
            const Overlap none =
                overlap_of(pair.first(), pair.second(), far_m * towards, known, nullptr, true);
            if (!none.is_none() || !known.is_edge()) {
                continue;
            }
            ++edges;
            const double way_m = none.gap_m + way_into_edge_m(known, pair.first(), pair.second(), slack_m3);
            for (int k = 0; k < 10; ++k) {
                const TwoBlocks moved_on = placed_at(far_m * towards + way_m * direction());
                ASSERT_LE(moved_on.overlap().force_m3.norm(), slack_m3) << most_turn << " " << trial;
            }
        }
    }
    EXPECT_GT(edges, 30);
}

TEST(Overlap, IsNoneWhereAFaceOrTwoEdgesKeepBlocksApart) {
    EXPECT_TRUE((TwoBlocks{unit_cube, moved(unit_cube, {0.0, 0.0, 1.001})}).overlap().is_none());
    // Two bars across each other, edge above edge: no face separates them.
    const double reach = std::sqrt(0.5);
    const solids::Hull along_x =
        moved(solids::box({4.0, 1.0, 1.0}), Vector3d::Zero(), {0.78539816339, 0.0, 0.0});
    for (const double gap_m : {0.01, -0.01}) {
        const TwoBlocks pair{along_x, moved(solids::box({1.0, 4.0, 1.0}), {0.0, 0.0, 2.0 * reach + gap_m},
                                            {0.0, 0.78539816339, 0.0})};
        EXPECT_EQ(pair.overlap().is_none(), gap_m > 0.0);
    }
}

TEST(Overlap, IsNoneWithinRoundingAndPressesInsideTheContactBeyond) {
    // Far from the origin rounding is of the order of 1e-13 m: forces of that size have any direction, and
    // their place would be anywhere.
    const Vector3d far{1000.0, 2000.0, 500.0};
    for (const double depth_m : {0.0, 1e-13, 1e-12, 1e-8, 1e-4}) {
        const TwoBlocks pair{moved(unit_cube, far),
                             moved(unit_cube, far + Vector3d{0.0, 0.0, 1.0 - depth_m})};
        const Overlap overlap = pair.overlap();
        EXPECT_EQ(overlap.is_none(), depth_m < 1e-9) << depth_m;
        if (!overlap.is_none()) {
            EXPECT_NEAR(overlap.force_m3.z(), depth_m, 1e-3 * depth_m);
            EXPECT_LT(overlap.pressure_centre_m().norm(), 0.51) << depth_m;  // about the second one's middle
        }
    }
}

/// Mean distance from the middle of pressure over a rectangle of sides a and b, on which the depth grows
/// from 0 along x; by a grid.
double mean_radius_of_wedge_m(double a_m, double b_m) {
    constexpr int cells = 400;
    double sum = 0.0, weight = 0.0;
    for (int i = 0; i < cells; ++i) {
        for (int k = 0; k < cells; ++k) {
            const double x_m = (i + 0.5) / cells * a_m, y_m = ((k + 0.5) / cells - 0.5) * b_m;
            sum += x_m * std::hypot(x_m - 2.0 / 3.0 * a_m, y_m);
            weight += x_m;
        }
    }
    return sum / weight;
}

TEST(Overlap, KnowsHowFarItsPressureLiesFromItsCentre) {
    const Ground ground{scenes::plane_of(0.0)};
    const auto radius_m = [&](const solids::Hull& hull, const Vector3d& place_m, double tilt) {
        const TwoBlocks block{moved(unit_cube, {0.0, 0.0, 50.0}), moved(hull, place_m, {0.0, tilt, 0.0})};
        const PlacedBlock placed = block.second();
        return ground.overlap_of(ground.prisms_in({-20.0, -20.0}, {20.0, 20.0}), placed, placed.centre_m)
            .friction_radius_m;
    };
    // A square of side s: s (sqrt 2 + asinh 1) / 6, wherever it lies.
    const double of_square = (std::sqrt(2.0) + std::asinh(1.0)) / 6.0;
    EXPECT_NEAR(radius_m(unit_cube, {3.0, -2.0, 0.5 - 1e-6}, 0.0), of_square, 1e-6);
    EXPECT_NEAR(radius_m(solids::box({2.0, 2.0, 1.0}), {0.1, 0.2, 0.5 - 1e-6}, 0.0), 2.0 * of_square, 1e-6);
    EXPECT_NEAR(radius_m(solids::box({10.0, 0.01, 1.0}), {0.3, 0.0, 0.5 - 1e-6}, 0.0), 2.5, 1e-5);
    // Tilted, so that the pressure grows from 0 at one side.
    const double tilt = 1e-4;
    for (const double width_m : {0.5, 1.0, 3.0}) {
        const solids::Hull block = solids::box({1.0, width_m, 1.0});
        const double height_m = 0.5 * std::cos(tilt) - 0.5 * std::sin(tilt);
        const double exact_m = mean_radius_of_wedge_m(1.0, width_m);
        EXPECT_NEAR(radius_m(block, {0.0, 0.0, height_m}, tilt), exact_m, 0.02 * exact_m) << width_m;
    }
    // Two blocks see the same one; so does a pair that is carried on.
    const TwoBlocks pair{unit_cube, moved(unit_cube, {0.3, 0.0, 0.9999})};
    const double p = 0.35, q = 0.5;
    const double of_rectangle =
        std::hypot(p, q) / 3.0 + (p * p / q * std::asinh(q / p) + q * q / p * std::asinh(p / q)) / 6.0;
    EXPECT_NEAR(pair.overlap().friction_radius_m, of_rectangle, 1e-3);
}

TEST(Overlap, ForceIsTheGradientOfItsEnergyWhateverTouches) {
    const solids::Hull round = solids::with_volume(solids::ellipsoid({1.0, 0.8, 0.6}, 0), 0.7);
    config::RandomStream draws{{5, 0, 0, 1}, config::Purpose::test};
    int touched = 0;
    for (int i = 0; i < 60; ++i) {
        const auto any = [&](double size) {
            return Vector3d{size * (2.0 * draws.uniform() - 1.0), size * (2.0 * draws.uniform() - 1.0),
                            size * (2.0 * draws.uniform() - 1.0)};
        };
        const Vector3d place = any(0.8), turn = any(2.0);
        const auto energy = [&](const Vector3d& by_m, const Vector3d& spin) {
            const Eigen::Quaterniond spun{Eigen::AngleAxisd{spin.norm(), spin.stableNormalized()}};
            const Eigen::Quaterniond at{Eigen::AngleAxisd{turn.norm(), turn.normalized()}};
            return TwoBlocks{unit_cube, solids::placed(round, spun * at, place + by_m)}.energy_m4();
        };
        const TwoBlocks pair{unit_cube, moved(round, place, turn)};
        const Overlap overlap = pair.overlap();
        if (overlap.is_none()) {
            continue;
        }
        ++touched;
        const double h = 1e-5;
        for (int k = 0; k < 3; ++k) {
            const Vector3d e = h * Vector3d::Unit(k);
            EXPECT_NEAR(overlap.force_m3[k],
                        -(energy(e, Vector3d::Zero()) - energy(-e, Vector3d::Zero())) / (2.0 * h), 2e-6)
                << i;
            EXPECT_NEAR(overlap.moment_m4[k],
                        -(energy(Vector3d::Zero(), e) - energy(Vector3d::Zero(), -e)) / (2.0 * h), 2e-6)
                << i;
        }
    }
    EXPECT_GT(touched, 20);
}

TEST(OverlapSlope, IsWhatForceAndMomentChangeBy) {
    const solids::Hull round = solids::with_volume(solids::ellipsoid({1.0, 0.8, 0.6}, 0), 0.7);
    config::RandomStream draws{{6, 0, 0, 1}, config::Purpose::test};
    int touched = 0;
    for (int i = 0; i < 60; ++i) {
        const auto any = [&](double size) {
            return Vector3d{size * (2.0 * draws.uniform() - 1.0), size * (2.0 * draws.uniform() - 1.0),
                            size * (2.0 * draws.uniform() - 1.0)};
        };
        const Vector3d place = any(0.8), turn = any(2.0);
        const Eigen::Quaterniond at{Eigen::AngleAxisd{turn.norm(), turn.normalized()}};
        OverlapSlope slope;
        // The turn is about the second block's centre of mass, which a hull made at the origin has there.
        const auto overlap = [&](const Vector3d& by_m, const Vector3d& spin, OverlapSlope* of) {
            const Eigen::Quaterniond spun{Eigen::AngleAxisd{spin.norm(), spin.stableNormalized()}};
            const TwoBlocks pair{unit_cube, solids::placed(round, spun * at, place + by_m)};
            SeparatingFace known;
            return overlap_of(pair.first(), pair.second(), pair.second().centre_m, known, of);
        };
        const Overlap middle = overlap(Vector3d::Zero(), Vector3d::Zero(), &slope);
        if (middle.is_none()) {
            continue;
        }
        ++touched;
        const double h = 1e-5;
        for (int k = 0; k < 3; ++k) {
            const Vector3d e = h * Vector3d::Unit(k), none = Vector3d::Zero();
            const Overlap there = overlap(e, none, nullptr), back = overlap(-e, none, nullptr);
            const Overlap left = overlap(none, e, nullptr), right = overlap(none, -e, nullptr);
            const auto slope_of = [&](const Vector3d& after, const Vector3d& before) {
                return Vector3d{(after - before) / (2.0 * h)};
            };
            EXPECT_LT((slope.force_by_shift.col(k) - slope_of(there.force_m3, back.force_m3)).norm(), 1e-4);
            EXPECT_LT((slope.moment_by_shift.col(k) - slope_of(there.moment_m4, back.moment_m4)).norm(),
                      1e-4);
            EXPECT_LT((slope.force_by_turn.col(k) - slope_of(left.force_m3, right.force_m3)).norm(), 1e-4);
            EXPECT_LT((slope.moment_by_turn.col(k) - slope_of(left.moment_m4, right.moment_m4)).norm(), 1e-4);
        }
    }
    EXPECT_GT(touched, 20);
}

TEST(Overlap, IsTheSameWithBlocksExchanged) {
    const solids::Hull other = moved(unit_cube, {0.6, 0.5, 0.55}, {0.3, 0.2, 0.1});
    const Overlap there = TwoBlocks{unit_cube, other}.overlap();
    const Overlap back = TwoBlocks{other, unit_cube}.overlap();
    EXPECT_NEAR((there.force_m3 + back.force_m3).norm(), 0.0, 1e-12);
    EXPECT_FALSE(there.is_none());
}

TEST(Ground, PushesAlongTheNormalOfAPlaneByTheVolumeBelow) {
    const Ground ground{scenes::plane_of(0.5)};
    const RockMass mass{
        scenes::lossless(),
        std::vector<BlockStart>{block_of(moved(unit_cube, {0.0, 0.0, 0.3}, {0.4, 0.5, 0.6}), 1.0, false)},
        {},
        Ground{}};
    const auto prisms = ground.prisms_in({-2.0, -2.0}, {2.0, 2.0});
    EXPECT_EQ(prisms.size(), 2U);
    const Overlap overlap = ground.overlap_of(prisms, mass.placed(0), Vector3d::Zero());
    const Vector3d normal = Vector3d{-0.5, 0.0, 1.0}.normalized();
    const ConvexCell below = part_below(cell_of(mass.placed(0)), {normal, 0.0});
    const VolumeAndCentre held = volume_and_centre(below);
    EXPECT_NEAR((overlap.force_m3 - held.volume_m3 * normal).norm(), 0.0, 1e-12);
    EXPECT_NEAR(ground.energy_m4(prisms, mass.placed(0)), -held.volume_m3 * normal.dot(held.centre_m), 1e-12);
}

}  // namespace
}  // namespace rockfall::rock_mass
