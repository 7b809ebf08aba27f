#pragma once

#include <cstddef>
#include <istream>
#include <string>
#include <vector>

namespace coupling::refusals {

/// A line of a file of cases, with its number from 1.
struct Line {
    std::size_t number;
    std::string text;
};

/// What is changed in a small project, and what the program then answers (README.md has the form).
struct Case {
    std::string file;
    std::string title;
    std::string project;
    std::vector<Line> lines;  ///< those before the first case of the file, then its own
};

/// The cases of a file. Throws std::runtime_error naming the line of what belongs to no case.
std::vector<Case> read_cases(std::istream& in, const std::string& file);

/// Makes the project, changes it and calls the program, in this process.
///
/// Returns where answers differ from those of the case, each with the lines that are expected (-) and printed
/// (+); "" if none does. Throws std::runtime_error naming a line that has no meaning or changes nothing.
std::string differences(const Case& refusal);

/// A problem is said once, whoever finds it: the lines that stand in an answer a second time, and the columns
/// that are missing twice, each with "said twice: " before it; "" without any.
std::string said_twice(const std::vector<std::string>& answer);

}  // namespace coupling::refusals
