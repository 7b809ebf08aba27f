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
    return stem == "Nr_blocks"       ? "collapse_page.map_blocks"
           : stem == "E_max"         ? "collapse_page.map_energy"
           : stem == "V_max"         ? "collapse_page.map_speed"
           : stem == "Deposit_depth" ? "collapse_page.map_depth"
                                     : "collapse_page.map_largest_block";
}

}  // namespace

std::string maps_section(const CollapseResults& results) {
    const Site site = drawn_site(results.site);
    const std::vector<CollapseMap> maps = maps_of(results);
    // Blocks that are wider than a cell lie in cells that no middle passed.
    const report::MapWindow window = report::window_around(site.map_frame, [&](config::Cell cell) {
        return std::any_of(maps.begin(), maps.end(), [&](const CollapseMap& map) {
            return map.raster.values[map.raster.frame.index(cell)] > 0.0F;
        });
    });
    const report::MapSheet sheet{site, window};
    std::string html = joined("<h2>", page_text("collapse_page.maps"), "</h2>\n", sheet.definitions(),
                              "<div class=\"thirds\">");
    int legends = 0;
    for (const CollapseMap& map : maps) {
        const report::ColourScale scale = report::scale_for(map.kind, range_of(map.raster));
        const std::string title = page_text(title_key(map.kind.stem));
        html += sheet.figure(
            {title, title, sheet.picture(report::without_zeros(map.raster), scale),
             scale.legend(joined("mass", std::to_string(++legends))), "", page_text("collapse_page.maps")},
            report::MapSize::third);
    }
    return joined(html, "</div>\n<p class=\"soft\">", page_text("collapse_page.middles_of_blocks_count"),
                  "</p>\n");
}

}  // namespace coupling::collapse
