#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "tests/coupling/inputs/sample_project.hpp"

namespace fuzz {

/// A folder of valid inputs and the reader of the program that takes them.
struct Subject {
    std::string name;
    std::vector<std::string> files;  ///< of the folder; each is changed while the others stay valid
    std::function<std::unique_ptr<coupling::SampleProject>()> make;
    /// Throws config::InputError for what is wrong with the input, and nothing else.
    std::function<void(const coupling::SampleProject&)> read;
};

/// Scenarios of every kind with all their files.
std::vector<Subject> subjects_of_inputs();
/// Rock masses that break up.
std::vector<Subject> subjects_of_collapse();
/// Meshes and other files by themselves, folders of Rockyfor3D.
std::vector<Subject> subjects_of_files();
/// Validation cases.
std::vector<Subject> subjects_of_cases();
/// What the program itself wrote: parts, checkpoints, stored paths, results.
std::vector<Subject> subjects_of_results();

}  // namespace fuzz
