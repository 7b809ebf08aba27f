#include "coupling/inputs/plausible/terrain/steps.hpp"

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/plausible/terrain/limits.hpp"

namespace coupling::plausible::terrain {
namespace {

using config::joined;

struct Pairs {
    std::size_t all = 0;
    std::size_t rising = 0;
    std::size_t level = 0;
};

void add_pairs(const HeightField& field, const Axis& axis, Pairs& pairs) {
    constexpr int reach = limits::rising_reach;
    const double least_rise_m =
        std::tan(limits::rising_deg * M_PI / 180.0) * (2 * reach + 1) * axis.spacing_m;
    const std::ptrdiff_t far_step = reach * axis.cell_step;
    visit_cells(field, axis, reach, axis.cells - reach - 1, [&](int, int, const double* cell) {
        const double rise = cell[axis.cell_step] - cell[0];
        const double around = cell[far_step + axis.cell_step] - cell[-far_step];
        if (std::isnan(rise)) {
            return;
        }
        ++pairs.all;
        if (std::abs(around) > least_rise_m) {
            ++pairs.rising;
            pairs.level += std::abs(rise) < 1e-9 * std::abs(cell[0]) + 1e-9 ? 1 : 0;
        }
    });
}

}  // namespace

double level_share(const HeightField& field) {
    Pairs pairs;
    add_pairs(field, along_rows(field), pairs);
    add_pairs(field, along_columns(field), pairs);
    // Few rising pairs are the bank of a lake.
    constexpr std::size_t fewest = 100;
    if (pairs.rising < fewest || static_cast<double>(pairs.rising) < 0.02 * static_cast<double>(pairs.all)) {
        return 0.0;
    }
    return static_cast<double>(pairs.level) / static_cast<double>(pairs.rising);
}

std::optional<Finding> judge_steps(const HeightField& field) {
    const double share = level_share(field);
    if (share < limits::level_warning) {
        return std::nullopt;
    }
    const double step_m = step_of_heights_m(field);
    std::string advice =
        step_m > 0.0
            ? joined("all heights lie on levels ", config::to_text(step_m),
                     " m apart: take heights that are not rounded, or interpolate between the contours")
            : std::string{
                  "this looks like resampling by the nearest neighbour: resample the original by bilinear or "
                  "cubic interpolation"};
    return Finding{
        share >= limits::level_error,
        joined("steps: on slopes of more than 15 degrees ", config::to_text(std::round(100.0 * share)),
               " % of the neighbours are exactly level"),
        "heights that rise with the slope", std::move(advice)};
}

}  // namespace coupling::plausible::terrain
