#include "coupling/results/vectors/gpx.hpp"

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/results/geopackage/layer_look.hpp"
#include "coupling/results/geopackage/stored_rows.hpp"
#include "coupling/results/text/element.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/vectors/degrees.hpp"
#include "coupling/results/vectors/layer_columns.hpp"

namespace coupling::vectors {
namespace {

using config::joined;
using geopackage::StoredGeometry;
using geopackage::StoredRows;
using geopackage::Vertex;
using geopackage::Written;
using report::element;
using report::escaped;

namespace fs = std::filesystem;

/// A place with what is inside it.
std::string gpx_place(const char* kind, const Vertex& corner, bool has_heights, const std::string& inside,
                      Degrees& degrees) {
    const Degrees::Place place = degrees.of(corner);
    const std::string elevation =
        has_heights ? element("ele", {}, config::to_text(corner.z_m)) : std::string{};
    return element(kind, {{"lat", place.latitude}, {"lon", place.longitude}}, joined(elevation, inside));
}

/// Name, description and type of a feature, and its fields.
std::string gpx_words(const geopackage::Plan& plan, const std::vector<std::string>& fields) {
    std::string words;
    std::string data;
    for (std::size_t i = 0; i < fields.size(); ++i) {
        if (fields[i].empty()) {
            continue;
        }
        words += joined(words.empty() ? "" : ", ", plan.columns[i].name, " ",
                        with_unit(fields[i], plan.columns[i]));
        data += element(joined("ogr:", plan.columns[i].name), {}, escaped(fields[i]));
    }
    return joined(
        element("name", {}, escaped(joined(geopackage::layer_title(plan), " ", name_of(plan, fields)))),
        element("desc", {}, escaped(words)), element("type", {}, escaped(plan.name)),
        element("extensions", {}, data));
}

std::string track(const geopackage::Plan& plan, const StoredRows& row, Degrees& degrees) {
    std::string segments;
    for (const StoredGeometry::Part& part : row.geometry().parts) {
        std::string places;
        for (const Vertex& corner : part.corners) {
            places += gpx_place("trkpt", corner, row.geometry().dimensions.z, "", degrees);
        }
        segments += element("trkseg", {}, places);
    }
    return joined(element("trk", {}, joined(gpx_words(plan, row.fields()), segments)), "\n");
}

}  // namespace

WrittenFile write_gpx(const fs::path& folder, geopackage::Database& database, std::span<const Written> layers,
                      const std::string& projection, const WriteWatch& watch) {
    OutFile out{folder / "results.gpx"};
    Degrees degrees{projection};
    const Tags gpx = tags_of("gpx", {{"version", "1.1"},
                                     {"creator", "bannwald"},
                                     {"xmlns", "http://www.topografix.com/GPX/1/1"},
                                     {"xmlns:ogr", "http://osgeo.org/gdal"}});
    out.stream() << xml_line << gpx.begin
                 << element("metadata", {}, element("desc", {}, escaped(degrees.way_in_words(layers))))
                 << "\n";
    for (const bool are_points : {true, false}) {  // the format wants waypoints first
        for (const Written& layer : layers) {
            if (!layer.plan.is_for_the_field) {
                continue;
            }
            watch(joined("results.gpx, ", layer.plan.name));
            for (StoredRows rows{database, layer.plan}; rows.next();) {
                const StoredGeometry& geometry = rows.geometry();
                if ((geometry.kind == StoredGeometry::Kind::point) != are_points) {
                    continue;
                }
                if (are_points) {
                    out.stream() << gpx_place("wpt", geometry.parts.front().corners.front(),
                                              geometry.dimensions.z, gpx_words(layer.plan, rows.fields()),
                                              degrees)
                                 << "\n";
                } else {
                    out.stream() << track(layer.plan, rows, degrees);
                }
            }
        }
    }
    out.stream() << gpx.end;
    out.close();
    return {"results.gpx", "Sources, targets, nets and trajectories for GPS devices."};
}

}  // namespace coupling::vectors
