#include "coupling/results/geopackage/stored_geometry.hpp"

#include <bit>
#include <stdexcept>
#include <string>

namespace coupling::geopackage {
namespace {

using Kind = StoredGeometry::Kind;

/// Well-known binary, least byte first.
class StoredBytes {
public:
    explicit StoredBytes(std::span<const std::uint8_t> bytes) : bytes_{bytes} {}

    std::uint32_t count() { return static_cast<std::uint32_t>(bits(4)); }
    double number() { return std::bit_cast<double>(bits(8)); }
    /// The code of a geometry, without what says that there are heights and measures.
    std::uint32_t begin(Dimensions& dimensions) {
        if (bits(1) != 1) {
            throw std::invalid_argument{"a geometry with the greatest byte first"};
        }
        const std::uint32_t code = count();
        dimensions = {.z = code / 1000 % 2 == 1, .m = code / 1000 >= 2};
        return code % 1000;
    }
    void skip(std::size_t size) {
        if (size > bytes_.size()) {
            throw std::invalid_argument{"a geometry that ends too early"};
        }
        bytes_ = bytes_.subspan(size);
    }
    Vertex corner(Dimensions dimensions) {
        Vertex corner;
        corner.x_m = number();
        corner.y_m = number();
        corner.z_m = dimensions.z ? number() : 0.0;
        corner.measure = dimensions.m ? number() : 0.0;
        return corner;
    }
    std::vector<Vertex> corners(Dimensions dimensions) {
        std::vector<Vertex> all(count());
        for (Vertex& each : all) {
            each = corner(dimensions);
        }
        return all;
    }

private:
    std::uint64_t bits(std::size_t size) {
        std::uint64_t value = 0;
        const std::span<const std::uint8_t> all = bytes_;
        skip(size);
        for (std::size_t i = 0; i < size; ++i) {
            value |= static_cast<std::uint64_t>(all[i]) << (8 * i);
        }
        return value;
    }
    std::span<const std::uint8_t> bytes_;
};

void add_stored(StoredBytes& bytes, StoredGeometry& geometry) {
    const std::uint32_t code = bytes.begin(geometry.dimensions);
    switch (code) {
        case 1:
            geometry.kind = Kind::point;
            geometry.parts.push_back({{bytes.corner(geometry.dimensions)}});
            return;
        case 2:
            geometry.kind = Kind::line;
            geometry.parts.push_back({bytes.corners(geometry.dimensions)});
            return;
        case 3: {
            geometry.kind = Kind::area;
            const std::uint32_t rings = bytes.count();
            for (std::uint32_t ring = 0; ring < rings; ++ring) {
                geometry.parts.push_back({bytes.corners(geometry.dimensions), ring > 0});
            }
            return;
        }
        case 5:
        case 6: {
            const std::uint32_t members = bytes.count();
            for (std::uint32_t member = 0; member < members; ++member) {
                add_stored(bytes, geometry);
            }
            return;
        }
        default:
            throw std::invalid_argument{"a geometry of the kind " + std::to_string(code)};
    }
}

}  // namespace

StoredGeometry read_geometry(std::span<const std::uint8_t> bytes) {
    constexpr std::size_t header = 8 + 4 * sizeof(double);  // as all that are written here
    StoredBytes stored{bytes};
    stored.skip(header);
    StoredGeometry geometry;
    add_stored(stored, geometry);
    return geometry;
}

}  // namespace coupling::geopackage
