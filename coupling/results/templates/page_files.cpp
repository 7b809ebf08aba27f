#include "coupling/results/templates/page_files.hpp"

#include <algorithm>
#include <stdexcept>

#include "config/text/embedded.hpp"
#include "config/text/joined.hpp"

// The list of files is written by coupling/CMakeLists.txt.
#define PAGE_FILE(number, folder, file) \
    BANNWALD_EMBED(page_file_##number, BANNWALD_PAGES_DIR "/" folder "/" file)
#include "page_files.inc"
#undef PAGE_FILE

namespace coupling::report {

const std::vector<PageFile>& page_files() {
#define PAGE_FILE(number, folder, file) {file, BANNWALD_EMBEDDED(page_file_##number)},
    static const std::vector<PageFile> files{
#include "page_files.inc"
    };
#undef PAGE_FILE
    return files;
}

std::string_view page_file(std::string_view name) {
    const auto found = std::find_if(page_files().begin(), page_files().end(),
                                    [&](const PageFile& file) { return file.name == name; });
    if (found == page_files().end()) {
        throw std::logic_error(config::joined("no such file of the pages: ", name));
    }
    return found->bytes;
}

}  // namespace coupling::report
