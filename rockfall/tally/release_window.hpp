#pragma once

#include <cstddef>
#include <vector>

#include "config/grid/raster.hpp"
#include "rockfall/tally/zeroed_list.hpp"

namespace rockfall {

/// The square around the middle of a cell in which rocks count for it: so many cells on each side of it.
struct CellReach {
    int columns = 0;
    int rows = 0;
    [[nodiscard]] bool is_of_one_cell() const { return columns == 0 && rows == 0; }
    friend bool operator==(const CellReach&, const CellReach&) = default;
};

/// The smallest square of whole cells, with the cell in its middle, that is at least so wide: one cell,
/// three, five. One cell for a width of 0.
CellReach reach_of_width(double width_m, const config::GridFrame& frame);

/// Finds the cells in whose squares one rock comes, each once with the rock's largest energy in its square.
class ReleaseWindow {
public:
    /// The rock visits a cell with this largest energy.
    void note(std::size_t cell, float energy_j, const config::GridFrame& frame, CellReach reach);

    /// Calls enter(cell, energy_j) for each cell in whose square the rock came, and begins with no rock.
    template <class Enter>
    void hand_over(const Enter& enter) {
        for (const std::size_t cell : cells_) {
            enter(cell, energy_j_[cell]);
            energy_j_[cell] = 0.0F;
        }
        cells_.clear();
    }

private:
    ZeroedList<float> energy_j_;  ///< by cell; 0: the rock did not come there
    std::vector<std::size_t> cells_;
};

}  // namespace rockfall
