#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string_view>

#include "config/text/joined.hpp"
#include "coupling/assessments/compare/page/parts.hpp"
#include "coupling/assessments/compare/runs/run_tables.hpp"
#include "coupling/results/report/percent_axis.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/messages.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::compare {
namespace {

using config::joined;
using report::Axis;
using report::Chart;
using report::ChartPoint;
using report::ChartRange;
using report::escaped;

/// Quantities worth a picture, with the title of their axis.
struct ShownFigure {
    const char* quantity;
    const char* title;
    const char* axis;
};
constexpr std::array shown_figures{
    ShownFigure{"protection_percent", "Protection", "Rocks stopped, %"},
    ShownFigure{"reached_percent", "Rocks that arrive", "Rocks that arrive, %"},
    ShownFigure{"reached_bare_percent", "Rocks that arrive over the bare slope", "Rocks that arrive, %"},
    ShownFigure{"energy_95_kj", "Energy, 95th percentile", "Energy, kJ"},
    ShownFigure{"above_300_kj_per_1000", "Rocks above 300 kJ", "Rocks per 1000 released"},
    ShownFigure{"above_300_kj_bare_per_1000", "Rocks above 300 kJ over the bare slope",
                "Rocks per 1000 released"},
    ShownFigure{"held_percent", "Rocks that a net holds", "Share of those that reach it, %"},
    ShownFigure{"held_bare_percent", "Rocks that a net holds over the bare slope",
                "Share of those that reach it, %"},
    ShownFigure{"sold_height_m", "Height of the net to order", "Height, m"},
    ShownFigure{"sold_height_bare_m", "Height of the net to order over the bare slope", "Height, m"}};
constexpr std::array shown_series{ShownFigure{"protection_percent", "Protection", "Rocks stopped, %"},
                                  ShownFigure{"reached_percent", "Rocks that arrive", "Rocks that arrive, %"},
                                  ShownFigure{"energy_95_kj", "Energy, 95th percentile", "Energy, kJ"},
                                  ShownFigure{"volume_m3pha", "Volume", "Volume, m³/ha"}};

/// The same figure of several courses; of today there is one course.
using Lines = std::vector<const Line*>;

/// Calls `use` with each figure that is known, the number of its course and of its run.
template <class Use>
void each_figure(const Lines& lines, const Use& use) {
    for (std::size_t course = 0; course < lines.size(); ++course) {
        for (std::size_t run = 0; run < lines[course]->figures.size(); ++run) {
            const auto& figure = lines[course]->figures[run];
            if (figure && !std::isnan(figure->value)) {
                use(*figure, course, run);
            }
        }
    }
}

bool has_interval(const Figure& figure) {
    return !std::isnan(figure.low) && !std::isnan(figure.high);
}

/// Protection lies close below 100 %, and there it is compared.
Axis axis_of(const ShownFigure& shown, double lowest, double highest) {
    return shown.quantity == std::string_view{"protection_percent"} && std::isfinite(lowest)
               ? report::percent_axis(report::page_text(shown.axis), lowest, highest)
               : Axis::from_zero(report::page_text(shown.axis), highest);
}

/// "1 none, 2 pfm1".
std::string list_of_courses(const Lines& lines) {
    std::string list;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        list += joined(i > 0 ? ", " : "", std::to_string(i + 1), " ",
                       escaped(course_name(lines[i]->key.regime, lines[i]->key.climate)));
    }
    return list;
}

/// Where the dot of a run stands: runs side by side around their course, or one after the other.
double place_of(std::size_t course, std::size_t run, const Lines& lines) {
    if (lines.size() == 1) {
        return static_cast<double>(run) + 1.0;
    }
    const auto runs = static_cast<double>(lines.front()->figures.size());
    return static_cast<double>(course) + 1.0 + 0.6 * ((static_cast<double>(run) + 0.5) / runs - 0.5);
}

/// Why a run has no value: it has no such thing, or too few rocks for the figure.
std::string why_no_point(const std::optional<Figure>& figure, std::string_view quantity) {
    if (figure && !figure->why_none.empty()) {
        return report::message_text(figure->why_none);
    }
    if (!figure) {
        return report::page_text("not part of this run");
    }
    return quantity == "energy_95_kj" ? report::page_text("fewer than 20 rocks arrive")
                                      : report::page_text("too few rocks");
}

