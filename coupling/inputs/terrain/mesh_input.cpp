#include "coupling/inputs/terrain/mesh_input.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <map>
#include <ostream>
#include <string>
#include <utility>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "config/text/reading.hpp"
#include "coupling/inputs/ground/ground_names.hpp"
#include "coupling/inputs/meshes/mesh_check.hpp"
#include "coupling/inputs/places/records.hpp"
#include "coupling/inputs/scenario/terrain_settings.hpp"
#include "coupling/inputs/tables/point_file.hpp"
#include "coupling/inputs/terrain/terrain_input.hpp"

namespace coupling::meshes {
namespace {

using config::joined;
using rockfall::TinFault;

/// Turns a mesh whose y axis points up about its x axis.
void turn_up(MeshFile& mesh, MeshUp up) {
    if (up == MeshUp::y) {
        for (Eigen::Vector3d& point : mesh.points_m) {
            point = {point.x(), -point.z(), point.y()};
        }
    }
}

/// Where the faces of each file begin in the faces of all.
struct Parts {
    std::vector<std::string> names;
    std::vector<std::size_t> first_face;

    /// Says of faces of all which file they are in, and their number there.
    void name(std::vector<LeftOutFace>& faces) const {
        for (LeftOutFace& face : faces) {
            const auto after = std::upper_bound(first_face.begin(), first_face.end(), face.number - 1);
            const auto part = static_cast<std::size_t>(after - first_face.begin()) - 1;
            face.file = names[part];
            face.number -= first_face[part];
        }
    }
};

}  // namespace

MeshFormat format_of(std::string_view bytes, const std::string& name) {
    const auto ends_with = [&](std::string_view ending) {
        const std::string low = config::in_lower_case(name);
        return (low.ends_with(".gz") ? low.substr(0, low.size() - 3) : low).ends_with(ending);
    };
    if (bytes.starts_with("ply\n") || bytes.starts_with("ply\r") || ends_with(".ply")) {
        return MeshFormat::ply;
    }
    return ends_with(".stl")   ? MeshFormat::stl
           : ends_with(".dxf") ? MeshFormat::dxf
           : ends_with(".csv") ? MeshFormat::contours
                               : MeshFormat::points;
}

MeshFile read_mesh_file(std::string_view bytes, const std::string& file) {
    switch (format_of(bytes, file)) {
        case MeshFormat::ply:
            return read_ply(bytes, file);
        case MeshFormat::stl:
            return read_stl(bytes, file);
        case MeshFormat::dxf:
            return read_dxf(bytes, file);
        case MeshFormat::contours:
            return read_contours(bytes, file);
        case MeshFormat::points:
            break;
    }
    formats::refuse_what_is_no_text_of_points(bytes, file);
    MeshFile mesh;
    mesh.format = "points as text";
    tables::PointFile read = tables::read_point_file(bytes, file);
    mesh.points_m = std::move(read.points);
    mesh.notes = std::move(read.notes);
    return mesh;
}

/// Contours and points as a GIS keeps them, by the ending of their file.
bool names_layer(const std::string& name) {
    const std::string file = formats::split_layer_name(name).file;
    const std::size_t dot = file.find_last_of('.');
    const std::string ending = dot == std::string::npos ? "" : config::in_lower_case(file.substr(dot));
    return ending == ".gpkg" || ending == ".shp" || ending == ".geojson" || ending == ".json" ||
           format_of("", file) == MeshFormat::contours;
}

MeshFile read_named_mesh(const std::string& name, Reading& reading) {
    if (names_layer(name)) {
        const config::Table table = reading.table("terrain.mesh", "mesh", name);
        return contours_of(table, table.file());
    }
    const FileBytes bytes = reading.open("terrain.mesh", "mesh", name,
                                         "a mesh (PLY, STL), contours (DXF, CSV, layers) or points as text");
    MeshFile mesh = read_mesh_file(bytes.text(), reading.shown(name));
    for (const std::string& sentence : mesh.notes) {
        reading.note(sentence);
    }
    return mesh;
}

namespace {

/// The files of terrain.meshes as one mesh; its codes are the numbers of their rows.
MeshInput read_parts(Reading& reading) {
    MeshInput input;
    const config::Table table = reading.table("terrain.meshes", "meshes", reading.terrain().meshes);
    config::Problems problems;
    table.require({"file", "surface"}, problems);
    problems.throw_if_any();
    if (table.rows() == 0) {
        config::fail(config::ExitCode::data, {table.file()}, "no mesh", "a row for each file");
    }
    MeshFile all;
    Parts parts;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const std::string& name = table.text(row, "file");
        const FileBytes bytes = reading.open_at(table.place(row, "file"), "mesh " + std::to_string(row + 1),
                                                name, "a mesh (PLY, STL, DXF)");
        MeshFile mesh = read_mesh_file(bytes.text(), reading.shown(name));
        if (mesh.faces.empty()) {
            problems.add(config::ExitCode::data, table.place(row, "file"),
                         "no faces in " + config::in_quotes(name), "triangles (PLY, STL, DXF with 3DFACE)",
                         "name contours and points in terrain.mesh instead");
            continue;
        }
        turn_up(mesh, reading.terrain().mesh_up);
        doubt_precision(mesh, reading.shown(name), reading);
        note_passed_over(mesh, reading.shown(name), reading);
        parts.names.push_back(name);
        parts.first_face.push_back(all.faces.size());
        const auto first_point = static_cast<std::uint32_t>(all.points_m.size());
        all.points_m.insert(all.points_m.end(), mesh.points_m.begin(), mesh.points_m.end());
        for (const auto& [a, b, c] : mesh.faces) {
            all.faces.push_back({a + first_point, b + first_point, c + first_point});
            all.codes.push_back(static_cast<std::uint32_t>(row));
        }
    }
    problems.throw_if_any();
    input.first_file = parts.names.front();
    input.has_codes = true;
    input.tin = checked_tin(tin_of(std::move(all)), table.file(), input.left_out, reading);
    parts.name(input.left_out);
    input.parts = table;
    return input;
}

}  // namespace

