#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "coupling/results/pack/crate.hpp"
#include "coupling/results/pack/run_folder.hpp"

namespace coupling::pack {

/// A file of an archive that is made: a file of the disk, or a text instead of it.
struct PackedFile {
    std::filesystem::path file;
    DescribedFile described;
    std::optional<std::string> text{};
};

/// A file of the disk under a name in the archive. Throws config::InputError (file) for one that is not
/// there.
PackedFile packed_file(const std::filesystem::path& file, std::string name, std::string sentence);

/// The scenario of a run, then all that it read, below `inputs/` by their names for results (InputNames). So
/// files from outside of the project folder lie inside of the archive, and the packed scenario names them
/// there.
///
/// Throws config::InputError: (settings) for settings that changed since the run and for files outside of the
/// project folder that are named in a table, (data) for inputs that changed, (file) for what is missing.
/// `settings` take the place of settings of the command line of the run: results name files from outside of
/// the project folder without their paths.
std::vector<PackedFile> packed_inputs(const RunFolder& run, const std::filesystem::path& scenario,
                                      const std::vector<std::string>& settings);

/// The text of a scenario in which every setting of a file has the name of the archive, which is that of
/// `read`, the scenario as the run read it. Where all have it already it is the text as it was.
std::string packed_scenario(const std::string& text, const Scenario& read, const RunKind& kind);

}  // namespace coupling::pack
