#pragma once

#include <benchmark/benchmark.h>

#include <bit>
#include <cstdint>

#include "rockfall/trajectory.hpp"

namespace benchmarks {

/// Finaliser of splitmix64 (Steele et al. 2014): spreads every bit over all others.
inline std::uint64_t mixed(std::uint64_t bits) {
    bits = (bits ^ (bits >> 30U)) * 0xBF58476D1CE4E5B9ULL;
    bits = (bits ^ (bits >> 27U)) * 0x94D049BB133111EBULL;
    return bits ^ (bits >> 31U);
}

/// What a pass over many rocks did.
struct Totals {
    std::uint64_t rocks = 0;
    std::uint64_t impacts = 0;
    std::uint64_t hits = 0;
    std::uint64_t crossings = 0;
    double run_out_m = 0.0;  ///< sum over the rocks, in plan
    std::uint64_t hash = 0;  ///< of the end points, in any order of the rocks

    void add(const Eigen::Vector3d& start_m, const rockfall::FallEnd& end) {
        ++rocks;
        impacts += end.ground_impacts;
        hits += end.tree_hits;
        crossings += end.crossings;
        run_out_m += (end.position_m - start_m).head<2>().norm();
        hash += mixed(std::bit_cast<std::uint64_t>(end.position_m.x()) ^
                      mixed(std::bit_cast<std::uint64_t>(end.position_m.y()) ^
                            mixed(std::bit_cast<std::uint64_t>(end.position_m.z()))));
    }
    void add(const Totals& other) {
        rocks += other.rocks;
        impacts += other.impacts;
        hits += other.hits;
        crossings += other.crossings;
        run_out_m += other.run_out_m;
        hash += other.hash;
    }
};

/// Time per item; in seconds, which the table shows with n for nanoseconds.
inline benchmark::Counter time_per(std::uint64_t items) {
    return {static_cast<double>(items), benchmark::Counter::kIsRate | benchmark::Counter::kInvert};
}

/// The counters of every trajectory benchmark, from the sum over all iterations.
inline void report(benchmark::State& state, const Totals& totals) {
    const auto rocks = static_cast<double>(totals.rocks);
    const auto impacts = static_cast<double>(totals.impacts);
    state.counters["traj/s"] = benchmark::Counter(rocks, benchmark::Counter::kIsRate);
    state.counters["ns_per_impact"] = time_per(totals.impacts);
    if (totals.crossings > 0) {
        state.counters["ns_per_crossing"] = time_per(totals.crossings);
        state.counters["crossings_per_impact"] = static_cast<double>(totals.crossings) / impacts;
    }
    state.counters["impacts_per_rock"] = impacts / rocks;
    state.counters["hits_per_rock"] = static_cast<double>(totals.hits) / rocks;
    state.counters["run_out_m"] = totals.run_out_m / rocks;
}

/// The same for a benchmark whose iterations are all alike; `one_pass` is one of them.
inline void report_repeated(benchmark::State& state, const Totals& one_pass) {
    const auto passes = static_cast<std::uint64_t>(state.iterations());
    report(state, {passes * one_pass.rocks, passes * one_pass.impacts, passes * one_pass.hits,
                   passes * one_pass.crossings, static_cast<double>(passes) * one_pass.run_out_m});
    // As many bits as the digits of a printed counter can show.
    state.counters["hash"] = static_cast<double>(one_pass.hash % 1'000'000);
}

}  // namespace benchmarks
