#include "coupling/inputs/plausible/terrain/spikes.hpp"

#include <algorithm>
#include <limits>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/plausible/terrain/limits.hpp"

namespace coupling::plausible::terrain {
namespace {

using config::joined;

struct Neighbours {
    int known = 0;
    double low_m = std::numeric_limits<double>::infinity();
    double high_m = -std::numeric_limits<double>::infinity();
};

Neighbours neighbours_of(const HeightField& field, int row, int column) {
    Neighbours around;
    for (int r = std::max(row - 1, 0); r <= std::min(row + 1, field.rows - 1); ++r) {
        for (int c = std::max(column - 1, 0); c <= std::min(column + 1, field.columns - 1); ++c) {
            const double height_m = field.at(r, c);
            if ((r != row || c != column) && !std::isnan(height_m)) {
                ++around.known;
                around.low_m = std::min(around.low_m, height_m);
                around.high_m = std::max(around.high_m, height_m);
            }
        }
    }
    return around;
}

std::string in_words(const char* beginning, double height_m, const HeightField& field, std::size_t cell) {
    const auto columns = static_cast<std::size_t>(field.columns);
    return joined(beginning, config::to_text(std::round(height_m)), " m, the first in row ",
                  std::to_string(cell / columns + 1), ", column ", std::to_string(cell % columns + 1));
}

std::string cells(std::size_t count) {
    return joined(std::to_string(count), count == 1 ? " cell" : " cells");
}

/// Calls `visit(cell, metres above all neighbours, metres below all neighbours)` for every spike.
template <class Visit>
void visit_spikes(const HeightField& field, Visit visit) {
    if (field.rows < 3 || field.columns < 3) {
        return;
    }
    const double least_m = std::max(limits::spike_cells * field.cell_m(), limits::spike_m);
    for (int row = 0; row < field.rows; ++row) {
        for (int column = 0; column < field.columns; ++column) {
            const double height_m = field.at(row, column);
            // Most cells are done with one neighbour: a spike differs from it, too.
            const double beside_m = field.at(row, column > 0 ? column - 1 : column + 1);
            if (std::isnan(height_m) || std::abs(height_m - beside_m) <= least_m) {
                continue;
            }
            const Neighbours around = neighbours_of(field, row, column);
            const double above_m = height_m - around.high_m;
            const double below_m = around.low_m - height_m;
            if (around.known >= 5 && (above_m > least_m || (below_m > least_m && height_m != 0.0))) {
                visit(static_cast<std::size_t>(row) * static_cast<std::size_t>(field.columns) +
                          static_cast<std::size_t>(column),
                      above_m, below_m);
            }
        }
    }
}

}  // namespace

Spikes spikes_of(const HeightField& field) {
    Spikes spikes;
    visit_spikes(field, [&](std::size_t cell, double above_m, double below_m) {
        if (above_m > below_m) {
            spikes.first_peak = spikes.peaks++ == 0 ? cell : spikes.first_peak;
            spikes.highest_m = std::max(spikes.highest_m, above_m);
        } else {
            spikes.first_pit = spikes.pits++ == 0 ? cell : spikes.first_pit;
            spikes.deepest_m = std::max(spikes.deepest_m, below_m);
        }
    });
    return spikes;
}

std::vector<std::size_t> spike_cells(const HeightField& field) {
    std::vector<std::size_t> found;
    visit_spikes(field, [&](std::size_t cell, double, double) { found.push_back(cell); });
    return found;
}

std::optional<Finding> judge_spikes(const HeightField& field) {
    const Spikes spikes = spikes_of(field);
    if (spikes.peaks + spikes.pits == 0) {
        return std::nullopt;
    }
    const bool more_peaks = spikes.peaks >= spikes.pits;
    std::string found =
        more_peaks
            ? joined(cells(spikes.peaks),
                     in_words(" above all neighbours by up to ", spikes.highest_m, field, spikes.first_peak))
            : joined(cells(spikes.pits),
                     in_words(" below all neighbours by up to ", spikes.deepest_m, field, spikes.first_pit));
    return Finding{false, std::move(found), "ground without single spikes and pits",
                   "set these cells to NODATA and fill them from their neighbours"};
}

}  // namespace coupling::plausible::terrain
