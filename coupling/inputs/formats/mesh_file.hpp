#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "config/table/table.hpp"
#include "rockfall/terrain/breaklines.hpp"

namespace coupling::meshes {

/// What a file of a surface holds, as it stands there.
struct MeshFile {
    std::string format;                               ///< in words
    std::vector<Eigen::Vector3d> points_m;            ///< finite
    std::vector<std::array<std::uint32_t, 3>> faces;  ///< of places in the list of points
    std::vector<std::uint32_t> codes;                 ///< ground by face; empty: the file says none
    std::vector<rockfall::PointPair> lines;           ///< pieces of lines between points
    bool single_precision = false;                    ///< coordinates of 32 bits
    std::vector<std::string> passed_over;             ///< what else the file holds, by name
    std::vector<std::string> notes{};                 ///< how the file was understood, a sentence each
};

/// Largest ground code of a face.
inline constexpr std::uint32_t largest_code = 1'000'000;

/// The formats that a file may have, recognised by its first bytes and its name.
enum class MeshFormat : std::uint8_t { ply, stl, dxf, contours, points };
MeshFormat format_of(std::string_view bytes, const std::string& name);

/// Reads a file of any of these formats. Throws InputError (data).
MeshFile read_mesh_file(std::string_view bytes, const std::string& file);

/// Reads PLY, ascii or binary: element `vertex` with x, y, z; element `face` with vertex_indices and perhaps
/// an integer property `surface`. Other properties and elements are passed over and named. Throws InputError
/// (data) with the line, or in binary files the number of the vertex or face.
MeshFile read_ply(std::string_view bytes, const std::string& file);

/// Reads STL, ascii or binary. Corners count, normals do not. Each face has points of its own.
MeshFile read_stl(std::string_view bytes, const std::string& file);

/// Reads DXF as text: POINT, LINE, LWPOLYLINE (with its elevation), POLYLINE, 3DFACE (triangles, or four
/// corners as two of them) of the section ENTITIES. Entities of other types are passed over and named.
MeshFile read_dxf(std::string_view bytes, const std::string& file);

/// Reads CSV with `wkt`: POINT or LINESTRING, each with Z, or with the height of the row in `height_m`.
MeshFile read_contours(std::string_view bytes, const std::string& file);
/// The same of a table or layer that was read already.
MeshFile contours_of(const config::Table& table, const std::string& file);

}  // namespace coupling::meshes
