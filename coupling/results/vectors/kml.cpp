#include "coupling/results/vectors/kml.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/results/figures/colours.hpp"
#include "coupling/results/geopackage/layer_look.hpp"
#include "coupling/results/geopackage/stored_rows.hpp"
#include "coupling/results/pack/zip_file.hpp"
#include "coupling/results/report/map/png.hpp"
#include "coupling/results/text/element.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/messages.hpp"
#include "coupling/results/vectors/degrees.hpp"
#include "coupling/results/vectors/layer_columns.hpp"

namespace coupling::vectors {
namespace {

using config::joined;
using geopackage::Column;
using geopackage::ColumnType;
using geopackage::LayerLook;
using geopackage::StoredGeometry;
using geopackage::StoredRows;
using geopackage::Vertex;
using geopackage::Written;
using report::element;
using report::escaped;
using Kind = StoredGeometry::Kind;

namespace fs = std::filesystem;

constexpr const char* dot_file = "dot.png";

/// A white disc that takes the colour of its style.
std::string dot() {
    constexpr int size = 32;
    constexpr double radius = 14.0;
    report::IndexedPicture picture{size,
                                   size,
                                   std::vector<std::uint8_t>(std::size_t{size} * size),
                                   {Colour{0, 0, 0}, Colour{255, 255, 255}}};
    for (int row = 0; row < size; ++row) {
        for (int column = 0; column < size; ++column) {
            const double dx = column + 0.5 - 0.5 * size;
            const double dy = row + 0.5 - 0.5 * size;
            picture.pixels[static_cast<std::size_t>(row * size + column)] =
                dx * dx + dy * dy <= radius * radius ? 1 : 0;
        }
    }
    return report::png(picture);
}

/// "ff0000ff" is red: opacity, blue, green, red.
std::string kml_colour(Colour colour, const char* opacity) {
    const std::string hex = to_hex(colour);
    return joined(opacity, hex.substr(5, 2), hex.substr(3, 2), hex.substr(1, 2));
}

std::string style(const std::string& id, Colour colour, double width) {
    const std::string solid = element("color", {}, kml_colour(colour, "ff"));
    return joined(
        element("Style", {{"id", id}},
                joined(element("IconStyle", {},
                               joined(solid, element("scale", {}, "0.4"),
                                      element("Icon", {}, element("href", {}, dot_file)))),
                       element("LabelStyle", {}, element("scale", {}, "0.7")),
                       element("LineStyle", {}, joined(solid, element("width", {}, config::to_text(width)))),
                       element("PolyStyle", {}, element("color", {}, kml_colour(colour, "66"))))),
        "\n");
}

/// The styles of a layer, and which of them a row has.
class LayerStyles {
public:
    explicit LayerStyles(const geopackage::Plan& plan) : name_{plan.name}, look_{geopackage::look_of(plan)} {
        const auto place_of = [&](const std::string& column) {
            const auto found = std::find_if(plan.columns.begin(), plan.columns.end(),
                                            [&](const Column& each) { return each.name == column; });
            return static_cast<std::size_t>(found - plan.columns.begin());
        };
        energy_ = place_of(look_.energy_column);
        class_ = place_of(look_.class_column);
    }
    [[nodiscard]] bool shown() const { return look_.shown; }
    [[nodiscard]] std::string definitions() const {
        constexpr double thin = 1.5;
        constexpr double wide = 3.0;
        std::string styles = style(name_, look_.colour, wide);
        if (!look_.energy_column.empty()) {
            for (std::size_t i = 0; i < energy_class_colours.size(); ++i) {
                styles += style(id_of(i), energy_class_colours[i], thin);
            }
        }
        for (std::size_t i = 0; i < look_.classes.size(); ++i) {
            styles += style(id_of(i), look_.classes[i].colour, thin);
        }
        return styles;
    }
    [[nodiscard]] std::string of(const std::vector<std::string>& fields) const {
        if (energy_ < fields.size()) {
            const double energy_kj = config::parse_number(fields[energy_]).value_or(0.0);
            return energy_kj > 0.0 ? id_of(energy_class(energy_kj)) : name_;
        }
        if (class_ < fields.size()) {
            for (std::size_t i = 0; i < look_.classes.size(); ++i) {
                if (look_.classes[i].value == fields[class_]) {
                    return id_of(i);
                }
            }
        }
        return name_;
    }

private:
    [[nodiscard]] std::string id_of(std::size_t number) const {
        return joined(name_, "_", std::to_string(number));
    }
    std::string name_;
    LayerLook look_;
    std::size_t energy_ = 0;  ///< place of the column; behind the last one: none
    std::size_t class_ = 0;
};

/// The type of a column: whole numbers of KML have 32 bits.
std::string type_of_column(geopackage::Database& database, const std::string& layer, const Column& column) {
    if (column.type == ColumnType::text) {
        return "string";
    }
    if (column.type == ColumnType::number) {
        return "double";
    }
    const std::string name = geopackage::sql_name(column.name);
    geopackage::Statement largest =
        database.prepare(joined("SELECT max(abs(", name, ")) FROM ", geopackage::sql_name(layer)));
    const bool is_small = !largest.step() || largest.whole(0) <= std::numeric_limits<std::int32_t>::max();
    return is_small ? "int" : "double";
}

std::string schema(geopackage::Database& database, const geopackage::Plan& plan) {
    std::string fields;
    for (const Column& column : plan.columns) {
        const std::string unit = unit_of(column);
        fields += element(
            "SimpleField", {{"type", type_of_column(database, plan.name, column)}, {"name", column.name}},
            element("displayName", {},
                    escaped(unit.empty() ? column.name : joined(column.name, " [", unit, "]"))));
    }
    return joined(element("Schema", {{"name", plan.name}, {"id", joined("columns_", plan.name)}}, fields),
                  "\n");
}

class KmlShapes {
public:
    explicit KmlShapes(const std::string& projection) : degrees_{projection} {}
    [[nodiscard]] Degrees& degrees() { return degrees_; }

