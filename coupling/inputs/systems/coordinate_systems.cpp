#include "coupling/inputs/systems/coordinate_systems.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "config/text/reading.hpp"
#include "coupling/inputs/formats/system_scale.hpp"

namespace coupling::plausible {
namespace {

using config::joined;

constexpr double km = 1000.0;

constexpr KnownSystem system_row(std::string_view name, int epsg, double meridian_deg, double easting_m,
                                 double northing_m, Extent area_km, std::string_view needs = "") {
    return {name,
            epsg,
            needs,
            meridian_deg,
            easting_m,
            northing_m,
            {km * area_km.west_m, km * area_km.east_m, km * area_km.south_m, km * area_km.north_m}};
}

constexpr double west_meridian_deg = 10.0 + 1.0 / 3.0;
constexpr double central_meridian_deg = 13.0 + 1.0 / 3.0;
constexpr double east_meridian_deg = 16.0 + 1.0 / 3.0;

/// Of two rows with the same parameters the one that `needs` a text comes first. WGS 84 / UTM begins at 600
/// km north (5 degrees): below lie the northings of the national systems, and nothing that Bannwald is made
/// for.
constexpr std::array systems{
    system_row("MGI / Austria Lambert", 31287, central_meridian_deg, 400e3, 400e3, {100, 700, 270, 580}),
    system_row("MGI / Austria GK West", 31254, west_meridian_deg, 0.0, -5e6, {-70, 120, 180, 280}),
    system_row("MGI / Austria GK Central", 31255, central_meridian_deg, 0.0, -5e6, {-120, 120, 140, 410}),
    system_row("MGI / Austria GK East", 31256, east_meridian_deg, 0.0, -5e6, {-120, 70, 150, 440}),
    system_row("MGI / Austria GK M28", 31257, west_meridian_deg, 150e3, -5e6, {80, 270, 180, 280}),
    system_row("MGI / Austria GK M31", 31258, central_meridian_deg, 450e3, -5e6, {330, 570, 140, 410}),
    system_row("MGI / Austria GK M34", 31259, east_meridian_deg, 750e3, -5e6, {630, 820, 150, 440}),
    system_row("MGI / Austria M28", 31284, west_meridian_deg, 150e3, 0.0, {80, 270, 5180, 5280}),
    system_row("MGI / Austria M31", 31285, central_meridian_deg, 450e3, 0.0, {330, 570, 5140, 5410}),
    system_row("MGI / Austria M34", 31286, east_meridian_deg, 750e3, 0.0, {630, 820, 5150, 5440}),
    system_row("CH1903 / LV03", 21781, 7.439583, 600e3, 200e3, {480, 840, 70, 300}),
    system_row("CH1903+ / LV95", 2056, 7.439583, 2600e3, 1200e3, {2480, 2840, 1070, 1300}),
    system_row("DHDN / Gauss-Kruger zone 2", 31466, 6.0, 2500e3, 0.0, {2490, 2620, 5440, 5970}),
    system_row("DHDN / Gauss-Kruger zone 3", 31467, 9.0, 3500e3, 0.0, {3380, 3620, 5230, 6110}),
    system_row("DHDN / Gauss-Kruger zone 4", 31468, 12.0, 4500e3, 0.0, {4380, 4620, 5250, 6060}),
    system_row("DHDN / Gauss-Kruger zone 5", 31469, 15.0, 5500e3, 0.0, {5380, 5420, 5370, 5430}),
    system_row("RGF93 / Lambert-93", 2154, 3.0, 700e3, 6600e3, {0, 1330, 6000, 7240}),
    system_row("NTF / Lambert II", 27572, 0.0, 600e3, 2200e3, {0, 1090, 1700, 2710}),
    system_row("Monte Mario / Italy zone 1", 3003, 9.0, 1500e3, 0.0, {1220, 1770, 4040, 5220}),
    system_row("Monte Mario / Italy zone 2", 3004, 15.0, 2520e3, 0.0, {2240, 2890, 3840, 5230}),
    system_row("Slovene National Grid", 3794, 15.0, 500e3, -5e6, {370, 630, 30, 200}),
    system_row("ETRS89 / UTM zone 31N", 25831, 3.0, 500e3, 0.0, {0, 1000, 3800, 9400}, "ETRS"),
    system_row("ETRS89 / UTM zone 32N", 25832, 9.0, 500e3, 0.0, {0, 1000, 3800, 9400}, "ETRS"),
    system_row("ETRS89 / UTM zone 33N", 25833, 15.0, 500e3, 0.0, {0, 1000, 3800, 9400}, "ETRS"),
    system_row("UTM zone 31N", 32631, 3.0, 500e3, 0.0, {0, 1000, 700, 9400}),
    system_row("UTM zone 32N", 32632, 9.0, 500e3, 0.0, {0, 1000, 700, 9400}),
    system_row("UTM zone 33N", 32633, 15.0, 500e3, 0.0, {0, 1000, 700, 9400}),
};

/// Strips are used beyond their borders to the east and west (East Tyrol in GK West), hardly to the north.
constexpr double slack_east_m = 100.0 * km;
constexpr double slack_north_m = 30.0 * km;

std::string letters_in_lower_case(std::string_view word) {
    std::string letters;
    for (const char c : word) {
        const auto byte = static_cast<unsigned char>(c);
        if (std::isalnum(byte) != 0) {
            letters += static_cast<char>(std::tolower(byte));
        }
    }
    return letters;
}

/// An element of well-known text: NAME["text",number,...] and how deep it stands.
struct Element {
    std::string keyword;  ///< lower case letters
    std::string text;     ///< the first field in quotes
    std::string after;    ///< the field after that
    std::string third;    ///< and the one after that
    int depth = 0;
};

/// The field at the place, to the next comma or bracket outside quotes; quotes are left out.
std::string field_at(std::string_view text, std::size_t& at) {
    std::string field;
    bool quoted = false;
    for (; at < text.size(); ++at) {
        const char c = text[at];
        if (c == '"') {
            quoted = !quoted;
        } else if (!quoted && (c == ',' || c == '[' || c == ']' || c == '(' || c == ')')) {
            break;
        } else if (quoted || std::isspace(static_cast<unsigned char>(c)) == 0) {
            field += c;
        }
    }
    return field;
}

std::vector<Element> elements_of(std::string_view text) {
    std::vector<Element> elements;
    int depth = 0;
    for (std::size_t at = 0; at < text.size(); ++at) {
        const std::string word = field_at(text, at);
        if (at >= text.size()) {
            break;
        }
        if (text[at] == '[' || text[at] == '(') {
            ++depth;
            Element element{letters_in_lower_case(word), "", "", "", depth};
            std::size_t inside = at + 1;
            element.text = field_at(text, inside);
            if (inside < text.size() && text[inside] == ',') {
                ++inside;
                element.after = field_at(text, inside);
            }
            if (inside < text.size() && text[inside] == ',') {
                ++inside;
                element.third = field_at(text, inside);
            }
            elements.push_back(std::move(element));
        } else if (text[at] == ']' || text[at] == ')') {
            --depth;
        }
    }
    return elements;
}

bool is_one_of(const std::string& word, std::initializer_list<std::string_view> words) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

void take_parameter(const Element& element, Projection& projection) {
    const std::string name = letters_in_lower_case(element.text);
    const auto value = config::parse_number(element.after);
    if (!value) {
        return;
    }
    if (is_one_of(name, {"falseeasting", "eastingatfalseorigin", "eastingatprojectioncentre"})) {
        projection.false_easting = value;
    } else if (is_one_of(name, {"falsenorthing", "northingatfalseorigin", "northingatprojectioncentre"})) {
        projection.false_northing = value;
    } else if (is_one_of(name, {"centralmeridian", "longitudeofcenter", "longitudeoforigin",
                                "longitudeofcentre", "longitudeofnaturalorigin", "longitudeoffalseorigin",
                                "longitudeofprojectioncentre"})) {
        projection.central_meridian_deg = value;
    } else if (is_one_of(name, {"latitudeoforigin", "latitudeofcenter", "latitudeofcentre",
                                "latitudeofnaturalorigin", "latitudeoffalseorigin",
                                "latitudeofprojectioncentre"})) {
        projection.latitude_of_origin_deg = value;
    } else if (is_one_of(name,
                         {"scalefactor", "scalefactoratnaturalorigin", "scalefactorattheprojectioncentre",
                          "scalefactoratprojectioncentre", "scalefactoroninitialline"})) {
        projection.scale = value;
    }
}

/// The code of EPSG of the system itself: that of its datum stands deeper.
std::optional<int> epsg_of(const Element& element) {
    constexpr double largest = 1e6;
    const auto code = config::parse_number(element.after);
    return element.text == "EPSG" && code && *code > 0.0 && *code < largest
               ? std::optional{static_cast<int>(*code)}
               : std::nullopt;
}

Extent with_slack(const Extent& extent) {
    return {extent.west_m - slack_east_m, extent.east_m + slack_east_m, extent.south_m - slack_north_m,
            extent.north_m + slack_north_m};
}

std::string name_with_code(const KnownSystem& system) {
    return joined(system.name, " (EPSG ", std::to_string(system.epsg), ")");
}

bool is_projection_file(const std::string& file) {
    return config::in_lower_case(file).ends_with(".prj");
}

/// What to do where a system is not that of the coordinates: it stands in a file of its own, or in that of
/// the heights.
std::string other_system(const Extent& extent, const std::string& file) {
    const std::string fitting = systems_around(extent);
    const std::string fits = fitting.empty() ? "" : joined(": the coordinates would fit ", fitting);
    if (is_projection_file(file)) {
        return joined("replace ", file, fits, ", or delete it: the results then name no projection");
    }
    return joined(
        "give ", file, " its own system", fits,
        ", or correct its corner; for local coordinates take the system off (gdal_translate -of AAIGrid ",
        file, " local.asc, and take local.prj away): the results then name no projection");
}

/// The command that makes metres of degrees: UTM in the zone of the middle. Polar regions have none.
std::string transform_from_degrees(const Extent& degrees, const std::string& file) {
    constexpr double degrees_of_zone = 6.0;
    constexpr int zones = 60;
    constexpr double northernmost_deg = 84.0;
    const double longitude_deg = (degrees.west_m + degrees.east_m) / 2.0;
    const double latitude_deg = (degrees.south_m + degrees.north_m) / 2.0;
    if (std::abs(latitude_deg) > northernmost_deg) {
        return "transform them to the national system or to UTM (QGIS: Warp; gdalwarp -t_srs)";
    }
    const int zone = 1 + static_cast<int>(std::floor((longitude_deg + 180.0) / degrees_of_zone));
    const int code = (latitude_deg < 0.0 ? 32700 : 32600) + (zone - 1 + zones) % zones + 1;
    return joined("transform them to the national system or to UTM (QGIS: Warp; gdalwarp -t_srs EPSG:",
                  std::to_string(code), " -r bilinear -dstnodata -9999 ",
                  is_projection_file(file) ? "IN" : file, " dem.tif)");
}

constexpr const char* transform_heights =
    "transform them to the national system or to UTM (QGIS: Warp; gdalwarp -t_srs EPSG:25832, for example)";

}  // namespace

std::span<const KnownSystem> known_systems() {
    return systems;
}

std::optional<Projection> read_projection(std::string_view text) {
    const std::vector<Element> elements = elements_of(text);
    const auto root = std::find_if(elements.begin(), elements.end(), [](const Element& element) {
        return is_one_of(element.keyword, {"projcs", "projcrs", "projectedcrs", "geogcs", "geogcrs",
                                           "geographiccrs", "geodcrs"});
    });
    if (root == elements.end() || root->text.empty()) {
        return std::nullopt;
    }
    Projection projection;
    projection.name = root->text;
    projection.is_geographic = root->keyword.starts_with("geo");
    // The unit of WKT 1 stands beside the parameters, that of WKT 2 in the axes or beside them.
    for (auto element = std::next(root); element != elements.end() && element->depth > root->depth;
         ++element) {
        if (element->keyword == "parameter") {
            take_parameter(*element, projection);
        } else if (is_one_of(element->keyword, {"unit", "lengthunit"}) && element->depth == root->depth + 1) {
            projection.metres_per_unit = config::parse_number(element->after);
        } else if (is_one_of(element->keyword, {"spheroid", "ellipsoid"}) && !projection.major_axis_m) {
            projection.major_axis_m = config::parse_number(element->after);
            projection.inverse_flattening = config::parse_number(element->third);
        } else if (is_one_of(element->keyword, {"authority", "id"}) && element->depth == root->depth + 1) {
            projection.epsg = epsg_of(*element);
        }
    }
    return projection;
}

const KnownSystem* system_of(const Projection& projection, std::string_view text) {
    constexpr double near_deg = 0.01;
    constexpr double near_m = 1.0;
    if (!projection.central_meridian_deg || !projection.false_easting || !projection.false_northing) {
        return nullptr;
    }
    const auto found = std::find_if(systems.begin(), systems.end(), [&](const KnownSystem& system) {
        return std::abs(*projection.central_meridian_deg - system.central_meridian_deg) < near_deg &&
               std::abs(*projection.false_easting - system.false_easting_m) < near_m &&
               std::abs(*projection.false_northing - system.false_northing_m) < near_m &&
               text.find(system.needs) != std::string_view::npos;
    });
    return found == systems.end() ? nullptr : &*found;
}

std::string systems_around(const Extent& extent) {
    constexpr std::size_t most = 3;
    std::string names;
    std::size_t count = 0;
    for (const KnownSystem& system : systems) {
        if (system.area.covers(extent) && system.needs.empty() && count++ < most) {
            names += joined(names.empty() ? "" : " or ", name_with_code(system));
        }
    }
    return names;
}

std::optional<Contradiction> contradiction_of(std::string_view text, const Extent& extent,
                                              const std::string& file) {
    const auto projection = read_projection(text);
    if (!projection) {
        return std::nullopt;
    }
    const std::string name = config::in_quotes(projection->name);
    const std::string coordinates =
        joined("coordinates of ", in_words(extent), " with the projection ", name);
    if (projection->is_geographic) {
        const Extent degrees{-360.0, 360.0, -90.0, 90.0};
        return degrees.covers(extent)
                   ? Contradiction{coordinates, "metres of a projected system, not degrees",
                                   transform_from_degrees(extent, file)}
                   : Contradiction{coordinates, "degrees with this geographic system",
                                   other_system(extent, file)};
    }
    constexpr double near_metre = 1e-6;
    if (projection->metres_per_unit && std::abs(*projection->metres_per_unit - 1.0) > near_metre) {
        return Contradiction{joined("the projection ", name, " in units of ",
                                    config::to_text(*projection->metres_per_unit), " m"),
                             "coordinates in metres", "transform all maps to a system in metres"};
    }
    const KnownSystem* const system = system_of(*projection, text);
    if (system == nullptr || with_slack(system->area).covers(extent)) {
        return std::nullopt;
    }
    return Contradiction{coordinates, joined("for ", system->name, " about ", in_words(system->area)),
                         other_system(extent, file)};
}

std::optional<formats::HeightUnit> height_unit_in(std::string_view text) {
    const std::vector<Element> elements = elements_of(text);
    const auto root = std::find_if(elements.begin(), elements.end(), [](const Element& element) {
        return is_one_of(element.keyword, {"vertcs", "vertcrs", "verticalcrs"});
    });
    if (root == elements.end()) {
        return std::nullopt;
    }
    std::optional<double> metres;
    bool is_depth = false;
    for (auto element = std::next(root); element != elements.end() && element->depth > root->depth;
         ++element) {
        const std::string name = letters_in_lower_case(element->text);
        if (is_one_of(element->keyword, {"unit", "lengthunit"})) {
            metres = config::parse_number(element->after);
        } else if (element->keyword == "axis") {
            is_depth = is_depth || letters_in_lower_case(element->after) == "down";
        } else if (element->keyword == "parameter" && name == "direction") {
            is_depth = is_depth || config::parse_number(element->after).value_or(1.0) < 0.0;
        }
    }
    return metres && *metres > 0.0 ? std::optional{formats::HeightUnit{root->text, *metres, is_depth}}
                                   : std::nullopt;
}

std::optional<Contradiction> contradiction_of_heights(const formats::HeightUnit& unit) {
    if (unit.is_metres_upwards()) {
        return std::nullopt;
    }
    const std::string name = config::in_quotes(unit.name);
    if (unit.is_depth) {
        return Contradiction{joined("depths, as ", name, " says"), "heights, which grow upwards",
                             "change their sign, and take the system of depths off"};
    }
    const std::string metres = config::to_text(std::round(1e6 * unit.metres) / 1e6);
    return Contradiction{
        joined("heights in units of ", metres, " m, as ", name, " says"), "heights in metres",
        joined(
            "multiply the heights by ", metres,
            " (QGIS: Raster calculator) and write them without that unit; if they are metres already, take "
            "the unit off (gdal_translate -a_srs EPSG:..., with the code of the plan alone)")};
}

std::optional<MapScale> contradiction_of_scale(const std::string& text, const std::string& file,
                                               const Extent& extent) {
    constexpr double refused = 0.01;
    constexpr double warned = 0.003;
    const auto scale = formats::system_scale(text, 0.5 * (extent.west_m + extent.east_m),
                                             0.5 * (extent.south_m + extent.north_m));
    if (!scale) {
        return std::nullopt;
    }
    const double off = std::max(std::abs(scale->longest - 1.0), std::abs(scale->shortest - 1.0));
    if (off < warned) {
        return std::nullopt;
    }
    const double worst = off == std::abs(scale->longest - 1.0) ? scale->longest : scale->shortest;
    const auto projection = read_projection(text);
    const std::string found = joined(
        "the projection ", config::in_quotes(projection ? projection->name : std::string{}),
        ", on which a metre of this slope measures ", config::to_text(std::round(1e4 * worst) / 1e4), " m");
    // Nothing of a national system lies so near to (0, 0): a local frame that carries one.
    constexpr double local_m = 20.0 * km;
    const bool is_local = std::max({std::abs(extent.west_m), std::abs(extent.east_m),
                                    std::abs(extent.south_m), std::abs(extent.north_m)}) < local_m;
    if (off >= refused) {
        return MapScale{true,
                        {found, "a system that keeps lengths to a per cent",
                         is_local ? other_system(extent, file) : transform_heights}};
    }
    return MapScale{false, {found, "a system that keeps lengths to 0.3 %", transform_heights}};
}

}  // namespace coupling::plausible
