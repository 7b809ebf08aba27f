#include "coupling/today/grounds.hpp"

#include <array>
#include <cmath>

#include "config/text/joined.hpp"
#include "coupling/results/report/html_table.hpp"
#include "coupling/results/report/markup.hpp"
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
    GroundColumn{"stops at an impact, %", &GroundFigures::p_stop, 4},
    GroundColumn{"caught while rolling, 1/m", &GroundFigures::rolling_stops_per_m, 4},
    GroundColumn{"friction k", &GroundFigures::friction, 2},
    GroundColumn{"β<sub>lim</sub>, °", &GroundFigures::threshold_deg, 1},
    GroundColumn{"width of R at rest, %", &GroundFigures::dr_slow_percent, 1},
    GroundColumn{"fast, %", &GroundFigures::dr_fast_percent, 1},
    GroundColumn{"width of k at rest, %", &GroundFigures::dk_slow_percent, 1},
    GroundColumn{"fast, %", &GroundFigures::dk_fast_percent, 1},
    GroundColumn{"width of the angles at rest, °", &GroundFigures::angle_slow_deg, 1},
    GroundColumn{"fast, °", &GroundFigures::angle_fast_deg, 1},
    GroundColumn{"fast from, m/s", &GroundFigures::limit_mps, 1},
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
            return "What PiR3D heeds of each ground type that occurs: its soil. Widths of R<sub>N</sub>, "
                   "R<sub>T</sub> and k are relative to them and fall straight from rest to the speed named "
                   "last.";
        case rockfall::MotionModel::classical:
            return "What the classical model heeds of each ground type that occurs.";
        case rockfall::MotionModel::picus:
            break;
    }
    return joined(
        "What PICUS heeds of each ground type that occurs; stopping for a rock of the mean diameter, ",
        fixed(middle_diameter_m(results), 2), " m.");
}

}  // namespace

std::string grounds(const RunResults& results) {
    const std::vector<GroundFigures> all = grounds_of(results);
    const bool has_soils = results.scenario.rockfall.fall.motion.model == rockfall::MotionModel::pir3d;
    std::vector<std::string> head{"Ground type", "code", "share of the area"};
    if (has_soils) {
        head.emplace_back("soil");
    }
    for (const GroundColumn& column : ground_columns) {
        if (any_has(all, column.value)) {
            head.emplace_back(column.head);
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
    return joined("<h2>Ground</h2>\n<section class=\"card\">", table.html(), "</section>\n");
}

}  // namespace coupling::report
