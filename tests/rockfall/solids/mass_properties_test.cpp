#include "rockfall/solids/mass_properties.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "rockfall/solids/shapes.hpp"

namespace rockfall::solids::mass_properties_test {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

const Quaterniond oblique = Quaterniond{0.3, -0.5, 0.7, 0.4}.normalized();

TEST(MassProperties, OfABoxAreThoseOfTheTextbookWhereverItStands) {
    const Vector3d sides_m{1.0, 2.0, 3.0};
    const Vector3d place_m{1000.0, -2000.0, 500.0};
    const VolumeIntegrals found = volume_integrals(placed(box(sides_m), oblique, place_m));
    EXPECT_NEAR(found.volume_m3, 6.0, 1e-9);
    EXPECT_LT((found.centroid_m - place_m).norm(), 1e-9);
    const Matrix3d turn = oblique.toRotationMatrix();
    // V (b^2 + c^2) / 12 about the first axis
    const Matrix3d expected = turn * Vector3d{6.5, 5.0, 2.5}.asDiagonal() * turn.transpose();
    EXPECT_LT((found.inertia_m5 - expected).norm(), 1e-9);
}

TEST(MassProperties, OfATetrahedronAreThoseOfTonon) {
    // Of the corner tetrahedron with legs 1 about the centroid: V = 1/6, integral of x^2 = 1/60, of x y =
    // 1/120 from the corner, so I_xx = 2/60 - V (2/16) = 1/80 and I_xy = -(1/120 - V/16) = 1/480.
    const VolumeIntegrals found =
        volume_integrals(convex_hull(std::vector<Vector3d>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
    EXPECT_NEAR(found.volume_m3, 1.0 / 6.0, 1e-15);
    EXPECT_LT((found.centroid_m - Vector3d::Constant(0.25)).norm(), 1e-15);
    const Matrix3d expected =
        Matrix3d::Constant(1.0 / 480.0) + (1.0 / 80.0 - 1.0 / 480.0) * Matrix3d::Identity();
    EXPECT_LT((found.inertia_m5 - expected).norm(), 1e-15);
}

TEST(MassProperties, OfAFineHullApproachTheEllipsoid) {
    // I = m (b^2 + c^2) / 5 with half axes. Each division takes the error to about a quarter.
    const Vector3d axes_m{1.0, 1.5, 2.5};
    const Vector3d squares = (0.5 * axes_m).cwiseAbs2();
    double coarser_error = 1.0;
    for (int divisions = 1; divisions <= 4; ++divisions) {
        const VolumeIntegrals found = volume_integrals(ellipsoid(axes_m, divisions));
        const double exact_volume_m3 = M_PI / 6.0 * axes_m.prod();
        const Vector3d exact = exact_volume_m3 / 5.0 * (Vector3d::Constant(squares.sum()) - squares);
        const double volume_error = 1.0 - found.volume_m3 / exact_volume_m3;
        const double inertia_error = (found.inertia_m5.diagonal() - exact).norm() / exact.norm();
        EXPECT_GT(volume_error, 0.0);
        EXPECT_LT(volume_error, 0.3 * coarser_error);
        EXPECT_NEAR(inertia_error, 5.0 / 3.0 * volume_error, 0.1 * volume_error);  // volume^(5/3)
        coarser_error = volume_error;
    }
}

TEST(PrincipalAxes, AreRightHandedAscendingAndDiagonalise) {
    const Vector3d moments{1.0, 2.0, 7.0};
    const Matrix3d turn = oblique.toRotationMatrix();
    const PrincipalAxes found = principal_axes(turn * moments.asDiagonal() * turn.transpose());
    EXPECT_LT((found.moments - moments).norm(), 1e-14);
    EXPECT_NEAR(found.axes.determinant(), 1.0, 1e-14);
    for (int k = 0; k < 3; ++k) {
        EXPECT_NEAR(std::abs(found.axes.col(k).dot(turn.col(k))), 1.0, 1e-14);
    }
}

TEST(PrincipalAxes, KeepTheGivenAxesWithoutPreference) {
    EXPECT_EQ(principal_axes(3.0 * Matrix3d::Identity()).axes, Matrix3d::Identity());
}

TEST(Solid, LiesInItsPrincipalAxes) {
    const Solid solid = solid_of(placed(box({3.0, 1.0, 2.0}), oblique, {10.0, 20.0, 30.0}), 2700.0);
    EXPECT_NEAR(solid.mass_kg, 6.0 * 2700.0, 1e-8);
    EXPECT_LT((solid.inertia_kgm2 - 2700.0 * Vector3d{2.5, 5.0, 6.5}).norm(), 1e-7);
    EXPECT_NEAR(solid.bounding_radius_m, 0.5 * std::sqrt(14.0), 1e-13);
    EXPECT_NEAR(solid.diameter_m(), std::cbrt(36.0 / M_PI), 1e-10);
    const VolumeIntegrals again = volume_integrals(solid.hull);
    EXPECT_LT(again.centroid_m.norm(), 1e-12);
    EXPECT_LT((again.inertia_m5 * 2700.0 - Matrix3d{solid.inertia_kgm2.asDiagonal()}).norm(), 1e-7);
    for (const Face& face : solid.hull.faces) {
        for (const std::uint32_t corner : face.corners) {
            EXPECT_NEAR(face.normal.dot(solid.hull.vertices_m[corner]), face.offset_m, 1e-12);
        }
    }
    // Back to where it was given.
    const Hull back = placed(solid.hull, solid.from_given.conjugate(), solid.centroid_m);
    EXPECT_LT((volume_integrals(back).centroid_m - Vector3d{10.0, 20.0, 30.0}).norm(), 1e-11);
    for (const Vector3d& vertex_m : back.vertices_m) {
        const Vector3d given = oblique.conjugate() * (vertex_m - Vector3d{10.0, 20.0, 30.0});
        EXPECT_LT((given.cwiseAbs() - Vector3d{1.5, 0.5, 1.0}).norm(), 1e-11);
    }
}

}  // namespace
}  // namespace rockfall::solids::mass_properties_test
