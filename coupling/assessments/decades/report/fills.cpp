#include <array>

#include "config/text/joined.hpp"
#include "coupling/assessments/decades/report/page_parts.hpp"
#include "coupling/results/report/species_colours.hpp"
#include "coupling/results/templates/page_files.hpp"
#include "coupling/results/text/element.hpp"

namespace coupling::decades {
namespace {

using config::joined;
using report::element;

/// Strokes over the plain colour, in a square of 6 units.
constexpr const char* rising = "M-1 1l2-2M0 6l6-6M5 7l2-2";
constexpr const char* falling = "M-1 5l2 2M0 0l6 6M5-1l2 2";
constexpr const char* level = "M0 2h6M0 5h6";
constexpr const char* upright = "M2 0v6M5 0v6";
constexpr const char* crossed = "M0 3h6M3 0v6";
constexpr const char* dotted = "M1.5 1.5h0M4.5 4.5h0";

struct Fill {
    const char* on_light;
    const char* on_dark;  ///< brighter where the colour would sink into a dark page
    const char* strokes;  ///< empty: plain
    const char* stroke_colour;
};

/// What distinguishes species beside their colour.
struct Strokes {
    const char* strokes;
    const char* colour;
};
constexpr std::array<Strokes, report::species_colours.size()> species_strokes{{{"", "#fff"},
                                                                               {rising, "#fff"},
                                                                               {dotted, "#222"},
                                                                               {falling, "#fff"},
                                                                               {level, "#222"},
                                                                               {upright, "#fff"},
                                                                               {crossed, "#fff"},
                                                                               {dotted, "#fff"},
                                                                               {level, "#fff"},
                                                                               {"", "#222"},
                                                                               {upright, "#fff"},
                                                                               {falling, "#222"}}};

constexpr auto species_fills = [] {
    std::array<Fill, species_strokes.size()> fills{};
    for (std::size_t i = 0; i < fills.size(); ++i) {
        fills[i] = {report::species_colours[i].on_light, report::species_colours[i].on_dark,
                    species_strokes[i].strokes, species_strokes[i].colour};
    }
    return fills;
}();

/// Colours of the same schemes, in the order of forest::Cause.
constexpr std::array<Fill, forest::cause_count> cause_fills{{{"#bbbbbb", "#bbbbbb", "", "#222"},
                                                             {"#ddaa33", "#ddaa33", dotted, "#222"},
                                                             {"#228833", "#3da556", rising, "#fff"},
                                                             {"#004488", "#5d92d6", level, "#fff"},
                                                             {"#66ccee", "#66ccee", dotted, "#222"},
                                                             {"#bb5566", "#cf7080", falling, "#fff"},
                                                             {"#555555", "#8a8a8a", crossed, "#fff"},
                                                             {"#aa3377", "#c75a97", upright, "#fff"},
                                                             {"#774411", "#b57a45", upright, "#fff"},
                                                             {"#ee99aa", "#ee99aa", level, "#222"},
                                                             {"#eecc66", "#eecc66", rising, "#222"}}};
constexpr std::size_t regime_lines = 8;

template <std::size_t Count>
std::string patterns(const std::string& kind, const std::array<Fill, Count>& fills) {
    std::string svg;
    for (std::size_t i = 0; i < Count; ++i) {
        const std::string name = joined(kind, std::to_string(i));
        const Fill& fill = fills[i];
        std::string content =
            element("rect", {{"class", joined(name, "-colour")}, {"width", 6.0}, {"height", 6.0}});
        if (*fill.strokes != '\0') {
            content += element("path", {{"stroke", fill.stroke_colour},
                                        {"stroke-width", fill.strokes == dotted ? 1.7 : 1.1},
                                        {"stroke-linecap", "round"},
                                        {"stroke-opacity", ".85"},
                                        {"d", fill.strokes}});
        }
        svg += element("pattern",
                       {{"id", name}, {"width", 6.0}, {"height", 6.0}, {"patternUnits", "userSpaceOnUse"}},
                       content);
    }
    return svg;
}

template <std::size_t Count>
std::string rules(const std::string& kind, const std::array<Fill, Count>& fills) {
    std::string plain;
    std::string dark;
    std::string print;
    for (std::size_t i = 0; i < Count; ++i) {
        const std::string name = joined(kind, std::to_string(i));
        plain +=
            joined(".", name, "{fill:url(#", name, ");stroke:var(--ink);stroke-width:.6}\n.", name,
                   "-colour{fill:", fills[i].on_light, "}.", name, "-line{stroke:", fills[i].on_light, "}\n");
        dark += joined(".", name, "-colour{fill:", fills[i].on_dark, "}");
        // Browsers print a pattern as a picture of its own for each shape: thousands of crowns make a file of
        // 50 MB.
        print += joined(".stand .crown.", name, ",.stand .crown .", name, "{fill:", fills[i].on_light, "}");
    }
    return joined(plain, "@media (prefers-color-scheme:dark){", dark, "}\n@media print{", print, "}\n");
}

}  // namespace

std::string fill_definitions() {
    return report::svg_definitions(
        joined(patterns("species", species_fills), patterns("cause", cause_fills)));
}

std::string fill_of_species(std::size_t species) {
    return joined("species", std::to_string(species % species_fills.size()));
}

std::string fill_of_cause(forest::Cause cause) {
    return joined("cause", std::to_string(forest::index_of(cause)));
}

std::string line_of_regime(std::size_t place) {
    return joined("regime", std::to_string(place % regime_lines));
}

std::string page_style() {
    return joined(rules("species", species_fills), rules("cause", cause_fills), "\n",
                  report::page_file("years.css"));
}

}  // namespace coupling::decades
