// A small rock mass that breaks up: its energies, and that nothing else decides what it does.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <numeric>
#include <thread>

#include "tests/rockfall/rock_mass/scenes.hpp"

namespace rockfall::rock_mass {
namespace {

using namespace scenes;

/// A tower of 3 x 3 x 5 cubes over a slope, joined with little strength, some courses not at all.
struct Tower {
    std::vector<BlockStart> blocks;
    std::vector<BondStart> bonds;

    Tower() {
        const std::array<int, 3> count{3, 3, 5};
        const auto place = [](int i, int j, int k) { return Vector3d{2.0 * i, 2.0 * j, 2.0 * k + 6.0}; };
        const auto number = [&](int i, int j, int k) {
            return static_cast<std::uint32_t>((k * 3 + j) * 3 + i);
        };
        for (int k = 0; k < count[2]; ++k) {
            for (int j = 0; j < count[1]; ++j) {
                for (int i = 0; i < count[0]; ++i) {
                    blocks.push_back(cube_at(place(i, j, k), 2.0, 2750.0));
                    const auto join = [&](int di, int dj, int dk) {
                        if (i + di < count[0] && j + dj < count[1] && k + dk < count[2]) {
                            bonds.push_back(bond_between(number(i, j, k), number(i + di, j + dj, k + dk),
                                                         place(i, j, k), place(i + di, j + dj, k + dk), 2.0,
                                                         {4e5, 3e5}));
                        }
                    };
                    join(1, 0, 0);
                    join(0, 1, 0);
                    if (k != 2) {
                        join(0, 0, 1);
                    }
                }
            }
        }
    }
    [[nodiscard]] RockMass mass(double step_factor, ParallelFor parallel = one_by_one,
                                ContactLaw law = ContactLaw::foundation) const {
        Laws laws;
        laws.step_factor = step_factor;
        laws.contact = law;
        return {laws, blocks, bonds, Ground{plane_of(0.7)}, {}, std::move(parallel)};
    }
};

void run_until(RockMass& mass, double time_s) {
    while (mass.time_s() < time_s) {
        mass.step();
    }
}

TEST(Ledger, ClosesAtBothStepsAndBetterAtTheShorterOne) {
    const Tower tower;
    std::array<double, 2> shares{};
    for (const auto& [i, factor, bound] : {std::tuple{0, 0.2, 0.02}, {1, 0.05, 0.003}}) {
        RockMass mass = tower.mass(factor);
        double fracture_j = 0.0, largest = 0.0;
        for (int part = 1; part <= 8; ++part) {
            run_until(mass, 0.5 * part);
            const Ledger ledger = mass.ledger();
            EXPECT_GE(ledger.fracture_j, fracture_j);
            EXPECT_GE(ledger.friction_j, -1e-6);  // rounding
            EXPECT_GE(ledger.dashpot_j, 0.0);
            fracture_j = ledger.fracture_j;
            largest = std::max(largest, std::abs(residual_share(mass)));
        }
        EXPECT_GT(fracture_j, 0.0);
        EXPECT_LT(mass.bonds_intact(), tower.bonds.size());
        EXPECT_LE(largest, bound);
        shares[static_cast<std::size_t>(i)] = largest;
    }
    EXPECT_LT(shares[1], shares[0]);
}

TEST(Ledger, DropsOnFaceEdgeAndCornerKeepTheirEnergy) {
    // Ten seconds of bounces without damping.
    const Eigen::Quaterniond on_edge{Eigen::AngleAxisd{0.25 * 3.14159265358979, Vector3d::UnitY()}};
    const Eigen::Quaterniond on_corner =
        Eigen::Quaterniond::FromTwoVectors(Vector3d::Ones().normalized(), Vector3d::UnitZ());
    constexpr double fall_m = 2.2;
    for (const auto& [turn, lowest_m] : {std::pair{Eigen::Quaterniond::Identity(), 0.5},
                                         {on_edge, std::sqrt(0.5)},
                                         {on_corner, std::sqrt(0.75)}}) {
        Laws laws;
        laws.damping_ratio = 0.0;
        laws.sleeping = false;
        const BlockStart cube =
            block_of(solids::placed(solids::box(Vector3d::Ones()), turn, {0.0, 0.0, fall_m + lowest_m}),
                     2500.0, false);
        RockMass mass{laws, {&cube, 1}, {}, Ground{plane_of(0.0)}};
        const double given_j = cube.solid.mass_kg * laws.gravity_mps2 * fall_m;
        double residual_j = 0.0, rise_j = 0.0;
        while (mass.time_s() < 10.0) {
            mass.step();
            const Ledger ledger = mass.ledger();
            residual_j = std::max(residual_j, std::abs(ledger.residual_j()));
            rise_j = std::max(rise_j, ledger.held_j() - ledger.start_j);
        }
        EXPECT_LE(residual_j, 0.02 * given_j) << lowest_m;
        EXPECT_LE(rise_j, 0.01 * given_j) << lowest_m;
    }
}

TEST(Ledger, OfTheLawOfPfcIsPrintedAsItIs) {
    // No gradient of an energy: it need not close, but nothing is lost from the books.
    RockMass mass = Tower{}.mass(0.2, one_by_one, ContactLaw::pfc);
    run_until(mass, 2.0);
    EXPECT_TRUE(std::isfinite(mass.ledger().residual_j()));
    EXPECT_LT(std::abs(residual_share(mass)), 0.5);
}

/// Threads that take the next piece of work, the last one first.
ParallelFor with_threads(unsigned count) {
    return [count](std::size_t pieces, const std::function<void(std::size_t)>& work) {
        std::atomic<std::size_t> left{pieces};
        std::vector<std::thread> threads;
        for (unsigned t = 0; t < count; ++t) {
            threads.emplace_back([&] {
                for (std::size_t k = left--; k > 0 && k <= pieces; k = left--) {
                    work(k - 1);
                }
            });
        }
        for (std::thread& thread : threads) {
            thread.join();
        }
    };
}

TEST(RockMass, HasTheSameBitsForAnyNumberOfThreads) {
    const Tower tower;
    RockMass alone = tower.mass(0.2);
    RockMass two = tower.mass(0.2, with_threads(2));
    RockMass four = tower.mass(0.2, with_threads(4));
    for (RockMass* mass : {&alone, &two, &four}) {
        mass->advance(400);
    }
    EXPECT_LT(alone.bonds_intact(), tower.bonds.size());
    EXPECT_EQ(alone.packed(), two.packed());
    EXPECT_EQ(alone.packed(), four.packed());
}

TEST(RockMass, GoesOnFromItsNumbersWithTheSameBits) {
    const Tower tower;
    RockMass whole = tower.mass(0.2);
    whole.advance(700);
    whole.refresh();
    const std::vector<double> numbers = whole.packed();
    RockMass resumed = tower.mass(0.2);
    ASSERT_TRUE(resumed.unpack(numbers));
    whole.advance(300);
    resumed.advance(300);
    EXPECT_LT(whole.bonds_intact(), tower.bonds.size());
    EXPECT_EQ(whole.packed(), resumed.packed());
    EXPECT_FALSE(resumed.unpack(std::span{numbers}.first(numbers.size() - 3)));
}

TEST(RockMass, StandsUnderItsWeightAfterItWasHeld) {
    // Five cubes on each other, each pressed together by what lies on it: p / c with c = E* / L.
    std::vector<BlockStart> blocks;
    for (int k = 0; k < 5; ++k) {
        blocks.push_back(cube_at({0.0, 0.0, 2.0 * k}, 2.0, 2750.0, k == 0));
    }
    Laws laws;
    RockMass mass{laws, blocks, {}, Ground{}};
    mass.hold();
    mass.advance(static_cast<std::uint64_t>(2.0 / mass.step_s()));
    mass.let_go();
    EXPECT_EQ(mass.steps(), 0U);
    EXPECT_EQ(mass.ledger().residual_j(), 0.0);
    double lowered_m = 0.0;
    for (int k = 1; k < 5; ++k) {
        lowered_m += 2750.0 * 9.81 * 2.0 * (5 - k) / (laws.modulus_pa / 2.0);
        EXPECT_NEAR(2.0 * k - mass.blocks()[static_cast<std::size_t>(k)].centre_m.z(), lowered_m,
                    0.01 * lowered_m);
    }
    mass.advance(200);
    for (const Block& block : mass.blocks()) {
        EXPECT_LT(block.velocity_mps.norm(), 0.01);
    }
}

TEST(RockMass, DoesTheSameWithBlocksRenumbered) {
    const Tower tower;
    Tower other = tower;
    const std::size_t count = tower.blocks.size();
    std::vector<std::uint32_t> now(count);
    for (std::size_t i = 0; i < count; ++i) {
        now[i] = static_cast<std::uint32_t>((i * 7 + 3) % count);
        other.blocks[now[i]] = tower.blocks[i];
    }
    for (BondStart& bond : other.bonds) {
        bond.first = now[bond.first];
        bond.second = now[bond.second];
    }
    std::reverse(other.bonds.begin(), other.bonds.end());
    RockMass mass = tower.mass(0.2), renumbered = other.mass(0.2);
    // Until rounding has grown: rocks that hit each other double it many times a second.
    mass.advance(150);
    renumbered.advance(150);
    for (std::size_t i = 0; i < count; ++i) {
        EXPECT_NEAR((mass.blocks()[i].centre_m - renumbered.blocks()[now[i]].centre_m).norm(), 0.0, 1e-9);
    }
    EXPECT_GT(mass.blocks()[0].centre_m.z(), -1e3);
}

TEST(RockMass, ComesToRestFlatterWithMoreFriction) {
    // Angle of repose: the same heap let loose over a plane spreads less the rougher its blocks are.
    std::array<double, 2> spread_m{};
    for (const auto& [i, friction] : {std::pair{0, 0.1}, {1, 0.7}}) {
        Tower tower;
        tower.bonds.clear();
        for (BlockStart& block : tower.blocks) {
            block.centre_m.z() -= 5.0;
        }
        Laws laws;
        laws.friction = laws.ground_friction = friction;
        // One course is pushed out, so that the tower falls.
        for (std::size_t b = 0; b < 9; ++b) {
            tower.blocks[b].velocity_mps.x() = 6.0;
        }
        RockMass falling{laws, tower.blocks, {}, Ground{plane_of(0.0)}};
        run_until(falling, 4.0);
        for (const Block& block : falling.blocks()) {
            spread_m[static_cast<std::size_t>(i)] +=
                (block.centre_m - Vector3d{2.0, 2.0, block.centre_m.z()}).norm() / 45.0;
        }
    }
    EXPECT_GT(spread_m[0], 1.1 * spread_m[1]);
}

TEST(RockMass, StemTakesItsEnergyOnceAndIsCleared) {
    std::vector<BlockStart> blocks{cube_at({0.0, 0.0, 5.0}, 2.0)};
    blocks[0].velocity_mps = {10.0, 0.0, 0.0};
    Laws laws = lossless();
    const StandingStem stem{5.0, 0.0, 0.0, 20.0, 0.3, 1e5};
    RockMass mass{laws, blocks, {}, Ground{}, {stem}};
    const double before_j = mass.motion_at_start_j();
    mass.advance(static_cast<std::uint64_t>(1.0 / mass.step_s()));
    EXPECT_TRUE(mass.stems()[0].is_broken());
    EXPECT_NEAR(mass.ledger().trees_j, 1e5, 1e-6);
    EXPECT_NEAR(mass.ledger().translation_j, before_j - 1e5, 1.0);
    // A strong one stops the block.
    RockMass held{laws, blocks, {}, Ground{}, {{5.0, 0.0, 0.0, 20.0, 0.3, 1e9}}};
    held.advance(static_cast<std::uint64_t>(1.0 / held.step_s()));
    EXPECT_FALSE(held.stems()[0].is_broken());
    EXPECT_NEAR(held.blocks()[0].centre_m.x(), 5.0 - 0.3 - 1.0, 0.05);
}

}  // namespace
}  // namespace rockfall::rock_mass
