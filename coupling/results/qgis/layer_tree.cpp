#include "coupling/results/qgis/layer_tree.hpp"

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/results/text/element.hpp"
#include "coupling/results/text/markup.hpp"

namespace coupling::qgis {
namespace {

using config::joined;
using report::Attributes;
using report::element;
using report::escaped;
using LayerKind = TreeLayer::Kind;

/// Identifiers are numbers in the order of the tree: the same results give the same file.
std::string id_of(std::size_t number) {
    return joined("bannwald_", std::to_string(number));
}

const char* checked(bool shown) {
    return shown ? "Qt::Checked" : "Qt::Unchecked";
}

const char* provider_of(LayerKind kind) {
    return kind == LayerKind::raster ? "gdal" : "ogr";
}

const char* flag(bool is_set) {
    return is_set ? "1" : "0";
}

/// Where QGIS keeps what plugins know of a layer or group, and wants to find it.
std::string no_properties() {
    return element("customproperties", {});
}

std::string branch(const TreeGroup& group, std::size_t& number) {
    std::string content = joined(no_properties(), "\n");
    for (const TreeLayer& layer : group.layers) {
        content += joined(element("layer-tree-layer",
                                  {{"id", id_of(number++)},
                                   {"name", layer.title},
                                   {"source", layer.source},
                                   {"providerKey", provider_of(layer.kind)},
                                   {"checked", checked(layer.shown)},
                                   {"expanded", flag(layer.shown)}},
                                  no_properties()),
                          "\n");
    }
    for (const TreeGroup& below : group.groups) {
        content += branch(below, number);
    }
    return joined(
        element("layer-tree-group",
                {{"name", group.title}, {"checked", checked(true)}, {"expanded", flag(group.open)}}, content),
        "\n");
}

std::string_view geometry_of(LayerKind kind) {
    switch (kind) {
        case LayerKind::point:
            return "Point";
        case LayerKind::line:
            return "Line";
        case LayerKind::area:
            return "Polygon";
        case LayerKind::raster:
        case LayerKind::table:
            break;
    }
    return "No geometry";
}

/// Nothing where the projection is not known.
std::string reference_of(const std::string& projection) {
    return projection.empty()
               ? ""
               : element("srs", {}, element("spatialrefsys", {}, element("wkt", {}, escaped(projection))));
}

std::string labels(const std::string& column) {
    const std::string buffer = element("text-buffer", {{"bufferDraw", "1"},
                                                       {"bufferSize", "0.8"},
                                                       {"bufferSizeUnits", "MM"},
                                                       {"bufferColor", "255,255,255,255"}});
    const std::string style = element(
        "text-style",
        {{"fieldName", column}, {"fontSize", "9"}, {"fontSizeUnit", "Point"}, {"textColor", "20,20,20,255"}},
        buffer);
    return element("labeling", {{"type", "simple"}}, element("settings", {}, style));
}

std::string map_layer(const TreeLayer& layer, const std::string& projection, std::size_t number) {
    const bool has_label = !layer.label.empty();
    const Attributes type = layer.kind == LayerKind::raster
                                ? Attributes{{"type", "raster"}}
                                : Attributes{{"type", "vector"},
                                             {"geometry", geometry_of(layer.kind)},
                                             {"labelsEnabled", flag(has_label)}};
    return element(
        "maplayer", type,
        joined("\n", element("id", {}, id_of(number)), element("datasource", {}, escaped(layer.source)),
               element("layername", {}, escaped(layer.title)),
               element("provider", {{"encoding", "UTF-8"}}, provider_of(layer.kind)), "\n",
               layer.kind == LayerKind::table ? "" : reference_of(projection), layer.style,
               has_label ? labels(layer.label) : ""));
}

std::string layers_of(const TreeGroup& group, const std::string& projection, std::size_t& number) {
    std::string layers;
    for (const TreeLayer& layer : group.layers) {
        layers += joined(map_layer(layer, projection, number++), "\n");
    }
    for (const TreeGroup& below : group.groups) {
        layers += layers_of(below, projection, number);
    }
    return layers;
}

/// The corner of a map.
std::string bound(const char* name, double metres) {
    return element(name, {}, config::to_text(metres));
}

std::string shown_part(const geopackage::Extent& extent) {
    return extent.empty ? std::string{}
                        : element("extent", {},
                                  joined(bound("xmin", extent.low_x_m), bound("ymin", extent.low_y_m),
                                         bound("xmax", extent.high_x_m), bound("ymax", extent.high_y_m)));
}

}  // namespace

void write_project(std::ostream& out, const TreeGroup& root, const std::string& projection,
                   const geopackage::Extent& extent) {
    const auto reference = [&](const char* name) {
        return projection.empty()
                   ? std::string{}
                   : element(name, {}, element("spatialrefsys", {}, element("wkt", {}, escaped(projection))));
    };
    std::size_t in_tree = 0;
    std::size_t number = 0;
    const std::string canvas = element("mapcanvas", {{"name", "theMapCanvas"}, {"annotationsVisible", "1"}},
                                       joined(element("units", {}, "meters"), shown_part(extent),
                                              element("rotation", {}, "0"), reference("destinationsrs")));
    // Without ProjectionsEnabled QGIS passes over the system of the project.
    const std::string has_system = projection.empty() ? "0" : "1";
    const std::string properties = element(
        "properties", {},
        joined(element("Paths", {}, element("Absolute", {{"type", "bool"}}, "false")),
               element("SpatialRefSys", {}, element("ProjectionsEnabled", {{"type", "int"}}, has_system))));
    out << "<!DOCTYPE qgis PUBLIC 'http://mrcc.com/qgis.dtd' 'SYSTEM'>\n"
        << element("qgis", {{"version", "3.22.0"}, {"projectname", root.title}},
                   joined("\n", element("title", {}, escaped(root.title)), "\n", reference("projectCrs"),
                          "\n", branch({"", root.layers, root.groups, true}, in_tree), canvas, "\n",
                          element("projectlayers", {}, joined("\n", layers_of(root, projection, number))),
                          "\n", properties, "\n"))
        << '\n';
}

void write_layer_tree(std::ostream& out, const TreeGroup& root, const std::string& projection) {
    std::size_t in_branch = 0;
    std::size_t number = 0;
    out << "<!DOCTYPE qgis-layer-definition>\n"
        << element("qlr", {},
                   joined("\n", branch({"", {}, {root}, true}, in_branch),
                          element("maplayers", {}, layers_of(root, projection, number)), "\n"))
        << '\n';
}

}  // namespace coupling::qgis
