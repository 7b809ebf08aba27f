#include "coupling/results/report/map/cut_out.hpp"

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/results/report/map/map_furniture.hpp"
#include "coupling/results/templates/page_template.hpp"
#include "coupling/results/text/markup.hpp"

namespace coupling::report {
namespace {

constexpr double cut_out_width = 1000.0;
constexpr double cut_out_lettering = 22.0;

}  // namespace

std::string cut_out(const MapSheet& sheet, const CutOut& part, const std::string& drawing) {
    const double larger = part.units_per_m() / sheet.units_per_m();
    const DrawnPoint corner = sheet.place_on_sheet({part.low.x_m, part.high.y_m});
    const double height = part.y_of(part.low.y_m);
    const SheetSize size{cut_out_width, height, part.units_per_m(), cut_out_lettering};
    return filled_template(
        "cut_out.html",
        {{"label", part.label},
         {"box", config::joined("0 0 ", place(cut_out_width), " ", place(height))},
         {"width", place(cut_out_width)},
         {"height", place(height)},
         {"has_picture", sheet.has_picture()},
         {"larger", config::joined("scale(", config::to_text(larger), ")translate(",
                                   config::to_text(-corner.x), " ", config::to_text(-corner.y), ")")},
         {"as_large", config::to_text(1.0 / larger)},
         {"drawing", drawing},
         {"furniture", config::joined(scale_bar(size), north_arrow(size))}});
}

}  // namespace coupling::report
