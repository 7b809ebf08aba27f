#include "coupling/assessments/decades/report/shown_ground.hpp"

#include <vector>

namespace coupling::decades {

report::MapWindow shown_ground(const Site& site, const forest::PatchGrid& grid,
                               std::span<const MemberYears> members) {
    const config::GridFrame& frame = site.map_frame;
    config::Raster<std::uint8_t> counts{frame, 0};
    for (const MemberYears& member : members) {
        for (const CellMap& map : member.maps) {
            for (std::size_t cell = 0; cell < map.cells.size(); ++cell) {
                if (map.cells[cell].passages > 0) {
                    counts.values[cell] = 1;
                }
            }
        }
    }
    return report::window_around(frame, [&](config::Cell cell) {
        return counts.at(cell) != 0 ||
               grid.at(frame.x_centre_m(cell.column), frame.y_centre_m(cell.row)).has_value();
    });
}

}  // namespace coupling::decades
