#include <benchmark/benchmark.h>

#include <map>
#include <string>

#include "forest/light/stand_light.hpp"
#include "forest/regeneration/regeneration.hpp"
#include "forest/site/season.hpp"
#include "tests/forest/small_forest.hpp"

namespace benchmarks {
namespace {

using benchmark::DoNotOptimize;
using benchmark::State;

/// A slope of `side` x `side` patches with about 1000 stems a hectare of spruce, beech and fir in two layers,
/// after ten years of their own: with saplings, groups, dead wood.
struct GrownForest {
    explicit GrownForest(int side)
        : forest{forest::square_of_forest(side)},
          stand{forest.grid, forest.species.size(), forest::mixed_stand(forest, 1100.0, 1), 2000} {
        for (int year = 0; year < 10; ++year) {
            static_cast<void>(forest.grow(stand));
        }
    }

    [[nodiscard]] forest::SiteWeather weather() const { return {forest.weather, 350.0, false}; }

    forest::SmallForest forest;
    forest::Stand stand;
};

const GrownForest& grown(int side) {
    static std::map<int, GrownForest> all;
    return all.try_emplace(side, side).first->second;
}

void count(State& state, const GrownForest& from) {
    const auto per_patch = static_cast<double>(from.forest.grid.size() * state.iterations());
    state.counters["ns_per_patch"] =
        benchmark::Counter(per_patch, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
    state.counters["stems_per_ha"] =
        static_cast<double>(from.stand.stems_standing()) / from.forest.grid.area_ha();
    state.counters["trees"] = static_cast<double>(from.stand.trees().size());
    state.counters["cohorts"] = static_cast<double>(from.stand.cohorts().size());
}

struct YearLight {
    forest::LightYear year;
    forest::LightField field;
    forest::StandLight trees;
};

YearLight light_of(const GrownForest& from) {
    YearLight light;
    light.year = forest::light_year_of(from.forest.site, from.forest.species, from.weather());
    const std::vector<forest::LightTree> trees = forest::light_trees_of(from.stand, from.forest.species);
    const forest::Canopy canopy{from.forest.site.light().ground(), trees};
    light.field = forest::compute_light(from.forest.site.light(), canopy, light.year, trees);
    light.trees = forest::light_in_stand(from.stand, from.forest.species, from.forest.site.light(), canopy,
                                         light.field);
    return light;
}

void light(State& state, int side) {
    const GrownForest& from = grown(side);
    for (auto _ : state) {
        DoNotOptimize(light_of(from));
    }
    count(state, from);
}

void season(State& state, int side) {
    const GrownForest& from = grown(side);
    const YearLight light = light_of(from);
    for (auto _ : state) {
        DoNotOptimize(forest::compute_season(from.stand, from.forest.site, from.forest.species,
                                             from.weather(), light.year, light.field, {}));
    }
    count(state, from);
}

/// `change` is timed on a fresh copy of the stand each time.
template <class Change>
void changing(State& state, int side, Change change) {
    const GrownForest& from = grown(side);
    for (auto _ : state) {
        state.PauseTiming();
        {
            forest::Stand stand = from.stand;
            state.ResumeTiming();
            change(from.forest, stand);
            state.PauseTiming();
        }
        state.ResumeTiming();
    }
    count(state, from);
}

void regeneration(State& state, int side) {
    changing(state, side, [](const forest::SmallForest& forest, forest::Stand& stand) {
        stand.begin_year();
        forest::regenerate(stand, forest.site, forest.species, forest.weather,
                           {stand.grid().size(), forest.species.size()}, forest.parameters.regeneration, 1,
                           0);
    });
}

void year(State& state, int side) {
    changing(state, side, [](const forest::SmallForest& forest, forest::Stand& stand) {
        DoNotOptimize(forest.grow(stand));
    });
}

}  // namespace

void register_forest_years() {
    for (const int side : {20, 63, 126}) {
        const std::string patches = std::to_string(side * side);
        const auto add = [&](const char* name, void (*function)(State&, int)) {
            benchmark::RegisterBenchmark((name + patches).c_str(), [=](State& s) {
                function(s, side);
            })->Unit(benchmark::kMillisecond);
        };
        add("Forest/Light/", light);
        add("Forest/Season/", season);
        add("Forest/Regeneration/", regeneration);
        add("Forest/Year/", year);
    }
}

}  // namespace benchmarks
