#include "config/table/shape_field.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "config/geometry/wkt.hpp"

namespace config {

namespace {

std::string advice_for(Shape::Kind kind) {
    return kind == Shape::Kind::point
               ? "make areas of the points (QGIS: Buffer), or draw lines"
               : "name a layer of the right kind, or convert it (QGIS: Polygons to lines; Lines to polygons)";
}

}  // namespace

std::string kinds_in_words(const std::vector<Shape::Kind>& kinds) {
    constexpr std::array names{"points", "lines", "polygons"};
    std::string text;
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        text += (i == 0                  ? ""
                 : i + 1 == kinds.size() ? " or "
                                         : ", ") +
                std::string{names[static_cast<std::size_t>(kinds[i])]};
    }
    return text;
}

std::optional<Shape> shape_of(const Table& table, std::size_t row, const std::vector<Shape::Kind>& allowed,
                              Problems& problems) {
    const std::string& text = table.text(row, "wkt");
    Place start = table.place(row, "wkt");
    start.column += text.find(',') == std::string::npos ? 0 : 1;  // such a field stands in quotes
    try {
        Shape shape = read_wkt(text, start);
        if (std::find(allowed.begin(), allowed.end(), shape.kind) != allowed.end()) {
            return shape;
        }
        problems.add(ExitCode::data, start, in_quotes(text), kinds_in_words(allowed), advice_for(shape.kind));
    } catch (const InputError& error) {
        problems.add(error);
    }
    return std::nullopt;
}

}  // namespace config
