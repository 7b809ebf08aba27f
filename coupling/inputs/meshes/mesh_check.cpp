#include "coupling/inputs/meshes/mesh_check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/places/records.hpp"
#include "coupling/inputs/scenario/terrain_settings.hpp"
#include "rockfall/terrain/upper_surface.hpp"

namespace coupling::meshes {

using config::joined;
using rockfall::TinFault;

std::string to_cm(double value_m) {
    return config::to_text(std::round(100.0 * value_m) / 100.0);
}

namespace {

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

}  // namespace

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

namespace {

/// Distance between neighbouring numbers of 32 bits at the largest coordinate [m].
double step_of_single_precision_m(const MeshFile& mesh) {
    double largest_m = 0.0;
    for (const Eigen::Vector3d& point : mesh.points_m) {
        largest_m = std::max(largest_m, point.cwiseAbs().maxCoeff());
    }
    const auto single = static_cast<float>(largest_m);
    return static_cast<double>(std::nextafter(single, std::numeric_limits<float>::infinity()) - single);
}

}  // namespace

void doubt_precision(const MeshFile& mesh, const std::string& file, Reading& reading) {
    constexpr double tolerable_m = 0.02;
    if (mesh.single_precision && step_of_single_precision_m(mesh) > tolerable_m) {
        reading.warn(
            {file},
            joined("coordinates of 32 bits in steps of ", to_cm(step_of_single_precision_m(mesh)), " m"),
            "double precision (PLY: property double), or coordinates from a nearer origin", "",
            config::Effect::detail);
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

namespace {

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

/// The upper ones of faces that lie over each other; what was left out goes into `left_out`.
rockfall::Tin upper_faces(const rockfall::Tin& tin, const std::string& file,
                          std::vector<LeftOutFace>& left_out, Reading& reading) {
    rockfall::UpperSurface upper = rockfall::upper_surface(tin);
    for (const rockfall::CoveredFace& face : upper.left_out) {
        left_out.push_back({"", face.number + 1, face.corners_m});
    }
    if (!upper.left_out.empty()) {
        reading.warn(joined(file, ": ", counted(upper.left_out.size(), "face"), " of ",
                            std::to_string(tin.faces.size()), " left out below others, the first",
                            at_place(upper.left_out.front().corners_m[0]), "; ", "gaps closed in plan by ",
                            counted(upper.filled, "new face"), " (mesh_left_out.csv lists what is gone)"));
    }
    return std::move(upper.tin);
}

bool has_faults(const rockfall::CheckedTin& checked) {
    return std::any_of(checked.findings.begin(), checked.findings.end(),
                       [](const rockfall::TinFinding& one) { return !rockfall::is_doubt(one.fault); });
}

}  // namespace

rockfall::Tin checked_tin(const rockfall::Tin& tin, const std::string& file,
                          std::vector<LeftOutFace>& left_out, Reading& reading) {
    const bool keeps_upper = reading.terrain().mesh_overhangs == MeshOverhangs::keep_upper;
    rockfall::CheckedTin checked = rockfall::checked(tin);
    if (keeps_upper && has_faults(checked)) {
        checked = rockfall::checked(upper_faces(tin, file, left_out, reading));
    }
    config::Problems faults;
    for (const rockfall::TinFinding& finding : checked.findings) {
        const char* expected = words_of(finding.fault).expected;
        if (rockfall::is_doubt(finding.fault)) {
            reading.warn({file}, found_in_words(finding), expected);
        } else {
            const bool lies_over = finding.fault == TinFault::overhang || finding.fault == TinFault::overlap;
            faults.add(config::ExitCode::data, {file}, found_in_words(finding), expected,
                       lies_over && !keeps_upper
                           ? "terrain.mesh_overhangs = keep_upper leaves out what lies below"
                           : "");
        }
    }
    if (checked.tin.faces.empty()) {
        faults.add(config::ExitCode::data, {file}, "no face with three corners", "a surface");
    }
    faults.throw_if_any();
    note_changes(checked.changes, file, reading);
    return std::move(checked.tin);
}

void note_passed_over(const MeshFile& mesh, const std::string& file, Reading& reading) {
    std::string names;
    for (const std::string& passed : mesh.passed_over) {
        names += (names.empty() ? "" : ", ") + passed;
    }
    if (!names.empty()) {
        reading.note(joined(file, ": passed over: ", names));
    }
}

}  // namespace coupling::meshes
