#include "coupling/results/vectors/degrees.hpp"

#include "config/errors/input_error.hpp"
#include "config/text/formatted.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"

namespace coupling::vectors {
namespace {

using config::joined;

constexpr int degree_decimals = 8;  // about a millimetre

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
    return {config::with_decimals(place->x, degree_decimals),
            config::with_decimals(place->y, degree_decimals)};
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
