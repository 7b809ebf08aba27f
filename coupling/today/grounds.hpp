#pragma once

#include <limits>
#include <ostream>
#include <string>
#include <vector>

#include "coupling/results/run_results.hpp"

namespace coupling {

/// What the chosen motion model heeds of a ground type; NaN and "" where it heeds nothing of the kind.
struct GroundFigures {
    static constexpr double none = std::numeric_limits<double>::quiet_NaN();
    int code = 0;
    std::string label;
    double area_share = 0.0;  ///< of the cells of the maps with ground [-]
    std::string soil;         ///< pir3d
    double r_n = none;        ///< [-]; those of the soil for pir3d
    double r_t = none;
    double p_stop = none;               ///< of a rock of middle size [-]; picus
    double rolling_stops_per_m = none;  ///< of the same
    double friction = none;             ///< of sliding [-]; pir3d, classical
    double threshold_deg = none;        ///< beta_lim; pir3d
    double dr_slow_percent = none;
    double dr_fast_percent = none;
    double dk_slow_percent = none;
    double dk_fast_percent = none;
    double angle_slow_deg = none;
    double angle_fast_deg = none;
    double limit_mps = none;
};

/// The ground types that occur on the maps or on faces of a mesh, in the order of their table.
std::vector<GroundFigures> grounds_of(const RunResults& results);

/// Mean diameter of the rocks, for which p_stop is told [m].
double middle_diameter_m(const RunResults& results);

void write_grounds(std::ostream& out, const RunResults& results);

}  // namespace coupling
