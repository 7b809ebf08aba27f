#include "coupling/inputs/places/shape_input.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "config/geometry/wkt.hpp"

namespace coupling {

namespace {

std::string in_words(const std::vector<config::Shape::Kind>& kinds) {
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

std::string advice_for(config::Shape::Kind kind) {
    return kind == config::Shape::Kind::point
               ? "make areas of the points (QGIS: Buffer), or draw lines"
               : "name a layer of the right kind, or convert it (QGIS: Polygons to lines; Lines to polygons)";
}

}  // namespace

std::optional<config::Shape> shape_of(const config::Table& table, std::size_t row,
                                      const std::vector<config::Shape::Kind>& allowed,
                                      config::Problems& problems) {
    const std::string& text = table.text(row, "wkt");
    config::Place start = table.place(row, "wkt");
    start.column += text.find(',') == std::string::npos ? 0 : 1;  // such a field stands in quotes
    try {
        config::Shape shape = config::read_wkt(text, start);
        if (std::find(allowed.begin(), allowed.end(), shape.kind) != allowed.end()) {
            return shape;
        }
        problems.add(config::ExitCode::data, start, config::in_quotes(text), in_words(allowed),
                     advice_for(shape.kind));
    } catch (const config::InputError& error) {
        problems.add(error);
    }
    return std::nullopt;
}

}  // namespace coupling