/// "No point: B (only 2 rocks arrive ...)." Empty where each run knows the figure.
std::string missing_points(const Lines& lines, const SideBySide& comparison) {
    std::string list;
    for (const Line* line : lines) {
        for (std::size_t run = 0; run < line->figures.size(); ++run) {
            const auto& figure = line->figures[run];
            if (!figure || std::isnan(figure->value)) {
                list += joined(list.empty() ? "" : ", ", comparison.letters[run], " (",
                               escaped(why_no_point(figure, line->key.quantity)), ")");
            }
        }
    }
    return list.empty() ? "" : report::page_text("No point: {list}.", {{"list", list}});
}

/// Empty where no run knows the figure.
std::string interval_chart(const Lines& lines, const ShownFigure& shown, const SideBySide& comparison,
                           const ShownTargets& charted) {
    double lowest = INFINITY;
    double highest = 1e-3;
    bool any = false;
    bool any_interval = false;
    each_figure(lines, [&](const Figure& figure, std::size_t, std::size_t) {
        any = true;
        any_interval = any_interval || has_interval(figure);
        lowest = std::min(lowest, has_interval(figure) ? figure.low : figure.value);
        highest = std::max(highest, has_interval(figure) ? figure.high : figure.value);
    });
    if (!any) {
        return "";
    }
    const Line& first = *lines.front();
    const bool alone = lines.size() == 1;
    const auto places = static_cast<double>(alone ? first.figures.size() : lines.size());
    Chart chart{report::with_label(report::page_text(shown.title),
                                   report::join_with_commas(
                                       {charted.name_of(first.key.target),
                                        alone ? course_name(first.key.regime, first.key.climate) : ""})),
                Axis{.title = report::page_text(alone ? "Run" : "Regime, by its number below"),
                     .low = 0.5,
                     .high = places + 0.5,
                     .whole_numbers = true,
                     .names = alone ? comparison.letters : std::vector<std::string>{}},
                axis_of(shown, lowest, highest)};
    each_figure(lines, [&](const Figure& figure, std::size_t course, std::size_t run) {
        const double x = place_of(course, run, lines);
        if (has_interval(figure)) {
            const std::array<ChartRange, 1> range{ChartRange{x, std::max(0.0, figure.low), figure.high}};
            chart.add_whiskers(look_of(run), range);
        }
        const std::array<ChartPoint, 1> point{ChartPoint{x, std::max(0.0, figure.value)}};
        chart.add_dots(look_of(run), point);
    });
    for (std::size_t run = 0; run < first.figures.size(); ++run) {
        chart.add_dot_name(look_of(run), comparison.names[run]);
    }
    return chart.figure(report::join_sentences(
        {alone ? "" : report::page_text("Regimes: {regimes}.", {{"regimes", list_of_courses(lines)}}),
         first.key.when == "today" ? report::page_text("With the 95 % interval of the chance in the rocks.")
         : any_interval            ? report::page_text("Mean over the years, with its 95 % interval.")
                                   : report::page_text("Mean over the years, without intervals."),
         shown.quantity == std::string_view{"protection_percent"}
             ? report::page_text("Below 0 is drawn as 0.")
             : "",
         missing_points(lines, comparison)}));
}

/// Year -> mean of a series of a run and its 90 % interval.
struct YearBand {
    double mean = 0.0;
    double low = 0.0;
    double high = 0.0;
    bool has_range = false;  ///< several replicates
};
using SeriesKey = std::array<std::string, 3>;  ///< quantity, target, course_name
using BandsOfRun = std::map<SeriesKey, std::map<int, YearBand>>;

BandsOfRun read_bands(const FinishedRun& run) {
    const config::Table table = read_table(
        run.folder, "regimes_by_year.csv",
        {"regime", "target_id", "quantity", "year", "replicates", "mean", "mean_low_90", "mean_high_90"});
    BandsOfRun bands;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const auto year = static_cast<int>(number(table, row, "year"));
        const std::string course = course_name(table.text(row, "regime"), climate_of(table, row));
        bands[{table.text(row, "quantity"), table.text(row, "target_id"), course}][year] = {
            number(table, row, "mean"), number(table, row, "mean_low_90"), number(table, row, "mean_high_90"),
            number(table, row, "replicates") > 1.0};
    }
    return bands;
}

