#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <iosfwd>
#include <optional>
#include <vector>

#include "coupling/inputs/formats/mesh_file.hpp"
#include "coupling/inputs/places/records.hpp"
#include "coupling/inputs/reading/reading.hpp"
#include "coupling/inputs/terrain/terrain_input.hpp"
#include "rockfall/slope/slope.hpp"
#include "rockfall/terrain/tin.hpp"

namespace coupling::meshes {

/// What terrain.mesh names: faces, or points and lines that are still to be triangulated.
struct MeshInput {
    std::optional<rockfall::Tin> tin;  ///< checked; its faces carry ground codes + 1, 0 where there are none
    std::vector<Eigen::Vector3d> points_m;
    std::vector<rockfall::PointPair> lines;  ///< between the points, to be edges of triangles
    bool has_codes = false;
    std::optional<config::Table> parts{};  ///< of terrain.meshes; faces carry the number of their row, from 1
    std::vector<LeftOutFace> left_out{};   ///< faces that lay below others
    std::string first_file{};              ///< as the scenario names it
};

/// Reads and checks the file. Throws InputError (data) for what no terrain can be made of; doubts holes,
/// parts without connection and coordinates of too few digits; notes what was changed and what was passed
/// over.
MeshInput read_mesh(Reading& reading);

/// Puts the place of a ground type in the list of types, counted from 1, where faces carry its code or the
/// row of their file. Refuses codes and names that are unknown; shipped types that rows name join the list.
void name_ground(HeightInput& heights, std::vector<rockfall::SurfaceType>& types, Reading& reading);

/// What a file holds, for `bannwald info`.
void describe(const MeshFile& mesh, std::ostream& out);

}  // namespace coupling::meshes
