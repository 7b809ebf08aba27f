#include "coupling/inputs/scenario/ground_columns.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "config/data/shipped_tables.hpp"
#include "config/table/table.hpp"
#include "coupling/inputs/scenario/block_grounds.hpp"

namespace coupling {
namespace {

using rockfall::SurfaceType;

void set_normal(SurfaceType& type, double value) {
    type.restitution.normal = value;
    if (type.published) {
        type.published->normal = value;
    }
}

void set_tangential(SurfaceType& type, double value) {
    type.restitution.tangential = value;
    if (type.published) {
        type.published->tangential = value;
    }
}

void set_rolling_stops(SurfaceType& type, double value) {
    type.rolling_stops_per_m = rockfall::StopCurve{{{1.0, value}}};
}

template <class Member>
auto set(Member member) {
    return [member](SurfaceType& type, double value) { type.*member = value; };
}

std::vector<GroundFigure> all_figures() {
    constexpr config::NumberRange restitutions{0.0, rockfall::largest_restitution};
    // clang-format off
    std::vector<GroundFigure> figures{
        {"r_n", restitutions, "normal restitution", set_normal},
        {"r_t", restitutions, "tangential restitution", set_tangential},
        {"jump_angle_factor", {0.1, 10.0}, "jump angles by those of the law; else 1", set(&SurfaceType::jump_angle_factor)},
        {"p_stop", {0.0, 1.0}, "stopping probability of a rock of 0.95 m", [](SurfaceType& type, double value) { type.stopping = stop_curve(value); }},
        {"rolling_stops_per_m", {0.0, 100.0}, "rate at which rolling rocks are caught; else 0", set_rolling_stops},
        {"rolling_friction", {0.01, 2.0}, "of a rolling rock; else that of the motion model", set(&SurfaceType::rolling_friction)},
        {"sliding_friction", {0.01, 5.0}, "of a sliding rock, where the motion model asks the ground", set(&SurfaceType::sliding_friction)},
        {"roughness_m", {0.0, 10.0}, "standard deviation of heights between the points of the terrain, for rocks with a shape; else 0", set(&SurfaceType::roughness_m)}};
    // clang-format on
    for (const BlockFigure& figure : block_figures()) {
        figures.push_back({figure.name, figure.range, figure.meaning,
                           [value = figure.value](SurfaceType& type, double to) { type.block.*value = to; }});
    }
    return figures;
}

}  // namespace

const std::vector<GroundFigure>& ground_figures() {
    static const std::vector<GroundFigure> figures = all_figures();
    return figures;
}

rockfall::StopCurve stop_curve(double stop_probability) {
    using Knots = std::vector<std::pair<double, double>>;
    static const Knots factors = [] {
        config::Problems problems;
        const config::Table table = config::read_shipped_table("stopping_size.csv");
        Knots knots;
        for (std::size_t row = 0; row < table.rows(); ++row) {
            knots.emplace_back(table.number(row, "diameter_m", {.low = 0.0}, problems).value_or(1.0),
                               table.number(row, "factor", {.low = 0.0}, problems).value_or(1.0));
        }
        problems.throw_if_any();
        return knots;
    }();
    Knots knots = factors;
    for (auto& [diameter_m, value] : knots) {
        value = std::min(1.0, value * stop_probability);
    }
    return rockfall::StopCurve{std::move(knots)};
}

}  // namespace coupling
