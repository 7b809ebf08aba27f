#include "validation/engine/kinds/collapse_case.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <sstream>
#include <utility>

#include "config/table/table.hpp"
#include "config/text/joined.hpp"
#include "coupling/assessments/collapse/collapse_run.hpp"
#include "coupling/examples/embedded.hpp"
#include "coupling/run/interrupt.hpp"
#include "validation/engine/case/over_seeds.hpp"
#include "validation/engine/case/unpacked_case.hpp"

namespace coupling::validation {
namespace {

using collapse::CollapseScenario;
using collapse::CollapseSite;
using collapse::FrameRow;
using collapse::SimulatedCollapse;
using config::joined;

/// A low that parts two peaks lies below both by this share of the largest [choice].
constexpr double share_of_a_peak = 0.2;
/// Pieces of work that the progress counts.
constexpr std::uint64_t pieces_of_work = 200;

struct OpenedCollapse {
    std::unique_ptr<CollapseScenario> scenario;
    CollapseSite site;
};

/// When a growing energy has reached a share of its last value.
double time_of_share(const std::vector<FrameRow>& rows, double (*energy_j)(const FrameRow&), double share) {
    const double last = energy_j(rows.back());
    for (const FrameRow& row : rows) {
        if (last > 0.0 && energy_j(row) >= share * last) {
            return row.time_s;
        }
    }
    return std::numeric_limits<double>::quiet_NaN();
}

/// A figure of the last frame up to a time.
double value_at(const std::vector<FrameRow>& rows, double time_s, double FrameRow::*figure) {
    double value = 0.0;
    for (const FrameRow& row : rows) {
        value = row.time_s <= time_s + 1e-6 ? row.*figure : value;
    }
    return value;
}

/// Figures of a collapse: name, label, unit, value.
struct CollapseFigure {
    const char* name;
    const char* label;
    const char* unit;
    double (*value)(const SimulatedCollapse&, const CollapseSite&);
};

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

const std::vector<CollapseFigure>& collapse_figures() {
    using S = SimulatedCollapse;
    using P = CollapseSite;
    static const std::vector<CollapseFigure> figures{
        {"duration_s", "time until less than 1 % of the blocks move", "s",
         [](const S& s, const P&) { return s.figures.duration_s.value_or(no_value); }},
        {"peak_mean_speed_mps", "peak of the mean speed", "m/s",
         [](const S& s, const P&) { return s.figures.peak_mean_speed_mps; }},
        {"peak_time_s", "time of that peak", "s", [](const S& s, const P&) { return s.figures.peak_time_s; }},
        {"largest_speed_mps", "largest speed of a block", "m/s",
         [](const S& s, const P&) { return s.figures.largest_speed_mps; }},
        {"front_m", "farthest way of a block in plan", "m",
         [](const S& s, const P&) { return s.figures.front_m; }},
        {"area_m2", "area that blocks passed", "m2", [](const S& s, const P&) { return s.figures.area_m2; }},
        {"speed_peaks", "peaks of the mean speed over time", "-",
         [](const S& s, const P&) {
             std::vector<double> speeds;
             for (const FrameRow& row : s.rows) {
                 speeds.push_back(row.mean_speed_mps);
             }
             return static_cast<double>(peaks_of(speeds, share_of_a_peak));
         }},
        {"friction_after_fracture_s", "half of the friction after half of the fracture energy", "s",
         [](const S& s, const P&) {
             return time_of_share(
                        s.rows, [](const FrameRow& r) { return r.ledger.friction_j; }, 0.5) -
                    time_of_share(
                        s.rows, [](const FrameRow& r) { return r.ledger.fracture_j; }, 0.5);
         }},
        {"mean_speed_4s_mps", "mean speed after 4 s", "m/s",
         [](const S& s, const P&) { return value_at(s.rows, 4.0, &FrameRow::mean_speed_mps); }},
        {"mean_speed_20s_mps", "mean speed after 20 s", "m/s",
         [](const S& s, const P&) { return value_at(s.rows, 20.0, &FrameRow::mean_speed_mps); }},
        {"front_6s_m", "farthest way after 6 s", "m",
         [](const S& s, const P&) { return value_at(s.rows, 6.0, &FrameRow::front_m); }},
        {"front_10s_m", "farthest way after 10 s", "m",
         [](const S& s, const P&) { return value_at(s.rows, 10.0, &FrameRow::front_m); }},
        {"front_20s_m", "farthest way after 20 s", "m",
         [](const S& s, const P&) { return value_at(s.rows, 20.0, &FrameRow::front_m); }},
        {"residual_percent", "largest residual of the energies", "%",
         [](const S& s, const P&) { return 100.0 * s.figures.largest_residual; }},
        {"floor_m2", "floor of houses that blocks reached", "m2",
         [](const S& s, const P&) { return s.floor_reached_m2; }},
        {"blocks", "blocks", "-",
         [](const S&, const P& site) { return static_cast<double>(site.count.free); }},
        {"volume_m3", "volume of the mass", "m3", [](const S&, const P& site) { return site.count.body_m3; }},
    };
    return figures;
}

/// A figure of the study at a time: that of another figure, or a number.
struct StudyPoint {
    const char* quantity = nullptr;
    const char* time_quantity = nullptr;
    double time_s = 0.0;
};

/// What a chart over time shows.
struct Course {
    const char* title;
    const char* axis;
    const char* note;
    double (*value)(const FrameRow&);
    std::array<StudyPoint, 4> of_study{};  ///< printed of the same, as far as published.csv has it
};

/// Those that the figures of the study show.
constexpr std::array<Course, 8> courses{{
    {"Mean speed of the mass",
     "mean speed [m/s]",
     "By mass, over all blocks.",
     [](const FrameRow& row) { return row.mean_speed_mps; },
     {{{"peak_mean_speed_mps", "peak_time_s"}}}},
    {"Front",
     "front [m]",
     "Farthest way of a block in plan.",
     [](const FrameRow& row) { return row.front_m; },
     {{{"front_6s_m", nullptr, 6.0},
       {"front_10s_m", nullptr, 10.0},
       {"front_20s_m", nullptr, 20.0},
       {"front_m", "duration_s"}}}},
    {"Mean displacement of the mass", "mean displacement [m]", "By mass, over all blocks.",
     [](const FrameRow& row) { return row.mean_displacement_m; }},
    {"Largest speed of a block",
     "largest speed [m/s]",
     "Of any block since the frame before.",
     [](const FrameRow& row) { return row.largest_speed_mps; },
     {{{"largest_speed_mps", "peak_time_s"}}}},
    {"Kinetic energy", "energy [MJ]", "Translation and rotation.",
     [](const FrameRow& row) { return 1e-6 * (row.ledger.translation_j + row.ledger.rotation_j); }},
    {"Friction", "energy [MJ]", "Taken by friction so far.",
     [](const FrameRow& row) { return 1e-6 * row.ledger.friction_j; }},
    {"Fracture", "energy [MJ]", "Freed by bonds that broke so far.",
     [](const FrameRow& row) { return 1e-6 * row.ledger.fracture_j; }},
    {"Strain", "energy [MJ]", "Held by contacts and bonds, with bending and twist.",
     [](const FrameRow& row) {
         return 1e-6 * (row.ledger.contact_normal_j + row.ledger.contact_shear_j + row.ledger.bonds.sum_j());
     }},
}};

using References = std::map<std::string, Reference>;

PlotSeries points_of_study(const Course& course, const References& references) {
    PlotSeries points{
        .name = "study", .style = "published", .form = PlotSeries::Form::dots, .points = {}, .ranges = {}};
    for (const StudyPoint& point : course.of_study) {
        const auto value = references.find(point.quantity != nullptr ? point.quantity : "");
        const auto time = references.find(point.time_quantity != nullptr ? point.time_quantity : "");
        const bool has_time = point.time_quantity == nullptr || time != references.end();
        if (value != references.end() && has_time) {
            points.points.push_back(
                {time != references.end() ? time->second.value : point.time_s, value->second.value});
        }
    }
    return points;
}

PlotGroup plots_of(const SimulatedCollapse& simulated, const References& references) {
    const double end_s = simulated.rows.back().time_s;
    PlotGroup group{.title = "Over time", .plots = {}, .small = false};
    for (const Course& course : courses) {
        PlotSeries series{
            .name = "mass", .style = "default", .form = PlotSeries::Form::line, .points = {}, .ranges = {}};
        double most = 1e-9, last_s = end_s;
        for (const FrameRow& row : simulated.rows) {
            series.points.push_back({row.time_s, course.value(row)});
            most = std::max(most, course.value(row));
        }
        std::vector<PlotSeries> shown{series};
        if (PlotSeries study = points_of_study(course, references); !study.points.empty()) {
            constexpr double room_for_a_dot = 1.05;
            for (const report::ChartPoint& point : study.points) {
                most = std::max(most, room_for_a_dot * point.y);
                last_s = std::max(last_s, room_for_a_dot * point.x);
            }
            shown.push_back(std::move(study));
        }
        group.plots.push_back({course.title,
                               report::Axis::from_zero("time [s]", last_s),
                               report::Axis::from_zero(course.axis, most),
                               shown,
                               {},
                               course.note});
    }
    return group;
}

/// published.csv: quantity, value, source.
void read_published(const CaseFiles& files, Comparison& comparison) {
    if (!files.has("published.csv")) {
        return;
    }
    const config::Table table = files.table("published.csv");
    config::Problems problems;
    table.require({"quantity", "value", "source"}, problems);
    problems.throw_if_any();
    std::vector<std::string> names;
    for (const CollapseFigure& figure : collapse_figures()) {
        names.emplace_back(figure.name);
    }
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const std::string name{table.text(row, "quantity")};
        if (std::find(names.begin(), names.end(), name) == names.end()) {
            problems.add(config::ExitCode::data, table.place(row, "quantity"), config::in_quotes(name),
                         joined("a figure of a collapse, perhaps ", config::nearest_word(name, names)));
        } else if (const auto value = table.number(row, "value", {}, problems)) {
            comparison.references[name] = {*value, std::string{table.text(row, "source")}};
        }
    }
    problems.throw_if_any();
}

Outcome simulate(const OpenedCollapse& opened, const References& references, const Work& work) {
    std::uint64_t told = 0;
    const SimulatedCollapse simulated =
        collapse::simulate_collapse(*opened.scenario, opened.site, work.threads, [&](double share) {
            if (InterruptGuard::requested()) {
                throw Interrupted{};
            }
            const auto now = static_cast<std::uint64_t>(share * static_cast<double>(pieces_of_work));
            work.done(now - told);
            told = now;
        });
    work.done(pieces_of_work - told);
    Outcome outcome;
    for (const CollapseFigure& figure : collapse_figures()) {
        outcome.values[figure.name] = figure.value(simulated, opened.site);
    }
    outcome.plots.push_back(plots_of(simulated, references));
    return outcome;
}

}  // namespace

