#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "config/units/constants.hpp"
#include "coupling/assessments/collapse/hand_over.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "tests/coupling/assessments/collapse/collapse_project.hpp"

namespace coupling::collapse {

/// The example collapse-small with a block thrown off its cliff, with the ground of a scree slope.
class HandOvers : public ::testing::Test {
protected:
    using Vector3d = Eigen::Vector3d;
    using BlockStatus = rockfall::rock_mass::BlockStatus;
    using HandedBlock = rockfall::rock_mass::HandedBlock;
    using RockMass = rockfall::rock_mass::RockMass;

    void SetUp() override {
        write_small_collapse(project);
        open({"collapse.hand_over=rigid", "collapse.hand_over_after_s=0.3", "collapse.depth_m=6",
              "terrain.ground=coarse_debris"});
    }
    void open(const std::vector<std::string>& settings) {
        scenario = read_collapse(project.file("scenario.ini"), settings);
        config::Warnings warnings;
        site = open_collapse(*scenario, warnings);
    }
    /// Coordinates of the terrain.
    [[nodiscard]] Vector3d at(double east_m, double north_m, double above_m) const {
        const double x = east_m - site.origin_m.x(), y = north_m - site.origin_m.y();
        return {x, y, *site.handed_ground->slope().terrain.height_m(x, y) + above_m};
    }
    /// The first block of the mass where it flies away from the cliff, turning.
    [[nodiscard]] HandedBlock thrown(const Vector3d& centre_m, const Vector3d& velocity_mps) const {
        HandedBlock block;
        block.centre_m = centre_m;
        block.velocity_mps = velocity_mps;
        block.rotation.momentum_nms = {0.0, 2.0 * solid()->inertia_kgm2.y(), 0.0};
        block.motion_j = 0.5 * solid()->mass_kg * velocity_mps.squaredNorm() +
                         block.rotation.energy_j(solid()->inertia_kgm2);
        return block;
    }
    [[nodiscard]] std::shared_ptr<const rockfall::solids::Solid> solid() const {
        return std::make_shared<const rockfall::solids::Solid>(site.blocks[0].solid);
    }
    [[nodiscard]] HandedFall followed(const HandedBlock& block,
                                      double until_s = std::numeric_limits<double>::infinity(),
                                      std::uint32_t earlier_falls = 0) const {
        return follow(*site.handed_ground, {&scenario->scenario.rockfall.fall, 1, look_s}, block, solid(),
                      std::vector<std::uint8_t>(site.handed_ground->stems().placed().size(), 0),
                      earlier_falls, until_s);
    }
    /// The mass without bonds, its first block in flight above the trees.
    [[nodiscard]] RockMass flying() const {
        std::vector<rockfall::rock_mass::BlockStart> blocks = site.blocks;
        const Vector3d to = at(1100.0, 2070.0, 60.0);
        blocks[0].centre_m = to;
        blocks[0].velocity_mps = {8.0, 0.0, 0.0};
        return {scenario->laws(), blocks, {}, site.ground, site.stems};
    }

    /// The mass with all blocks fixed but the first two, which are placed as given, far from the
    /// others.
    [[nodiscard]] RockMass two(const HandedBlock& first, const HandedBlock& second) const {
        std::vector<rockfall::rock_mass::BlockStart> blocks = site.blocks;
        for (rockfall::rock_mass::BlockStart& block : blocks) {
            block.fixed = true;
        }
        const auto put = [&](std::size_t i, const HandedBlock& as) {
            blocks[i].fixed = false;
            blocks[i].centre_m = as.centre_m;
            blocks[i].velocity_mps = as.velocity_mps;
            blocks[i].attitude = as.rotation.attitude;
        };
        put(0, first);
        put(1, second);
        RockMass mass{scenario->laws(), blocks, {}, site.ground, site.stems};
        mass.watch_lone_blocks();
        return mass;
    }
    [[nodiscard]] std::uint64_t steps_of_guard(const RockMass& mass) const {
        return static_cast<std::uint64_t>(std::lround(look_s / guards_of_look / mass.step_s()));
    }
    [[nodiscard]] HandOver hand_over_for(const RockMass& mass) const {
        return {*scenario, site, static_cast<double>(steps_of_guard(mass)) * mass.step_s(), guards_of_look,
                rockfall::rock_mass::one_by_one};
    }
    /// As a run goes on, look by look.
    template <class AfterGuard>
    void go_on(RockMass& mass, HandOver& hand_over, double until_s, const AfterGuard& after_guard) const {
        while (mass.time_s() < until_s) {
            for (std::uint64_t guard = 0; guard < guards_of_look; ++guard) {
                mass.advance(steps_of_guard(mass));
                hand_over.guard(mass);
                after_guard();
            }
            hand_over.look(mass);
        }
    }
    void go_on(RockMass& mass, HandOver& hand_over, double until_s) const {
        go_on(mass, hand_over, until_s, [] {});
    }
    /// A block on the even ground below the cliff, as it rests there in the mass.
    [[nodiscard]] HandedBlock at_rest(std::size_t number, double east_m, double north_m) const {
        HandedBlock lies;
        lies.centre_m = at(east_m, north_m, site.blocks[number].solid.bounding_radius_m);
        HandedBlock away;
        away.centre_m = at(1225.0, 2010.0, site.blocks[1].solid.bounding_radius_m);
        RockMass mass = number == 0 ? two(lies, away) : two(away, lies);
        while (mass.blocks()[number].status != BlockStatus::asleep) {
            mass.advance(100);
        }
        lies.centre_m = mass.blocks()[number].centre_m;
        lies.rotation = mass.blocks()[number].rotation;
        return lies;
    }
    /// A block in flight that would be at a place after a time.
    [[nodiscard]] static HandedBlock flying_to(const Vector3d& to_m, const Vector3d& from_m, double after_s) {
        HandedBlock block;
        block.centre_m = from_m;
        block.velocity_mps = (to_m - from_m) / after_s;
        block.velocity_mps.z() += 0.5 * config::gravity_mps2 * after_s;
        return block;
    }
    /// A crossing at time 0 as HandOver::unpack reads it: no return, no stem gone.
    [[nodiscard]] static std::vector<double> numbers_of_crossing(const HandedBlock& block) {
        std::vector<double> numbers{0.0, static_cast<double>(block.number), block.on_ground ? 1.0 : 0.0};
        const auto add = [&](const auto& vector) {
            numbers.insert(numbers.end(), vector.data(), vector.data() + vector.size());
        };
        add(block.centre_m);
        add(block.velocity_mps);
        add(block.rotation.momentum_nms);
        add(block.rotation.attitude.coeffs());
        numbers.insert(numbers.end(), {block.motion_j, block.gravity_j, block.strain_j, 0.0, 0.0});
        return numbers;
    }
    [[nodiscard]] double mass_kg(std::size_t number) const { return site.blocks[number].solid.mass_kg; }

    static constexpr double look_s = 0.05;
    SampleProject project;
    std::unique_ptr<CollapseScenario> scenario;
    CollapseSite site;
};

}  // namespace coupling::collapse
