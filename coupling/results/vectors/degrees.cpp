#include "coupling/results/vectors/degrees.hpp"

#include "config/errors/input_error.hpp"
#include "config/text/formatted.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

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
    const std::string way = way_.name().empty() ? "PROJ" : way_.name();
    return accuracy_m ? report::page_text("Longitude and latitude (WGS 84) by {way}, accurate to {metres} m.",
                                          {{"way", way}, {"metres", report::exact(*accuracy_m)}})
                      : report::page_text("Longitude and latitude (WGS 84) by {way}, of unknown accuracy.",
                                          {{"way", way}});
}

}  // namespace coupling::vectors
