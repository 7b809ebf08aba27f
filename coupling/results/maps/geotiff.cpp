#include "coupling/results/maps/geotiff.hpp"

#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <vector>

#include "config/text/joined.hpp"
#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/geopackage/spatial_reference.hpp"

namespace coupling {
namespace {

using config::joined;

constexpr float no_data = -9999.0F;

enum FieldType : std::uint16_t { ascii = 2, short_whole = 3, long_whole = 4, double_number = 12 };

/// Bytes of a little-endian file.
class Bytes {
public:
    template <class Whole>
    void add(Whole value) {
        for (std::size_t i = 0; i < sizeof(Whole); ++i) {
            text_ += static_cast<char>((static_cast<std::uint64_t>(value) >> (8 * i)) & 0xFFU);
        }
    }
    void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
    void add(const std::string& text) { text_ += text; }
    [[nodiscard]] const std::string& text() const { return text_; }

private:
    std::string text_;
};

/// A tag of TIFF 6.0 with its values as bytes.
struct Tag {
    std::uint16_t number;
    FieldType type;
    std::uint32_t count;
    Bytes values;
};

Tag whole(std::uint16_t number, std::uint32_t value) {
    Tag tag{number, long_whole, 1, {}};
    tag.values.add(value);
    return tag;
}

Tag shorts(std::uint16_t number, const std::vector<std::uint16_t>& values) {
    Tag tag{number, short_whole, static_cast<std::uint32_t>(values.size()), {}};
    for (const std::uint16_t value : values) {
        tag.values.add(value);
    }
    return tag;
}

Tag doubles(std::uint16_t number, const std::vector<double>& values) {
    Tag tag{number, double_number, static_cast<std::uint32_t>(values.size()), {}};
    for (const double value : values) {
        tag.values.add(value);
    }
    return tag;
}

Tag text(std::uint16_t number, const std::string& value) {
    Tag tag{number, ascii, static_cast<std::uint32_t>(value.size() + 1), {}};
    tag.values.add(value);
    tag.values.add(std::uint8_t{0});
    return tag;
}

/// Keys of GeoTIFF 1.0: what the coordinates mean.
void add_projection(std::vector<Tag>& tags, const std::string& projection) {
    constexpr std::uint16_t user_defined = 32767;
    constexpr std::uint16_t ascii_parameters = 34737;
    const geopackage::SpatialReference reference = geopackage::spatial_reference(projection);
    // version 1, revision 1.0, then key, where its value is (0: here), count, value; cells are areas
    std::vector<std::uint16_t> keys{1, 1, 0, 3, 1024, 0, 1, 1, 1025, 0, 1, 1};
    if (reference.organization == "EPSG") {
        keys.insert(keys.end(), {3072, 0, 1, static_cast<std::uint16_t>(reference.id)});
        tags.push_back(shorts(34735, keys));
    } else if (reference.id > 0) {
        const std::string citation = joined("ESRI PE String = ", reference.definition, "|");
        keys[3] = 4;
        keys.insert(keys.end(), {3072, 0, 1, user_defined, 3073, ascii_parameters,
                                 static_cast<std::uint16_t>(citation.size()), 0});
        tags.push_back(shorts(34735, keys));
        tags.push_back(text(ascii_parameters, citation));
    }
}

}  // namespace

void write_geotiff(const std::filesystem::path& file, const config::Raster<double>& raster,
                   const std::string& projection) {
    const config::GridFrame& frame = raster.frame;
    const auto cell_bytes = static_cast<std::uint32_t>(frame.size() * sizeof(float));
    assert(frame.size() <= (1ULL << 29U));
    std::vector<Tag> tags{whole(256, static_cast<std::uint32_t>(frame.columns)),
                          whole(257, static_cast<std::uint32_t>(frame.rows)),
                          shorts(258, {32}),  // bits
                          shorts(259, {1}),   // uncompressed
                          shorts(262, {1}),   // larger is brighter
                          whole(273, 0),      // where the cells begin, known below
                          shorts(277, {1}),   // one value a cell
                          whole(278, static_cast<std::uint32_t>(frame.rows)),
                          whole(279, cell_bytes),
                          shorts(284, {1}),
                          shorts(339, {3}),  // floats
                          doubles(33550, {frame.cell_width_m, frame.cell_height_m, 0.0}),
                          doubles(33922, {0.0, 0.0, 0.0, frame.x_west_m, frame.y_north_m(), 0.0})};
    add_projection(tags, projection);
    tags.push_back(text(42113, "-9999"));

    constexpr std::uint32_t header_bytes = 8;
    const auto directory_bytes = static_cast<std::uint32_t>(2 + 12 * tags.size() + 4);
    std::uint32_t next = header_bytes + directory_bytes;
    Bytes out;
    Bytes values;
    out.add(std::string{"II"});
    out.add(std::uint16_t{42});
    out.add(header_bytes);
    out.add(static_cast<std::uint16_t>(tags.size()));
    std::uint32_t cells_at = next;
    for (const Tag& tag : tags) {
        const auto size = static_cast<std::uint32_t>(tag.values.text().size());
        cells_at += size > 4 ? size + size % 2 : 0;
    }
    cells_at += (4 - cells_at % 4) % 4;
    for (const Tag& tag : tags) {
        out.add(tag.number);
        out.add(static_cast<std::uint16_t>(tag.type));
        out.add(tag.count);
        std::string bytes = tag.values.text();
        if (tag.number == 273) {
            out.add(cells_at);
        } else if (bytes.size() <= 4) {
            bytes.resize(4, '\0');
            out.add(bytes);
        } else {
            bytes.resize(bytes.size() + bytes.size() % 2, '\0');
            out.add(next);
            values.add(bytes);
            next += static_cast<std::uint32_t>(bytes.size());
        }
    }
    out.add(std::uint32_t{0});  // no other picture
    out.add(values.text());
    out.add(std::string(cells_at - next, '\0'));

    OutFile written{file};
    written.stream() << out.text();
    Bytes row;
    for (std::size_t i = 0; i < raster.values.size(); ++i) {
        const double value = raster.values[i];
        row.add(std::bit_cast<std::uint32_t>(std::isnan(value) ? no_data : static_cast<float>(value)));
        if ((i + 1) % static_cast<std::size_t>(frame.columns) == 0) {
            written.stream() << row.text();
            row = {};
        }
    }
    written.close();
}

}  // namespace coupling
