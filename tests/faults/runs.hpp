#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tests/coupling/inputs/sample_project.hpp"

namespace faults {

/// A small run of one kind, with several finished parts.
struct Run {
    std::string name;
    std::string holds;                                      ///< in a few words, for the table on screen
    std::vector<std::string> parts;                         ///< how names of finished parts begin
    std::vector<std::string> arguments;                     ///< of the program
    std::unique_ptr<coupling::SampleProject> (*project)();  ///< its inputs, in a folder of their own
};

/// A static run, a run over years, a hazard map, a run with nets and stored paths.
const std::vector<Run>& all_runs();

}  // namespace faults
