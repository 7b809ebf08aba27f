#include "coupling/inputs/meshes/mesh_input.hpp"

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
#include "coupling/inputs/terrain_input.hpp"

namespace coupling::meshes {
namespace {

using config::joined;
using rockfall::TinFault;

std::string to_cm(double value_m) {
    return config::to_text(std::round(100.0 * value_m) / 100.0);
}

std::string at_place(const Eigen::Vector3d& place_m) {
    return joined(" at ", to_cm(place_m.x()), ", ", to_cm(place_m.y()), ", ", to_cm(place_m.z()));
}

struct FaultWords {
    const char* one;   ///< of what there is one
    const char* many;  ///< the same where there are several
    const char* expected;
};

FaultWords words_of(TinFault fault) {
    switch (fault) {
        case TinFault::no_area:
            return {"face without area", "faces without area", "three corners that are not in one line"};
        case TinFault::doubled:
            return {"doubled face", "doubled faces", "each face once"};
        case TinFault::crowded:
            return {"edge of more than two faces", "edges of more than two faces",
                    "a surface: two faces at an edge, one at a border"};
        case TinFault::flipped:
            return {"flipped face", "flipped faces",
                    "corners counter-clockwise seen from above, as those of the neighbours"};
        case TinFault::overhang:
            return {"overhanging face", "overhanging faces",
                    "one height over each place: only the side that rocks fall on"};
        case TinFault::not_leaned:
            return {"face that a leaning wall turns over", "faces that leaning walls turn over",
                    "walls with a centimetre of ground at least behind and before them"};
        case TinFault::overlap:
            return {"border that lies over another face", "borders that lie over other faces",
                    "one height over each place: parts that do not lie over each other in plan, and seams "
                    "whose vertices are the same"};
        case TinFault::hole:
            return {"hole", "holes", "ground without holes: rocks that reach one have left the terrain"};
        case TinFault::parts:
            break;
    }
    return {"part without connection", "parts without connection", "faces that are connected"};
}

std::string found_in_words(const rockfall::TinFinding& finding) {
    const FaultWords words = words_of(finding.fault);
    std::string text =
        joined(std::to_string(finding.count), " ", finding.count == 1 ? words.one : words.many);
    text += (finding.count > 1 ? ", the first" : "") + at_place(finding.place_m);
    if (finding.fault == TinFault::hole) {
        text += " with " + counted(finding.size, "edge");
    } else if (finding.fault == TinFault::parts) {
        text += " with " + counted(finding.size, "face");
    }
    return text;
}

/// Distance between neighbouring numbers of 32 bits at the largest coordinate [m].
double step_of_single_precision_m(const MeshFile& mesh) {
    double largest_m = 0.0;
    for (const Eigen::Vector3d& point : mesh.points_m) {
        largest_m = std::max(largest_m, point.cwiseAbs().maxCoeff());
    }
    const auto single = static_cast<float>(largest_m);
    return static_cast<double>(std::nextafter(single, std::numeric_limits<float>::infinity()) - single);
}

void doubt_precision(const MeshFile& mesh, const std::string& file, Reading& reading) {
    constexpr double tolerable_m = 0.02;
    if (mesh.single_precision && step_of_single_precision_m(mesh) > tolerable_m) {
        reading.doubt(
            {file},
            joined("coordinates of 32 bits in steps of ", to_cm(step_of_single_precision_m(mesh)), " m"),
            "double precision (PLY: property double), or coordinates from a nearer origin");
    }
}

rockfall::Tin tin_of(MeshFile mesh) {
    rockfall::Tin tin;
    tin.faces.reserve(mesh.faces.size());
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        tin.faces.push_back({mesh.faces[f], mesh.codes.empty() ? 0 : mesh.codes[f] + 1});
    }
    tin.vertices_m = std::move(mesh.points_m);
    return tin;
}

void note_changes(const rockfall::TinChanges& changes, const std::string& file, Reading& reading) {
    if (changes.left_out > 0) {
        reading.note(joined(file, ": ", counted(changes.left_out, "face"), " with a corner twice left out"));
    }
    if (changes.turned_over) {
        reading.note(file + ": all faces look down; turned over");
    }
    if (changes.leaned > 0) {
        reading.note(joined(file, ": ", counted(changes.leaned, "upright face"), " leaned by up to ",
                            to_cm(changes.largest_lean_m), " m in plan"));
    }
}

/// The faces, checked; throws with all faults.
rockfall::Tin checked_tin(MeshFile mesh, const std::string& file, Reading& reading) {
    rockfall::CheckedTin checked = rockfall::checked(tin_of(std::move(mesh)));
    config::Problems faults;
    for (const rockfall::TinFinding& finding : checked.findings) {
        const char* expected = words_of(finding.fault).expected;
        if (rockfall::is_doubt(finding.fault)) {
            reading.doubt({file}, found_in_words(finding), expected);
        } else {
            faults.add(config::ExitCode::data, {file}, found_in_words(finding), expected);
        }
    }
    if (checked.tin.faces.empty()) {
        faults.add(config::ExitCode::data, {file}, "no face with three corners", "a surface");
    }
    faults.throw_if_any();
    note_changes(checked.changes, file, reading);
    return std::move(checked.tin);
}

}  // namespace

