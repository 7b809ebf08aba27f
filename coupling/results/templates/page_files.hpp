#pragma once

#include <string_view>
#include <vector>

namespace coupling::report {

/// A template or style of the pages, built into the program: each .html and .css file of `coupling` and
/// `validation` by its name without folders, as it stands beside the code that uses it.
struct PageFile {
    std::string_view name;
    std::string_view bytes;
};

const std::vector<PageFile>& page_files();

/// Its bytes. Throws std::logic_error where no file has that name.
std::string_view page_file(std::string_view name);

}  // namespace coupling::report
