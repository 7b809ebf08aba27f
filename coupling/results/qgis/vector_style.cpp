#include "coupling/results/qgis/vector_style.hpp"

#include <cmath>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/results/text/element.hpp"
#include "coupling/results/text/messages.hpp"

namespace coupling::qgis {
namespace {

using config::joined;
using config::to_text;
using report::Attributes;
using report::element;

/// Larger than any energy of a rock [kJ].
constexpr double no_limit_kj = 1e9;

std::string property(std::string_view key, std::string_view value) {
    return element("prop", {{"k", key}, {"v", value}});
}

std::string symbol_layer(std::string_view type, std::string_view properties) {
    return element("layer", {{"class", type}, {"enabled", "1"}, {"locked", "0"}, {"pass", "0"}}, properties);
}

std::string rgba(Colour colour, int alpha) {
    return joined(std::to_string(colour.red), ",", std::to_string(colour.green), ",",
                  std::to_string(colour.blue), ",", std::to_string(alpha));
}

std::string layer_of(Mark mark, const Symbol& symbol) {
    const std::string size = to_text(symbol.size_mm);
    const std::string colour = rgba(symbol.colour, 255);
    switch (mark) {
        case Mark::point:
            return symbol_layer("SimpleMarker",
                                joined(property("name", "circle"), property("color", colour),
                                       property("outline_color", "35,35,35,255"),
                                       property("outline_style", "solid"), property("outline_width", "0.1"),
                                       property("size", size), property("size_unit", "MM")));
        case Mark::line:
            return symbol_layer("SimpleLine",
                                joined(property("line_color", colour), property("line_style", "solid"),
                                       property("line_width", size), property("line_width_unit", "MM"),
                                       property("capstyle", "round"), property("joinstyle", "round")));
        case Mark::area:
            break;
    }
    return symbol_layer("SimpleFill",
                        joined(property("color", rgba(symbol.colour, 90)), property("style", "solid"),
                               property("outline_color", colour),
                               property("outline_style", symbol.size_mm > 0.0 ? "solid" : "no"),
                               property("outline_width", size), property("outline_width_unit", "MM")));
}

std::string symbol_of(Mark mark, std::size_t number, const Symbol& symbol) {
    const char* const type = mark == Mark::point ? "marker" : mark == Mark::line ? "line" : "fill";
    return joined(element("symbol",
                          {{"name", std::to_string(number)},
                           {"type", type},
                           {"alpha", "1"},
                           {"clip_to_extent", "1"},
                           {"force_rhr", "0"}},
                          layer_of(mark, symbol)),
                  "\n");
}

/// `attributes`: the type of the renderer and what that type needs.
std::string renderer(Attributes attributes, std::string_view classes, std::string_view symbols) {
    attributes.insert(attributes.end(),
                      {{"forceraster", "0"}, {"symbollevels", "0"}, {"enableorderby", "0"}});
    return joined(element("renderer-v2", attributes,
                          joined("\n", classes, element("symbols", {}, joined("\n", symbols)), "\n")),
                  "\n");
}

}  // namespace

std::string single(Mark mark, const Symbol& symbol) {
    return renderer({{"type", "singleSymbol"}}, "", symbol_of(mark, 0, symbol));
}

std::string graduated(Mark mark, std::string_view column, const std::vector<Range>& ranges) {
    std::string classes;
    std::string symbols;
    for (std::size_t i = 0; i < ranges.size(); ++i) {
        classes += joined(element("range", {{"render", "true"},
                                            {"symbol", std::to_string(i)},
                                            {"lower", to_text(ranges[i].low)},
                                            {"upper", to_text(ranges[i].high)},
                                            {"label", ranges[i].symbol.label}}),
                          "\n");
        symbols += symbol_of(mark, i, ranges[i].symbol);
    }
    return renderer({{"type", "graduatedSymbol"}, {"attr", column}, {"graduatedMethod", "GraduatedColor"}},
                    joined(element("ranges", {}, joined("\n", classes)), "\n"), symbols);
}

std::string categorised(Mark mark, std::string_view column, const std::vector<Category>& categories) {
    std::string classes;
    std::string symbols;
    for (std::size_t i = 0; i < categories.size(); ++i) {
        classes += joined(element("category", {{"render", "true"},
                                               {"symbol", std::to_string(i)},
                                               {"value", categories[i].value},
                                               {"label", categories[i].symbol.label}}),
                          "\n");
        symbols += symbol_of(mark, i, categories[i].symbol);
    }
    return renderer({{"type", "categorizedSymbol"}, {"attr", column}},
                    joined(element("categories", {}, joined("\n", classes)), "\n"), symbols);
}

std::string by_energy(Mark mark, std::string_view column, double least_size_mm, const Symbol* none) {
    std::vector<Range> ranges;
    if (none != nullptr) {
        ranges.push_back({0.0, 0.0, *none});
    }
    for (std::size_t i = 0; i < intensity_class_colours.size(); ++i) {
        const double low = i == 0 ? 0.0 : intensity_limits_kj[i - 1];
        const double high = i < intensity_limits_kj.size() ? intensity_limits_kj[i] : no_limit_kj;
        constexpr double per_mm = 100.0;  // no false digits, as in 1.9800000000000002
        const double size_mm =
            std::round(per_mm * least_size_mm * (1.0 + 0.6 * static_cast<double>(i))) / per_mm;
        ranges.push_back(
            {low,
             high,
             {report::message_text(intensity_class_names[i]), intensity_class_colours[i], size_mm}});
    }
    return graduated(mark, column, ranges);
}

}  // namespace coupling::qgis
