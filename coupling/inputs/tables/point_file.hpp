#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

namespace coupling::tables {

/// Points from text, and what there is to say about how they were read.
struct PointFile {
    std::vector<Eigen::Vector3d> points;
    std::vector<std::string> notes;
};

/// Reads points: one a line, fields apart by blanks, tabs, semicolons or commas; `#` begins a comment.
///
/// A header says which columns are x, y and z, by the names that tables have (x, easting, Rechtswert,
/// elevation,
/// ...); it may stand behind `#` or `//`. Other columns are named in a note. Without a header the first three
/// columns are x, y and z, which a note says of four or more; a first column that counts the points is
/// refused. Commas between digits are decimal commas where something else separates the fields.
///
/// Throws InputError (data) for up to 20 lines that are no points, and for a header without x, y and z.
PointFile read_point_file(std::string_view text, const std::string& file);

}  // namespace coupling::tables
