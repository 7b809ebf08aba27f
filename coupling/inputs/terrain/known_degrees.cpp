#include "coupling/inputs/terrain/known_degrees.hpp"

#include "config/options/options.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/scenario/output_settings.hpp"
#include "coupling/inputs/systems/same_system.hpp"
#include "coupling/inputs/systems/system_way.hpp"

namespace coupling {
namespace {

using config::joined;

void refuse_degrees(const std::string& found, const std::string& expected, Reading& reading) {
    const GisFiles& wanted = reading.output().gis;
    for (const auto& [is_wanted, key] :
         {std::pair{wanted.kml, "output.kml"}, std::pair{wanted.gpx, "output.gpx"}}) {
        if (is_wanted) {
            reading.problems().add(
                config::ExitCode::data, reading.settings().options->place_of(key), joined(key, found),
                expected,
                joined("give the heights their system (QGIS: Assign projection), or leave ", key, " out"));
        }
    }
}

}  // namespace

void check_degrees(const std::string& projection, const config::GridFrame& map, const std::string& file,
                   Reading& reading) {
    if (!reading.output().gis.wants_degrees()) {
        return;
    }
    if (projection.empty()) {
        refuse_degrees(joined(" with heights (", file, ") whose coordinate system is not known"),
                       "a .prj beside them, or a GeoTIFF that names its system", reading);
        return;
    }
    systems::SystemWay way{projection, systems::wgs84_system};
    const bool is_known = way.is_known() && way.at(map.x_west_m, map.y_south_m) &&
                          way.at(map.x_west_m, map.y_north_m()) && way.at(map.x_east_m(), map.y_south_m) &&
                          way.at(map.x_east_m(), map.y_north_m());
    if (!is_known || way.is_ballpark()) {
        refuse_degrees(joined(" with heights (", file, ") in ", plausible::name_of_system(projection),
                              ", from which no way to longitude and latitude (WGS 84) is known"),
                       "a system that PROJ can transform", reading);
        return;
    }
    const auto accuracy_m = way.accuracy_m();
    reading.note(joined("longitude and latitude (results.kmz, results.gpx) by ",
                        way.name().empty() ? "PROJ" : way.name(), ", ",
                        accuracy_m ? joined("accurate to ", config::to_text(*accuracy_m), " m")
                                   : std::string{"of unknown accuracy"}));
}

}  // namespace coupling
