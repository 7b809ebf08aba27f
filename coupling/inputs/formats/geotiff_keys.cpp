#include "coupling/inputs/formats/geotiff_keys.hpp"

#include <geo_normalize.h>
#include <geotiff.h>
#include <geovalues.h>
#include <xtiffio.h>

#include <array>
#include <cstdlib>
#include <memory>

#include "coupling/inputs/formats/system_text.hpp"

namespace coupling::formats {
namespace {

struct CloseKeys {
    void operator()(GTIF* keys) const { GTIFFree(keys); }
};

void say_nothing_of_keys(GTIF*, int, const char*, ...) {}

unsigned short short_key(GTIF* keys, geokey_t key) {
    unsigned short value = 0;
    return GTIFKeyGetSHORT(keys, key, &value, 0, 1) == 1 ? value : static_cast<unsigned short>(0);
}

/// Text of a key without what ArcGIS writes before it; empty where it is none of a coordinate system.
std::string system_in_citation(GTIF* keys, geokey_t key) {
    std::array<char, 8192> text{};
    if (GTIFKeyGetASCII(keys, key, text.data(), static_cast<int>(text.size()) - 1) == 0) {
        return {};
    }
    const std::string citation{text.data()};
    const std::string before = "ESRI PE String = ";
    if (!citation.starts_with(before)) {
        return {};
    }
    const std::string system = citation.substr(before.size());
    return system.ends_with('|') ? system.substr(0, system.size() - 1) : system;
}

std::string by_code(unsigned short code) {
    if (code == 0 || code == KvUserDefined) {
        return {};
    }
    const std::string number = std::to_string(code);
    const std::string text = esri_text_of("EPSG:" + number);
    return text.empty() ? esri_text_of("ESRI:" + number) : text;
}

std::string by_parameters(GTIF* keys) {
    const std::unique_ptr<GTIFDefn, void (*)(GTIFDefn*)> definition{GTIFAllocDefn(), GTIFFreeDefn};
    if (!definition || GTIFGetDefn(keys, definition.get()) == 0) {
        return {};
    }
    const std::unique_ptr<char, void (*)(char*)> of_proj{GTIFGetProj4Defn(definition.get()),
                                                         [](char* text) { GTIFFreeMemory(text); }};
    return of_proj && *of_proj != '\0' ? esri_text_of(std::string{of_proj.get()} + " +type=crs")
                                       : std::string{};
}

std::optional<HeightUnit> heights_by_keys(GTIF* keys) {
    const unsigned short system = short_key(keys, VerticalCSTypeGeoKey);
    if (system != 0 && system != KvUserDefined) {
        if (const auto unit = height_unit_of_system(system)) {
            return unit;
        }
    }
    const unsigned short unit = short_key(keys, VerticalUnitsGeoKey);
    return unit == 0 || unit == KvUserDefined ? std::nullopt : height_unit_of_unit(unit);
}

}  // namespace

GeoKeys read_geo_keys(tiff* file) {
    GeoKeys found;
    const std::unique_ptr<GTIF, CloseKeys> keys{GTIFNewEx(file, say_nothing_of_keys, nullptr)};
    if (!keys) {
        return found;
    }
    found.cells_are_points = short_key(keys.get(), GTRasterTypeGeoKey) == RasterPixelIsPoint;
    found.heights = heights_by_keys(keys.get());
    for (const geokey_t key : {PCSCitationGeoKey, GTCitationGeoKey}) {
        if (found.projection = system_in_citation(keys.get(), key); !found.projection.empty()) {
            return found;
        }
    }
    const unsigned short model = short_key(keys.get(), GTModelTypeGeoKey);
    if (model == ModelTypeProjected) {
        found.projection = by_code(short_key(keys.get(), ProjectedCSTypeGeoKey));
    } else if (model == ModelTypeGeographic) {
        found.projection = by_code(short_key(keys.get(), GeographicTypeGeoKey));
    }
    if (found.projection.empty() && (model == ModelTypeProjected || model == ModelTypeGeographic)) {
        found.projection = by_parameters(keys.get());
    }
    return found;
}

}  // namespace coupling::formats
