#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace coupling::report {

/// An attribute of an element: a text, which is escaped, or a coordinate as `place` writes it.
struct Attribute {
    std::string_view name;
    std::string value;

    Attribute(std::string_view of, std::string_view text) : name{of}, value{text} {}
    Attribute(std::string_view of, double coordinate);
};

using Attributes = std::vector<Attribute>;

/// An element of HTML, SVG or another XML without content: `<name a="b"/>`. An attribute with an empty text
/// is left out.
std::string element(std::string_view name, const Attributes& attributes);

/// An element with content, which is ready markup: `<name a="b">content</name>`.
std::string element(std::string_view name, const Attributes& attributes, std::string_view content);

// Shapes of SVG. The style is one or several classes.

std::string svg_path(std::string_view style, std::string_view commands);

/// Words with their baseline at a point, escaped; `more`: text-anchor, class, transform ...
std::string svg_text(double x, double y, std::string_view words, Attributes more = {});

/// A drawing that is read aloud by its label.
std::string svg_drawing(double width, double height, std::string_view label, std::string_view content);

/// What drawings of a page share by id; takes no room.
std::string svg_definitions(std::string_view content);

/// An entry of a legend in HTML: a sample of 30 by 14, and a name, which is ready HTML.
std::string legend_item(std::string_view sample, std::string_view name);

}  // namespace coupling::report