MeshInput read_mesh(Reading& reading) {
    if (!reading.terrain().meshes.empty()) {
        return read_parts(reading);
    }
    const std::string& name = reading.terrain().mesh;
    const std::string file = reading.shown(name);
    MeshFile mesh = read_named_mesh(name, reading);
    if (mesh.points_m.size() < 3) {
        config::fail(config::ExitCode::data, {file}, counted(mesh.points_m.size(), "point"),
                     "at least three");
    }
    turn_up(mesh, reading.terrain().mesh_up);
    doubt_precision(mesh, file, reading);
    note_passed_over(mesh, file, reading);
    MeshInput input;
    input.first_file = name;
    if (mesh.faces.empty()) {
        if (format_of("", file) == MeshFormat::ply) {
            reading.note(file + ": no faces in it; its points are triangulated as those of terrain.points");
        }
        input.points_m = std::move(mesh.points_m);
        input.lines = std::move(mesh.lines);
        if (const auto place_m = rockfall::crossing_of(input.points_m, input.lines)) {
            config::fail(config::ExitCode::data, {file},
                         joined("lines that cross at ", to_cm(place_m->x()), ", ", to_cm(place_m->y())),
                         "one height over each place: lines that meet at common points only");
        }
        return input;
    }
    input.has_codes = !mesh.codes.empty();
    input.tin = checked_tin(tin_of(std::move(mesh)), file, input.left_out, reading);
    Parts{{name}, {0}}.name(input.left_out);
    return input;
}

