#pragma once

#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

#include "coupling/results/pack/crate.hpp"

namespace coupling::pack {

/// What `bannwald pack` is asked for.
struct PackRequest {
    std::filesystem::path run;          ///< folder of a finished run
    std::filesystem::path scenario;     ///< empty: the file of that name beside the folder
    std::filesystem::path out;          ///< empty: the folder's name with .zip
    std::vector<std::string> settings;  ///< section.key=value: paths that the command line of the run gave
    Citation citation;                  ///< no date: the day on which the run ended (UTC)
    bool overwrite = false;
    bool quiet = false;
};

/// Puts a finished run into an archive: inputs, scenario, results, checksums, the command, RO-Crate and
/// DataCite descriptions. Inputs and settings must still be those of the run. The same folder gives the same
/// bytes.
///
/// Throws config::InputError: (settings) for an archive that is there, an input outside of the scenario's
/// disk tree, settings that changed; (file) for what is missing; (data) for inputs that changed.
void pack_run(const PackRequest& request, std::ostream& screen);

}  // namespace coupling::pack
