#include <algorithm>
#include <cmath>

#include "config/text/numbers.hpp"
#include "coupling/assessments/collapse/collapse_results.hpp"

namespace coupling::collapse {

using geopackage::ColumnType;

geopackage::AreaLayer deposit_layer(const CollapseResults& results) {
    geopackage::AreaLayer layer;
    layer.name = "deposit";
    layer.sentence = "Cells in which blocks lie with their middle at the end.";
    layer.columns = {{"depth_m", ColumnType::number, "mean depth of the deposit"},
                     {"volume_m3", ColumnType::number, "volume of the deposit in the cell"},
                     {"largest_block_m", ColumnType::number, "largest block in the cell"}};
    const std::vector<CollapseMap> maps = maps_of(results);
    const auto raster_of = [&](std::string_view stem) -> const config::Raster<float>& {
        return std::find_if(maps.begin(), maps.end(),
                            [&](const CollapseMap& map) { return map.kind.stem == stem; })
            ->raster;
    };
    const config::Raster<float>& depth = raster_of("Deposit_depth");
    const config::Raster<float>& largest = raster_of("Largest_block");
    const config::GridFrame& frame = depth.frame;
    for (std::size_t k = 0; k < depth.values.size(); ++k) {
        if (std::isnan(depth.values[k])) {
            continue;
        }
        const config::Cell cell = frame.cell_of(k);
        const double west = frame.x_west_m + cell.column * frame.cell_width_m;
        const double north = frame.y_north_m() - cell.row * frame.cell_height_m;
        const double east = west + frame.cell_width_m, south = north - frame.cell_height_m;
        const auto depth_m = static_cast<double>(depth.values[k]);
        layer.rows.push_back({{config::to_text(depth_m), config::to_text(depth_m * frame.cell_area_m2()),
                               config::to_text(static_cast<double>(largest.values[k]))},
                              {{{west, south}, {east, south}, {east, north}, {west, north}, {west, south}}}});
    }
    return layer;
}

Site drawn_site(const CollapseSite& site) {
    const rockfall::Terrain without_ground{site.origin_m, {}, {}};
    Site drawn{.slope = {without_ground, rockfall::SurfaceMap::uniform(rockfall::SurfaceId{0}), {}},
               .heights = site.heights,
               .surface = {},
               .projection = site.projection,
               .map_frame = site.map_frame,
               .trees = site.trees,
               .logs = {},
               .sources = {},
               .targets = site.targets,
               .nets = {},
               .inputs = {},
               .forest = nullptr,
               .picture = site.picture};
    return drawn;
}

}  // namespace coupling::collapse
