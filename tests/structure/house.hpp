#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace structure {

/// The rooms of the product: whatever holds sources beside the tests.
inline constexpr std::string_view rooms_of_the_house[] = {"config", "rockfall", "forest", "coupling",
                                                          "validation"};

/// A unit is a header with its source, without the ending, from the root: "forest/stand/tree".
using Unit = std::string;

/// Which units a unit includes, by unit; read off the sources of all rooms.
const std::map<Unit, std::set<Unit>>& includes_by_unit();

/// The folder of a unit or folder; "" at the root.
std::string folder_of(const std::string& name);

/// Whether a folder lies in another one, however deep.
bool lies_below(const std::string& folder, const std::string& other);

/// The two folders side by side that hold two units, and lie in the same folder; equal names if one unit lies
/// in a folder that holds the other.
std::pair<std::string, std::string> folders_side_by_side(const Unit& one, const Unit& other);

/// Units that include each other, directly or around several: rings of two and more, largest first.
std::vector<std::vector<Unit>> rings_of_units();

struct Source {
    std::string name;  ///< from the root, with slashes
    std::string text;
};

/// All headers and sources of a room.
std::vector<Source> sources_below(const std::string& room);

}  // namespace structure
