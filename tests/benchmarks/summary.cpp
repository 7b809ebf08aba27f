#include "tests/benchmarks/summary.hpp"

#include <cmath>
#include <functional>
#include <iomanip>
#include <limits>
#include <ostream>

namespace benchmarks {
namespace {

enum class Better { more, less };

struct Goal {
    std::string text;
    Better better;
    double must;
    double stretch;
    double reached;
};

std::vector<Goal> goals_of(const MedianKeeper& results) {
    const auto get = [&](const char* benchmark, const char* counter) {
        return results.median(benchmark, counter);
    };
    const auto times = [&](const char* ours, const char* theirs) {
        return get(ours, "traj/s") / get(theirs, "traj/s");
    };
    const char* const bare = "Trajectory/Bare/tin/f64";
    const char* const forest = "Trajectory/Forest/290/Stats";
    const char* const scale = "Scale/Ha40m1/Stats";
    const double threads =
        get("Threads/Forest290/1/real_time", "ms") / get("Threads/Forest290/2/real_time", "ms");
    const double ten_million_rocks_min = 1e7 / get(scale, "traj/s") / threads / 60.0;
    return {
        {"bare, times the ordinary program", Better::more, 150, 300, times(bare, "Ordinary/Bare")},
        {"bare, times the ordinary program with hints", Better::more, 8, 12,
         times(bare, "Ordinary/BareHinted")},
        {"bare, ns per impact", Better::less, 280, 200, get(bare, "ns_per_impact")},
        {"forest 290/ha with maps and records, times the ordinary program", Better::more, 100, 170,
         times(forest, "Ordinary/Forest290")},
        {"forest 290/ha with maps and records, times the one with hints", Better::more, 14, 22,
         times(forest, "Ordinary/Forest290Hinted")},
        {"forest 290/ha with maps and records, ns per impact", Better::less, 380, 260,
         get(forest, "ns_per_impact")},
        {"ns per crossing, 11 k triangles", Better::less, 20, 12, get("Walk/Tin11k", "ns_per_crossing")},
        {"ns per crossing, 400 k triangles", Better::less, 50, 35, get("Walk/Tin400k", "ns_per_crossing")},
        {"two threads over one, wall time", Better::more, 1.5, 1.9, threads},
        {"40 ha at 1 m, 10 million bare rocks with maps, two threads, minutes", Better::less, 5, 1.5,
         ten_million_rocks_min},
        {"40 ha at 1 m, largest memory of this process, MiB (alone: see README)", Better::less, 200, 100,
         get(scale, "peak_rss_mib")},
        {"light of 40 ha, 33 zones, times marching", Better::more, 80, 150,
         get("Light/March/33", "ms") / get("Light/Columns/33", "ms")},
        {"light of 40 ha, 33 zones, ms", Better::less, 30, 15, get("Light/Columns/33", "ms")},
    };
}

}  // namespace

void MedianKeeper::ReportRuns(const std::vector<Run>& runs) {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs) {
        if (run.run_type == Run::RT_Aggregate && run.aggregate_name == "median") {
            auto& counters = medians_[run.run_name.str()];
            // The sums of an aggregate belong to so many iterations; with threads only wall time tells.
            const bool of_the_wall = run.run_name.str().ends_with("/real_time");
            counters["ms"] = 1e3 * (of_the_wall ? run.real_accumulated_time : run.cpu_accumulated_time) /
                             static_cast<double>(run.iterations);
            for (const auto& [name, counter] : run.counters) {
                const bool is_time = (counter.flags & benchmark::Counter::kInvert) != 0;
                counters[name] = (is_time ? 1e9 : 1.0) * counter.value;
            }
        }
    }
}

double MedianKeeper::median(const std::string& benchmark, const std::string& counter) const {
    const auto found = medians_.find(benchmark);
    if (found == medians_.end() || !found->second.contains(counter)) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    return found->second.at(counter);
}

void print_goals(std::ostream& out, const MedianKeeper& results) {
    out << "\n| goal | must | stretch | reached | |\n|---|--:|--:|--:|---|\n";
    for (const Goal& goal : goals_of(results)) {
        if (std::isnan(goal.reached)) {
            continue;
        }
        const auto reaches = [&](double limit) {
            return goal.better == Better::more ? goal.reached >= limit : goal.reached <= limit;
        };
        const char* const verdict = reaches(goal.stretch) ? "stretch"
                                    : reaches(goal.must)  ? "must"
                                                          : "missed";
        out << "| " << goal.text << " | " << goal.must << " | " << goal.stretch << " | "
            << std::setprecision(3) << goal.reached << std::setprecision(6) << " | " << verdict << " |\n";
    }
}

}  // namespace benchmarks
