#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "config/text/joined.hpp"
#include "coupling/assessments/today/report/arrival_rows.hpp"
#include "coupling/assessments/today/report/sections.hpp"
#include "coupling/results/figures/most_reached.hpp"
#include "coupling/results/report/chart.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::report {
namespace {

using config::joined;

constexpr double most_rows = 12.0;

/// Stretches put together to at most a dozen rows of a round length.
std::vector<Stretch> longer_stretches(const AlongLine& line) {
    const double step_m = std::max(stretch_m, nice_step(line.length_m() / most_rows));
    std::vector<Stretch> merged;
    std::vector<std::size_t> row_of;
    for (const Stretch& stretch : line.stretches) {
        if (merged.empty() || stretch.from_m >= merged.back().from_m + step_m - 1e-6) {
            merged.push_back(stretch);
        } else {
            merged.back().to_m = stretch.to_m;
            merged.back().tally.add(stretch.tally);
        }
        row_of.push_back(merged.size() - 1);
    }
    for (const MovedAlong& rock : line.moved) {
        if (row_of[rock.forest] == row_of[rock.bare]) {
            ++merged[row_of[rock.bare]].tally.reached_both;
        }
    }
    return merged;
}

std::vector<PageFields> rows_of(const std::vector<Stretch>& stretches, std::uint64_t rocks) {
    std::vector<PageFields> rows;
    for (const Stretch& stretch : stretches) {
        rows.push_back(arrival_cells(stretch.tally, rocks));
        rows.back().push_back({"from", fixed(stretch.from_m, 0)});
        rows.back().push_back({"to", fixed(stretch.to_m, 0)});
    }
    return rows;
}

std::vector<double> edges_of(const AlongLine& line) {
    std::vector<double> edges{0.0};
    for (const Stretch& stretch : line.stretches) {
        edges.push_back(stretch.to_m);
    }
    return edges;
}

/// Arrivals on each stretch, per 1000 rocks that fell and per full stretch of 10 m.
std::vector<double> rates_of(const AlongLine& line, Cover cover, std::uint64_t rocks) {
    std::vector<double> rates;
    for (const Stretch& stretch : line.stretches) {
        const auto reached = static_cast<double>(stretch.tally.by_cover[index_of(cover)].reached);
        rates.push_back(rocks == 0 ? 0.0 : 1000.0 * reached / static_cast<double>(rocks));
    }
    return rates;
}

std::string rocks_chart(const RunResults& results, const AlongLine& line) {
    std::vector<Cover> covers = covers_of(results);
    std::reverse(covers.begin(), covers.end());
    double most = 0.0;
    for (const Cover cover : covers) {
        for (const double rate : rates_of(line, cover, results.rocks)) {
            most = std::max(most, rate);
        }
    }
    Axis x = Axis::from_zero(page_text("Distance along the line, m"), line.length_m());
    x.high = line.length_m();
    Chart chart{page_text("Rocks that arrive, by stretches of 10 m"), std::move(x),
                Axis::from_zero(page_text("Rocks per 1000 released"), most)};
    const std::vector<double> edges = edges_of(line);
    for (const Cover cover : covers) {
        chart.add_steps(name_of(cover), edges, rates_of(line, cover, results.rocks));
        chart.add_name(name_of(cover), title_of(cover));
    }
    return chart.figure(
        page_text("Distances are in plan, from the first point of the line; the map marks them."));
}

/// Runs of stretches in which the percentile is known: a line each.
std::vector<std::vector<ChartPoint>> energy_runs(const AlongLine& line, Cover cover) {
    std::vector<std::vector<ChartPoint>> runs(1);
    for (const Stretch& stretch : line.stretches) {
        const rockfall::ArrivalTally& arrived = stretch.tally.by_cover[index_of(cover)];
        const double energy_kj = figures_of(arrived, arrived.reached).energy_kj.p95;
        if (std::isnan(energy_kj)) {
            if (!runs.back().empty()) {
                runs.emplace_back();
            }
            continue;
        }
        runs.back().push_back({stretch.from_m, energy_kj});
        runs.back().push_back({stretch.to_m, energy_kj});
    }
    if (runs.back().empty()) {
        runs.pop_back();
    }
    return runs;
}

std::string energy_chart(const RunResults& results, const AlongLine& line) {
    std::vector<Cover> covers = covers_of(results);
    std::reverse(covers.begin(), covers.end());
    double most_kj = 0.0;
    for (const Cover cover : covers) {
        for (const auto& run : energy_runs(line, cover)) {
            for (const ChartPoint& point : run) {
                most_kj = std::max(most_kj, point.y);
            }
        }
    }
    if (most_kj == 0.0) {
        return "";
    }
    Axis x = Axis::from_zero(page_text("Distance along the line, m"), line.length_m());
    x.high = line.length_m();
    Chart chart{page_text("Energy by stretches of 10 m, 95th percentile"), std::move(x),
                Axis::from_zero(page_text("Energy, kJ"), most_kj)};
    for (const Cover cover : covers) {
        for (const auto& run : energy_runs(line, cover)) {
            chart.add_line(name_of(cover), run);
        }
        chart.add_name(name_of(cover), title_of(cover));
    }
    return chart.figure(
        page_text("Energy that 5 % of the rocks arriving on a stretch exceed. Gaps: fewer than 20 rocks, too "
                  "few for an estimate."));
}

PageFields part_of_line(const RunResults& results, const AlongLine& line) {
    const rockfall::Target& target = results.site.targets[line.target];
    const bool any = std::any_of(line.stretches.begin(), line.stretches.end(), [](const Stretch& stretch) {
        return stretch.tally.by_cover[0].reached + stretch.tally.by_cover[1].reached > 0;
    });
    std::optional<PageFields> arrivals;
    if (any) {
        const bool has_more = static_cast<double>(line.stretches.size()) > most_rows;
        arrivals = {
            {"charts", joined(rocks_chart(results, line), energy_chart(results, line))},
            {"stretches", rows_of(longer_stretches(line), results.rocks)},
            {"all_stretches",
             has_more ? std::optional{PageFields{{"stretches", rows_of(line.stretches, results.rocks)}}}
                      : std::nullopt}};
    }
    return {{"name", target.name.empty() ? target.id : target.name}, {"arrivals", arrivals}};
}

bool has_stretches(const AlongLine& line) {
    return !line.stretches.empty();
}

/// Those that most rocks reach.
std::vector<const AlongLine*> lines_shown(const RunResults& results) {
    std::map<std::size_t, const AlongLine*> line_of;
    std::vector<std::size_t> targets;
    for (const AlongLine& line : results.breakdown.lines) {
        if (has_stretches(line)) {
            line_of.emplace(line.target, &line);
            targets.push_back(line.target);
        }
    }
    std::vector<const AlongLine*> lines;
    for (const std::size_t target :
         most_reached(results.tally.targets, std::move(targets), most_target_cards)) {
        lines.push_back(line_of.at(target));
    }
    return lines;
}

}  // namespace

std::optional<PageFields> along_lines(const RunResults& results) {
    const Breakdown& breakdown = results.breakdown;
    std::vector<PageFields> lines;
    for (const AlongLine* line : lines_shown(results)) {
        lines.push_back(part_of_line(results, *line));
    }
    if (results.site.targets.empty() || (breakdown.is_known && lines.empty())) {
        return std::nullopt;
    }
    const auto all = static_cast<std::size_t>(
        std::count_if(breakdown.lines.begin(), breakdown.lines.end(), has_stretches));
    return PageFields{{"places_kept", breakdown.is_known},
                      {"lines", lines},
                      {"some_lines", lines.size() < all},
                      {"shown", grouped(lines.size())},
                      {"all", grouped(all)}};
}

}  // namespace coupling::report
