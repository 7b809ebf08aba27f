#pragma once

#include <string>
#include <vector>

#include "coupling/inputs/formats/mesh_file.hpp"
#include "coupling/inputs/places/records.hpp"
#include "coupling/inputs/reading/reading.hpp"
#include "rockfall/terrain/tin.hpp"

namespace coupling::meshes {

/// A coordinate to the centimetre.
std::string to_cm(double value_m);

/// A finding of the check in words, with the place of the first.
std::string found_in_words(const rockfall::TinFinding& finding);

/// Doubts coordinates of 32 bits that are too coarse for where they lie.
void doubt_precision(const MeshFile& mesh, const std::string& file, Reading& reading);

/// Notes what else the file holds.
void note_passed_over(const MeshFile& mesh, const std::string& file, Reading& reading);

/// The faces of a file; each carries its ground code + 1, 0 without one.
rockfall::Tin tin_of(MeshFile mesh);

/// The faces, checked; throws InputError (data) with all faults. With terrain.mesh_overhangs = keep_upper the
/// upper ones of faces that lie over each other stay, and the others go into `left_out`, numbered from 1.
rockfall::Tin checked_tin(const rockfall::Tin& tin, const std::string& file,
                          std::vector<LeftOutFace>& left_out, Reading& reading);

}  // namespace coupling::meshes
