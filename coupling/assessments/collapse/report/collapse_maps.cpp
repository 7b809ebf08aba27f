#include <algorithm>

#include "config/text/joined.hpp"
#include "coupling/assessments/collapse/collapse_results.hpp"
#include "coupling/results/report/map/map_colours.hpp"
#include "coupling/results/report/map/map_sheet.hpp"
#include "coupling/results/report/map/map_window.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::collapse {
namespace {

using config::joined;
using report::page_text;

/// Key of the title of a map, by the stem of its file.
const char* title_key(std::string_view stem) {
    return stem == "Nr_blocks"       ? "Blocks that passed"
           : stem == "E_max"         ? "Largest energy of a block"
           : stem == "V_max"         ? "Highest speed of a block"
           : stem == "Deposit_depth" ? "Depth of the deposit"
                                     : "Largest block in the deposit";
}

}  // namespace

report::PageFields maps_of_page(const CollapseResults& results) {
    const Site site = drawn_site(results.site);
    const std::vector<CollapseMap> maps = maps_of(results);
    // Blocks that are wider than a cell lie in cells that no middle passed.
    const report::MapWindow window = report::window_around(site.map_frame, [&](config::Cell cell) {
        return std::any_of(maps.begin(), maps.end(), [&](const CollapseMap& map) {
            return map.raster.values[map.raster.frame.index(cell)] > 0.0F;
        });
    });
    const report::MapSheet sheet{site, window};
    std::string figures;
    int legends = 0;
    for (const CollapseMap& map : maps) {
        const report::ColourScale scale = report::scale_for(map.kind, range_of(map.raster));
        const std::string title = page_text(title_key(map.kind.stem));
        figures +=
            sheet.figure({title, title, sheet.picture(report::without_zeros(map.raster), scale),
                          scale.legend(joined("mass", std::to_string(++legends))), "", page_text("Maps")},
                         report::MapSize::third);
    }
    return {{"map_definitions", sheet.definitions()}, {"maps", figures}};
}

}  // namespace coupling::collapse
