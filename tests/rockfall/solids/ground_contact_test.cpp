#include "rockfall/solids/ground_contact.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "rockfall/solids/shapes.hpp"

namespace rockfall::solids::ground_contact_test {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

const GroundTriangle flat{{Vector3d{-10, -10, 0}, Vector3d{10, -10, 0}, Vector3d{0, 10, 0}},
                          Vector3d::UnitZ()};

/// A ridge along x: both sides fall at 45 deg.
const GroundEdge ridge{
    {-1, 0, 0}, {1, 0, 0}, Vector3d{0, 1, 1}.normalized(), Vector3d{0, -1, 1}.normalized()};

Hull cube_at(const Quaterniond& attitude, const Vector3d& place_m) {
    return placed(box({1, 1, 1}), attitude, place_m);
}

TEST(GroundContact, OfACubeOnItsFaceIsFourVertices) {
    const auto contacts = vertices_on(flat, cube_at(Quaterniond::Identity(), {0, 0, 0.499}), 0.01);
    ASSERT_EQ(contacts.size(), 4U);
    for (const GroundContact& contact : contacts) {
        EXPECT_EQ(contact.kind, ContactKind::vertex_on_face);
        EXPECT_NEAR(contact.gap_m, -0.001, 1e-15);
        EXPECT_EQ(contact.normal, Vector3d::UnitZ());
        EXPECT_NEAR(contact.point_m.z(), 0.0, 1e-15);
    }
}

TEST(GroundContact, OfACubeOnEdgeAndCornerIsTwoAndOne) {
    const Quaterniond on_edge{Eigen::AngleAxisd{M_PI / 4, Vector3d::UnitX()}};
    EXPECT_EQ(vertices_on(flat, cube_at(on_edge, {0, 0, std::sqrt(0.5)}), 0.01).size(), 2U);
    const Quaterniond on_corner = Quaterniond::FromTwoVectors(Vector3d{1, 1, 1}, -Vector3d::UnitZ());
    const auto contacts = vertices_on(flat, cube_at(on_corner, {0, 0, std::sqrt(0.75) + 0.002}), 0.01);
    ASSERT_EQ(contacts.size(), 1U);
    EXPECT_NEAR(contacts[0].gap_m, 0.002, 1e-14);
}

TEST(GroundContact, EndsWithTheTriangle) {
    EXPECT_TRUE(vertices_on(flat, cube_at(Quaterniond::Identity(), {0, -11, 0.5}), 0.01).empty());
    EXPECT_EQ(vertices_on(flat, cube_at(Quaterniond::Identity(), {0, -10, 0.5}), 0.01).size(), 2U);
}

TEST(GroundContact, OfAPeakBelowAPlateIsItsFace) {
    const Hull plate = placed(box({2, 2, 0.2}), Quaterniond::Identity(), {0, 0, 0.1});
    const auto outside = face_on({0.3, 0.2, -0.005}, plate, 0.01);
    ASSERT_TRUE(outside.has_value());
    EXPECT_NEAR(outside->gap_m, 0.005, 1e-15);
    EXPECT_EQ(outside->normal, Vector3d::UnitZ());
    const auto inside = face_on({0.3, 0.2, 0.004}, plate, 0.01);
    ASSERT_TRUE(inside.has_value());
    EXPECT_NEAR(inside->gap_m, -0.004, 1e-15);
    EXPECT_FALSE(face_on({1.001, 0.2, -0.005}, plate, 0.01).has_value()) << "beside the face";
    EXPECT_FALSE(face_on({0.3, 0.2, 0.199}, plate, 0.01).has_value()) << "nearest to the upper face";
}

TEST(GroundContact, OfAnEdgeAcrossARidgeIsWhereTheyCross) {
    // A cube on its edge along y, across the ridge along x: the lowest edge runs over the ridge at x = 0.2.
    const Quaterniond on_edge{Eigen::AngleAxisd{M_PI / 4, Vector3d::UnitY()}};
    const auto contacts = edges_across(ridge, cube_at(on_edge, {0.2, 0.1, std::sqrt(0.5) - 0.003}), 0.01);
    ASSERT_EQ(contacts.size(), 1U);
    EXPECT_EQ(contacts[0].kind, ContactKind::edge_on_edge);
    EXPECT_NEAR(contacts[0].gap_m, -0.003, 1e-14);
    EXPECT_LT((contacts[0].point_m - Vector3d{0.2, 0, 0}).norm(), 1e-14);
    EXPECT_LT((contacts[0].normal - Vector3d::UnitZ()).norm(), 1e-14);
    EXPECT_TRUE(edges_across(ridge, cube_at(on_edge, {1.2, 0.1, std::sqrt(0.5)}), 0.01).empty())
        << "beyond the end of the ridge";
}

TEST(GroundContact, LeavesEdgesInPlanesAndValleysAlone) {
    const Quaterniond on_edge{Eigen::AngleAxisd{M_PI / 4, Vector3d::UnitY()}};
    const Hull cube = cube_at(on_edge, {0.2, 0.1, std::sqrt(0.5)});
    GroundEdge even = ridge;
    even.left_normal = even.right_normal = Vector3d::UnitZ();
    EXPECT_TRUE(edges_across(even, cube, 0.01).empty());
    GroundEdge valley = ridge;
    std::swap(valley.left_normal, valley.right_normal);
    EXPECT_TRUE(edges_across(valley, cube, 0.01).empty());
}

TEST(GroundContact, OfAPlateOnARidgeIsTwoEdges) {
    // The plate is wider than the ridge's two sides are steep: only its edges that cross the ridge touch it.
    const Hull plate = placed(box({1, 3, 0.2}), Quaterniond::Identity(), {0, 0, 0.1});
    const auto contacts = edges_across(ridge, plate, 1e-9);
    ASSERT_EQ(contacts.size(), 2U);
    for (const GroundContact& contact : contacts) {
        EXPECT_NEAR(std::abs(contact.point_m.x()), 0.5, 1e-15);
        EXPECT_LT((contact.normal - Vector3d::UnitZ()).norm(), 1e-15);
    }
}

}  // namespace
}  // namespace rockfall::solids::ground_contact_test
