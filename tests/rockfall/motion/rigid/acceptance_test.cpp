// Distances against another library, ledger, steps and bytes of whole falls.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <future>

#include "config/random/stream.hpp"
#include "rockfall/motion/rigid/extent.hpp"
#include "rockfall/solids/ground_contact.hpp"
#include "tests/rockfall/motion/rigid/fcl_oracle.hpp"
#include "tests/rockfall/motion/rigid/scene.hpp"
#include "tests/rockfall/motion/rigid/whole_fall.hpp"

namespace rockfall::rigid {
namespace {

using namespace testing;
using solids::GroundContact;
using solids::Hull;

/// Uniform numbers of one trial.
struct Chance {
    config::RandomStream stream;
    explicit Chance(std::uint64_t trial) : stream{{17, 0, 0, trial}, config::Purpose::test} {}
    double between(double low, double high) { return low + (high - low) * stream.uniform(); }
    Vector3d vector(double size) {
        const double x = between(-size, size), y = between(-size, size), z = between(-size, size);
        return {x, y, z};
    }
    Eigen::Quaterniond attitude() {
        const Vector3d v = vector(1.0);
        return Eigen::Quaterniond{between(-1.0, 1.0), v.x(), v.y(), v.z()}.normalized();
    }
    Hull hull() {
        std::vector<Vector3d> points;
        for (int i = 0; i < 12; ++i) {
            points.push_back(vector(0.5));
        }
        return solids::convex_hull(points);
    }
};

double from_piece_m(const Vector3d& p, const Vector3d& a, const Vector3d& b) {
    const Vector3d along_m = b - a;
    return (p - a - std::clamp(along_m.dot(p - a) / along_m.squaredNorm(), 0.0, 1.0) * along_m).norm();
}

solids::GroundTriangle triangle_of(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
    return {{a, b, c}, (b - a).cross(c - a).normalized()};
}

/// The contacts of a hull with a lone triangle, as the search of the engine has them.
std::vector<GroundContact> contacts_with(const solids::GroundTriangle& triangle, const Hull& hull) {
    constexpr double anywhere_m = 10.0;
    std::vector<GroundContact> all = solids::vertices_on(triangle, hull, anywhere_m);
    for (int k = 0; k < 3; ++k) {
        const Vector3d& from_m = triangle.corners_m[static_cast<std::size_t>(k)];
        const Vector3d& to_m = triangle.corners_m[static_cast<std::size_t>((k + 1) % 3)];
        if (const auto contact = solids::face_on(from_m, hull, anywhere_m)) {
            all.push_back(*contact);
        }
        const Vector3d outwards = (to_m - from_m).cross(triangle.normal).normalized();
        for (const GroundContact& contact :
             solids::edges_across({from_m, to_m, triangle.normal, outwards}, hull, anywhere_m)) {
            all.push_back(contact);
        }
    }
    return all;
}

TEST(RigidContacts, AreAsFarAsFclSays) {
    int compared = 0, of_contacts = 0;
    for (std::uint64_t trial = 0; trial < 400; ++trial) {
        Chance chance{trial};
        const auto triangle = triangle_of({chance.between(-1.0, 0.0), -0.7, chance.between(-0.3, 0.3)},
                                          {chance.between(0.3, 1.0), -0.5, chance.between(-0.3, 0.3)},
                                          {chance.between(-0.3, 0.3), 0.8, chance.between(-0.3, 0.3)});
        const Hull hull =
            solids::placed(chance.hull(), chance.attitude(),
                           {chance.between(-1.0, 1.0), chance.between(-1.0, 1.0), chance.between(0.9, 1.5)});
        const auto fcl_m = rockfall::testing::fcl_distance_m(hull, triangle);
        if (!fcl_m) {
            GTEST_SKIP() << "built without FCL and libccd (libfcl-dev, libccd-dev)";
        }
        if (*fcl_m <= 0.0) {
            continue;
        }
        double nearest_m = 1e9;
        for (const GroundContact& contact : contacts_with(triangle, hull)) {
            nearest_m = std::min(nearest_m, contact.gap_m > 0.0 ? contact.gap_m : 1e9);
        }
        // The rest of the pairs of features never touch first: corner and edge, corner and corner.
        double of_corners_m = 1e9;
        for (std::size_t k = 0; k < 3; ++k) {
            for (const Vector3d& vertex_m : hull.vertices_m) {
                of_corners_m = std::min(of_corners_m, from_piece_m(vertex_m, triangle.corners_m[k],
                                                                   triangle.corners_m[(k + 1) % 3]));
            }
            for (const solids::Edge& edge : hull.edges) {
                of_corners_m =
                    std::min(of_corners_m, from_piece_m(triangle.corners_m[k], hull.vertices_m[edge.from],
                                                        hull.vertices_m[edge.to]));
            }
        }
        EXPECT_NEAR(std::min(nearest_m, of_corners_m), *fcl_m, 1e-6) << trial;
        ++compared;
        of_contacts += nearest_m < of_corners_m ? 1 : 0;
    }
    EXPECT_GT(compared, 300);
    EXPECT_GT(of_contacts, 100);
}

TEST(RigidContacts, OverlapAsDeepAsFclSays) {
    // A pyramid of four triangles as ground: its peak, its ridges and its faces are met by shallow overlaps.
    const std::vector<Vector3d> base{
        {-3.0, -3.0, -1.2}, {3.0, -3.0, -1.0}, {3.0, 3.0, -1.3}, {-3.0, 3.0, -0.9}};
    const Vector3d peak{0.1, -0.05, 0.0};
    std::vector<Vector3d> corners = base;
    corners.push_back(peak);
    corners.emplace_back(0.0, 0.0, -9.0);
    const Hull ground = solids::convex_hull(corners);
    std::vector<solids::GroundTriangle> faces;
    for (std::size_t k = 0; k < 4; ++k) {
        faces.push_back(triangle_of(base[k], base[(k + 1) % 4], peak));
    }
    int compared[3] = {0, 0, 0};
    for (std::uint64_t trial = 0; trial < 6000; ++trial) {
        Chance chance{trial};
        // Every other one over the peak.
        const double off_m = trial % 2 == 0 ? 1.0 : 0.15;
        const Hull hull = solids::placed(
            chance.hull(), chance.attitude(),
            {chance.between(-off_m, off_m), chance.between(-off_m, off_m), chance.between(-0.2, 0.5)});
        constexpr double reach_m = 10.0;
        std::vector<GroundContact> contacts;
        for (std::size_t k = 0; k < 4; ++k) {
            for (const GroundContact& contact : solids::vertices_on(faces[k], hull, reach_m)) {
                contacts.push_back(contact);
            }
            for (const GroundContact& contact : solids::edges_across(
                     {peak, base[k], faces[k].normal, faces[(k + 3) % 4].normal}, hull, reach_m)) {
                contacts.push_back(contact);
            }
        }
        if (const auto contact = solids::face_on(peak, hull, reach_m)) {
            contacts.push_back(*contact);
        }
        std::erase_if(contacts, [](const GroundContact& contact) { return contact.gap_m >= 0.0; });
        if (contacts.size() != 1 || contacts[0].gap_m < -0.02) {
            continue;
        }
        const auto fcl_m = rockfall::testing::fcl_depth_m(hull, ground);
        if (!fcl_m) {
            GTEST_SKIP() << "built without FCL and libccd (libfcl-dev, libccd-dev)";
        }
        EXPECT_NEAR(-contacts[0].gap_m, *fcl_m, 1e-6) << trial << " " << static_cast<int>(contacts[0].kind);
        ++compared[static_cast<int>(contacts[0].kind)];
    }
    EXPECT_GT(compared[0], 20);
    EXPECT_GT(compared[1], 5);
    EXPECT_GT(compared[2], 20);
}

TEST(RigidContacts, OfASphereAreTheClosedForm) {
    // Over a face, beside an edge that bends outwards and beside a peak.
    const config::GridFrame frame{9, 9, -4.0, -4.0, 1.0, 1.0};
    const Slope roof = rockfall::testing::slope_over(
        rockfall::testing::heights_of(frame, [](double, double y) { return 50.0 - 0.5 * std::abs(y - 0.5); }),
        {0.3, 0.8});
    const solids::Solid ball = solids::ball_of(0.6, 2700.0);
    for (const double off_m : {-0.05, 0.0, 0.05, 1.3}) {
        for (const double gap_m : {-0.01, 0.0, 0.02}) {
            // The normal of the roof's right side, or straight up over the ridge.
            const bool over_ridge = off_m == 0.0;
            const Vector3d normal =
                over_ridge ? Vector3d::UnitZ() : Vector3d{0.0, off_m > 0.0 ? 0.5 : -0.5, 1.0}.normalized();
            const Vector3d foot{0.2, 0.5 + off_m, 50.0 - 0.5 * std::abs(off_m)};
            Body body;
            body.centre_m = foot + (ball.bounding_radius_m + gap_m) * normal;
            body.centre_m.head<2>() -= roof.terrain.origin_m();
            BlockScratch scratch;
            const Law law = law_of(0.5, 0.0);
            const auto under = roof.terrain.locate(body.centre_m.x(), body.centre_m.y()).value();
            Block block{roof, law, ball, body, under, scratch};
            EXPECT_NEAR(block.gap_m(0.1), gap_m, 1e-9) << off_m;
        }
    }
}

TEST(RigidExtent, DistanceOfAPieceIsThatOfFcl) {
    int apart = 0;
    for (std::uint64_t trial = 0; trial < 300; ++trial) {
        Chance chance{trial};
        const solids::Solid solid = solids::solid_of(chance.hull(), 2700.0);
        Body body;
        body.centre_m = chance.vector(0.3);
        body.rotation.attitude = chance.attitude();
        const Vector3d a = chance.vector(1.5), b = chance.vector(1.5);
        // A triangle as thin as a thread.
        const solids::GroundTriangle thread{{a, b, 0.5 * (a + b)}, Vector3d::UnitZ()};
        const auto fcl_m = rockfall::testing::fcl_distance_m(
            solids::placed(solid.hull, body.rotation.attitude, body.centre_m), thread);
        if (!fcl_m) {
            GTEST_SKIP() << "built without FCL and libccd (libfcl-dev, libccd-dev)";
        }
        EXPECT_NEAR(distance_from_piece_m(solid, body, a, b), std::max(0.0, *fcl_m), 1e-6) << trial;
        apart += *fcl_m > 0.0 ? 1 : 0;
    }
    EXPECT_GT(apart, 50);
}

/// A rough slope of 38 deg that ends in a flat.
Slope slope_with_foot(double cell_m = 2.0) {
    const config::GridFrame frame{60, 30, 0.0, 0.0, cell_m, cell_m};
    config::RandomStream chance{{3, 0, 0, 1}, config::Purpose::test};
    return rockfall::testing::slope_over(
        rockfall::testing::heights_of(
            frame,
            [&](double x, double) { return 500.0 - 0.78 * std::min(x, 70.0) + 0.2 * chance.uniform(); }),
        {0.3, 0.8});
}

WholeFall throw_block(const Slope& slope, const Law& law, const solids::Solid& solid, std::uint64_t number,
                      BlockScratch& scratch) {
    Chance chance{number};
    Body body;
    const double x_m = 8.0, y_m = chance.between(22.0, 38.0);
    const auto triangle = slope.terrain.locate(x_m, y_m).value();
    body.centre_m = {x_m, y_m, slope.terrain.plane_of(triangle).height_m(x_m, y_m) + 1.5};
    body.velocity_mps = {2.0, 0.0, -1.0};
    body.rotation.attitude = chance.attitude();
    return follow(slope, law, solid, body, triangle, scratch);
}

std::vector<double> stops_m(const Slope& slope, const Law& law, const solids::Solid& solid,
                            std::uint64_t throws) {
    BlockScratch scratch;
    std::vector<double> ends;
    for (std::uint64_t number = 0; number < throws; ++number) {
        const WholeFall fall = throw_block(slope, law, solid, number, scratch);
        ends.push_back(fall.end.centre_m.x());
        EXPECT_LT(std::abs(fall.residual_j), 1e-3 * fall.dissipated_j) << number;
    }
    std::sort(ends.begin(), ends.end());
    return ends;
}

/// Largest distance between the distribution functions of two sorted samples.
double kolmogorov_smirnov(const std::vector<double>& a, const std::vector<double>& b) {
    double largest = 0.0;
    for (const auto* sample : {&a, &b}) {
        for (const double x : *sample) {
            const auto share = [x](const std::vector<double>& of) {
                return static_cast<double>(std::upper_bound(of.begin(), of.end(), x) - of.begin()) /
                       static_cast<double>(of.size());
            };
            largest = std::max(largest, std::abs(share(a) - share(b)));
        }
    }
    return largest;
}

TEST(RigidBlock, StopsAlikeForEachStepOfContact) {
    const Slope slope = slope_with_foot();
    const solids::Solid solid = solids::solid_of(solids::box({0.6, 0.5, 0.45}), 2700.0);
    Law law = law_of(0.6, 0.3);
    law.rolling_resistance = 0.05;
    law.longest_s = 30.0;
    constexpr std::uint64_t throws = 40;
    std::vector<std::vector<double>> stops;
    for (const double step_s : {0.5e-3, 1e-3, 2e-3}) {
        law.step_s = step_s;
        stops.push_back(stops_m(slope, law, solid, throws));
    }
    // Two samples of one distribution differ by more in one of 1000 cases.
    const double bound = 1.95 * std::sqrt(2.0 / static_cast<double>(throws));
    EXPECT_LT(kolmogorov_smirnov(stops[0], stops[1]), bound);
    EXPECT_LT(kolmogorov_smirnov(stops[1], stops[2]), bound);
    EXPECT_LT(kolmogorov_smirnov(stops[0], stops[2]), bound);
}

TEST(RigidBlock, MovesByTheSameBytesWhateverItsMemoryHeldAndOnAnyThread) {
    const Slope slope = slope_with_foot();
    const Law law = law_of(0.6, 0.4);
    const solids::Solid plate = solids::solid_of(solids::box({0.8, 0.7, 0.2}), 2700.0);
    const solids::Solid other = cube(0.7);
    const auto ends_of = [&](bool used) {
        std::vector<Body> ends;
        for (std::uint64_t number = 0; number < 3; ++number) {
            BlockScratch scratch;
            if (used) {
                throw_block(slope, law, other, 77 + number, scratch);
            }
            ends.push_back(throw_block(slope, law, plate, number, scratch).end);
        }
        return ends;
    };
    auto beside = std::async(std::launch::async, ends_of, true);
    const std::vector<Body> fresh = ends_of(false), used = beside.get();
    for (std::size_t i = 0; i < fresh.size(); ++i) {
        EXPECT_EQ(fresh[i].centre_m, used[i].centre_m);
        EXPECT_EQ(fresh[i].velocity_mps, used[i].velocity_mps);
        EXPECT_EQ(fresh[i].rotation.attitude.coeffs(), used[i].rotation.attitude.coeffs());
        EXPECT_EQ(fresh[i].rotation.momentum_nms, used[i].rotation.momentum_nms);
    }
}

TEST(RigidBlock, NeverGainsEnergyWhereTheGroundDampsItsRotation) {
    const Slope flat = plane(0.0, 200.0, 200.0, 20.0);
    const solids::Solid solid = solids::solid_of(solids::box({0.9, 0.6, 0.3}), 2700.0);
    const Law law = law_of(0.4, 0.6);
    for (int axis = 0; axis < 3; ++axis) {
        Body start =
            lying(flat, solid, 0.0, 100.0, 100.0, Eigen::Quaterniond{0.8, 0.4, 0.3, 0.33}.normalized());
        start.centre_m.z() += 0.5;
        start.velocity_mps = {0.5, 0.0, 0.0};
        Vector3d spin = Vector3d::Constant(0.02);
        spin[axis] = 12.0;
        start.rotation.momentum_nms = solid.inertia_kgm2.cwiseProduct(spin);
        BlockScratch scratch;
        Block block{flat, law, solid, start, flat.terrain.locate(100.0, 100.0).value(), scratch};
        const auto energy_j = [&] {
            return block.body().kinetic_j(solid) + block.body().potential_j(solid) -
                   block.ledger().correction_j;
        };
        const double bound_j = 1e-4 * start.rotation.energy_j(solid.inertia_kgm2);
        double lowest_j = energy_j();
        const double begin_j = lowest_j;
        bool on_ground = false, inside = true;
        for (double time_s = 0.0; time_s < 6.0 && inside;) {
            if (on_ground) {
                const Touchdown touchdown = block.step(law.step_s, inside);
                time_s += law.step_s;
                on_ground = touchdown.touched && touchdown.lasts;
            } else {
                const FreeFlight flight = block.fly();
                block.go_on(flight.duration_s);
                time_s += flight.duration_s;
                on_ground = block.strike().lasts;
            }
            ASSERT_LE(energy_j(), lowest_j + bound_j) << axis << " at " << time_s << " s";
            lowest_j = std::min(lowest_j, energy_j());
        }
        EXPECT_LT(lowest_j, begin_j - 0.5 * start.rotation.energy_j(solid.inertia_kgm2));
    }
}

}  // namespace
}  // namespace rockfall::rigid
