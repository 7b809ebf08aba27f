#pragma once

#include <benchmark/benchmark.h>

#include <map>
#include <string>
#include <vector>

namespace benchmarks {

/// Prints benchmarks as usual and keeps the median of every counter.
class MedianKeeper : public benchmark::ConsoleReporter {
public:
    MedianKeeper() : ConsoleReporter{OO_Tabular} {}
    void ReportRuns(const std::vector<Run>& runs) override;

    /// Counter of a benchmark, not a number where it was not run; times in nanoseconds.
    /// "ms" is the wall time of an iteration.
    [[nodiscard]] double median(const std::string& benchmark, const std::string& counter) const;

private:
    std::map<std::string, std::map<std::string, double>> medians_;
};

/// The goals with what was reached, as a table in Markdown; goals without their benchmarks are left out.
void print_goals(std::ostream& out, const MedianKeeper& results);

}  // namespace benchmarks
