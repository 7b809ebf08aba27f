#include "coupling/inputs/plausible/terrain/spikes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_set>
#include <utility>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/plausible/terrain/limits.hpp"

namespace coupling::plausible::terrain {
namespace {

using config::joined;

/// Connected cells that differ from each other by no more than the least height of a spike.
struct Group {
    std::vector<std::size_t> cells;
    double low_m = std::numeric_limits<double>::infinity();
    double high_m = -std::numeric_limits<double>::infinity();
    int around = 0;  ///< known neighbours
    double around_low_m = std::numeric_limits<double>::infinity();
    double around_high_m = -std::numeric_limits<double>::infinity();
};

/// Calls `visit(cell)` for the known neighbours of a cell.
template <class Visit>
void visit_neighbours(const HeightField& field, std::size_t cell, Visit visit) {
    const auto columns = static_cast<std::size_t>(field.columns);
    const int row = static_cast<int>(cell / columns);
    const int column = static_cast<int>(cell % columns);
    for (int r = std::max(row - 1, 0); r <= std::min(row + 1, field.rows - 1); ++r) {
        for (int c = std::max(column - 1, 0); c <= std::min(column + 1, field.columns - 1); ++c) {
            if ((r != row || c != column) && !std::isnan(field.at(r, c))) {
                visit(static_cast<std::size_t>(r) * columns + static_cast<std::size_t>(c));
            }
        }
    }
}

/// The group of a cell; nothing where it is larger than a spike.
std::optional<Group> group_of(const HeightField& field, std::size_t cell, double least_m) {
    Group group;
    group.cells.push_back(cell);
    std::vector<std::size_t> around;
    for (std::size_t i = 0; i < group.cells.size(); ++i) {
        const double height_m = field.heights_m[group.cells[i]];
        group.low_m = std::min(group.low_m, height_m);
        group.high_m = std::max(group.high_m, height_m);
        visit_neighbours(field, group.cells[i], [&](std::size_t other) {
            if (std::find(group.cells.begin(), group.cells.end(), other) != group.cells.end()) {
                return;
            }
            if (std::abs(field.heights_m[other] - height_m) <= least_m) {
                group.cells.push_back(other);
            } else {
                around.push_back(other);
            }
        });
        if (group.cells.size() > limits::spike_group) {
            return std::nullopt;
        }
    }
    std::sort(around.begin(), around.end());
    around.erase(std::unique(around.begin(), around.end()), around.end());
    for (const std::size_t other : around) {
        if (std::find(group.cells.begin(), group.cells.end(), other) == group.cells.end()) {
            ++group.around;
            group.around_low_m = std::min(group.around_low_m, field.heights_m[other]);
            group.around_high_m = std::max(group.around_high_m, field.heights_m[other]);
        }
    }
    return group;
}

std::string in_words(const char* beginning, double height_m, const HeightField& field, std::size_t cell) {
    const auto columns = static_cast<std::size_t>(field.columns);
    return joined(beginning, config::to_text(std::round(height_m)), " m, the first in row ",
                  std::to_string(cell / columns + 1), ", column ", std::to_string(cell % columns + 1));
}

std::string cells(std::size_t count) {
    return joined(std::to_string(count), count == 1 ? " cell" : " cells");
}

/// Calls `visit(cell, metres above all neighbours, metres below all neighbours)` for every cell of a spike.
template <class Visit>
void visit_spikes(const HeightField& field, Visit visit) {
    if (field.rows < 3 || field.columns < 3) {
        return;
    }
    const double least_m = std::max(limits::spike_cells * field.cell_m(), limits::spike_m);
    std::unordered_set<std::size_t> done;
    for (int row = 0; row < field.rows; ++row) {
        for (int column = 0; column < field.columns; ++column) {
            const double height_m = field.at(row, column);
            // Most cells are done with one neighbour: the western cells of a spike differ from it.
            if (std::isnan(height_m) ||
                (column > 0 && std::abs(height_m - field.at(row, column - 1)) <= least_m)) {
                continue;
            }
            const std::size_t cell = static_cast<std::size_t>(row) * static_cast<std::size_t>(field.columns) +
                                     static_cast<std::size_t>(column);
            const std::optional<Group> group =
                done.contains(cell) ? std::nullopt : group_of(field, cell, least_m);
            if (!group || group->around < 5) {
                continue;
            }
            const double above_m = group->low_m - group->around_high_m;
            const double below_m = group->around_low_m - group->high_m;
            const bool is_pit = below_m > least_m && (group->low_m != 0.0 || group->high_m != 0.0);
            if (above_m > least_m || is_pit) {
                for (const std::size_t member : group->cells) {
                    done.insert(member);
                    visit(member, above_m, below_m);
                }
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

WithoutSpikes::WithoutSpikes(const HeightField& whole, bool without_zeros) : field_{whole} {
    const std::vector<std::size_t> cells = spike_cells(whole);
    const double* const end = whole.heights_m + whole.size();
    if (cells.empty() && !(without_zeros && std::find(whole.heights_m, end, 0.0) != end)) {
        return;
    }
    heights_m_.assign(whole.heights_m, end);
    for (const std::size_t cell : cells) {
        heights_m_[cell] = not_known;
    }
    if (without_zeros) {
        std::replace(heights_m_.begin(), heights_m_.end(), 0.0, not_known);
    }
    field_.heights_m = heights_m_.data();
}

namespace {

/// Bends of the ground at a cell along its row, its column and its diagonals: its height over the middle of
/// the two opposite neighbours.
struct Bends {
    double least_m = 0.0;    ///< the smallest of the four where all have one sign, with that sign; else 0
    double largest_m = 0.0;  ///< the largest of the four, without sign; NaN where a neighbour is not known
};

Bends bends_at(const HeightField& field, int row, int column) {
    const double height_m = field.at(row, column);
    double low_m = std::numeric_limits<double>::infinity();
    double high_m = -std::numeric_limits<double>::infinity();
    for (const auto& [down, right] : {std::pair{0, 1}, {1, 0}, {1, 1}, {1, -1}}) {
        const double bend_m =
            height_m - 0.5 * (field.at(row - down, column - right) + field.at(row + down, column + right));
        if (std::isnan(bend_m)) {
            return {0.0, not_known};
        }
        low_m = std::min(low_m, bend_m);
        high_m = std::max(high_m, bend_m);
    }
    const double least_m = low_m > 0.0 ? low_m : std::min(high_m, 0.0);
    return {least_m, std::max(std::abs(low_m), std::abs(high_m))};
}

/// Bends in a window around a cell, without the cell and its neighbours, whose bends it makes itself.
struct BendsAround {
    double largest_m = 0.0;
    double root_mean_square_m = 0.0;
};

/// Nothing where the ground around is mostly not known.
std::optional<BendsAround> bends_around(const HeightField& field, int row, int column) {
    constexpr int reach = limits::lone_reach;
    constexpr int fewest = 2 * reach * (reach + 1);  // half of the window
    BendsAround around;
    double squares_m2 = 0.0;
    int known = 0;
    for (int r = std::max(row - reach, 1); r <= std::min(row + reach, field.rows - 2); ++r) {
        for (int c = std::max(column - reach, 1); c <= std::min(column + reach, field.columns - 2); ++c) {
            if (std::max(std::abs(r - row), std::abs(c - column)) < 2) {
                continue;
            }
            if (const double bend_m = bends_at(field, r, c).largest_m; !std::isnan(bend_m)) {
                around.largest_m = std::max(around.largest_m, bend_m);
                squares_m2 += bend_m * bend_m;
                ++known;
            }
        }
    }
    if (known < fewest) {
        return std::nullopt;
    }
    around.root_mean_square_m = std::sqrt(squares_m2 / known);
    return around;
}

bool stands_out(double bend_m, const BendsAround& around) {
    return bend_m > limits::lone_ratio * around.largest_m ||
           (bend_m > around.largest_m && bend_m > limits::lone_roughness * around.root_mean_square_m);
}

/// Warns of cells that stand out of the ground around by less than a spike that is one anywhere.
std::optional<Finding> judge_lone_cells(const HeightField& field) {
    std::size_t count = 0;
    std::size_t first = 0;
    double most_m = 0.0;
    for (int row = 1; row + 1 < field.rows; ++row) {
        for (int column = 1; column + 1 < field.columns; ++column) {
            const double out_m = std::abs(bends_at(field, row, column).least_m);
            if (!(out_m >= limits::lone_m)) {
                continue;
            }
            const std::optional<BendsAround> around = bends_around(field, row, column);
            if (around && stands_out(out_m, *around)) {
                first = count++ == 0
                            ? static_cast<std::size_t>(row) * static_cast<std::size_t>(field.columns) +
                                  static_cast<std::size_t>(column)
                            : first;
                most_m = std::max(most_m, out_m);
            }
        }
    }
    if (count == 0) {
        return std::nullopt;
    }
    return Finding{
        false, joined(cells(count), in_words(" out of the ground around by up to ", most_m, field, first)),
        "ground without single spikes and pits",
        "look at these cells; set those that are wrong to NODATA and fill them from their neighbours"};
}

}  // namespace

std::optional<Finding> judge_spikes(const HeightField& field) {
    const Spikes spikes = spikes_of(field);
    if (spikes.peaks + spikes.pits == 0) {
        return judge_lone_cells(field);
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
