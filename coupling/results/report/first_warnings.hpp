#pragma once

#include <set>
#include <string>
#include <vector>

#include "config/errors/warnings.hpp"

namespace coupling::report {

/// The warnings for the first screen of a page, behind its answers and assumptions, the largest effect first:
/// of many of a kind the first one and how many more there are; beyond the first five lines folded.
/// "" without any. Notes stand behind the results (`list_of_warnings`).
std::string first_warnings(const config::Warnings& warnings);

/// Whether it shows each of them open and by itself, so that paper needs no second list.
bool are_all_first(const config::Warnings& warnings);

/// Those that it shows open and by themselves, which paper does not repeat.
std::set<std::string> open_first(const config::Warnings& warnings);

/// The same for the sentences of several runs, as they are. `where` says where all of them stand.
std::string first_warnings(const std::vector<std::string>& sentences, const std::string& where);

/// "3 warnings about this run", which leads there; "" without any. Stands between title and answers of each
/// page.
std::string link_to_first_warnings(const config::Warnings& warnings);
std::string link_to_first_warnings(const std::vector<std::string>& sentences);

}  // namespace coupling::report
