#include "coupling/inputs/plausible/terrain/upside_down.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/plausible/terrain/limits.hpp"
#include "coupling/inputs/plausible/terrain/spikes.hpp"

namespace coupling::plausible::terrain {
namespace {

using config::joined;

struct Averaged {
    int rows = 0;
    int columns = 0;
    std::vector<double> values;
};

/// Parts of cells of a side that a larger cell holds: as (first, weights).
struct Share {
    int first = 0;
    std::vector<double> weights;
};

std::vector<Share> shares_of(int cells, int parts) {
    std::vector<Share> shares;
    const double width = static_cast<double>(cells) / parts;
    for (int part = 0; part < parts; ++part) {
        const double from = part * width;
        const double to = part + 1 == parts ? cells : (part + 1) * width;
        Share share{.first = static_cast<int>(from), .weights = {}};
        for (int cell = share.first; cell < cells && cell < to - 1e-9; ++cell) {
            share.weights.push_back(std::min<double>(cell + 1, to) - std::max<double>(cell, from));
        }
        shares.push_back(std::move(share));
    }
    return shares;
}

/// Means over equal rectangles, which may cut cells: so no side is preferred. NaN where a cell is unknown.
Averaged averaged(const HeightField& field) {
    const double ratio =
        std::sqrt(static_cast<double>(limits::hollow_cells) / static_cast<double>(field.size()));
    const double scale = std::min(1.0, ratio);
    Averaged mean;
    mean.rows = std::max(1, static_cast<int>(std::round(field.rows * scale)));
    mean.columns = std::max(1, static_cast<int>(std::round(field.columns * scale)));
    const std::vector<Share> rows = shares_of(field.rows, mean.rows);
    const std::vector<Share> columns = shares_of(field.columns, mean.columns);
    for (const Share& row : rows) {
        for (const Share& column : columns) {
            double sum = 0.0;
            double weight = 0.0;
            for (std::size_t r = 0; r < row.weights.size(); ++r) {
                for (std::size_t c = 0; c < column.weights.size(); ++c) {
                    const double share = row.weights[r] * column.weights[c];
                    sum +=
                        share * field.at(row.first + static_cast<int>(r), column.first + static_cast<int>(c));
                    weight += share;
                }
            }
            mean.values.push_back(sum / weight);
        }
    }
    return mean;
}

/// Mean depth of water over the known cells once every hollow is full (priority flood, Barnes et al. 2014).
double mean_depth_m(const Averaged& ground, double sign) {
    struct Front {
        double level;
        int row;
        int column;
        bool operator>(const Front& other) const { return level > other.level; }
    };
    const auto index = [&](int row, int column) {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(ground.columns) +
               static_cast<std::size_t>(column);
    };
    const auto known = [&](int row, int column) {
        return row >= 0 && row < ground.rows && column >= 0 && column < ground.columns &&
               !std::isnan(ground.values[index(row, column)]);
    };
    std::priority_queue<Front, std::vector<Front>, std::greater<>> front;
    std::vector<char> reached(ground.values.size(), 0);
    for (int row = 0; row < ground.rows; ++row) {
        for (int column = 0; column < ground.columns; ++column) {
            const bool drains = !known(row - 1, column) || !known(row + 1, column) ||
                                !known(row, column - 1) || !known(row, column + 1);
            if (known(row, column) && drains) {
                front.push({sign * ground.values[index(row, column)], row, column});
                reached[index(row, column)] = 1;
            }
        }
    }
    double water_m = 0.0;
    std::size_t cells = 0;
    while (!front.empty()) {
        const Front here = front.top();
        front.pop();
        water_m += here.level - sign * ground.values[index(here.row, here.column)];
        ++cells;
        for (int row = here.row - 1; row <= here.row + 1; ++row) {
            for (int column = here.column - 1; column <= here.column + 1; ++column) {
                if (known(row, column) && reached[index(row, column)] == 0) {
                    reached[index(row, column)] = 1;
                    front.push({std::max(here.level, sign * ground.values[index(row, column)]), row, column});
                }
            }
        }
    }
    return cells > 0 ? water_m / static_cast<double>(cells) : not_known;
}

}  // namespace

Hollows hollows_of(const HeightField& field) {
    const Averaged ground = averaged(field);
    return {mean_depth_m(ground, 1.0), mean_depth_m(ground, -1.0)};
}

std::optional<Finding> judge_upside_down(const HeightField& field) {
    const Values values = values_of(field);
    if (values.known < limits::fewest_hollow_cells || values.high_m - values.low_m < limits::least_relief_m) {
        return std::nullopt;
    }
    // Cells that are damaged or stand for unknown ground make hollows of their own.
    const WithoutSpikes cleaned{field, values.high_m > 100.0};
    const Hollows hollows = hollows_of(cleaned.field());
    if (!(hollows.upright_m >= limits::hollows_m) ||
        hollows.upright_m < limits::hollows_ratio * hollows.inverted_m) {
        return std::nullopt;
    }
    return Finding{
        false,
        joined("closed hollows of ", config::to_text(std::round(100.0 * hollows.upright_m) / 100.0),
               " m on average, but hardly a closed summit"),
        "ground with valleys that drain",
        "check whether the heights are upside down: with the wrong sign, or as depths below a top"};
}

}  // namespace coupling::plausible::terrain
