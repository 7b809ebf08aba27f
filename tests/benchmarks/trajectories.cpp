#include <benchmark/benchmark.h>
#include <omp.h>
#include <sys/resource.h>

#include <memory>
#include <optional>

#include "rockfall/terrain/mesh.hpp"
#include "tests/benchmarks/counters.hpp"
#include "tests/benchmarks/one_cover.hpp"
#include "tests/benchmarks/ordinary.hpp"
#include "tests/benchmarks/scene.hpp"

namespace benchmarks {
namespace {

using benchmark::State;
using rockfall::StemIndex;

/// What all benchmarks on bench_slope share; made when first asked for.
struct Bench {
    rockfall::FallLaw law = compared_law();
    config::Raster<double> heights = bench_heights();
    const rockfall::Slope& slope = bench_slope();
    std::vector<rockfall::ReleaseSource> sources = bench_sources(slope.terrain);
    std::vector<rockfall::RockStart> starts = starts_of(slope, sources);
    config::GridFrame frame = map_frame(heights.frame, slope.terrain);
    double radius_m = 0.5 * compared_start().diameter.largest_m();
    StemIndex forest_290{bench_trees(), slope.terrain, radius_m, law.tree.taper};
    // 1000 stems on each of the seven hectares that bench_slope has under forest.
    StemIndex forest_1000{random_trees(350.0, 200.0, 7000), slope.terrain, radius_m, law.tree.taper};
};

const Bench& bench() {
    static const Bench it;
    return it;
}

/// Every n-th rock: the release points keep their shares.
std::vector<rockfall::RockStart> sample(const std::vector<rockfall::RockStart>& starts, std::size_t count) {
    std::vector<rockfall::RockStart> chosen;
    const std::size_t step = starts.size() / count;
    for (std::size_t i = 0; i < count; ++i) {
        chosen.push_back(starts[i * step]);
    }
    return chosen;
}

std::vector<Eigen::Vector3d> points_of(const rockfall::Terrain& terrain) {
    std::vector<Eigen::Vector3d> points;
    for (const rockfall::Vertex& v : terrain.vertices()) {
        points.emplace_back(v.x_m + terrain.origin_m().x(), v.y_m + terrain.origin_m().y(), v.z_m);
    }
    return points;
}

void ordinary_program(State& state, ordinary::Mode mode, std::size_t rocks) {
    static ordinary::Program program{points_of(bench().slope.terrain), bench_trees(), bench().heights.frame,
                                     bench().law, compared_ground()};
    const std::vector<rockfall::RockStart> starts = sample(bench().starts, rocks);
    Totals totals;
    for (auto _ : state) {
        totals.add(program.run(starts, bench().slope.terrain.origin_m(), mode));
    }
    report(state, totals);
}

void trajectory_ends(State& state, const StemIndex* stems) {
    Totals totals;
    for (auto _ : state) {
        totals = fall_bare(bench().slope, bench().sources, bench().law, stems);
    }
    report_repeated(state, totals);
}

void trajectory_every_cell(State& state) {
    const auto sources = bench_sources(full_bench_slope().terrain);
    Totals totals;
    for (auto _ : state) {
        totals = fall_bare(full_bench_slope(), sources, bench().law);
    }
    report_repeated(state, totals);
}

void trajectory_stats(State& state, const StemIndex* stems, bool with_percentiles) {
    std::optional<rockfall::CellHistograms> histograms;
    if (with_percentiles) {
        histograms.emplace(bench().frame);
    }
    OneCover cover{bench().slope, bench().law, stems, bench().frame, histograms ? &*histograms : nullptr};
    Totals totals;
    for (auto _ : state) {
        totals = cover.fall(bench().sources);
    }
    report_repeated(state, totals);
}

/// The worker as the program runs it: each rock with forest and without.
void worker_pairs(State& state) {
    const Bench& b = bench();
    const rockfall::Assessment assessment{
        b.slope, b.forest_290, b.sources, {}, compared_start(), b.law, b.frame, 20260101, 0, 0, 0};
    const std::vector<rockfall::Chunk> chunks = rockfall::plan_chunks(b.sources);
    rockfall::ChunkRows rows;
    for (auto _ : state) {
        rockfall::Worker worker{assessment, {nullptr, nullptr}};
        for (const rockfall::Chunk& chunk : chunks) {
            rows.clear();
            worker.run(chunk, rows, nullptr, {});
        }
        benchmark::DoNotOptimize(worker.tally().runs[0].rocks);
    }
    state.counters["pairs/s"] = benchmark::Counter(static_cast<double>(b.starts.size()),
                                                   benchmark::Counter::kIsIterationInvariantRate);
}

void threads(State& state) {
    const Bench& b = bench();
    const int count = static_cast<int>(state.range(0));
    std::vector<std::unique_ptr<OneCover>> covers;
    for (int i = 0; i < count; ++i) {
        covers.push_back(std::make_unique<OneCover>(b.slope, b.law, &b.forest_290, b.frame, nullptr));
    }
    Totals totals;
    for (auto _ : state) {
        totals = {};
        std::vector<Totals> by_source(b.sources.size());
#pragma omp parallel for schedule(dynamic) num_threads(count)
        for (std::size_t i = 0; i < b.sources.size(); ++i) {
            const auto worker = static_cast<std::size_t>(omp_get_thread_num());
            by_source[i] = covers[worker]->fall({&b.sources[i], 1});
        }
        for (const Totals& part : by_source) {
            totals.add(part);
        }
    }
    report_repeated(state, totals);
}

double peak_rss_mib() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

/// 40 ha with every cell of 1 m as a vertex: the mesh is far larger than the second-level cache.
struct LargeSlope {
    static constexpr double length_m = 800.0;
    static constexpr double width_m = 500.0;
    static constexpr std::uint64_t rocks = 8'000;
    config::Raster<double> heights = rough_plane(length_m, width_m, 1.0);
    rockfall::Slope slope = slope_of(rockfall::triangulate(heights, 0.0));
    rockfall::FallLaw law = compared_law();
    std::vector<rockfall::ReleaseSource> sources = edge_sources(slope.terrain, width_m, rocks);
    config::GridFrame frame = map_frame(heights.frame, slope.terrain);
};

const LargeSlope& large_slope() {
    static const LargeSlope it;
    return it;
}

void scale_bare(State& state) {
    const LargeSlope& large = large_slope();
    Totals totals;
    for (auto _ : state) {
        totals = fall_bare(large.slope, large.sources, large.law);
    }
    report_repeated(state, totals);
    state.counters["peak_rss_mib"] = peak_rss_mib();
}

void scale_stats(State& state) {
    const LargeSlope& large = large_slope();
    OneCover cover{large.slope, large.law, nullptr, large.frame, nullptr};
    Totals totals;
    for (auto _ : state) {
        totals = cover.fall(large.sources);
    }
    report_repeated(state, totals);
    state.counters["peak_rss_mib"] = peak_rss_mib();
}

}  // namespace

void register_trajectories() {
    const auto add = [](const char* name, auto function) {
        return benchmark::RegisterBenchmark(name, function)->Unit(benchmark::kMillisecond);
    };
    add("Ordinary/Bare", [](State& s) { ordinary_program(s, {false, false}, 80); });
    add("Ordinary/BareHinted", [](State& s) { ordinary_program(s, {true, false}, 2500); });
    add("Ordinary/Forest290", [](State& s) { ordinary_program(s, {false, true}, 320); });
    add("Ordinary/Forest290Hinted", [](State& s) { ordinary_program(s, {true, true}, 2500); });
    add("Trajectory/Bare/tin/f64", [](State& s) { trajectory_ends(s, nullptr); });
    add("Trajectory/Bare/every_cell/f64", trajectory_every_cell);
    add("Trajectory/Bare/tin/f64/Stats", [](State& s) { trajectory_stats(s, nullptr, false); });
    add("Trajectory/Forest/290", [](State& s) { trajectory_ends(s, &bench().forest_290); });
    add("Trajectory/Forest/1000", [](State& s) { trajectory_ends(s, &bench().forest_1000); });
    add("Trajectory/Forest/290/Stats", [](State& s) { trajectory_stats(s, &bench().forest_290, false); });
    add("Trajectory/Forest/290/StatsPercentiles",
        [](State& s) { trajectory_stats(s, &bench().forest_290, true); });
    add("Trajectory/Forest/1000/Stats", [](State& s) { trajectory_stats(s, &bench().forest_1000, false); });
    add("Ensemble/Pairs290", worker_pairs);
    add("Threads/Forest290", threads)->Arg(1)->Arg(2)->UseRealTime();
    add("Scale/Ha40m1/Bare", scale_bare);
    add("Scale/Ha40m1/Stats", scale_stats);
}

}  // namespace benchmarks
