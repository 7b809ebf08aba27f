#include <benchmark/benchmark.h>

#include <bit>

#include "tests/benchmarks/counters.hpp"
#include "tests/benchmarks/light_ordinary.hpp"
#include "tests/benchmarks/light_scene.hpp"

namespace benchmarks {
namespace {

using benchmark::DoNotOptimize;
using benchmark::State;

const LightScene& scene(bool deciduous) {
    static const LightScene evergreen = light_scene(false);
    static const LightScene mixed_leaves = light_scene(true);
    return deciduous ? mixed_leaves : evergreen;
}

forest::LightSite site_of(const LightScene& from, double zone_height_deg,
                          const forest::LightSettings& settings = {}) {
    return {light_sky(from, zone_height_deg), from.ground, forest::exposures_of(from.ground, {}), settings};
}

double mean(const std::vector<float>& values) {
    double sum = 0.0;
    for (const float value : values) {
        sum += static_cast<double>(value);
    }
    return sum / static_cast<double>(values.size());
}

/// All columns of a year; `ground_light` tells what was computed.
void columns(State& state, double zone_height_deg, bool deciduous, int ground_points) {
    const LightScene& from = scene(deciduous);
    const forest::LightSite site = site_of(from, zone_height_deg, {.ground_points = ground_points});
    const forest::Canopy canopy{site.ground(), from.trees};
    forest::LightField field = forest::make_light_field(site, from.trees.size());
    for (auto _ : state) {
        forest::compute_columns(site, canopy, from.year, 0, site.ground().frame().size(), field);
        benchmark::ClobberMemory();
    }
    state.counters["zones"] = static_cast<double>(site.sky().zones().size());
    state.counters["ground_light"] = mean(field.ground_light);
    state.counters["cell_light"] = mean_transmittance(site, canopy, field);
}

void march(State& state, double zone_height_deg) {
    const LightScene& from = scene(false);
    const forest::LightSite site = site_of(from, zone_height_deg);
    const forest::Canopy canopy{site.ground(), from.trees};
    const LightMarch marcher{from.ground, canopy, site.ground()};
    MarchedLight light;
    for (auto _ : state) {
        light = marcher.season(site, from.year);
        benchmark::ClobberMemory();
    }
    state.counters["zones"] = static_cast<double>(site.sky().zones().size());
    state.counters["ground_light"] = light.ground;
    state.counters["cell_light"] = light.cells;
}

void fill_canopy(State& state) {
    const LightScene& from = scene(false);
    const forest::LightSite site = site_of(from, 20.0);
    for (auto _ : state) {
        DoNotOptimize(forest::Canopy{site.ground(), from.trees});
    }
}

void trees_of_year(State& state) {
    const LightScene& from = scene(false);
    const forest::LightSite site = site_of(from, 20.0);
    const forest::Canopy canopy{site.ground(), from.trees};
    forest::LightField field = forest::make_light_field(site, from.trees.size());
    forest::compute_columns(site, canopy, from.year, 0, site.ground().frame().size(), field);
    for (auto _ : state) {
        forest::compute_trees(canopy, from.year, from.trees, 0, from.trees.size(), field);
        forest::close_budget(site, field);
        benchmark::ClobberMemory();
    }
    state.counters["light_ratio"] = mean(field.light_ratio);
}

void new_site(State& state) {
    const LightScene& from = scene(false);
    for (auto _ : state) {
        DoNotOptimize(site_of(from, 20.0));
    }
}

}  // namespace

void register_light() {
    const auto add = [](const char* name, auto function) {
        benchmark::RegisterBenchmark(name, function)->Unit(benchmark::kMillisecond);
    };
    add("Light/March/33", [](State& s) { march(s, 20.0); });
    add("Light/Columns/33", [](State& s) { columns(s, 20.0, false, 1); });
    add("Light/Columns/41", [](State& s) { columns(s, 15.0, false, 1); });
    add("Light/Columns/65", [](State& s) { columns(s, 10.0, false, 1); });
    add("Light/Columns/33/GroundPoints", [](State& s) { columns(s, 20.0, false, 2); });
    add("Light/Columns/33/Deciduous", [](State& s) { columns(s, 20.0, true, 1); });
    add("Light/Canopy", fill_canopy);
    add("Light/Trees", trees_of_year);
    add("Light/Site", new_site);
}

}  // namespace benchmarks
