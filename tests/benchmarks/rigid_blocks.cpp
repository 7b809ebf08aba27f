#include <benchmark/benchmark.h>

#include <Eigen/Geometry>
#include <numbers>

#include "config/random/stream.hpp"
#include "rockfall/solids/shapes.hpp"
#include "tests/benchmarks/scene.hpp"
#include "tests/rockfall/motion/rigid/whole_fall.hpp"

namespace benchmarks {
namespace {

namespace rigid = rockfall::rigid;
namespace solids = rockfall::solids;

constexpr std::uint64_t blocks = 50;

/// Ground with constant friction: rock (0.65, e 0.4, rolling 0.05) or debris (0.70, e 0.3, rolling 0.15).
rigid::Law law_of_blocks(bool debris) {
    rigid::Law law;
    law.friction_law = rockfall::FrictionLaw::constant;
    law.friction = debris ? 0.70 : 0.65;
    law.friction_max = law.friction;
    law.restitution = debris ? 0.3 : 0.4;
    law.rolling_resistance = debris ? 0.15 : 0.05;
    law.drag_ps = 0.0;
    law.longest_s = 120.0;
    return law;
}

/// Blocks with the volume of a sphere of 0.95 m, from the release line of bench_slope, with any attitude.
void blocks_on_slope(benchmark::State& state, const solids::Hull& shape, bool debris) {
    const rockfall::Slope& slope = full_bench_slope();
    const double volume_m3 = std::numbers::pi / 6.0 * 0.95 * 0.95 * 0.95;
    const solids::Solid solid = solids::solid_of(solids::with_volume(shape, volume_m3), 2700.0);
    const rigid::Law law = law_of_blocks(debris);
    rigid::BlockScratch scratch;
    double percussions = 0.0, unsolved = 0.0, residual_j = 0.0, dissipated_j = 0.0, run_out_m = 0.0;
    for (auto _ : state) {
        percussions = unsolved = residual_j = dissipated_j = run_out_m = 0.0;
        for (std::uint64_t number = 0; number < blocks; ++number) {
            config::RandomStream chance{key_of(number), config::Purpose::test};
            rigid::Body body;
            const double x_m = 11.25 - slope.terrain.origin_m().x();
            const double y_m = 81.0 + 38.0 * chance.uniform() - slope.terrain.origin_m().y();
            const std::uint32_t under = slope.terrain.locate(x_m, y_m).value();
            body.centre_m = {x_m, y_m, slope.terrain.plane_of(under).height_m(x_m, y_m) + 2.0};
            body.velocity_mps = {2.36, 0.0, -1.85};
            const double a = chance.uniform(), b = chance.uniform(), c = chance.uniform();
            body.rotation.attitude =
                Eigen::Quaterniond{a - 0.5, b - 0.5, c - 0.5, chance.uniform() - 0.5}.normalized();
            const auto fall = rigid::testing::follow(slope, law, solid, body, under, scratch);
            percussions += static_cast<double>(fall.percussions);
            unsolved += fall.unsolved;
            residual_j += std::abs(fall.residual_j);
            dissipated_j += fall.dissipated_j;
            run_out_m += fall.end.centre_m.x() - x_m;
        }
    }
    using benchmark::Counter;
    const auto rounds = static_cast<double>(state.iterations());
    state.counters["blocks/s"] = Counter{rounds * blocks, Counter::kIsRate};
    state.counters["s_per_contact"] =
        Counter{rounds * percussions, Counter::Flags(Counter::kIsRate | Counter::kInvert)};
    state.counters["contacts_per_block"] = percussions / blocks;
    state.counters["unsolved_share"] = unsolved / percussions;
    state.counters["ledger"] = residual_j / dissipated_j;
    state.counters["run_out_m"] = run_out_m / blocks;
}

BENCHMARK_CAPTURE(blocks_on_slope, rock, solids::box({1.0, 1.0, 1.0}), false)
    ->Name("Rigid/CubesOnSlope")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(blocks_on_slope, debris, solids::box({1.0, 1.0, 1.0}), true)
    ->Name("Rigid/CubesOnDebris")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(blocks_on_slope, plates, solids::box({1.0, 0.9, 0.25}), false)
    ->Name("Rigid/PlatesOnSlope")
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace benchmarks