namespace {

/// Faces carry the row of their file in terrain.meshes.
void name_ground_by_file(std::vector<rockfall::TinFace>& faces, const config::Table& parts,
                         std::vector<rockfall::SurfaceType>& types, Reading& reading) {
    auto elsewhere = reading.attempt([&] { return uniform_ground(reading); });
    GroundNames names{types, elsewhere.value_or(std::nullopt), *reading.settings().options};
    config::Problems problems;
    std::vector<std::uint32_t> ground_of_row;
    for (std::size_t row = 0; row < parts.rows(); ++row) {
        ground_of_row.push_back(names.place_of(parts, row, "file", problems).value_or(0) + 1U);
    }
    for (rockfall::TinFace& face : faces) {
        face.surface = ground_of_row[face.surface - 1];
    }
    types = std::move(names).list();
    config::Problems shown;
    add_first(shown, problems, parts.file());
    for (const config::Problem& problem : shown.list()) {
        reading.problems().add(problem);
    }
}

}  // namespace

void name_ground(HeightInput& heights, std::vector<rockfall::SurfaceType>& types, Reading& reading) {
    std::vector<rockfall::TinFace>& faces = heights.faces;
    if (heights.mesh_parts) {
        name_ground_by_file(faces, *heights.mesh_parts, types, reading);
        return;
    }
    std::map<std::uint32_t, std::uint32_t> place_of;
    std::string known;
    for (std::size_t i = 0; i < types.size(); ++i) {
        place_of.emplace(static_cast<std::uint32_t>(types[i].code) + 1, static_cast<std::uint32_t>(i + 1));
        known += (known.empty() ? "" : ", ") + std::to_string(types[i].code);
    }
    std::map<std::uint32_t, std::size_t> unknown;
    for (rockfall::TinFace& face : faces) {
        const auto place = place_of.find(face.surface);
        if (place == place_of.end()) {
            ++unknown[face.surface - 1];
        } else {
            face.surface = place->second;
        }
    }
    for (const auto& [code, count] : unknown) {
        reading.refuse(
            {reading.shown(reading.terrain().mesh)},
            joined("surface ", std::to_string(code), " of ", counted(count, "face")),
            reading.terrain().surface_types.empty()
                ? std::string{"terrain.surface_types with what the codes mean"}
                : joined("a code of ", reading.shown(reading.terrain().surface_types), ": ", known));
    }
}

void describe(const MeshFile& mesh, std::ostream& out) {
    Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
    Eigen::Vector3d high = -low;
    for (const Eigen::Vector3d& point : mesh.points_m) {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
    }
    out << mesh.format << "\npoints        " << mesh.points_m.size() << "\nfaces         "
        << mesh.faces.size() << '\n';
    if (!mesh.lines.empty()) {
        out << "line pieces   " << mesh.lines.size() << '\n';
    }
    for (Eigen::Index axis = 0; axis < 3 && !mesh.points_m.empty(); ++axis) {
        out << "xyz"[axis] << "             " << to_cm(low[axis]) << " to " << to_cm(high[axis]) << '\n';
    }
    out << "precision     " << (mesh.single_precision ? "32" : "64") << " bits\n";
    std::map<std::uint32_t, std::size_t> codes;
    for (const std::uint32_t code : mesh.codes) {
        ++codes[code];
    }
    for (const auto& [code, faces] : codes) {
        out << "surface       " << code << ": " << counted(faces, "face") << '\n';
    }
    for (const std::string& name : mesh.passed_over) {
        out << "passed over   " << name << '\n';
    }
    if (mesh.faces.empty()) {
        return;
    }
    const rockfall::CheckedTin checked = rockfall::checked(tin_of(mesh));
    for (const rockfall::TinFinding& finding : checked.findings) {
        out << (rockfall::is_doubt(finding.fault) ? "doubt         " : "fault         ")
            << found_in_words(finding) << '\n';
    }
    if (checked.changes.leaned > 0) {
        out << "upright       " << counted(checked.changes.leaned, "face") << '\n';
    }
    out << "terrain       " << (checked.is_sound() ? "yes" : "no") << '\n';
}

}  // namespace coupling::meshes
