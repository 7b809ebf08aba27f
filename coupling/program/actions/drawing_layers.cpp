#include "coupling/program/actions/drawing_layers.hpp"

#include <algorithm>
#include <cassert>

#include "config/text/joined.hpp"
#include "coupling/program/actions/input_tables.hpp"
#include "coupling/results/geopackage/spatial_reference.hpp"

namespace coupling {
namespace {

using config::joined;
using geopackage::Form;

constexpr Colour brown{0x8c, 0x51, 0x0a};
constexpr Colour ink{0x20, 0x20, 0x20};
constexpr Colour blue{0x05, 0x30, 0x61};
constexpr Colour violet{0x76, 0x2a, 0x83};
constexpr Colour green{0x1b, 0x78, 0x37};
constexpr Colour grey{0x77, 0x77, 0x77};

geopackage::ColumnType type_of(config::FieldKind kind) {
    switch (kind) {
        case config::FieldKind::number:
            return geopackage::ColumnType::number;
        case config::FieldKind::whole:
            return geopackage::ColumnType::whole;
        case config::FieldKind::text:
        case config::FieldKind::word:
        case config::FieldKind::flag:
        case config::FieldKind::shape:
        case config::FieldKind::words:
        case config::FieldKind::numbers:
            break;
    }
    return geopackage::ColumnType::text;
}

/// What a field means and what it may hold, as whoever fills it in needs it.
std::string meaning_of(const config::ColumnRules& column) {
    const std::string values = column.values_in_words();
    return joined(column.meaning, values.empty() ? "" : joined(" (", values, ")"),
                  column.may_be_empty() ? "; may be empty" : "");
}

}  // namespace

std::span<const DrawingLayer> drawing_layers() {
    static const std::vector<DrawingLayer> layers{
        {"source_lines",
         Form::multi_line,
         "Sources: lines",
         "Where rocks break off, such as the upper edge of a cliff. Lines or areas, not both.",
         {"source_shapes"},
         brown},
        {"source_areas",
         Form::multi_polygon,
         "Sources: areas",
         "Where rocks break off, such as the face of a cliff. Lines or areas, not both.",
         {"source_shapes"},
         brown},
        {"roads",
         Form::multi_line,
         "Targets: roads and other lines",
         "What is to be protected and is long: roads, railways, paths. Rocks that cross the line are "
         "counted.",
         {"targets"},
         ink,
         "name"},
        {"houses",
         Form::multi_polygon,
         "Targets: houses and other areas",
         "What is to be protected and is wide: houses, yards, camps. Rocks that enter the area are counted.",
         {"targets"},
         ink,
         "name"},
        {"nets",
         Form::line,
         "Rockfall nets",
         "Nets that stand already, a line each.",
         {"nets"},
         blue,
         "name"},
        {"corridors",
         Form::multi_line,
         "Cable corridors",
         "Lines of cable cranes for regimes: where = corridors, lines = drawing.gpkg|corridors.",
         {},
         violet},
        {"stands",
         Form::multi_polygon,
         "Forest stands",
         "What grows where: an area for each species of a stand, with two of stems_pha, basal_area_m2pha and "
         "mean_dbh_cm. A stand of two species is drawn once and copied.",
         {"stands", "stand_records"},
         green,
         "stand"},
        {"grounds",
         Form::multi_polygon,
         "Ground types",
         "Which ground lies where, by the codes of surface_types.csv. Later areas lie on top; where there is "
         "none terrain.ground holds.",
         {"surface_polygons"},
         grey,
         "code"}};
    return layers;
}

const DrawingLayer& drawing_layer(std::string_view name) {
    const auto layers = drawing_layers();
    const auto found = std::find_if(layers.begin(), layers.end(),
                                    [&](const DrawingLayer& layer) { return layer.name == name; });
    assert(found != layers.end());
    return *found;
}

std::vector<config::ColumnRules> drawing_columns(const DrawingLayer& layer) {
    std::vector<config::ColumnRules> columns;
    for (const std::string_view role : layer.roles) {
        for (const config::TableSchema* schema : input_tables()) {
            if (schema->rules().role != role) {
                continue;
            }
            for (const config::ColumnRules& column : schema->columns()) {
                const bool is_known =
                    std::any_of(columns.begin(), columns.end(),
                                [&](const config::ColumnRules& other) { return other.name == column.name; });
                if (column.kind != config::FieldKind::shape && !is_known) {
                    columns.push_back(column);
                }
            }
        }
    }
    return columns;
}

std::string empty_drawing(const std::vector<const DrawingLayer*>& layers, const std::string& projection) {
    geopackage::GeoPackage package{geopackage::spatial_reference(projection), drawing_file};
    for (const DrawingLayer* drawn : layers) {
        geopackage::Plan plan{.name = std::string{drawn->name},
                              .sentence = std::string{drawn->sentence},
                              .columns = {},
                              .form = drawn->form,
                              .dimensions = {},
                              .describes_columns = true};
        for (const config::ColumnRules& column : drawing_columns(*drawn)) {
            plan.columns.push_back(
                {column.name, type_of(column.kind), meaning_of(column), std::string{column.rules.unit}});
        }
        geopackage::Layer layer{package, std::move(plan)};
        layer.finish();
    }
    return package.bytes();
}

std::string drawing_source(std::string_view layer) {
    return joined(drawing_file, "|", layer);
}

}  // namespace coupling