std::string chart_over_years(const SeriesKey& key, const ShownFigure& shown,
                             const std::vector<BandsOfRun>& bands, const SideBySide& comparison) {
    double highest = 1e-3;
    double lowest = INFINITY;
    bool any = false;
    bool any_range = false;
    int last_year = 1;
    for (const BandsOfRun& of_run : bands) {
        const auto found = of_run.find(key);
        if (found == of_run.end()) {
            continue;
        }
        for (const auto& [year, band] : found->second) {
            any = any || !std::isnan(band.mean);
            for (const double value : {band.mean, band.low, band.high}) {
                highest = std::isnan(value) ? highest : std::max(highest, value);
                lowest = std::isnan(value) ? lowest : std::min(lowest, value);
            }
            any_range = any_range || band.has_range;
            last_year = std::max(last_year, year);
        }
    }
    if (!any) {
        return "";
    }
    const auto& [quantity, target, course] = key;
    Chart chart{report::with_label(report::page_text(shown.title),
                                   report::join_with_commas(
                                       {target.empty() ? report::page_text("forest") : target, course})),
                Axis::from_zero(report::page_text("Years since the start"), last_year),
                axis_of(shown, lowest, highest)};
    for (std::size_t i = 0; i < bands.size(); ++i) {
        const auto found = bands[i].find(key);
        if (found == bands[i].end()) {
            continue;
        }
        std::vector<ChartPoint> points;
        std::vector<ChartRange> ranges;
        for (const auto& [year, band] : found->second) {
            if (std::isnan(band.mean)) {
                continue;
            }
            const double x = year;
            points.push_back({x, std::max(0.0, band.mean)});
            if (band.has_range) {
                // No interval where all replicates are equal.
                const bool known = band.low <= band.high;
                ranges.push_back({x, std::max(0.0, known ? band.low : band.mean),
                                  std::max(0.0, known ? band.high : band.mean)});
            }
        }
        if (points.empty()) {
            continue;
        }
        chart.add_band(look_of(i), ranges);
        chart.add_line(look_of(i), points);
        chart.add_name(look_of(i), comparison.names[i]);
        chart.add_end_letter(points.back().y, comparison.letters[i]);
    }
    return chart.figure(
        any_range
            ? report::page_text(
                  "Mean of the replicates; bands are its 90 % interval (Student’s t). Below 0 is drawn as 0.")
            : report::page_text("One replicate: no bands. Below 0 is drawn as 0."));
}

}  // namespace

std::string look_of(std::size_t run) {
    constexpr std::size_t looks = 8;
    return joined("run", std::to_string(run % looks));
}

const std::string& slope_title(std::string_view cover) {
    return cover == "bare" ? report::page_text("Bare slope") : report::page_text("With forest");
}

std::optional<report::PageFields> interval_charts(const SideBySide& comparison, const ShownTargets& charted) {
    std::string html;
    std::string not_printed;
    for (const ShownFigure& shown : shown_figures) {
        std::vector<std::string> targets;
        std::map<std::string, Lines> of_target;
        for (const Line& line : comparison.lines) {
            if (line.key.quantity == shown.quantity && line.key.when != worst_year &&
                line.key.when != last_year && charted.charts(line.key.target)) {
                Lines& lines = of_target[line.key.target];
                if (lines.empty()) {
                    targets.push_back(line.key.target);
                }
                lines.push_back(&line);
            }
        }
        for (const std::string& target : targets) {
            (charted.prints(target) ? html : not_printed) +=
                interval_chart(of_target[target], shown, comparison, charted);
        }
    }
    auto part = part_if_any("charts", html);
    if (part) {
        part->push_back({"more_charts", part_if_any("not_printed", not_printed)});
    }
    return part;
}

std::optional<report::PageFields> charts_over_years(std::span<const FinishedRun> runs,
                                                    const SideBySide& comparison) {
    if (runs.front().summary.kind != "years") {
        return std::nullopt;
    }
    std::vector<BandsOfRun> bands;
    std::set<SeriesKey> keys;
    for (const FinishedRun& run : runs) {
        bands.push_back(read_bands(run));
        for (const auto& [key, series] : bands.back()) {
            keys.insert(key);
        }
    }
    std::string html;
    for (const ShownFigure& shown : shown_series) {
        for (const SeriesKey& key : keys) {
            if (key[0] == shown.quantity) {
                html += chart_over_years(key, shown, bands, comparison);
            }
        }
    }
    return part_if_any("charts", html);
}

}  // namespace coupling::compare
