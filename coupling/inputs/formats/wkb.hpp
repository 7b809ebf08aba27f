#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace coupling::formats {

/// A shape of a kind that nothing here can stand for: which, and how to turn it into one that is read.
class OtherKindOfShape : public std::invalid_argument {
public:
    OtherKindOfShape(const std::string& found, std::string advice)
        : std::invalid_argument{found}, advice_{std::move(advice)} {}
    [[nodiscard]] const std::string& advice() const { return advice_; }

private:
    std::string advice_;
};

/// Well-known text of a geometry in well-known binary (ISO and the older form with flags of PostGIS): points,
/// lines, polygons, curves, surfaces and several of each, perhaps with heights and measures, of which the
/// text keeps the heights. Arcs stay arcs: the reader of the text strokes them. Empty parts are left out.
/// Numbers are the shortest text that reads back the same.
///
/// Throws OtherKindOfShape for collections, TIN and the like, else std::invalid_argument with what was found:
/// bytes that end too early and nesting that no such geometry has; "" for an empty geometry.
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
    /// Begins a member that needs its name: `CIRCULARSTRING Z `; its bracket follows.
    void name(std::string_view kind, bool has_z);
    void point(double x, double y);
    void point(double x, double y, double z);
    [[nodiscard]] const std::string& text() const { return text_; }

    /// How far the text is, to come back to.
    struct Mark {
        std::size_t size = 0;
        bool next_is_first = true;
    };
    [[nodiscard]] Mark mark() const { return {text_.size(), next_is_first_}; }
    void back_to(const Mark& mark) {
        text_.resize(mark.size);
        next_is_first_ = mark.next_is_first;
    }

private:
    void separate() {
        text_ += next_is_first_ ? "" : ", ";
        next_is_first_ = false;
    }
    std::string text_;
    bool next_is_first_ = true;
};

}  // namespace coupling::formats
