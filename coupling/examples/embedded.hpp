#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace coupling {

/// A file of an example as it stood in coupling/examples when the program was built.
struct ExampleFile {
    std::string example;  ///< such as "tyrol"
    std::string name;     ///< such as "scenario.ini"
    std::string_view bytes;
};

/// All files of all shipped examples, in alphabetical order.
std::vector<ExampleFile> example_files();

/// Names of the shipped examples.
std::vector<std::string> example_names();

}  // namespace coupling
