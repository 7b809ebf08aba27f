#include "coupling/results/text/element.hpp"

#include "config/text/joined.hpp"
#include "coupling/results/text/markup.hpp"

namespace coupling::report {

using config::joined;

namespace {

std::string opening(std::string_view name, const Attributes& attributes) {
    std::string text = joined("<", name);
    for (const Attribute& attribute : attributes) {
        if (!attribute.value.empty()) {
            text += joined(" ", attribute.name, "=\"", escaped(attribute.value), "\"");
        }
    }
    return text;
}

}  // namespace

Attribute::Attribute(std::string_view of, double coordinate) : name{of}, value{place(coordinate)} {}

std::string element(std::string_view name, const Attributes& attributes) {
    return joined(opening(name, attributes), "/>");
}

std::string element(std::string_view name, const Attributes& attributes, std::string_view content) {
    return joined(opening(name, attributes), ">", content, "</", name, ">");
}

std::string svg_path(std::string_view style, std::string_view commands) {
    return element("path", {{"class", style}, {"d", commands}});
}

std::string svg_text(double x, double y, std::string_view words, Attributes more) {
    more.insert(more.begin(), {{"x", x}, {"y", y}});
    return element("text", more, escaped(words));
}

std::string svg_drawing(double width, double height, std::string_view label, std::string_view content) {
    return element("svg",
                   {{"viewBox", joined("0 0 ", place(width), " ", place(height))},
                    {"role", "img"},
                    {"aria-label", label}},
                   content);
}

std::string svg_definitions(std::string_view content) {
    return element("svg",
                   {{"class", "definitions"}, {"width", 0.0}, {"height", 0.0}, {"aria-hidden", "true"}},
                   element("defs", {}, content));
}

std::string legend_item(std::string_view sample, std::string_view name) {
    const std::string drawing = element("svg", {{"viewBox", "0 0 30 14"}, {"aria-hidden", "true"}}, sample);
    return element("li", {}, joined(drawing, name));
}

}  // namespace coupling::report
