#include "coupling/inputs/systems/transform_layer.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/systems/same_system.hpp"
#include "coupling/inputs/systems/system_way.hpp"

namespace coupling::systems {
namespace {

using config::joined;

constexpr double accurate_m = 5.0;  // [choice] the size of a cell

/// Two coordinates in a text of a shape, and where they stand.
struct PlaceInText {
    std::size_t begin = 0;
    std::size_t end = 0;  ///< behind the second one
    double x = 0.0;
    double y = 0.0;
};

bool begins_number(char c) {
    return std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '+' || c == '.';
}

/// The first two numbers of each point of well-known text. What is no shape is found by its reader later.
std::vector<PlaceInText> places_in(std::string_view text) {
    std::vector<PlaceInText> places;
    bool is_new = false;  // behind a bracket or a comma a point begins
    for (std::size_t at = 0; at < text.size();) {
        const char c = text[at];
        if (c == '(' || c == ',') {
            is_new = true;
            ++at;
            continue;
        }
        if (!is_new || !begins_number(c)) {
            is_new = is_new && std::isspace(static_cast<unsigned char>(c)) != 0;
            ++at;
            continue;
        }
        constexpr std::string_view ends = " \t\r\n,()";
        const std::size_t first_end = std::min(text.find_first_of(ends, at), text.size());
        const std::size_t second = std::min(text.find_first_not_of(" \t\r\n", first_end), text.size());
        const std::size_t second_end = std::min(text.find_first_of(ends, second), text.size());
        const auto x = config::parse_number(text.substr(at, first_end - at));
        const auto y = config::parse_number(text.substr(second, second_end - second));
        if (x && y) {
            places.push_back({at, second_end, *x, *y});
        }
        is_new = false;
        at = std::max(second_end, at + 1);
    }
    return places;
}

std::string rounded(double value) {
    constexpr double per_m = 1e4;
    return config::to_text(std::round(per_m * value) / per_m);
}

[[noreturn]] void refuse(const formats::Layer& layer, const std::string& target, const std::string& like,
                         const std::string& why) {
    config::fail(config::ExitCode::data, {layer.table.file()},
                 joined("coordinates in ", plausible::name_of_system(layer.projection), why),
                 joined("those of ", like, ", ", plausible::name_of_system(target),
                        ", or a system that PROJ can transform into it"),
                 "transform the layer (QGIS: Reproject layer), or give it its true system (QGIS: Assign "
                 "projection)");
}

/// A shape with other coordinates.
std::string with_places(std::string_view text, const std::vector<PlaceInText>& places,
                        const std::vector<PlaceInSystem>& coordinates) {
    std::string result;
    std::size_t at = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        result += joined(text.substr(at, places[i].begin - at), rounded(coordinates[i].x), " ",
                         rounded(coordinates[i].y));
        at = places[i].end;
    }
    return joined(result, text.substr(at));
}

}  // namespace

Transformed transform_layer(formats::Layer& layer, const std::string& target, const std::string& like) {
    SystemWay way{layer.projection, target};
    if (!way.is_known()) {
        refuse(layer, target, like, ", between which and that of the terrain no way is known");
    }
    config::Table& table = layer.table;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const std::string text = table.seen_text(row, "wkt");
        const std::vector<PlaceInText> places = places_in(text);
        std::vector<PlaceInSystem> coordinates;
        for (const PlaceInText& place : places) {
            const auto moved = way.at(place.x, place.y);
            if (!moved) {
                config::fail(config::ExitCode::data, table.place(row, "wkt"),
                             joined("a place ", config::to_text(place.x), " ", config::to_text(place.y),
                                    " outside the area of ", plausible::name_of_system(layer.projection)),
                             joined("coordinates of that system, to be transformed into ",
                                    plausible::name_of_system(target)),
                             "give the layer its true system (QGIS: Assign projection)");
            }
            coordinates.push_back(*moved);
        }
        table.set_text(row, "wkt", with_places(text, places, coordinates));
    }
    if (way.is_ballpark()) {
        refuse(layer, target, like, ", whose datum is not known");
    }
    const auto accuracy_m = way.accuracy_m();
    const std::string accuracy =
        accuracy_m ? joined("accurate to ", config::to_text(*accuracy_m), " m") : "of unknown accuracy";
    const std::string from = plausible::name_of_system(layer.projection);
    Transformed done;
    done.note = joined(table.file(), ": transformed from ", from, " to ", plausible::name_of_system(target),
                       " by ", way.name().empty() ? "PROJ" : way.name(), ", ", accuracy);
    if (!accuracy_m || *accuracy_m > accurate_m) {
        done.warning = joined("a transformation from ", from, " ", accuracy);
    }
    layer.projection = target;
    return done;
}

}  // namespace coupling::systems
