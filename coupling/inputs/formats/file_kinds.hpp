#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace coupling::formats {

/// A kind of file that people have and that is not read here: what it is recognised by, its name, one way
/// out.
struct FileKind {
    std::string_view name;     ///< with its article, in messages
    std::string_view way_out;  ///< what to do with it; the word IN stands for the name of the file
    std::string_view begins;   ///< its first bytes, capitals of letters do not count; empty: any
    std::size_t at = 0;        ///< where `begins` stands
    std::string_view root;     ///< of XML: its outermost element, without what stands before a colon
    std::string_view holds;    ///< what else stands near its beginning or its end; empty: anything
    /// Endings of its name, in small letters. They are asked for where `begins`, `root` and `holds` leave
    /// several kinds, and alone where all of these are empty. None: any name.
    std::array<std::string_view, 6> endings{};
};

/// The table of all such kinds, special ones before general ones.
std::span<const FileKind> other_file_kinds();

/// The kind of a file by its bytes and its name; nullptr where it is none of the table.
const FileKind* other_file_kind(std::string_view bytes, const std::string& name);

/// A mesh or drawing, which is read as terrain only; nullptr where it is none.
const FileKind* mesh_kind(std::string_view bytes, const std::string& name);

/// A kind of folder that other programs take for one file, such as a file geodatabase; nullptr: none.
const FileKind* folder_kind(const std::string& name);

/// What to do with a file of a kind: `way_out` with the name of the file in its commands, and the code of UTM
/// where a tile of degrees says by its name where it lies.
std::string advice_of(const FileKind& kind, const std::string& file);

bool is_utf16(std::string_view bytes);

/// Throws InputError (data) where a file is of a kind of the table, or empty.
void refuse_other_file_kinds(std::string_view bytes, const std::string& file, const char* expected);
/// Throws InputError (data) where bytes that ought to be text hold zeros.
void refuse_unknown_bytes(std::string_view bytes, const std::string& file, const char* expected);

}  // namespace coupling::formats
