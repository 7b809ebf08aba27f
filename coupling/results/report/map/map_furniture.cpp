#include "coupling/results/report/map/map_furniture.hpp"

#include "config/text/joined.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::report {

using config::joined;

std::string attribute(const char* name, double value) {
    return std::string{" "}.append(name).append("=\"").append(place(value)).append("\"");
}

std::string scale_bar(const SheetSize& sheet) {
    const double lettering = sheet.lettering;
    const double most_m = 0.3 * sheet.width / sheet.units_per_m;
    double length_m = nice_step(0.15 * sheet.width / sheet.units_per_m);
    length_m = length_m > most_m ? 0.5 * length_m : length_m;
    const double length = length_m * sheet.units_per_m;
    const double y = sheet.height - 0.7 * lettering;
    const std::string half = place(0.5 * length);
    const std::string bar = place(0.35 * lettering);
    return joined("<g class=\"bar\" transform=\"translate(", place(0.8 * lettering), " ", place(y),
                  ")\"><rect class=\"plate\"", attribute("x", -0.4 * lettering),
                  attribute("y", -1.5 * lettering), attribute("width", length + 3.6 * lettering),
                  attribute("height", 1.9 * lettering), "/><path class=\"filled\" d=\"M0 0v-", bar, "h", half,
                  "v", bar, "z\"/><path class=\"hollow\" d=\"M", half, " 0v-", bar, "h", half, "v", bar,
                  "z\"/><text", attribute("font-size", 0.85 * lettering), attribute("y", -0.6 * lettering),
                  ">0</text><text", attribute("font-size", 0.85 * lettering), attribute("x", length),
                  attribute("y", -0.6 * lettering), " text-anchor=\"middle\">",
                  length_m >= 1000.0 ? page_text("{length} km", {{"length", tick_text(length_m / 1000.0)}})
                                     : page_text("{length} m", {{"length", tick_text(length_m)}}),
                  "</text></g>");
}

std::string north_arrow(const SheetSize& sheet) {
    const double lettering = sheet.lettering;
    const std::string a = place(lettering);
    const std::string half = place(0.45 * lettering);
    return joined("<g class=\"north\" transform=\"translate(", place(sheet.width - 1.2 * lettering), " ",
                  place(0.5 * lettering), ")\"><rect class=\"plate\"", attribute("x", -0.8 * lettering),
                  attribute("y", -0.2 * lettering), attribute("width", 1.6 * lettering),
                  attribute("height", 2.6 * lettering), "/><path class=\"filled\" d=\"M0 0l", half, " ", a,
                  "l-", half, " -", place(0.3 * lettering), "l-", half, " ", place(0.3 * lettering),
                  "z\"/><text text-anchor=\"middle\"", attribute("font-size", lettering),
                  attribute("y", 2.1 * lettering), ">N</text></g>");
}

}  // namespace coupling::report
