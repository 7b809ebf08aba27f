#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace coupling {

/// What the user asked `bannwald run` for.
struct RunRequest {
    std::filesystem::path scenario;
    std::vector<std::string> overrides;  ///< section.key=value
    std::filesystem::path out;           ///< empty: `out` beside the scenario file
    int threads = 0;                     ///< 0: as many as the machine has
    bool overwrite = false;
    bool quiet = false;
    bool verbose = false;
};

/// Runs the static assessment of a scenario: reads, checks, lets the rocks fall with and without forest,
/// writes the results.
///
/// A scenario with terrain.profile runs in two dimensions instead (coupling/profile).
///
/// Returns 0, or 75 if the user interrupted it: finished parts stay and the next call goes on from them.
/// Throws config::InputError; then no new output folder is left.
int run_assessment(const RunRequest& request);

}  // namespace coupling
