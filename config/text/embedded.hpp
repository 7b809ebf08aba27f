#pragma once

#include <string_view>

/// Builds the bytes of a file into the program, so that it needs no source tree: at file scope, once a name.
/// The build passes the path and the hash of the file, so that another file is another source for compiler
/// caches too (embed_file in coupling/CMakeLists.txt).
#define BANNWALD_EMBED(name, path)                                                           \
    asm(".pushsection .rodata\n"                                                             \
        ".hidden bannwald_" #name "_begin\n.globl bannwald_" #name "_begin\nbannwald_" #name \
        "_begin:\n.incbin \"" path                                                           \
        "\"\n"                                                                               \
        ".hidden bannwald_" #name "_end\n.globl bannwald_" #name "_end\nbannwald_" #name     \
        "_end:\n.byte 0\n.popsection\n");                                                    \
    extern "C" const char bannwald_##name##_begin[];                                         \
    extern "C" const char bannwald_##name##_end[];

/// The bytes of an embedded file.
#define BANNWALD_EMBEDDED(name)                        \
    std::string_view {                                 \
        bannwald_##name##_begin, bannwald_##name##_end \
    }
