#pragma once

#include <bit>
#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

#include "rockfall/terrain/terrain.hpp"

namespace coupling::meshes {

/// A terrain as the bytes of mesh files, in absolute coordinates.
class MeshTexts {
public:
    explicit MeshTexts(const rockfall::Terrain& terrain) : terrain_{terrain} {}

    /// With a property `surface` where `code_of(x, y)` is given, else without.
    template <class CodeOf>
    [[nodiscard]] std::string ply_with_codes(CodeOf code_of) const {
        std::ostringstream text;
        text.precision(17);
        text << header("ascii", "property uchar surface\n");
        for (const rockfall::Vertex& v : terrain_.vertices()) {
            text << east(v) << ' ' << north(v) << ' ' << v.z_m << '\n';
        }
        for (const rockfall::Triangle& t : terrain_.triangles()) {
            const rockfall::Vertex& v = terrain_.vertices()[t.corners[0]];
            text << "3 " << t.corners[0] << ' ' << t.corners[1] << ' ' << t.corners[2] << ' '
                 << code_of(east(v), north(v)) << '\n';
        }
        return text.str();
    }
    [[nodiscard]] std::string ply() const {
        std::ostringstream text;
        text.precision(17);
        text << header("ascii", "");
        for (const rockfall::Vertex& v : terrain_.vertices()) {
            text << east(v) << ' ' << north(v) << ' ' << v.z_m << '\n';
        }
        for (const rockfall::Triangle& t : terrain_.triangles()) {
            text << "3 " << t.corners[0] << ' ' << t.corners[1] << ' ' << t.corners[2] << '\n';
        }
        return text.str();
    }
    [[nodiscard]] std::string binary_ply() const {
        std::string bytes = header("binary_little_endian", "");
        for (const rockfall::Vertex& v : terrain_.vertices()) {
            for (const double value : {east(v), north(v), v.z_m}) {
                put(bytes, std::bit_cast<std::uint64_t>(value), 8);
            }
        }
        for (const rockfall::Triangle& t : terrain_.triangles()) {
            put(bytes, 3, 1);
            for (const std::uint32_t corner : t.corners) {
                put(bytes, corner, 4);
            }
        }
        return bytes;
    }
    [[nodiscard]] std::string stl() const {
        std::ostringstream text;
        text.precision(17);
        text << "solid slope\n";
        for (const rockfall::Triangle& t : terrain_.triangles()) {
            text << "facet normal 0 0 0\nouter loop\n";
            for (const std::uint32_t corner : t.corners) {
                const rockfall::Vertex& v = terrain_.vertices()[corner];
                text << "vertex " << east(v) << ' ' << north(v) << ' ' << v.z_m << '\n';
            }
            text << "endloop\nendfacet\n";
        }
        text << "endsolid slope\n";
        return text.str();
    }
    [[nodiscard]] std::string binary_stl() const {
        std::string bytes(80, ' ');
        put(bytes, static_cast<std::uint32_t>(terrain_.triangles().size()), 4);
        for (const rockfall::Triangle& t : terrain_.triangles()) {
            bytes += std::string(12, '\0');
            for (const std::uint32_t corner : t.corners) {
                const rockfall::Vertex& v = terrain_.vertices()[corner];
                for (const double value : {east(v), north(v), v.z_m}) {
                    put(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(value)), 4);
                }
            }
            bytes += std::string(2, '\0');
        }
        return bytes;
    }
    [[nodiscard]] std::string points() const {
        std::ostringstream text;
        text.precision(17);
        for (const rockfall::Vertex& v : terrain_.vertices()) {
            text << east(v) << ' ' << north(v) << ' ' << v.z_m << '\n';
        }
        return text.str();
    }

private:
    [[nodiscard]] double east(const rockfall::Vertex& v) const { return v.x_m + terrain_.origin_m().x(); }
    [[nodiscard]] double north(const rockfall::Vertex& v) const { return v.y_m + terrain_.origin_m().y(); }
    [[nodiscard]] std::string header(const std::string& encoding, const std::string& more) const {
        return "ply\nformat " + encoding + " 1.0\nelement vertex " +
               std::to_string(terrain_.vertices().size()) +
               "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
               std::to_string(terrain_.triangles().size()) + "\nproperty list uchar int vertex_indices\n" +
               more + "end_header\n";
    }
    static void put(std::string& bytes, std::uint64_t value, int size) {
        for (int i = 0; i < size; ++i) {
            bytes += static_cast<char>((value >> (8 * i)) & 0xFFU);
        }
    }

    const rockfall::Terrain& terrain_;
};

}  // namespace coupling::meshes
