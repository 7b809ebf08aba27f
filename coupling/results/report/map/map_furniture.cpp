#include "coupling/results/report/map/map_furniture.hpp"

#include "config/text/joined.hpp"
#include "coupling/results/text/element.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::report {

using config::joined;

namespace {

/// The light ground of what stands at x, y of the sheet.
struct Plate {
    double x, y;  ///< of what stands on it
    double west, north, width, height;

    [[nodiscard]] std::string svg() const {
        return element("rect",
                       {{"class", "plate"}, {"x", west}, {"y", north}, {"width", width}, {"height", height}});
    }
    [[nodiscard]] LetteredBox on_sheet() const {
        return {x + west, y + north, x + west + width, y + north + height};
    }
};

double bar_length_m(const SheetSize& sheet) {
    const double most_m = 0.3 * sheet.width / sheet.units_per_m;
    const double length_m = nice_step(0.15 * sheet.width / sheet.units_per_m);
    return length_m > most_m ? 0.5 * length_m : length_m;
}

Plate plate_of_bar(const SheetSize& sheet) {
    const double lettering = sheet.lettering;
    return {0.8 * lettering,
            sheet.height - 0.7 * lettering,
            -0.4 * lettering,
            -1.5 * lettering,
            bar_length_m(sheet) * sheet.units_per_m + 3.6 * lettering,
            1.9 * lettering};
}

Plate plate_of_arrow(const SheetSize& sheet) {
    const double lettering = sheet.lettering;
    return {sheet.width - 1.2 * lettering,
            0.5 * lettering,
            -0.8 * lettering,
            -0.2 * lettering,
            1.6 * lettering,
            2.6 * lettering};
}

std::string placed(std::string_view style, double x, double y, std::string_view content) {
    return element("g", {{"class", style}, {"transform", joined("translate(", place(x), " ", place(y), ")")}},
                   content);
}

}  // namespace

std::vector<LetteredBox> furniture_boxes(const SheetSize& sheet) {
    return {plate_of_bar(sheet).on_sheet(), plate_of_arrow(sheet).on_sheet()};
}

std::string scale_bar(const SheetSize& sheet) {
    const double lettering = sheet.lettering;
    const double length_m = bar_length_m(sheet);
    const double length = length_m * sheet.units_per_m;
    const Plate plate = plate_of_bar(sheet);
    const std::string half = place(0.5 * length);
    const std::string bar = place(0.35 * lettering);
    const std::string words = length_m >= 1000.0
                                  ? page_text("{length} km", {{"length", tick_text(length_m / 1000.0)}})
                                  : page_text("{length} m", {{"length", tick_text(length_m)}});
    const Attribute size{"font-size", 0.85 * lettering};
    return placed("bar", plate.x, plate.y,
                  joined(plate.svg(), svg_path("filled", joined("M0 0v-", bar, "h", half, "v", bar, "z")),
                         svg_path("hollow", joined("M", half, " 0v-", bar, "h", half, "v", bar, "z")),
                         svg_text(0.0, -0.6 * lettering, "0", {size}),
                         svg_text(length, -0.6 * lettering, words, {size, {"text-anchor", "middle"}})));
}

std::string north_arrow(const SheetSize& sheet) {
    const double lettering = sheet.lettering;
    const std::string a = place(lettering);
    const std::string half = place(0.45 * lettering);
    const std::string notch = place(0.3 * lettering);
    const Plate plate = plate_of_arrow(sheet);
    return placed(
        "north", plate.x, plate.y,
        joined(plate.svg(),
               svg_path("filled",
                        joined("M0 0l", half, " ", a, "l-", half, " -", notch, "l-", half, " ", notch, "z")),
               svg_text(0.0, 2.1 * lettering, "N", {{"text-anchor", "middle"}, {"font-size", lettering}})));
}

}  // namespace coupling::report
