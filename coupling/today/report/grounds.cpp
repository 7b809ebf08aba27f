#include "coupling/today/grounds.hpp"

#include <array>
#include <cmath>

#include "config/text/joined.hpp"
#include "coupling/results/report/html_table.hpp"
#include "coupling/results/report/markup.hpp"
#include "coupling/results/report/page_text.hpp"
#include "coupling/today/report/sections.hpp"

namespace coupling::report {
namespace {

using config::joined;

/// A column of the page and how to read it; shown where any ground has a value.
struct GroundColumn {
    const char* head;
    double GroundFigures::*value;
    int digits;
};

constexpr std::array ground_columns{
    GroundColumn{"R<sub>N</sub>", &GroundFigures::r_n, 2},
    GroundColumn{"R<sub>T</sub>", &GroundFigures::r_t, 2},
    GroundColumn{"today.grounds.stops_at_an_impact", &GroundFigures::p_stop, 4},
    GroundColumn{"today.grounds.caught_while_rolling_1_m", &GroundFigures::rolling_stops_per_m, 4},
    GroundColumn{"today.grounds.friction_k", &GroundFigures::friction, 2},
    GroundColumn{"β<sub>lim</sub>, °", &GroundFigures::threshold_deg, 1},
    GroundColumn{"today.grounds.width_of_r_at_rest", &GroundFigures::dr_slow_percent, 1},
    GroundColumn{"today.grounds.fast", &GroundFigures::dr_fast_percent, 1},
    GroundColumn{"today.grounds.width_of_k_at_rest", &GroundFigures::dk_slow_percent, 1},
    GroundColumn{"today.grounds.fast", &GroundFigures::dk_fast_percent, 1},
    GroundColumn{"today.grounds.width_of_the_angles_at_rest", &GroundFigures::angle_slow_deg, 1},
    GroundColumn{"fast, °", &GroundFigures::angle_fast_deg, 1},
    GroundColumn{"today.grounds.fast_from_m_s", &GroundFigures::limit_mps, 1},
};

bool any_has(const std::vector<GroundFigures>& grounds, double GroundFigures::*value) {
    for (const GroundFigures& ground : grounds) {
        if (!std::isnan(ground.*value)) {
            return true;
        }
    }
    return false;
}

std::string shown(const GroundFigures& ground, const GroundColumn& column) {
    const double value = ground.*column.value;
    if (column.value == &GroundFigures::p_stop) {
        return std::isnan(value) ? "–" : three_digits(100.0 * value);
    }
    return column.digits > 2 ? (std::isnan(value) ? "–" : three_digits(value)) : fixed(value, column.digits);
}

std::string caption_of(const RunResults& results) {
    switch (results.scenario.rockfall.fall.motion.model) {
        case rockfall::MotionModel::pir3d:
            return page_text("today.grounds.what_pir3d_heeds_of_each_ground");
        case rockfall::MotionModel::classical:
            return page_text("today.grounds.what_the_classical_model_heeds");
        case rockfall::MotionModel::picus:
            break;
    }
    return page_text("today.grounds.what_picus_heeds_of_each_ground",
                     {{"middle_diameter_m", fixed(middle_diameter_m(results), 2)}});
}

}  // namespace

std::string grounds(const RunResults& results) {
    const std::vector<GroundFigures> all = grounds_of(results);
    const bool has_soils = results.scenario.rockfall.fall.motion.model == rockfall::MotionModel::pir3d;
    std::vector<std::string> head{page_text("today.grounds.ground_type"), page_text("today.grounds.code"),
                                  page_text("today.grounds.share_of_the_area")};
    if (has_soils) {
        head.emplace_back(page_text("today.grounds.soil"));
    }
    for (const GroundColumn& column : ground_columns) {
        if (any_has(all, column.value)) {
            head.emplace_back(page_text(column.head));
        }
    }
    HtmlTable table{caption_of(results), head};
    if (has_soils) {
        table.text_columns({3});
    }
    for (const GroundFigures& ground : all) {
        std::vector<std::string> cells{escaped(ground.label), std::to_string(ground.code),
                                       percent(ground.area_share)};
        if (has_soils) {
            cells.push_back(joined("<code>", escaped(ground.soil), "</code>"));
        }
        for (const GroundColumn& column : ground_columns) {
            if (any_has(all, column.value)) {
                cells.push_back(shown(ground, column));
            }
        }
        table.row(cells);
    }
    return joined("<h2>", page_text("common.ground"), "</h2>\n<section class=\"card\">", table.html(),
                  "</section>\n");
}

}  // namespace coupling::report
