#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace coupling {

struct Scenario;

/// Part `number` (from 1) of `count` of the members of a run over years, for a machine of a cluster.
struct Shard {
    std::uint32_t number = 1;
    std::uint32_t count = 1;
};

/// What the user asked `bannwald run` or `bannwald merge` for.
struct RunRequest {
    std::filesystem::path scenario;
    std::vector<std::string> overrides;  ///< section.key=value
    std::filesystem::path out;           ///< empty: `out` beside the scenario file
    int threads = 0;                     ///< 0: as many as the machine has
    bool overwrite = false;
    bool quiet = false;
    bool verbose = false;
    Shard shard{};
    std::vector<std::filesystem::path>
        shards{};  ///< not empty: nothing is simulated, the parts lie in these folders
    std::filesystem::path inputs_within{};  ///< not empty: inputs elsewhere are refused
};

/// Where the results of a run go: as asked for, or `out` beside the scenario file.
std::filesystem::path output_folder_of(const RunRequest& request, const Scenario& scenario);

}  // namespace coupling
