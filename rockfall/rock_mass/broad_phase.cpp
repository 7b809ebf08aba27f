#include "rockfall/rock_mass/broad_phase.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

namespace rockfall::rock_mass {

using Eigen::Vector3d;

namespace {

/// A box in one of its cells.
struct Entry {
    std::uint64_t cell;
    std::uint32_t box;
};

/// Cells of one size: entries of boxes that belong to the level, sorted by cell, and where each cell begins.
struct Level {
    double cell_m = 0.0;
    std::vector<Entry> entries;
    std::vector<std::uint32_t> slots;  ///< by a mix of the cell's key: its first entry, or none

    static constexpr std::uint32_t none = 0xFFFFFFFF;
    [[nodiscard]] std::size_t slot_of(std::uint64_t key) const {
        return static_cast<std::size_t>((key * 0x9E3779B97F4A7C15ULL) >> 32U) & (slots.size() - 1);
    }
    void list_cells() {
        slots.assign(std::bit_ceil(2 * entries.size() + 1), none);
        for (std::size_t k = 0; k < entries.size(); ++k) {
            if (k == 0 || entries[k].cell != entries[k - 1].cell) {
                std::size_t slot = slot_of(entries[k].cell);
                while (slots[slot] != none) {
                    slot = (slot + 1) & (slots.size() - 1);
                }
                slots[slot] = static_cast<std::uint32_t>(k);
            }
        }
    }
    /// The first entry of a cell; the number of entries if it has none.
    [[nodiscard]] std::size_t first_of(std::uint64_t key) const {
        for (std::size_t slot = slot_of(key); slots[slot] != none; slot = (slot + 1) & (slots.size() - 1)) {
            if (entries[slots[slot]].cell == key) {
                return slots[slot];
            }
        }
        return entries.size();
    }
};

using CellPlace = std::array<std::int64_t, 3>;

CellPlace place_of(const Vector3d& point_m, double cell_m) {
    return {static_cast<std::int64_t>(std::floor(point_m.x() / cell_m)),
            static_cast<std::int64_t>(std::floor(point_m.y() / cell_m)),
            static_cast<std::int64_t>(std::floor(point_m.z() / cell_m))};
}

std::uint64_t key_of(const CellPlace& place) {
    constexpr std::uint64_t mask = (1ULL << 21) - 1;
    std::uint64_t key = 0;
    for (const std::int64_t at : place) {
        key = (key << 21) | (static_cast<std::uint64_t>(at + (1 << 20)) & mask);
    }
    return key;
}

template <class Visit>
void each_cell(const Box3& box, double cell_m, const Visit& visit) {
    const CellPlace low = place_of(box.low_m, cell_m), high = place_of(box.high_m, cell_m);
    CellPlace at{};
    for (at[0] = low[0]; at[0] <= high[0]; ++at[0]) {
        for (at[1] = low[1]; at[1] <= high[1]; ++at[1]) {
            for (at[2] = low[2]; at[2] <= high[2]; ++at[2]) {
                visit(at);
            }
        }
    }
}

double size_of(const Box3& box) {
    return (box.high_m - box.low_m).maxCoeff();
}

std::vector<Level> levels_of(std::span<const Box3> boxes, std::vector<std::uint8_t>& level_of) {
    double smallest = std::numeric_limits<double>::infinity();
    for (const Box3& box : boxes) {
        if (!box.is_nowhere()) {
            smallest = std::min(smallest, std::max(size_of(box), 1e-3));
        }
    }
    std::vector<Level> levels;
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
        if (boxes[i].is_nowhere()) {
            continue;
        }
        std::size_t level = 0;
        double cell_m = 2.0 * smallest;
        for (; cell_m < size_of(boxes[i]); cell_m *= 2.0) {
            ++level;
        }
        for (std::size_t k = levels.size(); k <= level; ++k) {
            levels.push_back({std::ldexp(2.0 * smallest, static_cast<int>(k)), {}, {}});
        }
        level_of[i] = static_cast<std::uint8_t>(level);
        each_cell(boxes[i], levels[level].cell_m, [&](const CellPlace& at) {
            levels[level].entries.push_back({key_of(at), i});
        });
    }
    for (Level& level : levels) {
        std::sort(level.entries.begin(), level.entries.end(), [](const Entry& a, const Entry& b) {
            return a.cell != b.cell ? a.cell < b.cell : a.box < b.box;
        });
        level.list_cells();
    }
    return levels;
}

/// Of all cells that two boxes share, the one with their common low corner reports the pair.
bool reports(const Box3& a, const Box3& b, double cell_m, const CellPlace& at) {
    return place_of(a.low_m.cwiseMax(b.low_m), cell_m) == at;
}

}  // namespace

std::vector<std::pair<std::uint32_t, std::uint32_t>> meeting_pairs(std::span<const Box3> boxes,
                                                                   std::span<const std::uint8_t> moves) {
    std::vector<std::uint8_t> level_of(boxes.size(), 0);
    const std::vector<Level> levels = levels_of(boxes, level_of);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
        if (boxes[i].is_nowhere()) {
            continue;
        }
        for (std::size_t k = level_of[i]; k < levels.size(); ++k) {
            const Level& level = levels[k];
            each_cell(boxes[i], level.cell_m, [&](const CellPlace& at) {
                const std::uint64_t key = key_of(at);
                for (std::size_t entry = level.first_of(key);
                     entry < level.entries.size() && level.entries[entry].cell == key; ++entry) {
                    const std::uint32_t other = level.entries[entry].box;
                    const bool once = k > level_of[i] || other > i;
                    if (once && (moves[i] != 0 || moves[other] != 0) && boxes[i].meets(boxes[other]) &&
                        reports(boxes[i], boxes[other], level.cell_m, at)) {
                        pairs.emplace_back(std::min(i, other), std::max(i, other));
                    }
                }
            });
        }
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

}  // namespace rockfall::rock_mass