    std::string shape(const StoredGeometry& geometry) {
        std::vector<std::string> members;
        for (const StoredGeometry::Part& part : geometry.parts) {
            const std::string corners = coordinates(part.corners, geometry.dimensions.z);
            if (geometry.kind == Kind::point) {
                members.push_back(element("Point", {}, corners));
            } else if (geometry.kind == Kind::line) {
                members.push_back(element("LineString", {}, joined(element("tessellate", {}, "1"), corners)));
            } else {
                const std::string ring = element("LinearRing", {}, corners);
                part.is_hole ? members.back() += element("innerBoundaryIs", {}, ring)
                             : members.emplace_back(element("outerBoundaryIs", {}, ring));
            }
        }
        std::string all;
        for (const std::string& member : members) {
            all += geometry.kind == Kind::area
                       ? element("Polygon", {}, joined(element("tessellate", {}, "1"), member))
                       : member;
        }
        return members.size() == 1 ? all : element("MultiGeometry", {}, all);
    }

private:
    std::string coordinates(const std::vector<Vertex>& corners, bool has_heights) {
        std::string text;
        for (const Vertex& corner : corners) {
            const Degrees::Place place = degrees_.of(corner);
            text += joined(text.empty() ? "" : " ", place.longitude, ",", place.latitude);
            if (has_heights) {
                text += joined(",", config::to_text(corner.z_m));
            }
        }
        return element("coordinates", {}, text);
    }
    Degrees degrees_;
};

std::string placemark(const geopackage::Plan& plan, const StoredRows& row, const LayerStyles& styles,
                      KmlShapes& shapes) {
    const std::vector<std::string>& fields = row.fields();
    std::string words;
    std::string data;
    for (std::size_t i = 0; i < fields.size(); ++i) {
        if (fields[i].empty()) {
            continue;
        }
        words += joined(plan.columns[i].name, ": ", escaped(with_unit(fields[i], plan.columns[i])), "\n");
        data += element("SimpleData", {{"name", plan.columns[i].name}}, escaped(fields[i]));
    }
    return joined(
        element(
            "Placemark", {},
            joined(element("name", {}, escaped(name_of(plan, fields))),
                   styles.shown() ? "" : element("visibility", {}, "0"), element("description", {}, words),
                   element("styleUrl", {}, joined("#", styles.of(fields))),
                   element("ExtendedData", {},
                           element("SchemaData", {{"schemaUrl", joined("#columns_", plan.name)}}, data)),
                   shapes.shape(row.geometry()))),
        "\n");
}

}  // namespace

WrittenFile write_kmz(const fs::path& folder, geopackage::Database& database, std::span<const Written> layers,
                      const std::string& projection, const WriteWatch& watch) {
    const fs::path text = folder / ".doc.kml";
    OutFile out{text};
    KmlShapes shapes{projection};
    const Tags kml = tags_of("kml", {{"xmlns", "http://www.opengis.net/kml/2.2"}});
    const Tags document = tags_of("Document");
    const Tags tags_of_folder = tags_of("Folder");
    out.stream() << xml_line << kml.begin << document.begin << element("name", {}, "Bannwald") << "\n"
                 << element("description", {}, escaped(shapes.degrees().way_in_words(layers))) << "\n";
    for (const Written& layer : layers) {
        if (layer.plan.form != geopackage::Form::none) {
            out.stream() << LayerStyles{layer.plan}.definitions() << schema(database, layer.plan);
        }
    }
    for (const Written& layer : layers) {
        if (layer.plan.form == geopackage::Form::none) {
            continue;
        }
        watch(joined("results.kmz, ", layer.plan.name));
        const LayerStyles styles{layer.plan};
        out.stream() << tags_of_folder.begin
                     << element("name", {}, escaped(geopackage::layer_title(layer.plan)))
                     << element("visibility", {}, styles.shown() ? "1" : "0")
                     << element("description", {}, escaped(report::message_text(layer.plan.sentence)))
                     << "\n";
        for (StoredRows rows{database, layer.plan}; rows.next();) {
            out.stream() << placemark(layer.plan, rows, styles, shapes);
        }
        out.stream() << tags_of_folder.end;
    }
    out.stream() << document.end << kml.end;
    out.close();
    watch("results.kmz");
    pack::ZipWriter zip{folder / "results.kmz"};
    zip.add_file("doc.kml", text);
    zip.add_text(dot_file, dot());
    zip.close();
    delete_entry(text);
    return {"results.kmz", "The layers of results.gpkg for Google Earth and others."};
}

}  // namespace coupling::vectors
