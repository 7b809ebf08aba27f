#include "coupling/assessments/today/report/shown_window.hpp"

#include <vector>

#include "coupling/results/figures/figures.hpp"
#include "coupling/results/maps/rasters.hpp"

namespace coupling::report {

MapWindow shown_window(const RunResults& results) {
    std::vector<config::Raster<float>> passages;
    for (const Cover cover : covers_of(results)) {
        passages.push_back(raster_of(raster_kind("Nr_passages"), results, cover));
    }
    return window_around(results.site.map_frame, [&](config::Cell cell) {
        for (const config::Raster<float>& raster : passages) {
            if (raster.at(cell) > 0.0F) {
                return true;
            }
        }
        return false;
    });
}

}  // namespace coupling::report