int peaks_of(const std::vector<double>& values, double share) {
    const double least = share * (values.empty() ? 0.0 : *std::max_element(values.begin(), values.end()));
    int peaks = 0;
    double low = std::numeric_limits<double>::infinity(), high = -low;
    bool rises = true;
    for (const double value : values) {
        if (rises) {
            low = std::min(low, value);
            high = std::max(high, value);
            if (high - low >= least && high - value >= least && least > 0.0) {
                ++peaks;
                rises = false;
                low = value;
            }
        } else {
            low = std::min(low, value);
            if (value - low >= least) {
                rises = true;
                high = value;
            }
        }
    }
    return peaks;
}

/// The files of a case, and those of an example that the case does not have itself: all unpacked together.
CaseFiles with_example(CaseFiles files, const std::string& example, const config::Place& place) {
    bool found = false;
    for (const ExampleFile& file : example_files()) {
        if (file.example == example) {
            found = true;
            files.texts.try_emplace(file.name, file.bytes);
        }
    }
    if (!found) {
        config::fail(config::ExitCode::settings, place, joined("example ", config::in_quotes(example)),
                     config::in_quotes(config::nearest_word(example, example_names())));
    }
    files.path.clear();
    return files;
}

namespace {

/// The mass of a seed.
Comparison read_mass(const CaseFiles& files, const std::string& scenario,
                     const std::vector<std::string>& overrides, std::uint64_t& seed) {
    const UnpackedCase folder{files};
    auto opened = std::make_shared<OpenedCollapse>();
    opened->scenario = collapse::read_collapse(folder.path() / scenario, overrides);
    seed = opened->scenario->scenario.run.seed;
    config::Warnings warnings;
    opened->site = collapse::open_collapse(*opened->scenario, warnings);
    Comparison comparison;
    comparison.extent = joined(std::to_string(opened->site.count.free), " blocks for up to ",
                               std::to_string(std::llround(opened->scenario->settings.duration_s)), " s");
    for (const CollapseFigure& figure : collapse_figures()) {
        comparison.figures.push_back({figure.name, figure.label, figure.unit});
    }
    read_published(files, comparison);
    comparison.pieces = pieces_of_work;
    comparison.run = [opened, references = comparison.references](const Work& work) {
        return simulate(*opened, references, work);
    };
    return comparison;
}

}  // namespace

