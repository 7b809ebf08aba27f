#pragma once

#include <string>
#include <utility>
#include <vector>

namespace coupling::report {

/// The texts that the scripts of pages write, by key, in the language in use (writing_language.hpp).
std::vector<std::pair<std::string, std::string>> script_texts();

}  // namespace coupling::report
