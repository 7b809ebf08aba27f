#include <benchmark/benchmark.h>

#include <fstream>
#include <iostream>
#include <string>
#include <string_view>
#include <vector>

#include "tests/benchmarks/flat_terrain.hpp"
#include "tests/benchmarks/scene.hpp"
#include "tests/benchmarks/summary.hpp"

namespace benchmarks {
void register_trajectories();
void register_pieces();
void register_light();
void register_forest_years();
void register_member_years();
}  // namespace benchmarks

namespace {

/// Writes the terrain of bench_slope for `impacts_counted`.
int write_terrain(const std::string& file) {
    std::ofstream out{file, std::ios::binary};
    benchmarks::write_flat(out, benchmarks::bench_slope().terrain);
    return out.flush() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc == 3 && std::string_view{argv[1]} == "--write") {
        return write_terrain(argv[2]);
    }
    // What the caller says comes later and counts.
    std::vector<std::string> words{argv[0], "--benchmark_enable_random_interleaving=true",
                                   "--benchmark_repetitions=9", "--benchmark_report_aggregates_only=true",
                                   "--benchmark_min_time=0.1"};
    words.insert(words.end(), argv + 1, argv + argc);
    std::vector<char*> arguments;
    for (std::string& word : words) {
        arguments.push_back(word.data());
    }
    int count = static_cast<int>(arguments.size());
    benchmark::Initialize(&count, arguments.data());
    if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) {
        return 2;
    }
    benchmarks::register_trajectories();
    benchmarks::register_pieces();
    benchmarks::register_light();
    benchmarks::register_forest_years();
    benchmarks::register_member_years();
    benchmarks::MedianKeeper results;
    benchmark::RunSpecifiedBenchmarks(&results);
    benchmarks::print_goals(std::cout, results);
    return 0;
}
