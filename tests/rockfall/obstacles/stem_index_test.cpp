#include "rockfall/obstacles/stem_index.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "rockfall/obstacles/tree_energy.hpp"
#include "tests/rockfall/slopes.hpp"

namespace rockfall::stem_index_test {
namespace {

using testing::plane_slope;

constexpr std::uint64_t seed = 11;

/// Stems at random places of a square, all alike.
std::vector<Stem> random_stems(std::size_t count, double side_m, double dbh_cm) {
    std::vector<Stem> stems;
    for (std::size_t i = 0; i < count; ++i) {
        config::RandomStream stream{{seed, 0, 0, i}, config::Purpose::test};
        stems.push_back({stream.uniform() * side_m, stream.uniform() * side_m, dbh_cm, 30.0, 1.0});
    }
    return stems;
}

/// Ground level flight in plan: far below the tree tops all the way.
Flight along(const Slope& slope, double x_m, double y_m, double angle_rad, double speed_mps) {
    const Eigen::Vector2d p = Eigen::Vector2d{x_m, y_m} - slope.terrain.origin_m();
    const double ground_m = slope.terrain.height_m(p.x(), p.y()).value();
    return {{p.x(), p.y(), ground_m + 1.0},
            {speed_mps * std::cos(angle_rad), speed_mps * std::sin(angle_rad), 0.0}};
}

/// The first hit among all stems, without any index.
std::optional<StemHit> first_hit_of_all(const StemIndex& index, const Flight& flight, double until_s,
                                        double radius_m) {
    std::optional<StemHit> first;
    const Eigen::Vector2d v = flight.velocity_mps.head<2>();
    for (std::uint32_t i = 0; i < index.placed().size(); ++i) {
        const PlacedStem& stem = index.placed()[i];
        const Eigen::Vector2d r = Eigen::Vector2d{stem.x_m, stem.y_m} - flight.start_m.head<2>();
        const double reach_m = radius_m + stem.breast_radius_m;
        const double abeam_s = r.dot(v) / v.squaredNorm();
        const double offset2 = (r - abeam_s * v).squaredNorm();
        if (stem.height_m == 0.0 || abeam_s <= 0.0 || offset2 >= reach_m * reach_m) {
            continue;
        }
        const double time_s = std::max(0.0, abeam_s - std::sqrt(reach_m * reach_m - offset2) / v.norm());
        if (time_s <= until_s && (!first || time_s < first->time_s)) {
            first = StemHit{i, time_s, 0.0, reach_m, 0.0};
        }
    }
    return first;
}

TEST(StemIndex, MeetsTheMeanFreePath) {
    // 1 / (n (D + DBH)): 290 stems/ha of 31 cm and a rock of 0.95 m give 27.4 m (within 3 %).
    constexpr double side_m = 1000.0;
    const Slope flat = plane_slope(0.0, {0.3, 0.75}, 0.0, side_m, side_m);
    const std::vector<Stem> stems = random_stems(29'000, side_m, 31.0);
    const StemIndex index{stems, flat.terrain, 0.475, false};
    double travelled_m = 0.0;
    int hits = 0;
    for (std::uint64_t i = 0; i < 20'000; ++i) {
        config::RandomStream stream{{seed, 1, 0, i}, config::Purpose::test};
        const Flight flight = along(flat, 100.0 + 500.0 * stream.uniform(), 100.0 + 800.0 * stream.uniform(),
                                    0.5 * (stream.uniform() - 0.5), 10.0);
        constexpr double until_s = 20.0;
        // Falls 2 km in that time: hits count in plan only, so the height of the flight is kept by short
        // legs.
        const auto hit = index.first_hit_rolling(flight.start_m, flight.velocity_mps, until_s, 0.475, {}, {});
        travelled_m += 10.0 * (hit ? hit->time_s : until_s);
        hits += hit ? 1 : 0;
    }
    const double expected_m = 1.0 / (0.029 * (0.95 + 0.31));
    EXPECT_NEAR(expected_m, 27.4, 0.05);
    EXPECT_NEAR(travelled_m / hits, expected_m, 0.03 * expected_m);
}

TEST(StemIndex, NoStemIsMetOnAWayThatIsClear) {
    constexpr double side_m = 60.0;
    constexpr double radius_m = 0.7;
    const Slope flat = plane_slope(0.0, {0.3, 0.75}, 0.0, side_m, side_m);
    const StemIndex index{random_stems(300, side_m, 35.0), flat.terrain, radius_m, true};
    int clear = 0;
    int met = 0;
    constexpr int ways = 20'000;
    for (std::uint64_t i = 0; i < ways; ++i) {
        config::RandomStream stream{{seed, 5, 0, i}, config::Purpose::test};
        // Short ways, many of them over a border of the bins, and some beside all stems.
        const Flight flight =
            along(flat, 5.0 + (side_m - 10.0) * stream.uniform(), 5.0 + (side_m - 10.0) * stream.uniform(),
                  7.0 * stream.uniform(), 3.0 * stream.uniform());
        const double until_s = stream.uniform();
        const Eigen::Vector2d end_m = flight.start_m.head<2>() + until_s * flight.velocity_mps.head<2>();
        const bool hit =
            index.first_hit_rolling(flight.start_m, flight.velocity_mps, until_s, radius_m, {}, {})
                .has_value();
        const ClearPlace clear_place = index.clear_place(flight.start_m.head<2>(), radius_m);
        const bool is_clear =
            clear_place.has(flight.start_m.x(), flight.start_m.y()) && clear_place.has(end_m.x(), end_m.y());
        ASSERT_FALSE(hit && is_clear) << i;
        clear += is_clear ? 1 : 0;
        met += hit ? 1 : 0;
    }
    // Of ways that meet nothing it finds some: what it leaves out costs time only.
    EXPECT_GT(clear, ways / 10);
    EXPECT_GT(met, ways / 10);
}

TEST(StemIndex, TakesBothTreesOfOnePatch) {
    // A tool of this field kept one tree per cell for years.
    const Slope flat = plane_slope(0.0, {0.3, 0.75}, 0.0, 100.0, 100.0);
    const std::vector<Stem> pair{{50.0, 50.0, 30.0, 20.0, 1.0}, {52.0, 50.5, 30.0, 20.0, 1.0}};
    const StemIndex index{pair, flat.terrain, 0.5, false};
    const Flight flight = along(flat, 45.0, 50.2, 0.0, 10.0);
    const auto first = index.first_hit(flight, 0.3 + 1.0, 0.5, {}, {});
    ASSERT_TRUE(first);
    EXPECT_EQ(first->stem, 0U);
    const auto second =
        index.first_hit_rolling(flight.start_m, flight.velocity_mps, 2.0, 0.5, std::array{0U}, {});
    ASSERT_TRUE(second);
    EXPECT_EQ(second->stem, 1U);
}

TEST(StemIndex, IsMetByTheEdgeOfTheRock) {
    // The same tool counted a hit only if the centre of the rock met the stem.
    const Slope flat = plane_slope(0.0, {0.3, 0.75}, 0.0, 100.0, 100.0);
    const StemIndex index{std::vector<Stem>{{50.0, 50.0, 30.0, 20.0, 1.0}}, flat.terrain, 0.5, false};
    const auto hit_at_offset = [&](double offset_m) {
        const Flight flight = along(flat, 45.0, 50.0 + offset_m, 0.0, 10.0);
        return index.first_hit_rolling(flight.start_m, flight.velocity_mps, 2.0, 0.5, {}, {});
    };
    ASSERT_TRUE(hit_at_offset(0.649));
    EXPECT_FALSE(hit_at_offset(0.651));
    EXPECT_NEAR(hit_at_offset(0.4)->offset_m, -0.4, 1e-9);  // the axis lies right of the path
    EXPECT_NEAR(hit_at_offset(0.0)->time_s, (5.0 - 0.65) / 10.0, 1e-9);
}

TEST(StemIndex, IsFlownOver) {
    const Slope flat = plane_slope(0.0, {0.3, 0.75}, 0.0, 100.0, 100.0);
    const StemIndex index{std::vector<Stem>{{50.0, 50.0, 30.0, 8.0, 1.0}}, flat.terrain, 0.5, false};
    Flight flight = along(flat, 45.0, 50.0, 0.0, 20.0);
    flight.start_m.z() += 8.0;  // underside 9 m above ground, falls 0.23 m until the stem
    EXPECT_FALSE(index.first_hit(flight, 1.0, 0.5, {}, {}));
    flight.start_m.z() -= 1.0;
    EXPECT_TRUE(index.first_hit(flight, 1.0, 0.5, {}, {}));
}

TEST(StemIndex, IsFlownOverWhereASnagIsBrokenOff) {
    const Slope flat = plane_slope(0.0, {0.3, 0.75}, 0.0, 100.0, 100.0);
    Stem snag{50.0, 50.0, 30.0, 25.0, 1.0};
    snag.broken_at_m = 3.0;
    const StemIndex index{std::vector<Stem>{snag}, flat.terrain, 0.5, true};
    Flight flight = along(flat, 45.0, 50.0, 0.0, 20.0);  // underside falls by 0.25 m until the stem
    flight.start_m.z() += 2.4;
    EXPECT_FALSE(index.first_hit(flight, 1.0, 0.5, {}, {}));
    flight.start_m.z() -= 0.4;
    const auto hit = index.first_hit(flight, 1.0, 0.5, {}, {});
    ASSERT_TRUE(hit);
    // The centre passes above the top: the stem is met by its thickness there, that of the whole tree.
    EXPECT_GT(hit->height_m, 3.0);
    EXPECT_NEAR(hit->reach_m, 0.5 + 0.15 * taper(3.0, 25.0), 1e-12);
    snag.strength = 0.4;
    const StemIndex rotten{std::vector<Stem>{snag}, flat.terrain, 0.5, true};
    EXPECT_DOUBLE_EQ(rotten.placed()[0].largest_energy_j, 0.4 * largest_energy_j(30.0, 1.0));
}

TEST(StemIndex, IgnoresTheStemJustHitAndThoseGone) {
    const Slope flat = plane_slope(0.0, {0.3, 0.75}, 0.0, 100.0, 100.0);
    const StemIndex index{std::vector<Stem>{{50.0, 50.0, 30.0, 20.0, 1.0}}, flat.terrain, 0.5, false};
    const Flight flight = along(flat, 45.0, 50.0, 0.0, 10.0);
    EXPECT_FALSE(index.first_hit_rolling(flight.start_m, flight.velocity_mps, 2.0, 0.5, std::array{0U}, {}));
    const std::vector<std::uint8_t> gone{1};
    EXPECT_FALSE(index.first_hit_rolling(flight.start_m, flight.velocity_mps, 2.0, 0.5, {}, gone));
}

TEST(StemIndex, ReportsStemsWithoutGround) {
    const Slope flat = plane_slope(0.0, {0.3, 0.75}, 0.0, 100.0, 100.0);
    const StemIndex index{std::vector<Stem>{{500.0, 50.0, 30.0, 20.0, 1.0}, {50.0, 50.0, 30.0, 20.0, 1.0}},
                          flat.terrain, 0.5, true};
    ASSERT_EQ(index.outside().size(), 1U);
    EXPECT_EQ(index.outside()[0], 0U);
    EXPECT_EQ(index.placed().size(), 2U);
}

RC_GTEST_PROP(StemIndex, FindsWhatALookAtEveryStemFinds, ()) {
    static const Slope flat = plane_slope(0.0, {0.3, 0.75}, 0.0, 300.0, 300.0);
    static const std::vector<Stem> stems = random_stems(4'000, 300.0, 40.0);
    static const StemIndex index{stems, flat.terrain, 1.0, false};
    config::RandomStream stream{{*rc::gen::arbitrary<std::uint32_t>(), 0, 0, 0}, config::Purpose::test};
    const Flight flight = along(flat, 20.0 + 250.0 * stream.uniform(), 20.0 + 250.0 * stream.uniform(),
                                6.2832 * stream.uniform(), 5.0 + 20.0 * stream.uniform());
    const double until_s = 3.0 * stream.uniform();
    const double radius_m = 0.05 + 0.95 * stream.uniform();
    const auto found =
        index.first_hit_rolling(flight.start_m, flight.velocity_mps, until_s, radius_m, {}, {});
    const auto expected = first_hit_of_all(index, flight, until_s, radius_m);
    RC_ASSERT(found.has_value() == expected.has_value());
    if (found) {
        RC_ASSERT(found->stem == expected->stem);
        RC_ASSERT(std::abs(found->time_s - expected->time_s) < 1e-9);
    }
}

}  // namespace
}  // namespace rockfall::stem_index_test
