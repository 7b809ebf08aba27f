#pragma once

#include <memory>
#include <string>

#include "tests/coupling/inputs/sample_project.hpp"
#include "tests/refusals/refusals.hpp"

namespace coupling::refusals {

/// A project of README.md by its name. Throws std::runtime_error if there is none.
std::unique_ptr<SampleProject> make_project(const std::string& name);

/// Carries out a line that changes a project; `content` has what the lines behind a `write` hold. Throws
/// std::runtime_error if the line has no meaning or nothing to change.
void change(const SampleProject& project, const std::string& line, const std::string& content);

}  // namespace coupling::refusals
