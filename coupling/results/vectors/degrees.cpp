#include "coupling/results/vectors/degrees.hpp"

#include <array>
#include <charconv>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"

namespace coupling::vectors {
namespace {

using config::joined;

std::string in_degrees(double value) {
    constexpr int decimals = 8;
    std::array<char, 32> text{};
    const auto result =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, decimals);
    return {text.data(), result.ptr};
}

}  // namespace

Degrees::Degrees(const std::string& projection) : way_{projection, systems::wgs84_system} {
    if (!way_.is_known()) {
        config::fail(config::ExitCode::data, {}, "a map from which no way to longitude and latitude is known",
                     "a system that PROJ can transform", "leave output.kml and output.gpx out");
    }
}

Degrees::Place Degrees::of(const geopackage::Vertex& corner) {
    const auto place = way_.at(corner.x_m, corner.y_m);
    if (!place) {
        config::fail(config::ExitCode::data, {},
                     joined("a place ", config::to_text(corner.x_m), " ", config::to_text(corner.y_m),
                            " without longitude and latitude"),
                     "places in the area of the map's system", "leave output.kml and output.gpx out");
    }
    return {in_degrees(place->x), in_degrees(place->y)};
}

std::string Degrees::way_in_words(std::span<const geopackage::Written> layers) {
    for (const geopackage::Written& layer : layers) {
        if (!layer.extent.empty) {
            (void)of({layer.extent.low_x_m, layer.extent.low_y_m});
            (void)of({layer.extent.high_x_m, layer.extent.high_y_m});
        }
    }
    const auto accuracy_m = way_.accuracy_m();
    return joined("Longitude and latitude (WGS 84) by ", way_.name().empty() ? "PROJ" : way_.name(), ", ",
                  accuracy_m ? joined("accurate to ", config::to_text(*accuracy_m), " m.")
                             : std::string{"of unknown accuracy."});
}

}  // namespace coupling::vectors
