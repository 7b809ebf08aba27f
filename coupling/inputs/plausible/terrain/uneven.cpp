#include "coupling/inputs/plausible/terrain/uneven.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/plausible/terrain/limits.hpp"
#include "coupling/inputs/plausible/terrain/spikes.hpp"

namespace coupling::plausible::terrain {
namespace {

using config::joined;

struct Sums {
    double first = 0.0;
    double second = 0.0;
    std::size_t firsts = 0;
    std::size_t seconds = 0;
};

void add_differences(const HeightField& field, const Axis& axis, int lag, Sums& sums) {
    const std::ptrdiff_t step = lag * axis.cell_step;
    const double most_m = limits::largest_difference * lag * axis.spacing_m;
    visit_cells(field, axis, 0, axis.cells - lag, [&](int, int i, const double* cell) {
        const double rise = cell[step] - cell[0];
        if (std::isnan(rise)) {
            return;
        }
        sums.first += std::min(std::abs(rise), most_m);
        ++sums.firsts;
        const double bend = i + 2 * lag < axis.cells ? cell[2 * step] - cell[step] - rise : not_known;
        if (!std::isnan(bend)) {
            sums.second += std::min(std::abs(bend), most_m);
            ++sums.seconds;
        }
    });
}

/// What the unevenness of a field amounts to.
struct Judged {
    double ratio = 0.0;
    bool is_error = false;
    bool is_warning = false;
};

/// The worst of neighbours at distances up to the width of a crown.
Judged judged(const HeightField& field) {
    Judged worst;
    if (field.cell_m() < limits::finest_cell_m) {
        return worst;
    }
    for (const int lag : {1, 2, 4}) {
        if (lag > 1 && lag * field.cell_m() > limits::crown_reach_m) {
            break;
        }
        const Unevenness uneven = unevenness(field, lag);
        const bool is_steep = uneven.bend >= limits::least_bend;
        const bool beyond_ground =
            lag == 1 && uneven.ratio >= limits::uneven_gentle && uneven.bend >= limits::least_gentle_bend;
        if ((is_steep || beyond_ground) && uneven.ratio > worst.ratio) {
            worst.ratio = uneven.ratio;
            worst.is_error = worst.is_error || (is_steep && uneven.ratio >= limits::uneven_error);
            worst.is_warning = uneven.ratio >= limits::uneven_warning;
        }
    }
    return worst;
}

std::string advice_for(const Values& values) {
    const bool starts_at_zero = values.low_m > -1.0 && values.low_m < 1.0;
    return starts_at_zero ? "this looks like a raster of results or slopes, or a surface model with crowns: "
                            "name the raster "
                            "of the bare ground"
                          : "this looks like a surface model with crowns and roofs: take the terrain model, "
                            "which is the "
                            "bare ground";
}

std::string percent(double share) {
    return config::to_text(std::round(100.0 * share));
}

struct Crossing {
    double climbed_m = 0.0;   ///< sum of all rises and falls
    double ranges_m = 0.0;    ///< sum of the ranges of the lines
    double distance_m = 0.0;  ///< of all known pairs of neighbours
};

void add_crossings(const HeightField& field, const Axis& axis, Crossing& crossing) {
    const auto lines = static_cast<std::size_t>(axis.lines);
    std::vector<double> low(lines, std::numeric_limits<double>::infinity());
    std::vector<double> high(lines, -std::numeric_limits<double>::infinity());
    visit_cells(field, axis, 0, axis.cells, [&](int line, int i, const double* cell) {
        const auto k = static_cast<std::size_t>(line);
        if (std::isnan(*cell)) {
            return;
        }
        low[k] = std::min(low[k], *cell);
        high[k] = std::max(high[k], *cell);
        const double before = i > 0 ? cell[-axis.cell_step] : not_known;
        if (!std::isnan(before)) {
            crossing.climbed_m += std::abs(*cell - before);
            crossing.distance_m += axis.spacing_m;
        }
    });
    for (std::size_t k = 0; k < lines; ++k) {
        crossing.ranges_m += high[k] > low[k] ? high[k] - low[k] : 0.0;
    }
}

}  // namespace

Unevenness unevenness(const HeightField& field, int lag) {
    Sums sums;
    add_differences(field, along_rows(field), lag, sums);
    add_differences(field, along_columns(field), lag, sums);
    if (sums.seconds < limits::fewest_cells || !(sums.first > 0.0)) {
        return {};
    }
    const double second = sums.second / static_cast<double>(sums.seconds);
    return {second / (sums.first / static_cast<double>(sums.firsts)), second / (lag * field.cell_m())};
}

std::optional<Finding> judge_pictures(const HeightField& field) {
    const Values values = values_of(field);
    if (!values.all_whole || values.low_m < 0.0 || values.high_m > 255.0) {
        return std::nullopt;
    }
    const bool full_span = values.low_m <= 1.0 && values.high_m >= 254.0;
    if (!full_span && !judged(field).is_error) {
        return std::nullopt;
    }
    return Finding{true,
                   joined("whole numbers from ", config::to_text(values.low_m), " to ",
                          config::to_text(values.high_m), " in all cells"),
                   "ground heights in metres",
                   "this looks like an 8-bit picture, such as a hillshade: name the raster of the heights"};
}

std::optional<Finding> judge_unevenness(const HeightField& field) {
    const WithoutSpikes rest{field};
    const Judged worst = judged(rest.field());
    if (!worst.is_warning) {
        return std::nullopt;
    }
    return Finding{
        worst.is_error,
        joined("slopes that change by ", percent(worst.ratio),
               " % of their size from one cell to the next, on average"),
        joined("the bare ground, where they change by less than ", percent(limits::uneven_warning), " %"),
        advice_for(values_of(field))};
}

std::optional<Finding> judge_ups_and_downs(const HeightField& field) {
    Crossing crossing;
    add_crossings(field, along_rows(field), crossing);
    add_crossings(field, along_columns(field), crossing);
    if (values_of(field).known < limits::fewest_cells || !(crossing.ranges_m > 0.0)) {
        return std::nullopt;
    }
    const double crossings = crossing.climbed_m / crossing.ranges_m;
    const double cells = 0.5 * (field.rows + field.columns);
    if (crossings < limits::fewest_traverses || crossings / cells < limits::traverses_per_cell ||
        crossing.climbed_m / crossing.distance_m < limits::least_mean_gradient) {
        return std::nullopt;
    }
    const Values values = values_of(field);
    return Finding{true,
                   joined("values from ", config::to_text(std::round(10.0 * values.low_m) / 10.0), " to ",
                          config::to_text(std::round(10.0 * values.high_m) / 10.0),
                          ", a range that a line of ", config::to_text(std::round(cells)),
                          " cells runs through ", config::to_text(std::round(crossings)), " times"),
                   "ground heights in metres",
                   "this looks like a raster of results, such as speeds: name the raster of the heights"};
}

}  // namespace coupling::plausible::terrain
