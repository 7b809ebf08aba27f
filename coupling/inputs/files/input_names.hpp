#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace coupling {

/// The folder that results and archives name for inputs outside of the project folder.
inline constexpr const char* outside_folder = "outside";

/// How results, and messages in them, name the files of a scenario: the same from any working directory, in
/// any home and on any machine. A file in the folder of the scenario or below has its name from there. One
/// elsewhere is `outside/NAME`, without its folders; files of a second folder elsewhere are `outside_2/NAME`.
/// Files of a folder that was shown before, such as one of tiles, keep its name in front of theirs.
/// An archive keeps each input under this name.
class InputNames {
public:
    /// The name of a file for results. `name` is as the scenario has it and `path` leads to it from the
    /// working directory; `folder` is that of the scenario.
    std::string shown(const std::string& name, const std::filesystem::path& path,
                      const std::filesystem::path& folder);

    /// Where the file of a name for results lies, from the working directory: of files that had a name
    /// before, and of those beside them elsewhere. Other names are given back as they are.
    [[nodiscard]] std::string path_of(const std::string& shown) const;

private:
    /// A folder elsewhere; its files are named `outside_NUMBER/...`.
    struct Folder {
        std::filesystem::path path;
        std::size_t number = 1;
    };
    std::string outside(const std::filesystem::path& path, const std::filesystem::path& folder);

    std::vector<Folder> folders_;                                 ///< in the order of their first file
    std::map<std::string, std::string> paths_;                    ///< by name for results
    std::map<std::filesystem::path, std::string> named_folders_;  ///< elsewhere, with their names for results
};

/// Whether a path stays in a folder when all links are followed; neither needs to exist.
bool is_within(const std::filesystem::path& path, const std::filesystem::path& folder);

}  // namespace coupling
