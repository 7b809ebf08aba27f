#include <benchmark/benchmark.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <sstream>
#include <vector>

#include "rockfall/motion/picus/ground_contact.hpp"
#include "rockfall/motion/picus/johnson_damping.hpp"
#include "rockfall/tally/ensemble_tally.hpp"
#include "rockfall/terrain/mesh.hpp"
#include "tests/benchmarks/counters.hpp"
#include "tests/benchmarks/flat_terrain.hpp"
#include "tests/benchmarks/scene.hpp"

namespace benchmarks {
namespace {

using benchmark::DoNotOptimize;
using benchmark::State;

config::RandomStream chance(std::uint64_t id) {
    return {key_of(id), config::Purpose::test};
}

/// Time per item of a benchmark whose every iteration handles `items` of them.
void per_item(State& state, const char* name, std::uint64_t items) {
    state.counters[name] = time_per(static_cast<std::uint64_t>(state.iterations()) * items);
}

// --- Terrain ---

/// Flights so high above the ground that they end at the border: nothing but crossings and the height test.
void walk(State& state, const rockfall::Terrain& terrain, double length_m, double width_m) {
    config::RandomStream stream = chance(11);
    std::vector<std::pair<rockfall::Flight, std::uint32_t>> flights;
    while (flights.size() < 256) {
        const double x_m = (0.1 + 0.8 * stream.uniform()) * length_m;
        const double y_m = (0.1 + 0.8 * stream.uniform()) * width_m;
        const double heading_rad = 2.0 * std::numbers::pi * stream.uniform();
        flights.push_back(
            {{{x_m, y_m, 1e5}, {300.0 * std::cos(heading_rad), 300.0 * std::sin(heading_rad), 0.0}},
             terrain.locate(x_m, y_m).value()});
    }
    std::vector<rockfall::Stretch> stretches;
    std::uint64_t crossings = 0;
    for (auto _ : state) {
        crossings = 0;
        for (const auto& [flight, triangle] : flights) {
            DoNotOptimize(rockfall::fly(terrain, flight, triangle, stretches));
            crossings += stretches.size();
        }
    }
    per_item(state, "ns_per_crossing", crossings);
    state.counters["triangles"] = static_cast<double>(terrain.triangles().size());
}

void walk_11k(State& state) {
    static const rockfall::Terrain terrain = thinned_rough_plane(350.0, 200.0, 2.5);
    walk(state, terrain, 350.0, 200.0);
}

void walk_400k(State& state) {
    static const rockfall::Terrain terrain = thinned_rough_plane(800.0, 500.0, 1.0);
    walk(state, terrain, 800.0, 500.0);
}

void locate_release_point(State& state) {
    const rockfall::Terrain& terrain = bench_slope().terrain;
    const auto sources = bench_sources(terrain);
    for (auto _ : state) {
        for (const rockfall::ReleaseSource& source : sources) {
            DoNotOptimize(terrain.locate(source.first_m.x(), source.first_m.y()));
        }
    }
    per_item(state, "ns_per_locate", sources.size());
}

void mesh_delaunay(State& state) {
    const config::Raster<double> heights = bench_heights();
    for (auto _ : state) {
        DoNotOptimize(rockfall::triangulate(heights, 0.0));
    }
}

void mesh_load(State& state) {
    std::ostringstream out;
    write_flat(out, bench_slope().terrain);
    const std::string bytes = out.str();
    for (auto _ : state) {
        std::istringstream in{bytes};
        DoNotOptimize(read_flat(in));
    }
}

// --- Contact with the ground ---

struct Arriving {
    Eigen::Vector3d velocity_mps;
    Eigen::Vector3d normal;
    rockfall::picus::ContactDraws draws;
};

std::vector<Arriving> arriving_rocks(std::size_t count) {
    config::RandomStream stream = chance(12);
    std::vector<Arriving> rocks;
    while (rocks.size() < count) {
        const double tangent_x = -0.78 + 0.3 * (stream.uniform() - 0.5);
        const double tangent_y = 0.3 * (stream.uniform() - 0.5);
        const Eigen::Vector3d normal = Eigen::Vector3d{-tangent_x, -tangent_y, 1.0}.normalized();
        const Eigen::Vector3d velocity_mps{3.0 + 12.0 * stream.uniform(), 2.0 * (stream.uniform() - 0.5),
                                           -5.0 - 12.0 * stream.uniform()};
        if (velocity_mps.dot(normal) < 0.0) {
            rocks.push_back({velocity_mps, normal, {}});
            rocks.back().draws.noise = 2.0 * stream.uniform() - 1.0;
            rocks.back().draws.lateral = 2.0 * stream.uniform() - 1.0;
        }
    }
    return rocks;
}

void impact_rebound(State& state) {
    const std::vector<Arriving> rocks = arriving_rocks(1024);
    const rockfall::FallLaw law = compared_law();
    const rockfall::Rock rock = rockfall::Rock::sphere(0.95, 2700.0);
    for (auto _ : state) {
        for (const Arriving& r : rocks) {
            DoNotOptimize(rockfall::picus::meet_ground(r.velocity_mps, 10.0, r.normal, {0.30, 0.75}, 0.0,
                                                       rock, law.motion.of<rockfall::picus::Model>(),
                                                       r.draws));
        }
    }
    per_item(state, "ns_per_impact", rocks.size());
}

std::vector<double> squared_speeds() {
    config::RandomStream stream = chance(13);
    std::vector<double> speeds(1024);
    for (double& squared : speeds) {
        squared = 4.0 + 600.0 * stream.uniform();
    }
    return speeds;
}

/// Calls law(v^2) for many squared speeds.
template <class Law>
void over_speeds(State& state, Law law) {
    const std::vector<double> speeds = squared_speeds();
    for (auto _ : state) {
        for (const double squared : speeds) {
            DoNotOptimize(law(squared));
        }
    }
    per_item(state, "ns_per_call", speeds.size());
}

void jump_angle_ours(State& state) {
    const rockfall::picus::JumpAngleLaw law = compared_law().motion.of<rockfall::picus::Model>().jump_angle;
    over_speeds(state, [&](double squared_speed) {
        return config::sin_cos_of(rockfall::picus::jump_angle(squared_speed, law).in_radians());
    });
}

config::SinCos jump_angle_libm(double squared_speed) {
    const double angle_deg = std::min(60.0, 80.0 * std::pow(std::sqrt(squared_speed), -0.74));
    const double angle_rad = angle_deg * std::numbers::pi / 180.0;
    return {std::sin(angle_rad), std::cos(angle_rad)};
}

rockfall::Restitution damping_libm(double squared_speed) {
    const double speed_mps = std::sqrt(squared_speed);
    const double factor = speed_mps > 10.0 ? std::pow(10.0 / speed_mps, 0.25) : 1.0;
    return {0.30 * factor, 0.75 * factor};
}

// --- Chance ---

void philox(State& state) {
    const config::RandomStream stream = chance(14);
    std::uint32_t event = 0;
    for (auto _ : state) {
        DoNotOptimize(stream.uniforms_of(event++));
    }
    per_item(state, "ns_per_four", 1);
}

void mersenne_twister(State& state) {
    std::mt19937 engine{42};
    std::uniform_real_distribution<double> uniform;
    for (auto _ : state) {
        DoNotOptimize(
            config::FourUniforms{uniform(engine), uniform(engine), uniform(engine), uniform(engine)});
    }
    per_item(state, "ns_per_four", 1);
}

void mersenne_twister_seeded(State& state) {
    std::uint32_t rock = 0;
    for (auto _ : state) {
        std::mt19937 engine{rock++};
        DoNotOptimize(engine());
    }
    per_item(state, "ns_per_rock", 1);
}

// --- Trees ---

constexpr double tree_length_m = 800.0;
constexpr double tree_width_m = 500.0;
constexpr double rock_radius_m = 0.475;

const rockfall::Terrain& forty_hectares() {
    static const rockfall::Terrain terrain =
        rockfall::triangulate(rough_plane(tree_length_m, tree_width_m, 2.5), 0.0);
    return terrain;
}

void trees_rebuild(State& state) {
    // The loop repeats the rebuild, so its time is that of the second and later calls.
    const auto count = static_cast<std::size_t>(state.range(0));
    const auto stems = random_trees(tree_length_m, tree_width_m, count);
    for (auto _ : state) {
        DoNotOptimize(rockfall::StemIndex{stems, forty_hectares(), rock_radius_m, false});
    }
}

void trees_query(State& state) {
    const auto stems = random_trees(tree_length_m, tree_width_m, 11'600);
    const rockfall::StemIndex index{stems, forty_hectares(), rock_radius_m, false};
    config::RandomStream stream = chance(15);
    std::vector<rockfall::Flight> flights;
    while (flights.size() < 4096) {
        const double x_m = 20.0 + (tree_length_m - 40.0) * stream.uniform();
        const double y_m = 20.0 + (tree_width_m - 40.0) * stream.uniform();
        const double z_m = forty_hectares().height_m(x_m, y_m).value();
        flights.push_back(
            {{x_m, y_m, z_m}, {4.0 + 8.0 * stream.uniform(), 4.0 * (stream.uniform() - 0.5), 1.0}});
    }
    std::uint64_t hits = 0;
    for (auto _ : state) {
        hits = 0;
        for (const rockfall::Flight& flight : flights) {
            hits += index.first_hit(flight, 0.7, rock_radius_m, {}, {}).has_value() ? 1 : 0;
        }
    }
    per_item(state, "ns_per_query", flights.size());
    state.counters["hits_per_query"] = static_cast<double>(hits) / static_cast<double>(flights.size());
}

// --- Statistics ---

void stats_reduce(State& state) {
    // 40 ha in cells of 2.5 m.
    const config::GridFrame frame{320, 200, 0.0, 0.0, 2.5, 2.5};
    rockfall::EnsembleTally mine{frame, 0, 11'600};
    const rockfall::EnsembleTally other{frame, 0, 11'600};
    for (auto _ : state) {
        mine.add(other);
        benchmark::ClobberMemory();
    }
}

}  // namespace

void register_pieces() {
    const auto add = [](const char* name, auto function) {
        return benchmark::RegisterBenchmark(name, function);
    };
    const auto milliseconds = benchmark::kMillisecond;
    add("Walk/Tin11k", walk_11k);
    add("Walk/Tin400k", walk_400k);
    add("Locate/ReleasePoint", locate_release_point);
    add("Impact/Rebound", impact_rebound);
    add("Math/JumpAngle/ours", jump_angle_ours);
    add("Math/JumpAngle/libm", [](State& s) { over_speeds(s, jump_angle_libm); });
    add("Math/Damping/ours", [](State& s) {
        over_speeds(s, [](double squared) {
            return rockfall::picus::at_impact_speed({0.30, 0.75}, squared);
        });
    });
    add("Math/Damping/libm", [](State& s) { over_speeds(s, damping_libm); });
    add("Rng/Philox4x32", philox);
    add("Rng/mt19937", mersenne_twister);
    add("Rng/mt19937_seeded_per_rock", mersenne_twister_seeded);
    add("Trees/Rebuild", trees_rebuild)->Arg(11'600)->Arg(40'000)->Unit(milliseconds);
    add("Trees/Query", trees_query);
    add("Stats/Reduce", stats_reduce)->Unit(milliseconds);
    add("Mesh/Delaunay", mesh_delaunay)->Unit(milliseconds);
    add("Mesh/Load", mesh_load)->Unit(milliseconds);
}

}  // namespace benchmarks
