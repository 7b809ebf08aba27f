#include "validation/engine/field/reach_figures.hpp"

#include <algorithm>
#include <array>

#include "config/text/joined.hpp"
#include "config/units/constants.hpp"
#include "coupling/inputs/observed/distribution.hpp"
#include "coupling/results/text/markup.hpp"
#include "rockfall/tally/reach_angle.hpp"

namespace coupling::validation {
namespace {

using config::joined;
using config::percent;

constexpr double least_fall_m = 50.0;
constexpr double least_shadow_deg = 27.5;  ///< Evans & Hungr 1993
constexpr double lowest_share = 0.01;      ///< of reach angles: the minimum grows ever lower with more rocks

struct ReachFigure {
    const char* name;
    const char* label;
    const char* unit;
};
constexpr ReachFigure shadow_figure{"shadow_below_27.5_percent", "stops below a shadow angle of 27.5 deg",
                                    "%"};
constexpr ReachFigure lowest_figure{"reach_angle_p01_deg", "1 % of reach angles", "deg"};
constexpr ReachFigure mean_figure{"reach_angle_mean_deg", "mean reach angle", "deg"};
constexpr ReachFigure left_figure{"left_percent", "rocks that leave the terrain", "%"};

/// NaN without any.
double share_percent(std::size_t some, std::size_t all) {
    return percent * static_cast<double>(some) / static_cast<double>(all);
}

double below_percent(const std::vector<double>& shadow_deg) {
    const auto below = std::count_if(shadow_deg.begin(), shadow_deg.end(),
                                     [](double deg) { return deg < least_shadow_deg; });
    return share_percent(static_cast<std::size_t>(below), shadow_deg.size());
}

}  // namespace

ReachSample reach_sample_of(const rockfall::Terrain& terrain,
                            std::span<const observed::SimulatedStop> stops) {
    ReachSample sample;
    sample.rocks = stops.size();
    for (const observed::SimulatedStop& stop : stops) {
        if (stop.left_terrain) {
            ++sample.left;
            continue;
        }
        const auto angles = rockfall::reach_angles(terrain, stop.start_m - terrain.origin_m(),
                                                   stop.end_m - terrain.origin_m());
        if (!angles || angles->fall_m <= least_fall_m) {
            continue;
        }
        sample.reach_deg.push_back(angles->reach.in_degrees());
        if (angles->shadow) {
            sample.shadow_deg.push_back(angles->shadow->in_degrees());
        }
    }
    return sample;
}

void name_reach_figures(const std::string& state, const std::string& meaning, Comparison& comparison) {
    for (const ReachFigure& figure : {shadow_figure, lowest_figure, mean_figure, left_figure}) {
        comparison.figures.push_back(
            {joined(figure.name, ":", state), joined(figure.label, ", ", meaning), figure.unit});
    }
}

void take_reach_figures(const std::string& state, const ReachSample& sample, Outcome& outcome) {
    const auto take = [&](const ReachFigure& figure, double value) {
        outcome.values[joined(figure.name, ":", state)] = value;
    };
    if (!sample.shadow_deg.empty()) {
        take(shadow_figure, below_percent(sample.shadow_deg));
    }
    if (!sample.reach_deg.empty()) {
        const observed::Distribution reach{sample.reach_deg};
        take(lowest_figure, reach.quantile(lowest_share));
        take(mean_figure, reach.mean());
    }
    if (sample.rocks > 0) {
        take(left_figure, share_percent(sample.left, sample.rocks));
    }
}

PlainTable reach_table() {
    return {.caption = joined(
                "Shadow angle from the lowest cliff, reach angle from the start, of stops after falls of "
                "more than ",
                report::fixed(least_fall_m, 0), " m"),
            .head = {"state", "stops", "left the terrain [%]", "shadow below 27.5 deg [%]", "shadow 5 %",
                     "shadow 50 %", "shadow 95 %", "reach 1 %", "reach 5 %", "reach 50 %", "reach 95 %",
                     "reach, mean [deg]"},
            .rows = {}};
}

std::vector<std::string> reach_row(const std::string& meaning, const ReachSample& sample) {
    constexpr std::array shadow_shares{0.05, 0.5, 0.95};
    constexpr std::array reach_shares{lowest_share, 0.05, 0.5, 0.95};
    const observed::Distribution shadow{sample.shadow_deg};
    const observed::Distribution reach{sample.reach_deg};
    std::vector<std::string> row{meaning, std::to_string(sample.reach_deg.size()),
                                 report::fixed(share_percent(sample.left, sample.rocks), 1),
                                 report::fixed(below_percent(sample.shadow_deg), 1)};
    for (const double share : shadow_shares) {
        row.push_back(report::fixed(shadow.quantile(share), 1));
    }
    for (const double share : reach_shares) {
        row.push_back(report::fixed(reach.quantile(share), 1));
    }
    row.push_back(report::fixed(reach.mean(), 1));
    return row;
}

}  // namespace coupling::validation