MeshFormat format_of(std::string_view bytes, const std::string& name) {
    const auto ends_with = [&](std::string_view ending) {
        std::string low = name.ends_with(".gz") ? name.substr(0, name.size() - 3) : name;
        std::transform(low.begin(), low.end(), low.begin(),
                       [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
        return low.ends_with(ending);
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
    MeshFile mesh;
    mesh.format = "points as text";
    mesh.points_m = read_points(bytes, file);
    return mesh;
}

/// Contours and points as a GIS keeps them, by the ending of their file.
bool names_layer(const std::string& name) {
    const std::string file = formats::split_layer_name(name).file;
    const std::size_t dot = file.find_last_of('.');
    std::string ending = dot == std::string::npos ? "" : file.substr(dot);
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending == ".gpkg" || ending == ".shp" || ending == ".geojson" || ending == ".json";
}

MeshFile read_named_mesh(const std::string& name, Reading& reading) {
    if (names_layer(name)) {
        const config::Table table = reading.table("terrain.mesh", "mesh", name);
        return contours_of(table, table.file());
    }
    const FileBytes bytes = reading.open("terrain.mesh", "mesh", name,
                                         "a mesh (PLY, STL), contours (DXF, CSV, layers) or points as text");
    return read_mesh_file(bytes.text(), reading.shown(name));
}

MeshInput read_mesh(Reading& reading) {
    const std::string& name = reading.scenario().mesh;
    const std::string file = reading.shown(name);
    MeshFile mesh = read_named_mesh(name, reading);
    if (mesh.points_m.size() < 3) {
        config::fail(config::ExitCode::data, {file}, counted(mesh.points_m.size(), "point"),
                     "at least three");
    }
    doubt_precision(mesh, file, reading);
    std::string names;
    for (const std::string& passed : mesh.passed_over) {
        names += (names.empty() ? "" : ", ") + passed;
    }
    if (!names.empty()) {
        reading.note(joined(file, ": passed over: ", names));
    }
    MeshInput input;
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
    input.tin = checked_tin(std::move(mesh), file, reading);
    return input;
}

void name_ground(std::vector<rockfall::TinFace>& faces, const std::vector<rockfall::SurfaceType>& types,
                 Reading& reading) {
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
    const Scenario& scenario = reading.scenario();
    for (const auto& [code, count] : unknown) {
        reading.refuse({reading.shown(scenario.mesh)},
                       joined("surface ", std::to_string(code), " of ", counted(count, "face")),
                       scenario.surface_types.empty()
                           ? std::string{"terrain.surface_types with what the codes mean"}
                           : joined("a code of ", reading.shown(scenario.surface_types), ": ", known));
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
