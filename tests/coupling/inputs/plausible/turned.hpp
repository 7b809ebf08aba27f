#pragma once

#include <Eigen/Core>
#include <vector>

#include "config/grid/raster.hpp"

namespace coupling::plausible {

/// One of the eight ways to turn a map by right angles and to mirror it.
struct Turn {
    int quarters = 0;  ///< counter-clockwise
    bool mirrored = false;

    /// A place about the centre (0, 0).
    [[nodiscard]] Eigen::Vector2d of(Eigen::Vector2d place) const {
        if (mirrored) {
            place.x() = -place.x();
        }
        for (int i = 0; i < quarters; ++i) {
            place = {-place.y(), place.x()};
        }
        return place;
    }
    /// A grid of square cells; the centre of its frame goes to (0, 0).
    template <class Value>
    [[nodiscard]] config::Raster<Value> of(const config::Raster<Value>& cells) const {
        config::GridFrame frame = cells.frame;
        if (quarters % 2 == 1) {
            std::swap(frame.columns, frame.rows);
        }
        frame.x_west_m = -0.5 * frame.columns * frame.cell_width_m;
        frame.y_south_m = -0.5 * frame.rows * frame.cell_height_m;
        const Eigen::Vector2d centre{0.5 * (cells.frame.x_west_m + cells.frame.x_east_m()),
                                     0.5 * (cells.frame.y_south_m + cells.frame.y_north_m())};
        config::Raster<Value> turned{frame, Value{}};
        for (std::size_t i = 0; i < cells.values.size(); ++i) {
            const config::Cell cell = cells.frame.cell_of(i);
            const Eigen::Vector2d place = of(Eigen::Vector2d{
                Eigen::Vector2d{cells.frame.x_centre_m(cell.column), cells.frame.y_centre_m(cell.row)} -
                centre});
            turned.at(frame.cell_at(place.x(), place.y())) = cells.values[i];
        }
        return turned;
    }
};

inline std::vector<Turn> all_turns() {
    std::vector<Turn> turns;
    for (const bool mirrored : {false, true}) {
        for (int quarters = 0; quarters < 4; ++quarters) {
            turns.push_back({quarters, mirrored});
        }
    }
    return turns;
}

}  // namespace coupling::plausible
