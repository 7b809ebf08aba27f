#include "rockfall/obstacles/nets/net_index.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace rockfall::net_index_test {
namespace {

using Line = std::vector<Eigen::Vector2d>;

NetIndex index_of(std::vector<Line> lines) {
    std::vector<Net> nets;
    for (Line& line : lines) {
        nets.push_back({std::move(line), 3.0, 0.0, 1e6});
    }
    return NetIndex{nets};
}

std::vector<NetLineCrossing> crossings(const NetIndex& nets, const Eigen::Vector2d& from,
                                       const Eigen::Vector2d& to) {
    std::vector<NetLineCrossing> found;
    nets.find_crossings(from, to, found);
    return found;
}

TEST(NetIndex, TellsWhereAPathCrossesTheLine) {
    const NetIndex nets = index_of({{{10.0, 0.0}, {10.0, 20.0}, {30.0, 20.0}}});
    const auto found = crossings(nets, {0.0, 5.0}, {40.0, 5.0});
    ASSERT_EQ(found.size(), 1U);
    EXPECT_DOUBLE_EQ(found[0].share, 0.25);
    EXPECT_DOUBLE_EQ(found[0].along_m, 5.0);
    const auto second = crossings(nets, {15.0, 10.0}, {15.0, 30.0});
    ASSERT_EQ(second.size(), 1U);
    EXPECT_DOUBLE_EQ(second[0].along_m, 25.0);
    EXPECT_TRUE(crossings(nets, {15.0, 0.0}, {40.0, 15.0}).empty());
}

TEST(NetIndex, OrdersCrossingsAlongThePath) {
    const NetIndex nets = index_of({{{30.0, -5.0}, {30.0, 5.0}}, {{10.0, -5.0}, {10.0, 5.0}}});
    const auto found = crossings(nets, {0.0, 0.0}, {40.0, 0.0});
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0].net, 1U);
    EXPECT_EQ(found[1].net, 0U);
}

TEST(NetIndex, CountsAPathThroughACornerOnce) {
    const NetIndex nets = index_of({{{10.0, -10.0}, {12.0, 0.0}, {10.0, 10.0}}});
    EXPECT_EQ(crossings(nets, {0.0, 0.0}, {20.0, 0.0}).size(), 1U);
    EXPECT_EQ(crossings(nets, {20.0, 0.0}, {0.0, 0.0}).size(), 1U);
}

TEST(NetIndex, CountsAPathOfPiecesThatMeetOnTheLineOnce) {
    const NetIndex nets = index_of({{{10.0, -10.0}, {10.0, 10.0}}});
    const std::size_t count =
        crossings(nets, {0.0, 0.0}, {10.0, 1.0}).size() + crossings(nets, {10.0, 1.0}, {20.0, 3.0}).size();
    EXPECT_EQ(count, 1U);
}

double uniform(double low, double high) {
    return low + (high - low) * *rc::gen::inRange(0, 1'000'000) * 1e-6;
}

RC_GTEST_PROP(NetIndex, AgreesWithAFineWalkAlongThePath, ()) {
    Line line;
    for (int i = *rc::gen::inRange(2, 6); i > 0; --i) {
        line.emplace_back(uniform(0.0, 50.0), uniform(0.0, 50.0));
    }
    const NetIndex nets = index_of({line});
    const Eigen::Vector2d from{uniform(0.0, 50.0), uniform(0.0, 50.0)};
    const Eigen::Vector2d to{uniform(0.0, 50.0), uniform(0.0, 50.0)};
    const auto found = crossings(nets, from, to);
    // Both lines as parameters, solved by Cramer's rule: another way to the same points.
    std::size_t expected = 0;
    double before_m = 0.0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const Eigen::Vector2d way = to - from;
        const Eigen::Vector2d edge = line[i + 1] - line[i];
        const Eigen::Vector2d gap = line[i] - from;
        const double det = way.y() * edge.x() - way.x() * edge.y();
        RC_PRE(std::abs(det) > 1e-6);
        const double s = (gap.y() * edge.x() - gap.x() * edge.y()) / det;
        const double t = (way.x() * gap.y() - way.y() * gap.x()) / det;
        RC_PRE(std::abs(s) > 1e-9 && std::abs(s - 1.0) > 1e-9 && std::abs(t) > 1e-9 &&
               std::abs(t - 1.0) > 1e-9);
        if (s > 0.0 && s < 1.0 && t > 0.0 && t < 1.0) {
            ++expected;
            bool there = false;
            for (const NetLineCrossing& crossing : found) {
                there = there || (std::abs(crossing.share - s) < 1e-6 &&
                                  std::abs(crossing.along_m - before_m - t * edge.norm()) < 1e-5);
            }
            RC_ASSERT(there);
        }
        before_m += edge.norm();
    }
    RC_ASSERT(found.size() == expected);
    for (std::size_t i = 1; i < found.size(); ++i) {
        RC_ASSERT(found[i - 1].share <= found[i].share);
    }
}

}  // namespace
}  // namespace rockfall::net_index_test
