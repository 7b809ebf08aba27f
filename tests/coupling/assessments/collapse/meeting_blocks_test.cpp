#include "coupling/assessments/collapse/meeting_blocks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "config/random/stream.hpp"
#include "rockfall/rock_mass/overlap.hpp"
#include "rockfall/solids/shapes.hpp"
#include "tests/coupling/assessments/collapse/handing_mass.hpp"

namespace coupling::collapse {
namespace {

using Eigen::Vector3d;
using rockfall::rock_mass::BlockStatus;
using rockfall::rock_mass::HandedBlock;
using rockfall::rock_mass::RockMass;

/// Boxes of 4 x 1 x 1 m.
const rockfall::solids::Solid& column() {
    static const rockfall::solids::Solid solid =
        rockfall::solids::solid_of(rockfall::solids::box({4.0, 1.0, 1.0}), 2500.0);
    return solid;
}

BlockOnWay column_at(const Vector3d& centre_m, double way_m, bool is_single) {
    return {&column(), centre_m, column().from_given, way_m, is_single};
}

using Flags = std::vector<std::uint8_t>;

TEST(SinglesNearOthers, AreThoseThatAnotherBlockMayReach) {
    const auto near = [](const Vector3d& at, double way_m, double other_way_m) {
        const std::vector<BlockOnWay> blocks{
            column_at(Vector3d::Zero(), way_m, true),
            column_at(at, other_way_m, false),
            column_at({0.0, 100.0, 0.0}, 0.0, false),
            {nullptr, Vector3d::Zero(), Eigen::Quaterniond::Identity(), 0.0, false}};
        return singles_near_others(blocks);
    };
    const Flags none{0, 0, 0, 0}, first{1, 0, 0, 0};
    const double clearance_m = 2.0 * clearance_by_radius * column().bounding_radius_m;
    for (const double more_m : {-0.01, 0.01}) {
        const Flags& expected = more_m < 0.0 ? first : none;
        EXPECT_EQ(near({0.0, 1.0 + clearance_m + more_m, 0.0}, 0.0, 0.0), expected) << "side by side";
        EXPECT_EQ(near({4.0 + clearance_m + more_m, 0.0, 0.0}, 0.0, 0.0), expected) << "end to end";
        EXPECT_EQ(near({0.0, 0.0, 2.5 + clearance_m + more_m}, 1.0, 0.5), expected) << "with their ways";
    }
}

TEST(SinglesNearOthers, AreNoneOfBlocksThatAreNotAskedFor) {
    const std::vector<BlockOnWay> blocks(2, column_at(Vector3d::Zero(), 1.0, false));
    EXPECT_EQ(singles_near_others(blocks), (Flags{0, 0}));
    const std::vector<BlockOnWay> singles(2, column_at(Vector3d::Zero(), 1.0, true));
    EXPECT_EQ(singles_near_others(singles), (Flags{1, 1}));
}

TEST(BoundsOfSpeed, AreThoseOfAnyPointAndAnyTurn) {
    // A block of given energy moves and turns in any way: its fastest corner is within the bounds.
    config::RandomStream chance{{1, 0, 0, 0}, config::Purpose::test};
    for (int k = 0; k < 1000; ++k) {
        const auto any = [&] { return 2.0 * chance.uniform() - 1.0; };
        const Vector3d velocity_mps{10.0 * any(), 10.0 * any(), 10.0 * any()};
        const Vector3d spin_radps{5.0 * any(), 5.0 * any(), 5.0 * any()};
        const double rotation_j = 0.5 * column().inertia_kgm2.dot(spin_radps.cwiseAbs2());
        const double kinetic_j = rotation_j + 0.5 * column().mass_kg * velocity_mps.squaredNorm();
        double fastest_mps = 0.0;
        for (const Vector3d& corner_m : column().hull.vertices_m) {
            fastest_mps = std::max(fastest_mps, (velocity_mps + spin_radps.cross(corner_m)).norm());
        }
        EXPECT_LE(fastest_mps, point_speed_mps(column(), velocity_mps.norm(), rotation_j));
        EXPECT_LE(fastest_mps, fastest_point_mps(column(), kinetic_j));
        EXPECT_LE(velocity_mps.norm(), fastest_point_mps(column(), kinetic_j));
    }
}

/// The same with the two smallest blocks first.
class BlockReturns : public HandOvers {
protected:
    void SetUp() override {
        HandOvers::SetUp();
        const auto free = static_cast<std::ptrdiff_t>(site.count.free);
        std::partial_sort(site.blocks.begin(), site.blocks.begin() + 2, site.blocks.begin() + free,
                          [](const auto& a, const auto& b) {
                              return a.solid.bounding_radius_m < b.solid.bounding_radius_m;
                          });
    }
};

/// A block where it is seen, for overlaps.
class SeenShape {
public:
    SeenShape(const rockfall::solids::Solid& solid, const SeenBlock& seen)
        : centre_m_{seen.centre_m}, radius_m_{solid.bounding_radius_m} {
        const Eigen::Matrix3d turn = seen.attitude.toRotationMatrix();
        for (const Vector3d& vertex_m : solid.hull.vertices_m) {
            vertices_m_.emplace_back(centre_m_ + turn * vertex_m);
        }
        std::uint16_t corner = 0;
        for (const rockfall::solids::Face& face : solid.hull.faces) {
            const Vector3d normal = turn * face.normal;
            faces_.push_back({normal, face.offset_m + normal.dot(centre_m_)});
            lists_.push_back(corner);
            for (const std::uint32_t vertex : face.corners) {
                corners_.push_back(static_cast<std::uint16_t>(vertex));
            }
            corner = static_cast<std::uint16_t>(corner + face.corners.size());
        }
        lists_.push_back(corner);
    }
    [[nodiscard]] rockfall::rock_mass::PlacedBlock placed() const {
        return {vertices_m_, faces_, lists_, corners_, centre_m_, radius_m_};
    }

private:
    std::vector<Vector3d> vertices_m_;
    std::vector<rockfall::rock_mass::Plane3> faces_;
    std::vector<std::uint16_t> lists_, corners_;
    Vector3d centre_m_;
    double radius_m_;
};

/// Pairs of a single block and another one that lie in each other.
std::size_t touching_singles(const CollapseSite& site, const RockMass& mass, const HandOver& hand_over) {
    std::size_t pairs = 0;
    for (std::size_t i = 0; i < site.count.free; ++i) {
        const SeenBlock single = hand_over.seen(mass, i);
        if (!single.is_handed || single.status == BlockStatus::left) {
            continue;
        }
        for (std::size_t j = 0; j < site.count.free; ++j) {
            const SeenBlock other = hand_over.seen(mass, j);
            const bool once = !other.is_handed || j > i;
            const double reach_m =
                site.blocks[i].solid.bounding_radius_m + site.blocks[j].solid.bounding_radius_m;
            if (j == i || !once || other.status == BlockStatus::left ||
                (other.centre_m - single.centre_m).norm() > reach_m) {
                continue;
            }
            const SeenShape a{site.blocks[i].solid, single}, b{site.blocks[j].solid, other};
            rockfall::rock_mass::SeparatingFace known;
            pairs += rockfall::rock_mass::overlap_of(a.placed(), b.placed(), other.centre_m, known).is_none()
                         ? 0
                         : 1;
        }
    }
    return pairs;
}

/// Each ledger, and what came back with the blocks.
void expect_closed_ledgers(const CollapseSite& site, const RockMass& mass, const HandOver& hand_over) {
    double handed_j = 0.0, back_j = 0.0, given_j = 0.0;
    for (std::size_t f = 0; f < hand_over.falls().size(); ++f) {
        const HandedFall& fall = hand_over.falls()[f];
        handed_j += fall.block.motion_j;
        EXPECT_LT(std::abs(fall.end.residual_j), 0.01 * fall.start_j) << f;
        EXPECT_NEAR(fall.start_j + fall.end.corrected_j - fall.end.dissipated_j - fall.motion_end_j,
                    -fall.end.residual_j, 1e-9 * fall.start_j)
            << f;
        if (const auto& back = hand_over.return_of(f)) {
            back_j += back->taken.motion_j;
            given_j += hand_over.lift_given_j(f, mass);
            // What it brings is what it had, less the work of the lift.
            const double lift_j =
                site.blocks[fall.block.number].solid.mass_kg * config::gravity_mps2 * back->taken.lift_m;
            EXPECT_NEAR(std::max(0.0, fall.motion_end_j - lift_j), back->taken.motion_j, 1e-9 * fall.start_j)
                << f;
            EXPECT_EQ(back->taken.strain_j, 0.0) << f;
        }
    }
    const auto ledger = mass.ledger();
    EXPECT_NEAR(ledger.handed_motion_j, handed_j, 1e-9 * handed_j);
    EXPECT_NEAR(ledger.back_motion_j, back_j, 1e-9 * handed_j);
    EXPECT_EQ(ledger.back_strain_j, 0.0);
    EXPECT_GE(given_j, -1e-9 * handed_j);
    EXPECT_LT(given_j, 0.01 * handed_j);
    EXPECT_LT(std::abs(ledger.residual_j()), 0.005 * ledger.turnover_j(0.0));
}

TEST_F(BlockReturns, ComeBeforeAnyOtherBlockIsTouchedAndCloseTheLedgers) {
    open({"collapse.hand_over=rigid", "collapse.hand_over_after_s=0.1", "collapse.depth_m=10",
          "collapse.least_block_m=2.5", "terrain.ground=coarse_debris"});
    const auto begun = [&] {
        RockMass mass{scenario->laws(), site.blocks, site.bonds, site.ground, site.stems};
        mass.watch_lone_blocks();
        return mass;
    };
    constexpr double until_s = 10.0;
    RockMass mass = begun();
    HandOver hand_over = hand_over_for(mass);
    std::size_t touching = 0;
    go_on(mass, hand_over, until_s, [&] { touching += touching_singles(site, mass, hand_over); });
    EXPECT_EQ(touching, 0U);
    EXPECT_GT(hand_over.returns(), 2U);
    expect_closed_ledgers(site, mass, hand_over);

    // Without guards they run through others.
    RockMass ignored = begun();
    HandOver never_back = hand_over_for(ignored);
    std::size_t in_others = 0;
    while (ignored.time_s() < until_s && in_others == 0) {
        ignored.advance(guards_of_look * steps_of_guard(ignored));
        never_back.look(ignored);
        in_others += touching_singles(site, ignored, never_back);
    }
    EXPECT_GT(in_others, 0U);
}

TEST_F(BlockReturns, TwoSingleBlocksStrikeEachOtherWithTheirMomentum) {
    const HandedBlock east = flying_to(at(1190.0, 2070.0, 40.0), at(1170.0, 2070.0, 60.0), 2.0);
    const HandedBlock west = flying_to(at(1190.0, 2070.3, 40.0), at(1210.0, 2070.3, 60.0), 2.0);
    RockMass mass = two(east, west);
    HandOver hand_over = hand_over_for(mass);
    go_on(mass, hand_over, 1.0);
    ASSERT_EQ(hand_over.falls().size(), 2U);
    ASSERT_EQ(hand_over.returns(), 0U);
    const auto momentum = [&] {
        return Vector3d{mass_kg(0) * hand_over.seen(mass, 0).velocity_mps +
                        mass_kg(1) * hand_over.seen(mass, 1).velocity_mps};
    };
    const auto moment_of_momentum = [&] {
        Vector3d sum = Vector3d::Zero();
        for (const std::size_t i : {0U, 1U}) {
            const rockfall::rock_mass::Block& block = mass.blocks()[i];
            sum += block.mass_kg * block.centre_m.cross(block.velocity_mps) +
                   block.rotation.momentum_in_space_nms();
        }
        return sum;
    };
    const Vector3d before_ns = momentum();
    const double scale_ns = mass_kg(0) * 10.0;
    bool struck = false;
    Vector3d turning_nms = Vector3d::Zero();
    go_on(mass, hand_over, 2.4, [&] {
        if (hand_over.returns() == 2 && turning_nms.isZero(0.0)) {
            turning_nms = moment_of_momentum();
        }
        const double apart =
            hand_over.seen(mass, 1).velocity_mps.x() - hand_over.seen(mass, 0).velocity_mps.x();
        struck = struck || apart > 0.0;
        EXPECT_NEAR(momentum().x(), before_ns.x(), 1e-9 * scale_ns) << mass.time_s();
        EXPECT_NEAR(momentum().y(), before_ns.y(), 1e-9 * scale_ns) << mass.time_s();
    });
    EXPECT_TRUE(struck);
    EXPECT_EQ(hand_over.returns(), 2U);
    for (const std::size_t f : {0U, 1U}) {
        EXPECT_FALSE(hand_over.falls()[f].has_ended);
        EXPECT_EQ(hand_over.return_of(f)->taken.lift_m, 0.0);
        EXPECT_EQ(hand_over.return_of(f)->taken.strain_j, 0.0);
    }
    if (hand_over.falls().size() == 2) {
        EXPECT_NEAR(moment_of_momentum().z(), turning_nms.z(), 1e-6 * scale_ns * 10.0);
    }
    const auto ledger = mass.ledger();
    EXPECT_LT(std::abs(ledger.residual_j()), 0.01 * (east.velocity_mps.squaredNorm() * mass_kg(0)));
}

TEST_F(BlockReturns, ABlockAtRestInTheMassThatASingleOneHitsStartsAgain) {
    const HandedBlock lies = at_rest(1, 1200.0, 2070.0);
    const HandedBlock flies = flying_to(lies.centre_m, at(1160.0, 2070.0, 8.0), 1.5);
    RockMass mass = two(flies, lies);
    HandOver hand_over = hand_over_for(mass);
    go_on(mass, hand_over, 0.6);
    ASSERT_NE(hand_over.fall_of(0), nullptr);
    go_on(mass, hand_over, 1.0);
    ASSERT_EQ(mass.blocks()[1].status, BlockStatus::asleep);
    EXPECT_LT((mass.blocks()[1].centre_m - lies.centre_m).norm(), 1e-3);
    double fastest_mps = 0.0;
    go_on(mass, hand_over, 2.0,
          [&] { fastest_mps = std::max(fastest_mps, mass.blocks()[1].velocity_mps.x()); });
    EXPECT_EQ(hand_over.returns(), 1U);
    EXPECT_GT(fastest_mps, 1.0);
    EXPECT_GT((mass.blocks()[1].centre_m - lies.centre_m).norm(), 0.5);
    EXPECT_LT(std::abs(mass.ledger().residual_j()), 0.02 * mass_kg(0) * flies.velocity_mps.squaredNorm());
}

TEST_F(BlockReturns, ASingleBlockAtRestThatIsHitStartsAgain) {
    const HandedBlock first = flying_to(at(1180.0, 2070.0, 1.0), at(1160.0, 2070.0, 10.0), 2.0);
    HandedBlock waits;
    waits.centre_m = at(1225.0, 2010.0, 500.0);
    RockMass alone = two(first, waits);
    HandOver before = hand_over_for(alone);
    go_on(alone, before, 1.0);
    ASSERT_NE(before.fall_of(0), nullptr);
    ASSERT_TRUE(rockfall::came_to_rest(before.fall_of(0)->end.reason));
    const Vector3d lies_m = before.fall_of(0)->last.centre_m;
    const double rests_s = before.start_s(0) + before.fall_of(0)->duration_s;

    const double hit_s = rests_s + 2.0;
    RockMass mass = two(first, flying_to(lies_m, lies_m + Vector3d{40.0, 0.0, 60.0}, hit_s));
    HandOver hand_over = hand_over_for(mass);
    go_on(mass, hand_over, hit_s - 0.5);
    ASSERT_NE(hand_over.fall_of(0), nullptr);
    EXPECT_EQ(hand_over.seen(mass, 0).status, BlockStatus::asleep);
    EXPECT_EQ(hand_over.seen(mass, 0).centre_m, lies_m);
    EXPECT_EQ(hand_over.returns(), 0U);
    double fastest_mps = 0.0;
    go_on(mass, hand_over, hit_s + 0.5,
          [&] { fastest_mps = std::max(fastest_mps, hand_over.seen(mass, 0).velocity_mps.norm()); });
    ASSERT_EQ(hand_over.returns(), 2U);
    const std::size_t fall = 0;
    EXPECT_TRUE(hand_over.falls()[fall].has_ended);
    EXPECT_EQ(hand_over.falls()[fall].motion_end_j, 0.0);
    EXPECT_GT(hand_over.return_of(fall)->time_s, rests_s);
    EXPECT_LT(hand_over.return_of(fall)->time_s, hit_s);
    EXPECT_GT(fastest_mps, 3.0);
    EXPECT_GT((hand_over.seen(mass, 0).centre_m - lies_m).norm(), 0.5);
    EXPECT_TRUE(hand_over.was_single(0, rests_s));
    EXPECT_FALSE(hand_over.was_single(0, hit_s));
    EXPECT_EQ(hand_over.returns_of(0), 1U);
}

TEST_F(BlockReturns, ReturnAndGoOnAfterAStopWithTheSameBits) {
    const HandedBlock east = flying_to(at(1190.0, 2070.0, 40.0), at(1170.0, 2070.0, 60.0), 2.0);
    const HandedBlock west = flying_to(at(1190.0, 2070.3, 40.0), at(1210.0, 2070.3, 60.0), 2.0);
    RockMass mass = two(east, west);
    HandOver hand_over = hand_over_for(mass);
    for (const double stop_s : {1.0, 2.1, 2.8}) {  // both single, both back, single once more
        go_on(mass, hand_over, stop_s);
        mass.refresh();
        RockMass resumed = two(east, west);
        ASSERT_TRUE(resumed.unpack(mass.packed()));
        HandOver again = hand_over_for(resumed);
        ASSERT_TRUE(again.unpack(hand_over.packed(), resumed));
        EXPECT_EQ(again.packed(), hand_over.packed());
        RockMass whole = two(east, west);
        ASSERT_TRUE(whole.unpack(mass.packed()));
        go_on(whole, hand_over, stop_s + 0.7);
        go_on(resumed, again, stop_s + 0.7);
        EXPECT_EQ(again.packed(), hand_over.packed()) << stop_s;
        EXPECT_EQ(resumed.packed(), whole.packed()) << stop_s;
        ASSERT_EQ(again.falls().size(), hand_over.falls().size());
        for (std::size_t f = 0; f < again.falls().size(); ++f) {
            EXPECT_EQ(again.falls()[f].last.centre_m, hand_over.falls()[f].last.centre_m);
            EXPECT_EQ(again.falls()[f].end.dissipated_j, hand_over.falls()[f].end.dissipated_j);
        }
        mass = two(east, west);
        ASSERT_TRUE(mass.unpack(whole.packed()));
    }
    EXPECT_GE(hand_over.returns(), 2U);
    EXPECT_GT(hand_over.falls().size(), 2U) << "blocks that came back leave again";
}

/// Three columns in the air with their long sides side by side: a single one, a light one of the mass at some
/// gap beside it, and a fast one of the mass far away. Whether the single one comes back at the guard.
class ColumnsInTheAir : public HandOvers {
protected:
    [[nodiscard]] bool single_comes_back(double gap_m, const Vector3d& velocity_mps,
                                         const Vector3d& spin_radps) const {
        CollapseSite in_air = site;
        for (rockfall::rock_mass::BlockStart& block : in_air.blocks) {
            block.fixed = true;
        }
        const auto put = [&](std::size_t i, const Vector3d& centre_m) {
            in_air.blocks[i] = {column(),         centre_m,         column().from_given,
                                Vector3d::Zero(), Vector3d::Zero(), false};
        };
        const Vector3d middle_m = at(1150.0, 2070.0, 60.0);
        put(0, middle_m);
        put(1, middle_m + Vector3d{0.0, 1.0 + gap_m, 0.0});
        put(2, middle_m + Vector3d{30.0, 0.0, 0.0});
        in_air.blocks[2].velocity_mps = velocity_mps;
        in_air.blocks[2].momentum_nms = column().inertia_kgm2.cwiseProduct(spin_radps);
        RockMass mass{scenario->laws(), in_air.blocks, {}, in_air.ground, in_air.stems};
        const HandedBlock left = mass.hand_over(std::vector<std::uint32_t>{0}).front();
        HandOver hand_over{*scenario, in_air, guard_s, guards_of_look, rockfall::rock_mass::one_by_one};
        std::vector<double> numbers = numbers_of_crossing(left);
        numbers.insert(numbers.begin(), 1.0);
        EXPECT_TRUE(hand_over.unpack(numbers, mass));
        hand_over.guard(mass);
        return hand_over.returns() == 1;
    }
    static constexpr double guard_s = 0.01;
};

TEST_F(ColumnsInTheAir, ComeBackWhereALightBlockThatTheFastestStrikesMayReachThem) {
    const double rest_m = 2.0 * clearance_by_radius * column().bounding_radius_m;
    for (const double speed_mps : {10.0, 30.0}) {
        for (const double spin_radps : {0.0, 8.0}) {
            const double fastest_mps = speed_mps + column().bounding_radius_m * spin_radps;
            // Along the axis of least inertia, of which the bound of the speed of points is made.
            Eigen::Index least = 0;
            column().inertia_kgm2.minCoeff(&least);
            Vector3d spin = Vector3d::Zero();
            spin[least] = spin_radps;
            const auto comes_back = [&](double times) {
                return single_comes_back(rest_m + times * fastest_mps * guard_s, {speed_mps, 0.0, 0.0}, spin);
            };
            EXPECT_TRUE(comes_back(1.9)) << speed_mps << " m/s, " << spin_radps << " rad/s";
            EXPECT_FALSE(comes_back(2.1)) << speed_mps << " m/s, " << spin_radps << " rad/s";
        }
    }
}

}  // namespace
}  // namespace coupling::collapse
