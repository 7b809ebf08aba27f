#include "coupling/examples/embedded.hpp"

#include <algorithm>
#include <array>

// Each file becomes a pair of symbols around its bytes. The list of files is written by
// coupling/CMakeLists.txt.
#define EXAMPLE(number, example, name)                                                                       \
    asm(".pushsection .rodata\n"                                                                             \
        ".hidden bannwald_example_" #number "_begin\n.globl bannwald_example_" #number                       \
        "_begin\nbannwald_example_" #number "_begin:\n.incbin \"" BANNWALD_EXAMPLES_DIR "/" example "/" name \
        "\"\n"                                                                                               \
        ".hidden bannwald_example_" #number "_end\n.globl bannwald_example_" #number                         \
        "_end\nbannwald_example_" #number "_end:\n.byte 0\n.popsection\n");                                  \
    extern "C" const char bannwald_example_##number##_begin[];                                               \
    extern "C" const char bannwald_example_##number##_end[];
#include "example_files.inc"
#undef EXAMPLE

namespace coupling {
namespace {

/// An example that takes the files that it does not bring from another one.
struct Based {
    std::string_view example;
    std::string_view on;
};
constexpr std::array based_examples{Based{"calibrate", "tyrol"}, Based{"calibrate-sites", "tyrol"}};

}  // namespace

std::vector<ExampleFile> example_files() {
    std::vector<ExampleFile> files;
#define EXAMPLE(number, example, name) \
    files.push_back({example, name, {bannwald_example_##number##_begin, bannwald_example_##number##_end}});
#include "example_files.inc"
#undef EXAMPLE
    for (const Based& based : based_examples) {
        const std::vector<ExampleFile> own = files;
        for (const ExampleFile& file : own) {
            const bool is_own = std::any_of(own.begin(), own.end(), [&](const ExampleFile& other) {
                return other.example == based.example && other.name == file.name;
            });
            if (file.example == based.on && !is_own) {
                files.push_back({std::string{based.example}, file.name, file.bytes});
            }
        }
    }
    // As folders sort: "regimes-small/" before "regimes/".
    std::sort(files.begin(), files.end(), [](const ExampleFile& a, const ExampleFile& b) {
        return a.example + '/' + a.name < b.example + '/' + b.name;
    });
    return files;
}

std::vector<std::string> example_names() {
    std::vector<std::string> names;
    for (const ExampleFile& file : example_files()) {
        if (std::find(names.begin(), names.end(), file.example) == names.end()) {
            names.push_back(file.example);
        }
    }
    return names;
}

}  // namespace coupling
