// Blocks out of joint sets and Voronoi cells, and out of bodies: volumes add up, faces pair up.

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "rockfall/rock_mass/body.hpp"
#include "rockfall/rock_mass/interfaces.hpp"
#include "rockfall/rock_mass/joint_sets.hpp"
#include "rockfall/rock_mass/voronoi_cells.hpp"
#include "tests/rockfall/rock_mass/scenes.hpp"

namespace rockfall::rock_mass {
namespace {

using Eigen::Vector3d;

double volume_of(const std::vector<ConvexCell>& cells) {
    return std::accumulate(cells.begin(), cells.end(), 0.0, [](double sum, const ConvexCell& cell) {
        return sum + volume_and_centre(cell).volume_m3;
    });
}

double area_of_face(const CellFace& face) {
    Vector3d sum = Vector3d::Zero();
    for (std::size_t k = 1; k + 1 < face.corners_m.size(); ++k) {
        sum += (face.corners_m[k] - face.corners_m[0]).cross(face.corners_m[k + 1] - face.corners_m[0]);
    }
    return 0.5 * sum.norm();
}

/// Area of all faces that are not of the border, each side counted.
double inner_area(const std::vector<ConvexCell>& cells) {
    double sum = 0.0;
    for (const ConvexCell& cell : cells) {
        for (const CellFace& face : cell.faces) {
            sum += face.made_by == made_by_border ? 0.0 : area_of_face(face);
        }
    }
    return sum;
}

double shared_area(const std::vector<ConvexCell>& cells) {
    double sum = 0.0;
    for (const Interface& face : shared_faces(cells)) {
        sum += face.area_m2;
    }
    return sum;
}

const Vector3d low{0.0, 0.0, 0.0}, high{20.0, 16.0, 12.0};

std::vector<JointSet> three_sets(SpacingLaw law) {
    return {{"a", 70.0, 90.0, 3.0, law, 1.0, 1.0, {}},
            {"b", 85.0, 10.0, 4.0, law, 1.0, 1.0, {}},
            {"c", 15.0, 250.0, 2.5, law, 1.0, 1.0, {}}};
}

TEST(JointSet, NormalFollowsDipAndDirection) {
    // Dips 30 deg to the east: the normal leans to the east by 30 deg.
    const Vector3d normal = JointSet{"", 30.0, 90.0, 1.0, SpacingLaw::constant, 0.0, 1.0, {}}.normal();
    EXPECT_NEAR((normal - Vector3d(0.5, 0.0, std::sqrt(0.75))).norm(), 0.0, 1e-10);
    const Vector3d west = JointSet{"", 90.0, 270.0, 1.0, SpacingLaw::constant, 0.0, 1.0, {}}.normal();
    EXPECT_NEAR((west - Vector3d(-1.0, 0.0, 0.0)).norm(), 0.0, 1e-10);
}

TEST(JointSet, PiecesAreAsManyAsExpected) {
    const std::vector<JointSet> sets = three_sets(SpacingLaw::constant);
    const Vector3d corner{80.0, 72.0, 60.0};
    const double expected = expected_pieces(corner.prod(), sets, 0.01);
    const auto cells = cut_by_joints(box_cell(low, corner, made_by_border), sets, 0.01, 5);
    // Each piece has a lowest corner in which three joints meet, but for those at the border: with at least
    // 16 joints of a set across the box these are fewer than (1 + 1/16)^3 - 1 on either side.
    EXPECT_GT(static_cast<double>(cells.size()), expected / std::pow(1.0 + 1.0 / 16.0, 3));
    EXPECT_LT(static_cast<double>(cells.size()), expected * std::pow(1.0 + 2.0 / 16.0, 3));
    EXPECT_EQ(expected_pieces(1000.0, sets, 5.0), 8.0);
    EXPECT_EQ(expected_pieces(1000.0, std::span{sets}.first(2), 0.01), 0.0);
}

TEST(JointSet, SpacingsHaveTheirMean) {
    for (const SpacingLaw law :
         {SpacingLaw::constant, SpacingLaw::uniform, SpacingLaw::exponential, SpacingLaw::lognormal}) {
        const JointSet set{"", 0.0, 0.0, 2.0, law, 0.8, 1.0, {}};
        config::RandomStream draws{{1, 0, 0, 7}, config::Purpose::test};
        const std::vector<double> places = joint_places(set, 0.0, 20000.0, draws);
        const double mean = (places.back() - places.front()) / static_cast<double>(places.size() - 1);
        const double deviation = law == SpacingLaw::constant      ? 0.01
                                 : law == SpacingLaw::exponential ? 2.0
                                                                  : 0.8;
        EXPECT_NEAR(mean, 2.0, 4.0 * deviation / 100.0) << static_cast<int>(law);
    }
}

TEST(Cutting, ByJointsKeepsTheVolumeAndPairsTheFaces) {
    for (const SpacingLaw law : {SpacingLaw::constant, SpacingLaw::uniform, SpacingLaw::exponential}) {
        const std::vector<JointSet> sets = three_sets(law);
        const std::vector<ConvexCell> cells =
            cut_by_joints(box_cell(low, high, made_by_border), sets, 0.5, 4);
        EXPECT_GT(cells.size(), 60U);
        EXPECT_NEAR(volume_of(cells), 20.0 * 16.0 * 12.0, 1e-8 * 3840.0);
        // Each inner face has its other side; joints that end at a sliver pair up in part with two of them.
        EXPECT_NEAR(2.0 * shared_area(cells), inner_area(cells), 1e-3 * inner_area(cells));
        for (const ConvexCell& cell : cells) {
            EXPECT_GE(volume_and_centre(cell).volume_m3, 0.125);
        }
    }
}

TEST(Cutting, IntoVoronoiCellsKeepsTheVolumeAndPairsTheFaces) {
    const std::vector<ConvexCell> cells = voronoi_cells(low, high, 2.0, 3);
    EXPECT_EQ(cells.size(), 480U);
    EXPECT_NEAR(volume_of(cells), 3840.0, 1e-9 * 3840.0);
    EXPECT_NEAR(2.0 * shared_area(cells), inner_area(cells), 1e-3 * inner_area(cells));
}

/// Facets of a hull as the border of a body.
Body body_of(const solids::Hull& hull) {
    Body body;
    for (const solids::Face& face : hull.faces) {
        Facet facet;
        for (const std::uint32_t corner : face.corners) {
            facet.corners_m.push_back(hull.vertices_m[corner]);
        }
        body.border.push_back(facet);
    }
    body.contains = [hull](const Vector3d& point_m) {
        return std::all_of(hull.faces.begin(), hull.faces.end(), [&](const solids::Face& face) {
            return face.normal.dot(point_m) <= face.offset_m;
        });
    };
    return body;
}

TEST(Dividing, GivesEachSideItsVolume) {
    const solids::Hull ball = solids::placed(solids::ellipsoid({8.0, 7.0, 5.0}, 1),
                                             Eigen::Quaterniond::Identity(), {10.0, 8.0, 6.0});
    const double volume_m3 = solids::volume_integrals(ball).volume_m3;
    const Body body = body_of(ball);
    const FacetIndex index{body, 3.0};
    std::vector<ConvexCell> inside, outside;
    for (const ConvexCell& cell :
         cut_by_joints(box_cell(low, high, made_by_border), three_sets(SpacingLaw::uniform), 0.5, 4)) {
        const Division division = divide(cell, body, index.near(cell), made_by_border);
        inside.insert(inside.end(), division.inside.begin(), division.inside.end());
        outside.insert(outside.end(), division.outside.begin(), division.outside.end());
    }
    EXPECT_NEAR(volume_of(inside), volume_m3, 1e-5 * volume_m3);
    EXPECT_NEAR(volume_of(outside), 3840.0 - volume_m3, 1e-5 * volume_m3);
    // Slivers go to their neighbours or are counted as left out: nothing is lost.
    const Merged merged = merge_slivers(inside, 0.5);
    EXPECT_LT(merged.cells.size(), inside.size());
    EXPECT_NEAR(volume_of(merged.cells) + merged.left_out_m3, volume_of(inside), 1e-6 * volume_m3);
    EXPECT_LT(merged.left_out_m3, 0.02 * volume_m3);
}

TEST(Dividing, OfADentedBodyIsExact) {
    // A box with a step: two boxes on each other, of which one is smaller.
    Body body;
    const auto add_box = [&](const Vector3d& from, const Vector3d& to) {
        for (const CellFace& face : box_cell(from, to, 0).faces) {
            body.border.push_back({face.corners_m});
        }
    };
    add_box({2.0, 2.0, 1.0}, {18.0, 14.0, 5.0});
    add_box({2.0, 2.0, 5.0}, {9.0, 14.0, 10.0});
    body.contains = [](const Vector3d& p) {
        return p.x() > 2.0 && p.x() < 18.0 && p.y() > 2.0 && p.y() < 14.0 && p.z() > 1.0 &&
               p.z() < (p.x() < 9.0 ? 10.0 : 5.0);
    };
    const FacetIndex index{body, 3.0};
    const ConvexCell whole = box_cell(low, high, 0);
    const Division division = divide(whole, body, index.near(whole), made_by_border);
    EXPECT_NEAR(volume_of(division.inside), 16.0 * 12.0 * 4.0 + 7.0 * 12.0 * 5.0, 1e-9);
}

}  // namespace
}  // namespace rockfall::rock_mass
