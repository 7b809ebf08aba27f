#include "rockfall/tally/target_index.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "config/random/stream.hpp"

namespace rockfall::target_index_test {
namespace {

using Eigen::Vector2d;

Target house(double x, double y, double size) {
    Target target;
    target.is_area = true;
    target.parts = {{{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}, {x, y}}};
    return with_bounds(target);
}

Target road(std::vector<Vector2d> line) {
    Target target;
    target.parts = {std::move(line)};
    return with_bounds(target);
}

/// A village: houses of many sizes, some within others, long roads across and a large area under all.
std::vector<Target> village(int houses) {
    config::RandomStream draw{{7, 0, 0, 1}, config::Purpose::sampling};
    std::vector<Target> targets;
    for (int i = 0; i < houses; ++i) {
        targets.push_back(
            house(1000.0 * draw.uniform(), 700.0 * draw.uniform(), 5.0 + 40.0 * draw.uniform()));
    }
    targets.push_back(road({{-50.0, 20.0}, {400.0, 350.0}, {1100.0, 360.0}}));
    targets.push_back(road({{500.0, -20.0}, {500.0, 800.0}}));
    targets.push_back(house(100.0, 100.0, 500.0));
    return targets;
}

bool holds(std::span<const std::uint32_t> list, std::uint32_t target) {
    return std::find(list.begin(), list.end(), target) != list.end();
}

TEST(TargetIndex, MissesNoTargetThatAPieceMeets) {
    for (const int houses : {0, 1, 30, 400}) {
        const std::vector<Target> targets = village(houses);
        TargetIndex index{targets};
        config::RandomStream draw{{8, 0, 0, 2}, config::Purpose::sampling};
        int met = 0;
        for (int i = 0; i < 4000; ++i) {
            const Vector2d from{1300.0 * draw.uniform() - 150.0, 1000.0 * draw.uniform() - 150.0};
            const double length = i % 4 == 0 ? 400.0 : 15.0;
            const Vector2d to = from + length * Vector2d{draw.uniform() - 0.5, draw.uniform() - 0.5};
            const auto near = index.near_piece(from, to);
            EXPECT_TRUE(std::is_sorted(near.begin(), near.end()));
            EXPECT_EQ(std::adjacent_find(near.begin(), near.end()), near.end());
            for (std::uint32_t t = 0; t < targets.size(); ++t) {
                if (first_crossing(targets[t], from, to)) {
                    ++met;
                    EXPECT_TRUE(holds(near, t)) << t;
                }
            }
        }
        EXPECT_GT(met, 100);
    }
}

TEST(TargetIndex, NamesTheSameWhateverPieceCameBefore) {
    const std::vector<Target> targets = village(30);
    TargetIndex index{targets};
    config::RandomStream draw{{9, 0, 0, 2}, config::Purpose::sampling};
    const auto near = [](TargetIndex& of, const Vector2d& from, const Vector2d& to) {
        const auto found = of.near_piece(from, to);
        return std::vector<std::uint32_t>{found.begin(), found.end()};
    };
    Vector2d place{600.0, 300.0};
    std::size_t named = 0;
    for (int i = 0; i < 2000; ++i) {  // one way of short pieces, into the grid and out of it
        Vector2d next = place + 20.0 * Vector2d{draw.uniform() - 0.5, draw.uniform() - 0.5};
        next = next.cwiseMax(-200.0).cwiseMin(1300.0);
        TargetIndex fresh{targets};
        const std::vector<std::uint32_t> found = near(index, place, next);
        ASSERT_EQ(found, near(fresh, place, next)) << i;
        named += found.size();
        place = next;
    }
    EXPECT_GT(named, 100U);
}

TEST(TargetIndex, MissesNoTargetWithinItsReach) {
    const std::vector<Target> targets = village(200);
    for (const double reach_m : {0.4, 3.0}) {
        TargetIndex index{targets, reach_m};
        config::RandomStream draw{{11, 0, 0, 2}, config::Purpose::sampling};
        int touched = 0;
        for (int i = 0; i < 2000; ++i) {
            const Vector2d from{1300.0 * draw.uniform() - 150.0, 1000.0 * draw.uniform() - 150.0};
            const Vector2d to = from + 15.0 * Vector2d{draw.uniform() - 0.5, draw.uniform() - 0.5};
            const auto near = index.near_piece(from, to);
            for (std::uint32_t t = 0; t < targets.size(); ++t) {
                if (first_touch(targets[t], from, to, reach_m)) {
                    ++touched;
                    EXPECT_TRUE(holds(near, t)) << t;
                }
            }
        }
        EXPECT_GT(touched, 100);
    }
}

TEST(TargetIndex, MissesNoPieceAlongOrAtTheEndOfASide) {
    const std::vector<Target> targets{house(0.0, 0.0, 10.0), house(10.0, 0.0, 10.0),
                                      road({{0.0, 40.0}, {333.3, 40.0}})};
    TargetIndex index{targets};
    for (const auto& [from, to] : {std::pair{Vector2d{-5.0, 0.0}, Vector2d{0.0, 0.0}},
                                   {Vector2d{5.0, 10.0}, Vector2d{5.0, 10.0 + 1e-9}},
                                   {Vector2d{10.0, 5.0}, Vector2d{10.0, 5.0}}}) {
        EXPECT_TRUE(holds(index.near_piece(from, to), 0));
    }
    EXPECT_TRUE(holds(index.near_piece({20.0, -1.0}, {20.0, 1.0}), 1));
    EXPECT_TRUE(holds(index.near_piece({333.3, 39.0}, {333.3, 41.0}), 2));
}

TEST(TargetIndex, KnowsTheAreasAroundAPoint) {
    const std::vector<Target> targets = village(300);
    const TargetIndex index{targets};
    config::RandomStream draw{{9, 0, 0, 3}, config::Purpose::sampling};
    int inside = 0;
    for (int i = 0; i < 3000; ++i) {
        const Vector2d point{1300.0 * draw.uniform() - 150.0, 1000.0 * draw.uniform() - 150.0};
        const auto near = index.areas_near(point);
        for (std::uint32_t t = 0; t < targets.size(); ++t) {
            if (targets[t].is_area && is_inside(targets[t], point)) {
                ++inside;
                EXPECT_TRUE(holds(near, t));
            }
        }
        EXPECT_TRUE(std::all_of(near.begin(), near.end(), [&](auto t) { return targets[t].is_area; }));
    }
    EXPECT_GT(inside, 1000);
}

TEST(TargetIndex, NamesFewTargetsHoweverManyThereAre) {
    // Houses of 10 m side by side: near a piece of 15 m lie a handful, of 25 as of 10 000.
    for (const int side : {5, 100}) {
        std::vector<Target> targets;
        for (int i = 0; i < side * side; ++i) {
            targets.push_back(house(20.0 * (i % side), 20.0 * (i / side), 10.0));
        }
        TargetIndex index{targets};
        std::size_t most = 0;
        config::RandomStream draw{{10, 0, 0, 4}, config::Purpose::sampling};
        for (int i = 0; i < 500; ++i) {
            const Vector2d from = 20.0 * side * Vector2d{draw.uniform(), draw.uniform()};
            most = std::max(most, index.near_piece(from, from + Vector2d{15.0, 3.0}).size());
        }
        EXPECT_LE(most, 16U) << side;
    }
}

TEST(TargetIndex, OfNothingNamesNothing) {
    TargetIndex index{std::span<const Target>{}};
    EXPECT_TRUE(index.near_piece({0.0, 0.0}, {1.0, 1.0}).empty());
    EXPECT_TRUE(index.areas_near({0.0, 0.0}).empty());
}

}  // namespace
}  // namespace rockfall::target_index_test