Comparison read_collapse_case(const CaseFiles& files, CaseHead& head,
                              const std::vector<std::string>& overrides) {
    config::Options options;
    std::string scenario = "scenario.ini", example;
    std::uint64_t seeds = 1;
    declare(options, head);
    options.text("collapse.scenario", scenario,
                 {.meaning = "scenario of `bannwald collapse` in the folder of the case"});
    options.text("collapse.example", example,
                 {.meaning = "example of `bannwald init` whose files the scenario finds beside its own"});
    options.count(
        "collapse.seeds", seeds,
        {.unit = "-",
         .low = 1.0,
         .high = 100.0,
         .meaning = "seeds that the case runs with, from that of the scenario on: figures are means "
                    "over them, with the standard deviation between them"});
    std::istringstream in{files.texts.at("case.ini")};
    options.read(in, files.shown("case.ini"), {});
    const auto all = std::make_shared<const CaseFiles>(
        example.empty() ? files : with_example(files, example, options.place_of("collapse.example")));
    std::uint64_t first_seed = 0;
    Comparison first = read_mass(*all, scenario, overrides, first_seed);
    std::vector<std::function<Comparison()>> more;
    for (std::uint64_t seed = first_seed + 1; seed < first_seed + seeds; ++seed) {
        std::vector<std::string> others = overrides;
        std::erase_if(others, [](const std::string& one) { return one.starts_with("run.seed="); });
        others.push_back(joined("run.seed=", std::to_string(seed)));
        more.emplace_back([all, scenario, others] {
            std::uint64_t own = 0;
            return read_mass(*all, scenario, others, own);
        });
    }
    return over_seeds(std::move(first), std::move(more));
}

}  // namespace coupling::validation
