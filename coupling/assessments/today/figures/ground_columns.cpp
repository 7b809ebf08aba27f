#include "coupling/assessments/today/figures/ground_columns.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "config/text/joined.hpp"
#include "config/units/angle.hpp"
#include "config/units/constants.hpp"
#include "rockfall/motion/models.hpp"

namespace coupling {
namespace {

using config::joined;

double degrees_of_tangent(double tangent) {
    return config::Angle::from_radians(std::atan(tangent)).in_degrees();
}

/// A motion model that uses a column.
struct ColumnUse {
    std::string_view model;
    rockfall::GroundColumnText column;
};

std::vector<ColumnUse> uses_of(std::string_view name) {
    std::vector<ColumnUse> uses;
    for (const rockfall::MotionModel model : rockfall::all_models()) {
        for (const rockfall::GroundColumnText& column : rockfall::ground_columns_of(model)) {
            if (column.name == name) {
                uses.push_back({rockfall::description_of(model).name, column});
            }
        }
    }
    return uses;
}

/// The meaning, what it is under single models, and which models use it unless all do. A column that is "the
/// same" as the one before has its models too.
std::string meaning_of(const GroundColumn& column, const std::vector<ColumnUse>& uses) {
    std::string text = column.meaning;
    for (const ColumnUse& use : uses) {
        if (!use.column.remark.empty()) {
            text += joined(", ", use.column.remark, " for ", use.model);
        }
    }
    if (uses.size() < rockfall::all_models().size() && !text.starts_with("the same ")) {
        const char* before = "; ";
        for (const ColumnUse& use : uses) {
            text += joined(before, use.model);
            before = ", ";
        }
    }
    return text;
}

/// Where models take a figure from: said once where all agree; what the default model does needs no name.
std::string source_of(const std::vector<ColumnUse>& uses) {
    std::vector<std::string_view> sources;
    std::string text;
    const std::string_view by_default = rockfall::description_of(rockfall::all_models().front()).name;
    const bool agree = std::all_of(uses.begin(), uses.end(), [&](const ColumnUse& use) {
        return use.column.from == uses.front().column.from;
    });
    for (const ColumnUse& use : uses) {
        if (std::find(sources.begin(), sources.end(), use.column.from) == sources.end()) {
            sources.push_back(use.column.from);
            text += joined(text.empty() ? "" : "; ",
                           agree || use.model == by_default ? "" : joined(use.model, ": "), use.column.from);
        }
    }
    return text;
}

}  // namespace

const std::vector<GroundColumn>& ground_columns() {
    static const std::vector<GroundColumn> columns{
        {.name = soil_column.data(), .unit = "text", .meaning = "soil of the ground type", .head = "soil"},
        {.name = "r_n",
         .unit = "-",
         .meaning = "coefficient of normal restitution",
         .decimals = 3,
         .head = "R<sub>N</sub>"},
        {.name = "r_t",
         .unit = "-",
         .meaning = "coefficient of tangential restitution",
         .decimals = 3,
         .head = "R<sub>T</sub>"},
        {.name = "jump_angle_factor",
         .unit = "-",
         .meaning = "jump angles on this ground by those of the law",
         .decimals = 3,
         .head = "jump angle ×"},
        {.name = "p_stop",
         .unit = "-",
         .meaning = "probability that an impact stops a rock of the mean diameter",
         .decimals = 6,
         .head = "stops at an impact, %",
         .page_decimals = 4,
         .page_factor = config::percent,
         .page_note = "Stopping is that of a rock of the mean diameter."},
        {.name = "rolling_stops_per_m",
         .unit = "1/m",
         .meaning = "rate at which such a rock is caught while it rolls",
         .decimals = 6,
         .head = "caught while rolling, 1/m",
         .page_decimals = 4},
        {.name = "friction",
         .unit = "-",
         .meaning = "coefficient of sliding friction",
         .decimals = 3,
         .head = "friction k"},
        {.name = "friction_max",
         .unit = "-",
         .meaning = "friction after a long slip",
         .decimals = 3,
         .head = "friction μ max"},
        {.name = "slip_kappa_pm",
         .unit = "1/m",
         .meaning = "growth of friction with the slip",
         .decimals = 3,
         .head = "slip κ (1/m)",
         .page_decimals = 2},
        {.name = "slip_beta_ps",
         .unit = "1/s",
         .meaning = "decay of the slip without contact",
         .decimals = 1,
         .head = "slip β (1/s)",
         .page_decimals = 0},
        {.name = "contact_drag_ps",
         .unit = "1/s",
         .meaning = "drag in contact, by the velocity",
         .decimals = 3,
         .head = "contact drag (1/s)"},
        {.name = "restitution",
         .unit = "-",
         .meaning = "restitution of slow impacts",
         .decimals = 3,
         .head = "restitution e"},
        {.name = "rolling_resistance",
         .unit = "-",
         .meaning = "rolling resistance: couple against the spin by normal force and radius",
         .decimals = 3,
         .head = "rolling resistance μr"},
        {.name = "soil_strength_kpa",
         .unit = "kPa",
         .meaning = "strength of the soil in the scars of impacts; 0: it takes none",
         .decimals = 0,
         .head = "strength of the soil (kPa)"},
        {.name = "roughness_m",
         .unit = "m",
         .meaning = "standard deviation of heights between the points of the terrain",
         .decimals = 3,
         .head = "roughness (m)"},
        {.name = "threshold_deg",
         .unit = "deg",
         .meaning = "angle to the ground below which a rock slides",
         .converted = degrees_of_tangent,
         .head = "β<sub>lim</sub>, °",
         .page_decimals = 1},
        {.name = "dr_slow_percent",
         .unit = "%",
         .meaning = "width of r_n at rest, relative to it",
         .head = "width of R at rest, %",
         .page_decimals = 1,
         .page_note = "Widths of R<sub>N</sub>, R<sub>T</sub> and k are relative to them and fall linearly "
                      "from rest to the speed under “fast from”, or to a limit of their own."},
        {.name = "dr_fast_percent",
         .unit = "%",
         .meaning = "the same from limit_mps on",
         .head = "fast, %",
         .page_decimals = 1},
        {.name = "dk_slow_percent",
         .unit = "%",
         .meaning = "width of the friction at rest, relative to it",
         .head = "width of k at rest, %",
         .page_decimals = 1},
        {.name = "dk_fast_percent",
         .unit = "%",
         .meaning = "the same from limit_mps on",
         .head = "fast, %",
         .page_decimals = 1},
        {.name = "angle_slow_deg",
         .unit = "deg",
         .meaning = "width of the horizontal angle of a rebound at rest",
         .head = "width of the angles at rest, °",
         .page_decimals = 1},
        {.name = "angle_fast_deg",
         .unit = "deg",
         .meaning = "the same from limit_mps on",
         .head = "fast, °",
         .page_decimals = 1},
        {.name = "limit_mps",
         .unit = "m/s",
         .meaning = "speed from which on the width of r_n is constant",
         .head = "fast from, m/s",
         .page_decimals = 1},
        {.name = "dr_t_slow_percent",
         .unit = "%",
         .meaning = "width of r_t at rest, relative to it",
         .head = "width of R<sub>T</sub> at rest, %",
         .page_decimals = 1,
         .repeats = "dr_slow_percent"},
        {.name = "dr_t_fast_percent",
         .unit = "%",
         .meaning = "the same from its limit speed on",
         .head = "fast, %",
         .page_decimals = 1,
         .repeats = "dr_fast_percent"},
        {.name = "angle_v_slow_deg",
         .unit = "deg",
         .meaning = "width of the vertical angle at rest",
         .head = "width of the vertical angle at rest, °",
         .page_decimals = 1,
         .repeats = "angle_slow_deg"},
        {.name = "angle_v_fast_deg",
         .unit = "deg",
         .meaning = "the same from its limit speed on",
         .head = "fast, °",
         .page_decimals = 1,
         .repeats = "angle_fast_deg"},
        {.name = "limit_r_t_mps",
         .unit = "m/s",
         .meaning = "limit speed of the width of r_t",
         .head = "limit of R<sub>T</sub>, m/s",
         .page_decimals = 1,
         .repeats = "limit_mps"},
        {.name = "limit_k_mps",
         .unit = "m/s",
         .meaning = "limit speed of the width of the friction",
         .head = "limit of k, m/s",
         .page_decimals = 1,
         .repeats = "limit_mps"},
        {.name = "limit_angle_h_mps",
         .unit = "m/s",
         .meaning = "limit speed of the horizontal angle",
         .head = "limit of the horizontal angle, m/s",
         .page_decimals = 1,
         .repeats = "limit_mps"},
        {.name = "limit_angle_v_mps",
         .unit = "m/s",
         .meaning = "limit speed of the vertical angle",
         .head = "limit of the vertical angle, m/s",
         .page_decimals = 1,
         .repeats = "limit_mps"},
    };
    return columns;
}

std::size_t ground_column(std::string_view name) {
    const std::vector<GroundColumn>& columns = ground_columns();
    const auto found =
        std::find_if(columns.begin(), columns.end(), [&](const GroundColumn& c) { return c.name == name; });
    if (found == columns.end()) {
        throw std::logic_error{joined("no column of ground types is named ", name)};
    }
    return static_cast<std::size_t>(found - columns.begin());
}

std::vector<Column> ground_table_columns() {
    std::vector<Column> columns;
    for (const GroundColumn& column : ground_columns()) {
        const std::vector<ColumnUse> uses = uses_of(column.name);
        columns.push_back({column.name, column.unit, meaning_of(column, uses), source_of(uses)});
    }
    return columns;
}

}  // namespace coupling
