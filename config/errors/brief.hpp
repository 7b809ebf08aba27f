#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "config/errors/input_error.hpp"

namespace config {

/// Messages of one kind that are printed one by one; of more than these the first stands for all.
inline constexpr std::size_t printed_of_a_kind = 3;

/// A message as a screen or page shows it.
struct BriefMessage {
    std::string sentence;
    std::size_t more = 0;  ///< how many more of its kind there are
};

/// Problems as a screen shows them: of a kind with more than `printed_of_a_kind` the first one and how many
/// more there are. Two are of a kind if they name the same file and differ only in numbers and quoted words.
std::vector<BriefMessage> brief(const std::vector<Problem>& problems);

/// The same for sentences: two are of a kind if only their numbers and quoted words differ.
std::vector<BriefMessage> brief(const std::vector<std::string>& sentences);

/// A line of a terminal: the sentence, and how many more there are and what prints them.
std::string to_string(const BriefMessage& message);

}  // namespace config
