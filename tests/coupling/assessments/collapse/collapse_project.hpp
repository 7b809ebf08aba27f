#pragma once

#include "coupling/examples/embedded.hpp"
#include "tests/coupling/inputs/sample_project.hpp"

namespace coupling {

/// The example collapse-small in a folder of its own.
inline void write_small_collapse(const SampleProject& project) {
    for (const ExampleFile& file : example_files()) {
        if (file.example == "collapse-small") {
            project.write(file.name, std::string{file.bytes});
        }
    }
}

}  // namespace coupling
