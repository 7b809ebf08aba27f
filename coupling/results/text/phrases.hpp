#pragma once

#include <string>
#include <string_view>

namespace coupling::report {

/// Words that rooms without pages say (a motion model of itself, a ground type its name) in the language of
/// the page: the phrases of the texts `phrase.*` in it are replaced, the longest ones first. What is no
/// phrase stays English.
std::string in_page_language(std::string_view words);

}  // namespace coupling::report
