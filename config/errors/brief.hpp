#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "config/errors/input_error.hpp"

namespace config {

/// Problems of one kind that are printed before the rest is only counted.
inline constexpr std::size_t told_of_a_kind = 3;

/// Problems as a screen shows them, one line each: of those that speak of the same file and differ only in
/// numbers and in what stands in quotes the first three, then how many more there are.
std::vector<std::string> brief(const std::vector<Problem>& problems);

/// The same for sentences: two are of a kind if only their numbers and quoted words differ. `where` says
/// where all of them stand.
std::vector<std::string> brief(const std::vector<std::string>& sentences,
                               const std::string& where = "--verbose prints all");

}  // namespace config
