#include "coupling/assessments/works/work_tables.hpp"

#include <cmath>
#include <limits>

#include "config/text/joined.hpp"
#include "config/units/constants.hpp"
#include "coupling/assessments/nets/figures/net_summary.hpp"
#include "coupling/assessments/nets/figures/net_tables.hpp"
#include "coupling/inputs/nets/net_lines.hpp"
#include "coupling/results/tables/figure_columns.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"
#include "rockfall/motion/models.hpp"

namespace coupling {
namespace {

using config::joined;

constexpr const char* from_works = "input works.file";
constexpr double no_figure = std::numeric_limits<double>::quiet_NaN();

/// A work on one slope.
struct WorkOnSlope : WorkFigures {
    const WorkRecord& record;
};

/// Whether rocks can end so at a work of a kind; columns are left empty where not.
bool can_end(WorkKind kind, WorkOutcome outcome) {
    switch (outcome) {
        case WorkOutcome::held:
            return true;
        case WorkOutcome::over:
            return kind != WorkKind::gallery;
        case WorkOutcome::beside:
            return kind != WorkKind::wall;
        case WorkOutcome::back:
            return is_of_earth(kind);
        case WorkOutcome::broke:
            return kind == WorkKind::wall;
    }
    return false;
}

ColumnsOf<WorkOnSlope> outcome_columns_of(WorkOutcome outcome, const char* meaning) {
    const char* name = name_of(outcome);
    return {
        {name, 0, meaning, from_counting,
         [outcome](const WorkOnSlope& row) {
             return can_end(row.record.kind, outcome) ? static_cast<double>(row.at(outcome).part) : no_figure;
         }},
        {share_columns(name, "share of the rocks that reached the work"), [outcome](const WorkOnSlope& row) {
             const Share& of = row.at(outcome);
             return can_end(row.record.kind, outcome) && of.whole > 0
                        ? of
                        : Share{of.part, of.whole, no_figure, {no_figure, no_figure}};
         }}};
}

TableOf<WorkOnSlope> work_table() {
    const auto of_section = [](double WorkRecord::*of) {
        return [of](const WorkOnSlope& row) {
            return is_of_earth(row.record.kind) ? row.record.*of : no_figure;
        };
    };
    return {
        "works.csv",
        "Each dam, ditch, wall and gallery on each slope: rocks that reach it and what becomes of them; "
        "energy and height with which they come.",
        "a work on one slope",
        {{"work", "name of the work", from_works, [](const auto& row) { return row.record.name; }},
         {"kind", "dam, ditch, wall or gallery", from_works,
          [](const auto& row) { return name_of(row.record.kind); }},
         {cover_column(), [](const auto& row) { return name_of(row.cover); }},
         {"work_height_m", 2, "height above the ground, or depth of a ditch; empty: gallery", from_works,
          [](const auto& row) {
              return row.record.kind == WorkKind::gallery ? no_figure : row.record.height_m;
          }},
         {"capacity_kj", 1, "kinetic energy that a wall or roof takes at most; empty: any", from_works,
          [](const auto& row) {
              const double kj = row.record.capacity_j / config::j_per_kj;
              return std::isfinite(kj) ? kj : no_figure;
          }},
         {"length_m", 2, "length of the line, or of the edge of a roof, in plan", from_works,
          [](const auto& row) { return plan_length_m(row.record.line_m); }},
         {"volume_m3", 1, "earth heaped for a dam or dug for a ditch", "its shape on the terrain",
          of_section(&WorkRecord::volume_m3)},
         {"area_m2", 1, "ground that a dam or a ditch takes, in plan", "its shape on the terrain",
          of_section(&WorkRecord::ground_m2)},
         {"rocks", "rocks that fell", from_counting, [](const auto& row) { return row.reached.whole; }},
         {"reached", "rocks that came to the work; each counts once", from_counting,
          [](const auto& row) { return row.reached.part; }},
         {share_columns("reached", "share of the rocks that fell"), &WorkOnSlope::reached},
         outcome_columns_of(WorkOutcome::held,
                            "rocks that a wall held, that rest on a roof, or in a dam or ditch and the strip "
                            "above it that is as wide as it is high"),
         outcome_columns_of(WorkOutcome::over, "rocks that passed over it"),
         outcome_columns_of(WorkOutcome::beside,
                            "rocks that left over one of its ends; of a roof: over any side"),
         outcome_columns_of(WorkOutcome::back,
                            "rocks that left uphill and did not come again: they rest above it or went "
                            "around it"),
         outcome_columns_of(WorkOutcome::broke, "rocks that broke through a wall"),
         {net_quantity_columns(
              "energy", "kj",
              joined("the kinetic energy as rocks come to the work (", rockfall::what_energies_count(), ")")),
          &WorkOnSlope::energy_kj},
         {net_quantity_columns("height", "m",
                               "the height of the rock's upper edge above the ground as it comes to the "
                               "work, vertical"),
          &WorkOnSlope::height_m}}};
}

}  // namespace

std::vector<TableLayout> work_layouts() {
    return {work_table()};
}

std::vector<WrittenFile> write_work_tables(const RunResults& results, const std::filesystem::path& folder) {
    if (results.site.works.empty()) {
        return {};
    }
    return {work_table().write(folder, [&](auto& rows) {
        for (const WorkFigures& of : work_figures(results)) {
            rows.add({of, results.site.works[of.work]});
        }
    })};
}

Json works_json(const RunResults& results) {
    Json list = Json::array();
    for (const WorkFigures& of : work_figures(results)) {
        const WorkRecord& record = results.site.works[of.work];
        Json work{{"name", record.name},
                  {"kind", name_of(record.kind)},
                  {"slope", name_of(of.cover)},
                  {"reached", json_share(of.reached)},
                  {"energy_kj", json_of(of.energy_kj)},
                  {"height_m", json_of(of.height_m)}};
        for (std::size_t i = 0; i < work_outcomes; ++i) {
            const auto outcome = static_cast<WorkOutcome>(i);
            if (can_end(record.kind, outcome)) {
                work[name_of(outcome)] = json_share(of.at(outcome));
            }
        }
        if (is_of_earth(record.kind)) {
            work["volume_m3"] = json_number(record.volume_m3);
        }
        list.push_back(std::move(work));
    }
    return list;
}

std::string in_words(const WorkRecord& work, const WorkFigures& figures) {
    const std::string slope = figures.cover == rockfall::Cover::forest ? report::page_text("with forest")
                                                                       : report::page_text("bare slope");
    const std::string text = report::page_text("{net}, {slope}: {reach} of {rocks} rocks reach it",
                                               {{"net", work.name},
                                                {"slope", slope},
                                                {"reach", std::to_string(figures.reached.part)},
                                                {"rocks", std::to_string(figures.reached.whole)}});
    if (figures.reached.part == 0) {
        return text;
    }
    const auto share = [&](WorkOutcome outcome, const char* words) {
        return can_end(work.kind, outcome)
                   ? report::page_text(words, {{"share", report::percent(figures.at(outcome).value)}})
                   : "";
    };
    return report::join_with_semicolons({text, share(WorkOutcome::held, "it holds {share}"),
                                         share(WorkOutcome::over, "{share} pass over it"),
                                         share(WorkOutcome::beside, "{share} leave beside it"),
                                         share(WorkOutcome::back, "{share} go back uphill"),
                                         share(WorkOutcome::broke, "{share} break through it")});
}

}  // namespace coupling
