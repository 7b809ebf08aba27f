#pragma once

#include <filesystem>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "config/errors/warnings.hpp"
#include "coupling/inputs/files/input_names.hpp"

namespace coupling {

/// What `check` is asked for.
struct CheckRequest {
    std::filesystem::path scenario;
    std::vector<std::string> overrides{};
    std::vector<std::string> models{};  ///< motion models of a run under several; none: that of the scenario
    std::filesystem::path out{};        ///< of the run; empty: `out` beside the scenario file
    int threads = 0;                    ///< 0: as many as the machine has
    std::filesystem::path page{};       ///< of a run over years: where its regimes act; empty: none
    bool overwrite = false;
    bool print_settings = false;
};

/// Reads everything that a scenario names and says what the run will be. Throws InputError with all
/// problems. Warnings are in `warnings` even then.
/// `names` gets how results name the files, as soon as the scenario is read.
void check_scenario(const CheckRequest& request, config::Warnings& warnings, std::ostream& out,
                    std::shared_ptr<const InputNames>* names = nullptr);

}  // namespace coupling
