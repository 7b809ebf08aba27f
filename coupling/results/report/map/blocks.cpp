#include "coupling/results/report/map/blocks.hpp"

#include <cmath>
#include <limits>

namespace coupling::report {

config::Raster<float> in_blocks(const config::Raster<float>& raster, int block) {
    if (block == 1) {
        return raster;
    }
    config::GridFrame frame = raster.frame;
    frame.columns = (raster.frame.columns + block - 1) / block;
    frame.rows = (raster.frame.rows + block - 1) / block;
    config::Raster<float> blocks{frame, std::numeric_limits<float>::quiet_NaN()};
    for (std::size_t i = 0; i < raster.values.size(); ++i) {
        const config::Cell cell = raster.frame.cell_of(i);
        float& shown = blocks.at({cell.column / block, cell.row / block});
        const float value = raster.values[i];
        if (!std::isnan(value) && (std::isnan(shown) || std::abs(value) > std::abs(shown))) {
            shown = value;
        }
    }
    return blocks;
}

}  // namespace coupling::report
