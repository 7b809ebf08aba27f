#include "coupling/inputs/formats/geojson_layer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "config/text/reading.hpp"
#include "coupling/inputs/formats/json_library.hpp"
#include "coupling/inputs/formats/system_text.hpp"
#include "coupling/inputs/formats/wkb.hpp"

namespace coupling::formats {
namespace {

using config::joined;

/// Whether all coordinates so far can be degrees.
struct Range {
    bool can_be_degrees = true;
    void take(double x, double y) {
        can_be_degrees = can_be_degrees && std::abs(x) <= 180.0 && std::abs(y) <= 90.0;
    }
};

void write_point(const Json& point, WktText& text, Range& range) {
    if (!point.is_array() || point.size() < 2 || !point[0].is_number() || !point[1].is_number()) {
        throw std::invalid_argument{"coordinates that are no numbers"};
    }
    const auto x = point[0].get<double>();
    const auto y = point[1].get<double>();
    if (!std::isfinite(x) || !std::isfinite(y)) {
        throw std::invalid_argument{"coordinates that are no numbers"};
    }
    range.take(x, y);
    point.size() > 2 && point[2].is_number() ? text.point(x, y, point[2].get<double>()) : text.point(x, y);
}

/// Coordinates nested `depth` arrays deep around points.
void write_nested(const Json& coordinates, int depth, WktText& text, Range& range) {
    if (depth == 0) {
        write_point(coordinates, text, range);
        return;
    }
    if (!coordinates.is_array()) {
        throw std::invalid_argument{"coordinates that are no list"};
    }
    text.open();
    for (const Json& inner : coordinates) {
        write_nested(inner, depth - 1, text, range);
    }
    text.close();
}

std::string text_of(const Json& object, const char* key) {
    const auto found = object.find(key);
    return found != object.end() && found->is_string() ? found->get<std::string>() : std::string{};
}

std::string wkt_of_json(const Json& geometry, Range& range) {
    if (geometry.is_null()) {
        return {};
    }
    struct Kind {
        const char* name;
        const char* wkt;
        int depth;
    };
    constexpr std::array kinds{
        Kind{"Point", "POINT", 0},           Kind{"MultiPoint", "MULTIPOINT", 1},
        Kind{"LineString", "LINESTRING", 1}, Kind{"MultiLineString", "MULTILINESTRING", 2},
        Kind{"Polygon", "POLYGON", 2},       Kind{"MultiPolygon", "MULTIPOLYGON", 3}};
    const std::string type = geometry.is_object() ? text_of(geometry, "type") : "";
    const auto kind = std::find_if(kinds.begin(), kinds.end(), [&](const Kind& k) { return type == k.name; });
    if (kind == kinds.end() || !geometry.contains("coordinates")) {
        throw std::invalid_argument{"geometry " + config::in_quotes(type)};
    }
    const Json& coordinates = geometry["coordinates"];
    if (coordinates.is_array() && coordinates.empty()) {
        return {};
    }
    WktText text{joined(kind->wkt, " ")};
    if (kind->depth == 0) {
        text.open();
        write_point(coordinates, text, range);
        text.close();
    } else {
        write_nested(coordinates, kind->depth, text, range);
    }
    return text.text();
}

std::string cell_of(const Json& value) {
    if (value.is_string()) {
        return value.get<std::string>();
    }
    if (value.is_boolean()) {
        return value.get<bool>() ? "yes" : "no";
    }
    if (value.is_number_float()) {
        const auto number = value.get<double>();
        return std::isfinite(number) ? config::to_text(number) : std::string{};
    }
    return value.is_number() ? value.dump() : std::string{};  // neither null nor lists are one value
}

/// "urn:ogc:def:crs:EPSG::31254" and "EPSG:31254".
std::string code_of(const std::string& name) {
    const std::size_t last = name.find_last_of(':');
    if (last == std::string::npos) {
        return {};
    }
    const std::string number = name.substr(last + 1);
    const bool is_number =
        !number.empty() && number.size() < 8 &&
        std::all_of(number.begin(), number.end(), [](char c) { return c >= '0' && c <= '9'; });
    return is_number && name.find("EPSG") != std::string::npos ? "EPSG:" + number
           : number == "CRS84"                                 ? "EPSG:4326"
                                                               : "";
}

std::string projection_of(const Json& collection, const Range& range, const std::string& file) {
    const auto crs = collection.find("crs");
    if (crs == collection.end() || crs->is_null()) {
        return range.can_be_degrees ? esri_text_of("EPSG:4326") : std::string{};
    }
    const auto properties = crs->is_object() ? crs->find("properties") : crs->end();
    const std::string name = crs->is_object() && properties != crs->end() && properties->is_object()
                                 ? text_of(*properties, "name")
                                 : "";
    const std::string text = esri_text_of(code_of(name));
    if (text.empty()) {
        config::fail(config::ExitCode::data, {file}, joined("crs ", config::in_quotes(name)),
                     "a system with a code of EPSG", "export the layer in the system of the terrain");
    }
    return text;
}

Json parsed(std::string_view text, const std::string& file) {
    try {
        return Json::parse(text.begin(), text.end());
    } catch (const Json::parse_error& error) {
        const std::size_t at = std::min<std::size_t>(error.byte > 0 ? error.byte - 1 : 0, text.size());
        config::fail(config::ExitCode::data, config::place_in(text, at, {file, 1, 1}),
                     "no valid JSON from here on", "a complete GeoJSON", "copy or export the file again");
    } catch (const Json::exception&) {
        config::fail(config::ExitCode::data, {file}, "a number that is too large", "numbers of coordinates");
    }
}

}  // namespace

bool is_geojson(std::string_view text) {
    return config::trimmed(config::without_byte_order_mark(text.substr(0, 4096))).starts_with('{');
}

Layer read_geojson(std::string_view bytes, const std::string& file) {
    const Json collection = parsed(config::checked_text(bytes, file), file);
    const std::string type = collection.is_object() ? text_of(collection, "type") : "";
    const auto list = collection.is_object() ? collection.find("features") : collection.end();
    const bool is_collection = type == "FeatureCollection" && list != collection.end() && list->is_array();
    if (!is_collection && type != "Feature") {
        config::fail(config::ExitCode::data, {file}, joined("JSON of the type ", config::in_quotes(type)),
                     "a FeatureCollection of GeoJSON", "export the layer again (QGIS: Save features as)");
    }
    std::vector<const Json*> items;
    if (is_collection) {
        for (const Json& feature : *list) {
            items.push_back(&feature);
        }
    } else {
        items.push_back(&collection);
    }
    config::Features features{.file = file, .columns = {"wkt"}, .cells = {}, .numbers = {}};
    std::map<std::string, std::size_t> place_of;
    Range range;
    config::Problems problems;
    constexpr std::size_t most_problems = 100;
    for (std::size_t i = 0; i < items.size() && problems.list().size() < most_problems; ++i) {
        const Json& feature = *items[i];
        const auto number = static_cast<std::uint32_t>(i + 1);
        std::vector<std::string> cells(features.columns.size());
        try {
            if (!feature.is_object()) {
                throw std::invalid_argument{"a feature that is none"};
            }
            const auto geometry = feature.find("geometry");
            cells[0] = geometry == feature.end() ? std::string{} : wkt_of_json(*geometry, range);
        } catch (const std::invalid_argument& error) {
            problems.add(config::ExitCode::data, {file, number, 1}, error.what(), "points, lines or polygons",
                         "export the layer again (QGIS: Save features as)");
            continue;
        }
        const auto properties = feature.find("properties");
        if (properties != feature.end() && properties->is_object()) {
            for (const auto& [name, value] : properties->items()) {
                const auto [place, is_new] = place_of.try_emplace(name, features.columns.size());
                if (is_new && features.columns.size() >= config::Table::most_columns) {
                    config::fail(config::ExitCode::data, {file}, "features of more than 1000 properties",
                                 "a layer of at most so many columns");
                }
                if (is_new) {
                    features.add_column(name);
                }
                cells.resize(std::max(cells.size(), place->second + 1));
                cells[place->second] = cell_of(value);
            }
        }
        features.cells.push_back(std::move(cells));
        features.numbers.push_back(number);
    }
    problems.throw_if_any();
    return {config::Table::of(std::move(features)), projection_of(collection, range, file)};
}

}  // namespace coupling::formats
