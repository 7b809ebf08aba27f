#include <algorithm>

#include "config/text/joined.hpp"
#include "coupling/assessments/collapse/collapse_results.hpp"
#include "coupling/results/report/map/map_colours.hpp"
#include "coupling/results/report/map/map_sheet.hpp"
#include "coupling/results/report/map/map_window.hpp"
#include "coupling/results/text/markup.hpp"
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

/// Speed and displacement at each picture, side by side, all on one scale.
std::string field_figures(const CollapseResults& results, const report::MapSheet& sheet, int legends) {
    const std::vector<FieldMap> fields = fields_of(results);
    std::string figures;
    for (const FieldMap& field : fields) {
        const RasterKind kind = field.kind();
        const report::ColourScale scale = report::scale_for(kind, range_of_fields(fields, field.is_speed));
        const std::string time = report::fixed(field.time_s, 1);
        const std::string title = field.is_speed ? page_text("Speed after {time} s", {{"time", time}})
                                                 : page_text("Displacement after {time} s", {{"time", time}});
        figures += sheet.figure({title, title, sheet.picture(report::without_zeros(field.raster), scale),
                                 scale.legend(joined("mass", std::to_string(++legends))), ""},
                                report::MapSize::half);
    }
    return figures;
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
    return {{"map_definitions", sheet.definitions()},
            {"maps", figures},
            {"field_maps", field_figures(results, sheet, legends)}};
}

}  // namespace coupling::collapse
