#include <algorithm>
#include <functional>

#include "config/text/joined.hpp"
#include "config/units/constants.hpp"
#include "coupling/assessments/today/figures/path_series.hpp"
#include "coupling/assessments/today/report/sections.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/report/chart.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::report {
namespace {

using config::j_per_kj;
using config::joined;

/// Lines of the chosen paths on a slope and, last, of the mean of all sampled ones.
class TimeCharts {
public:
    TimeCharts(const RunResults& results, Cover cover)
        : shown_{with_a_reason_of_its_own(paths_of_series(results, cover))},
          means_{means_of_paths(results, cover)},
          cover_{cover} {
        for (const SeriesPath& path : shown_) {
            series_.push_back(series_of(*path.path, mass_of_rock_kg(results, *path.path)));
            last_s_ = std::max(last_s_, series_.back().back().time_s);
        }
        constexpr std::uint64_t least_rocks = 10;  // [choice]
        std::erase_if(means_, [](const PathMean& mean) { return mean.rocks < least_rocks; });
        last_s_ = std::max(last_s_, means_.empty() ? 0.0 : means_.back().time_s);
    }

    [[nodiscard]] std::string figure(
        const std::string& title, const std::string& axis, const std::string& caption,
        const std::function<std::optional<double>(const PathMoment&)>& of_path,
        const std::function<std::optional<double>(const PathMean&)>& of_mean) const {
        double high = 1e-9;
        const auto line_of = [&](const auto& rows, const auto& value_of) {
            std::vector<ChartPoint> line;
            for (const auto& row : rows) {
                if (const std::optional<double> value = value_of(row)) {
                    high = std::max(high, *value);
                    line.push_back({row.time_s, *value});
                }
            }
            return line;
        };
        std::vector<std::vector<ChartPoint>> lines;
        for (const std::vector<PathMoment>& moments : series_) {
            lines.push_back(line_of(moments, of_path));
        }
        const std::vector<ChartPoint> mean = line_of(means_, of_mean);
        Chart chart{join_with_commas({title, title_of(cover_)}),
                    Axis::from_zero(page_text("Time, s"), last_s_), Axis::from_zero(axis, high)};
        for (std::size_t i = 0; i < lines.size(); ++i) {
            const std::string series = joined("path", std::to_string(i));
            chart.add_line(series, lines[i]);
            chart.add_name(series, page_text("rock {chosen_rock}: {chosen_why}",
                                             {{"chosen_rock", std::to_string(shown_[i].path->rock)},
                                              {"chosen_why", why(shown_[i])}}));
        }
        if (!mean.empty()) {
            chart.add_line("path-mean", mean);
            chart.add_name("path-mean", page_text("mean of the sampled blocks"));
        }
        return chart.figure(caption);
    }

private:
    /// As many lines as a chart can hold apart: without those that are only named.
    static std::vector<SeriesPath> with_a_reason_of_its_own(std::vector<SeriesPath> paths) {
        std::erase_if(paths,
                      [](const SeriesPath& path) { return path.reasons == std::vector{PathReason::named}; });
        return paths;
    }

    static std::string why(const SeriesPath& path) {
        std::vector<std::string> reasons;
        for (const PathReason reason : path.reasons) {
            if (reason != PathReason::named) {
                reasons.push_back(reason == PathReason::fastest    ? page_text("fastest")
                                  : reason == PathReason::farthest ? page_text("farthest")
                                                                   : page_text("median run-out"));
            }
        }
        return join_with_commas(reasons);
    }

    std::vector<SeriesPath> shown_;
    std::vector<std::vector<PathMoment>> series_;
    std::vector<PathMean> means_;
    Cover cover_;
    double last_s_ = 1.0;
};

}  // namespace

std::optional<PageFields> paths_over_time(const RunResults& results) {
    if (!has_path_series(results)) {
        return std::nullopt;
    }
    const std::string under_way =
        page_text("The mean is that of the sampled blocks that are under way at the time.");
    std::string charts;
    for (const Cover cover : covers_of(results)) {
        const TimeCharts chart{results, cover};
        charts += joined(
            chart.figure(
                page_text("Speed over time"), page_text("Speed, m/s"), under_way,
                [](const PathMoment& m) { return std::optional{m.speed_mps}; },
                [](const PathMean& m) { return std::optional{m.speed_mps}; }),
            chart.figure(
                page_text("Acceleration over time"), page_text("Acceleration, m/s²"),
                page_text(
                    "Change of the mean velocity from one interval of {step} s to the next, by its length: "
                    "shorter blows are spread over it.",
                    {{"step", exact(series_step_s)}}),
                [](const PathMoment& m) { return m.acceleration_mps2; },
                [](const PathMean& m) { return m.acceleration_mps2; }),
            chart.figure(
                page_text("Displacement over time"), page_text("Distance from the start, m"),
                page_text("The mean is that of all sampled blocks; those at their end count with that."),
                [](const PathMoment& m) { return std::optional{m.displacement_m}; },
                [](const PathMean& m) { return std::optional{m.displacement_m}; }),
            chart.figure(
                page_text("Kinetic energy over time"), page_text("Kinetic energy, kJ"), under_way,
                [](const PathMoment& m) { return std::optional{m.kinetic_j / j_per_kj}; },
                [](const PathMean& m) { return std::optional{m.kinetic_j / j_per_kj}; }),
            chart.figure(
                page_text("Energy taken over time"), page_text("Energy, kJ"),
                page_text(
                    "By ground, trees, logs and nets so far: what the start and the lost height gave, less "
                    "the kinetic energy. The mean is that of the sampled blocks that are under way at the "
                    "time."),
                [](const PathMoment& m) { return std::optional{m.taken_j() / j_per_kj}; },
                [](const PathMean& m) { return std::optional{m.taken_j / j_per_kj}; }));
    }
    return PageFields{{"time_charts", charts}};
}

}  // namespace coupling::report
