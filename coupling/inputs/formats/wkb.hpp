#pragma once

#include <string>
#include <string_view>

namespace coupling::formats {

/// Well-known text of a geometry in well-known binary (ISO and the older form with flags of PostGIS): points,
/// lines, polygons and several of each, perhaps with heights and measures, of which the text keeps the
/// heights. Numbers are the shortest text that reads back the same.
///
/// Throws std::invalid_argument with what was found for other kinds (curves, collections), bytes that end too
/// early and nesting that no such geometry has; "" for an empty geometry.
std::string wkt_of_wkb(std::string_view bytes);

/// Writes coordinates into well-known text: one reader of shapes for all formats.
class WktText {
public:
    explicit WktText(std::string_view kind) : text_{kind} {}
    void open() {
        text_ += next_is_first_ ? "(" : ", (";
        next_is_first_ = true;
    }
    void close() {
        text_ += ')';
        next_is_first_ = false;
    }
    void point(double x, double y);
    void point(double x, double y, double z);
    [[nodiscard]] const std::string& text() const { return text_; }

private:
    void separate() {
        text_ += next_is_first_ ? "" : ", ";
        next_is_first_ = false;
    }
    std::string text_;
    bool next_is_first_ = true;
};

}  // namespace coupling::formats
