#include "coupling/assessments/works/work_page.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "config/units/constants.hpp"
#include "coupling/assessments/works/work_figures.hpp"
#include "coupling/inputs/nets/net_lines.hpp"
#include "coupling/results/figures/figures.hpp"
#include "coupling/results/templates/page_template.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"
#include "coupling/results/text/phrases.hpp"

namespace coupling::report {
namespace {

std::string share_with_interval(const Share& share) {
    return share.whole == 0 ? "–"
                            : page_text("{share} ({interval_low} to {interval_high})",
                                        {{"share", percent(share.value)},
                                         {"interval_low", percent(share.interval.low)},
                                         {"interval_high", percent(share.interval.high)}});
}

/// "12.3 / 45.6 / 78.9"; dashes where a figure is not known.
std::string joined_figures(double median, double p95, double largest) {
    return three_digits(median) + " / " + three_digits(p95) + " / " + three_digits(largest);
}

std::string kind_in_words(WorkKind kind) {
    switch (kind) {
        case WorkKind::dam:
            return page_text("dam");
        case WorkKind::ditch:
            return page_text("ditch");
        case WorkKind::wall:
            return page_text("wall");
        case WorkKind::gallery:
            return page_text("gallery");
    }
    return "";
}

/// "dam, 40 m long, 4 m high, 1 230 m³ on 560 m²".
std::string size_in_words(const WorkRecord& work) {
    const double length_m = plan_length_m(work.line_m);
    std::string size;
    if (work.kind == WorkKind::ditch) {
        size = page_text("{length_m} m long, {depth_m} m deep",
                         {{"length_m", three_digits(length_m)}, {"depth_m", exact(work.height_m)}});
    } else if (work.kind != WorkKind::gallery) {
        size = page_text("{length_m} m long, {height_m} m high",
                         {{"length_m", three_digits(length_m)}, {"height_m", exact(work.height_m)}});
    }
    std::string earth;
    if (is_of_earth(work.kind)) {
        earth = page_text(
            "{volume_m3} m³ of earth, {area_m2} m² of ground",
            {{"volume_m3", three_digits(work.volume_m3)}, {"area_m2", three_digits(work.ground_m2)}});
    }
    std::string capacity;
    if (work.kind == WorkKind::wall || work.kind == WorkKind::gallery) {
        capacity = std::isfinite(work.capacity_j)
                       ? page_text("takes {capacity_kj} kJ",
                                   {{"capacity_kj", three_digits(work.capacity_j / config::j_per_kj)}})
                       : page_text("takes any energy");
    }
    return join_with_commas({kind_in_words(work.kind), size, earth, capacity});
}

PageFields outcome_row(const std::string& words, const std::vector<WorkFigures>& figures,
                       WorkOutcome outcome) {
    std::vector<PageFields> slopes;
    for (const WorkFigures& of : figures) {
        slopes.push_back({{"figure", share_with_interval(of.at(outcome))}});
    }
    return {{"words", words}, {"slopes", slopes}};
}

std::vector<PageFields> outcome_rows(WorkKind kind, const std::vector<WorkFigures>& figures) {
    std::vector<PageFields> rows;
    for (const auto& [outcome, words] : outcomes_in_words(kind)) {
        rows.push_back(outcome_row(words, figures, outcome));
    }
    return rows;
}

PageFields work_quantity_row(const std::string& words, const std::vector<WorkFigures>& figures,
                             NetQuantity WorkFigures::*quantity) {
    std::vector<PageFields> slopes;
    for (const WorkFigures& of : figures) {
        const NetQuantity& q = of.*quantity;
        slopes.push_back({{"figure", joined_figures(q.p50, q.p95.value, q.max)}});
    }
    return {{"words", words}, {"slopes", slopes}};
}

PageFields one_work(const WorkRecord& work, const std::vector<WorkFigures>& figures) {
    std::vector<PageFields> slopes;
    for (const WorkFigures& of : figures) {
        slopes.push_back(
            {{"slope", title_of(of.cover)},
             {"reached", join_with_commas({grouped(of.reached.part), share_with_interval(of.reached)})}});
    }
    std::vector<PageFields> rows = outcome_rows(work.kind, figures);
    rows.push_back(work_quantity_row(page_text("Energy, kJ: median / 95 % / largest"), figures,
                                     &WorkFigures::energy_kj));
    rows.push_back(work_quantity_row(page_text("Upper edge above the ground, m: median / 95 % / largest"),
                                     figures, &WorkFigures::height_m));
    return {{"work", work.name}, {"size", size_in_words(work)}, {"slopes", slopes}, {"rows", rows}};
}

}  // namespace

std::vector<std::pair<WorkOutcome, std::string>> outcomes_in_words(WorkKind kind) {
    switch (kind) {
        case WorkKind::wall:
            return {{WorkOutcome::held, page_text("Held")},
                    {WorkOutcome::over, page_text("Pass over")},
                    {WorkOutcome::broke, page_text("Break through")}};
        case WorkKind::gallery:
            return {{WorkOutcome::held, page_text("Rest on the roof")},
                    {WorkOutcome::beside, page_text("Leave the roof")}};
        default:
            return {{WorkOutcome::held, page_text("Rest on it or just above it")},
                    {WorkOutcome::over, page_text("Pass over")},
                    {WorkOutcome::beside, page_text("Leave over its ends")},
                    {WorkOutcome::back, page_text("Go back uphill")}};
    }
}

std::string works(const RunResults& results) {
    if (results.site.works.empty()) {
        return "";
    }
    const std::vector<WorkFigures> all = work_figures(results);
    std::vector<PageFields> shown;
    bool has_earth = false;
    bool has_wall = false;
    bool has_roof = false;
    for (std::uint32_t number = 0; number < results.site.works.size(); ++number) {
        const WorkRecord& work = results.site.works[number];
        std::vector<WorkFigures> figures;
        std::copy_if(all.begin(), all.end(), std::back_inserter(figures),
                     [&](const WorkFigures& of) { return of.work == number; });
        shown.push_back(one_work(work, figures));
        has_earth = has_earth || is_of_earth(work.kind);
        has_wall = has_wall || work.kind == WorkKind::wall;
        has_roof = has_roof || work.kind == WorkKind::gallery;
    }
    return filled_template("work_section.html", {{"with_forest", results.with_forest},
                                                 {"has_earth", has_earth},
                                                 {"has_wall", has_wall},
                                                 {"has_roof", has_roof},
                                                 {"works", shown}});
}

}  // namespace coupling::report
