#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "config/text/joined.hpp"
#include "coupling/assessments/compare/page/parts.hpp"
#include "coupling/assessments/compare/runs/run_tables.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::compare {
namespace {

using config::joined;
using report::Axis;
using report::Chart;
using report::ChartPoint;

/// Rocks by the lower end of their bin.
struct Bins {
    std::vector<std::array<double, 3>> bins;  ///< low, high, rocks
};

struct Key {
    std::string target;  ///< empty for run-outs
    std::string cover;
    std::string quantity;
    friend auto operator<=>(const Key&, const Key&) = default;
};

/// The distributions of a run, and how many rocks it simulated over each slope.
struct Distributions {
    std::map<Key, Bins> of;
    std::map<std::string, double> rocks;  ///< by cover
};

Distributions read_distributions(const FinishedRun& run) {
    Distributions read;
    const config::Table runs = read_table(run.folder, "runs.csv", {"cover", "rocks"});
    for (std::size_t row = 0; row < runs.rows(); ++row) {
        read.rocks[runs.text(row, "cover")] = count(runs, row, "rocks");
    }
    const config::Table run_out =
        read_table(run.folder, "run_out.csv", {"cover", "run_out_low_m", "run_out_high_m", "rocks"});
    // A rock that did not stop gets at least as far as it was seen: it counts in what exceeds a distance.
    const bool has_open = run_out.has("not_stopped");
    for (std::size_t row = 0; row < run_out.rows(); ++row) {
        read.of[{"", run_out.text(row, "cover"), "run_out"}].bins.push_back(
            {size(run_out, row, "run_out_low_m"), size(run_out, row, "run_out_high_m"),
             count(run_out, row, "rocks") + (has_open ? count(run_out, row, "not_stopped") : 0.0)});
    }
    if (has_table(run.folder, "target_distributions.csv")) {
        const config::Table table =
            read_table(run.folder, "target_distributions.csv",
                       {"target_id", "cover", "quantity", "bin_low", "bin_high", "rocks"});
        for (std::size_t row = 0; row < table.rows(); ++row) {
            read.of[{table.text(row, "target_id"), table.text(row, "cover"), table.text(row, "quantity")}]
                .bins.push_back(
                    {size(table, row, "bin_low"), size(table, row, "bin_high"), count(table, row, "rocks")});
        }
    }
    return read;
}

struct Quantity {
    const char* name;
    const char* title;
    const char* axis;
    bool logarithmic;
};
constexpr std::array at_targets{Quantity{"energy", "Energy exceeded", "Energy E, kJ", true},
                                Quantity{"speed", "Speed exceeded", "Speed v, m/s", false},
                                Quantity{"height", "Height exceeded", "Height above ground h, m", false}};
constexpr Quantity run_outs{"run_out", "Run-out exceeded", "Run-out in plan, m", false};
/// Where axes of energy begin: a rock of less is as good as at rest.
constexpr double least_kj = 0.1;

/// Share of all rocks [%] above each limit of the bins.
std::vector<ChartPoint> exceeded(const Bins& bins, double rocks, double least_x) {
    double above = 0.0;
    for (const auto& bin : bins.bins) {
        above += bin[2];
    }
    std::vector<ChartPoint> points;
    for (const auto& [low, high, count] : bins.bins) {
        if (count <= 0.0) {
            continue;
        }
        if (points.empty()) {
            points.push_back({std::max(least_x, low), 100.0 * above / rocks});
        }
        above -= count;
        points.push_back({std::max(least_x, high), 100.0 * std::max(0.0, above) / rocks});
    }
    return points;
}

const std::string& words_of(const std::string& cover) {
    return cover == "bare" ? report::page_text("bare slope") : report::page_text("with forest");
}

std::string chart_of(const Key& key, const Quantity& quantity, const std::vector<Distributions>& runs,
                     const SideBySide& comparison, const ShownTargets& charted) {
    double most_x = quantity.logarithmic ? 1.0 : 1e-6;
    double most_percent = 0.0;
    double least_percent = 100.0;
    std::vector<std::pair<std::size_t, std::vector<ChartPoint>>> lines;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const auto found = runs[i].of.find(key);
        const auto rocks = runs[i].rocks.find(key.cover);
        if (found == runs[i].of.end() || rocks == runs[i].rocks.end() || rocks->second <= 0.0) {
            continue;
        }
        std::vector<ChartPoint> points =
            exceeded(found->second, rocks->second, quantity.logarithmic ? least_kj : 0.0);
        if (!points.empty()) {
            points.pop_back();  // above the largest value lies none: a logarithm has no place for it
        }
        if (points.size() < 2) {
            continue;  // rocks of one bin draw no line
        }
        most_x = std::max(most_x, points.back().x);
        most_percent = std::max(most_percent, points.front().y);
        least_percent = std::min(least_percent, points.back().y);
        lines.emplace_back(i, std::move(points));
    }
    if (lines.empty()) {
        return "";
    }
    const Axis x = quantity.logarithmic
                       ? Axis::powers_of_ten(report::page_text(quantity.axis), least_kj, most_x)
                       : Axis::from_zero(report::page_text(quantity.axis), most_x);
    Chart chart{report::join_with_commas(
                    {report::page_text(quantity.title), charted.name_of(key.target), words_of(key.cover)}),
                x,
                Axis::powers_of_ten(report::page_text("% of all rocks with more"), least_percent,
                                    std::max(most_percent, 10.0 * least_percent))};
    for (const auto& [run, points] : lines) {
        chart.add_line(look_of(run), points);
        chart.add_name(look_of(run), comparison.names[run]);
    }
    if (quantity.logarithmic) {
        chart.add_mark(30.0, report::page_text("30 kJ"));
        chart.add_mark(300.0, report::page_text("300 kJ"));
    }
    return chart.figure("");
}

}  // namespace

std::optional<report::PageFields> distributions(std::span<const FinishedRun> runs,
                                                const SideBySide& comparison, const ShownTargets& charted) {
    if (runs.front().summary.kind != "today") {
        return std::nullopt;
    }
    std::vector<Distributions> read;
    std::vector<std::string> targets;
    for (const FinishedRun& run : runs) {
        read.push_back(read_distributions(run));
        for (const auto& [key, bins] : read.back().of) {
            if (!key.target.empty() && charted.charts(key.target) &&
                std::find(targets.begin(), targets.end(), key.target) == targets.end()) {
                targets.push_back(key.target);
            }
        }
    }
    std::vector<report::PageFields> slopes;
    for (const char* cover : {"forest", "bare"}) {
        std::string charts = chart_of({"", cover, "run_out"}, run_outs, read, comparison, charted);
        for (const std::string& target : targets) {
            for (const Quantity& quantity : at_targets) {
                charts += chart_of({target, cover, quantity.name}, quantity, read, comparison, charted);
            }
        }
        if (!charts.empty()) {
            slopes.push_back({{"slope", slope_title(cover)}, {"charts", charts}});
        }
    }
    return part_if_any("slopes", slopes);
}

}  // namespace coupling::compare
