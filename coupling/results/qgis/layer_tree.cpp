#include "coupling/results/qgis/layer_tree.hpp"

#include "config/text/joined.hpp"
#include "coupling/results/text/markup.hpp"

namespace coupling::qgis {
namespace {

using config::joined;
using report::escaped;
using Kind = TreeLayer::Kind;

/// Identifiers are numbers in the order of the tree: the same results give the same file.
std::string id_of(std::size_t number) {
    return joined("bannwald_", std::to_string(number));
}

const char* checked(bool shown) {
    return shown ? "Qt::Checked" : "Qt::Unchecked";
}

const char* provider_of(Kind kind) {
    return kind == Kind::raster ? "gdal" : "ogr";
}

void write_branch(std::ostream& out, const TreeGroup& group, std::size_t& number) {
    out << "<layer-tree-group name=\"" << escaped(group.title) << "\" checked=\"Qt::Checked\" expanded=\""
        << (group.open ? 1 : 0) << "\">\n<customproperties/>\n";
    for (const TreeLayer& layer : group.layers) {
        out << "<layer-tree-layer id=\"" << id_of(number++) << "\" name=\"" << escaped(layer.title)
            << "\" source=\"" << escaped(layer.source) << "\" providerKey=\"" << provider_of(layer.kind)
            << "\" checked=\"" << checked(layer.shown) << "\" expanded=\"" << (layer.shown ? 1 : 0)
            << "\"><customproperties/></layer-tree-layer>\n";
    }
    for (const TreeGroup& below : group.groups) {
        write_branch(out, below, number);
    }
    out << "</layer-tree-group>\n";
}

std::string_view geometry_of(Kind kind) {
    switch (kind) {
        case Kind::point:
            return "Point";
        case Kind::line:
            return "Line";
        case Kind::area:
            return "Polygon";
        case Kind::raster:
        case Kind::table:
            break;
    }
    return "No geometry";
}

/// Nothing where the projection is not known.
std::string reference_of(const std::string& projection) {
    return projection.empty()
               ? std::string{}
               : joined("<srs><spatialrefsys><wkt>", escaped(projection), "</wkt></spatialrefsys></srs>\n");
}

std::string labels(const std::string& column) {
    return joined(
        "<labeling type=\"simple\"><settings><text-style fieldName=\"", escaped(column),
        "\" fontSize=\"9\" fontSizeUnit=\"Point\" textColor=\"20,20,20,255\"><text-buffer bufferDraw=\"1\" "
        "bufferSize=\"0.8\" bufferSizeUnits=\"MM\" bufferColor=\"255,255,255,255\"/></text-style>"
        "</settings></labeling>\n");
}

void write_layer(std::ostream& out, const TreeLayer& layer, const std::string& projection,
                 std::size_t number) {
    if (layer.kind == Kind::raster) {
        out << "<maplayer type=\"raster\">\n";
    } else {
        out << "<maplayer type=\"vector\" geometry=\"" << geometry_of(layer.kind) << "\" labelsEnabled=\""
            << (layer.label.empty() ? 0 : 1) << "\">\n";
    }
    out << "<id>" << id_of(number) << "</id>\n<datasource>" << escaped(layer.source)
        << "</datasource>\n<layername>" << escaped(layer.title)
        << "</layername>\n<provider encoding=\"UTF-8\">" << provider_of(layer.kind) << "</provider>\n"
        << (layer.kind == Kind::table ? std::string{} : reference_of(projection)) << layer.style
        << (layer.label.empty() ? "" : labels(layer.label)) << "</maplayer>\n";
}

void write_layers(std::ostream& out, const TreeGroup& group, const std::string& projection,
                  std::size_t& number) {
    for (const TreeLayer& layer : group.layers) {
        write_layer(out, layer, projection, number++);
    }
    for (const TreeGroup& below : group.groups) {
        write_layers(out, below, projection, number);
    }
}

}  // namespace

void write_layer_tree(std::ostream& out, const TreeGroup& root, const std::string& projection) {
    out << "<!DOCTYPE qgis-layer-definition>\n<qlr>\n<layer-tree-group name=\"\" checked=\"Qt::Checked\" "
           "expanded=\"1\">\n<customproperties/>\n";
    std::size_t number = 0;
    write_branch(out, root, number);
    out << "</layer-tree-group>\n<maplayers>\n";
    number = 0;
    write_layers(out, root, projection, number);
    out << "</maplayers>\n</qlr>\n";
}

}  // namespace coupling::qgis
