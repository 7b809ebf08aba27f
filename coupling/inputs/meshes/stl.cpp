#include <algorithm>
#include <cstring>

#include "config/errors/input_error.hpp"
#include "config/text/numbers.hpp"
#include "config/text/reading.hpp"
#include "coupling/inputs/formats/mesh_file.hpp"
#include "coupling/inputs/reading/reading.hpp"

namespace coupling::meshes {

namespace {

using config::ExitCode;
using config::fail;

constexpr std::size_t header_bytes = 84;
constexpr std::size_t face_bytes = 50;

/// How many faces the header of a binary file promises.
std::uint32_t promised_faces(std::string_view bytes) {
    std::uint32_t count = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        count |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[80 + i])) << (8 * i);
    }
    return count;
}

/// Binary files may begin with `solid` too; those that do not have the length they promise are text.
bool is_text(std::string_view bytes) {
    if (!bytes.starts_with("solid")) {
        return false;
    }
    const bool as_promised = bytes.size() >= header_bytes &&
                             bytes.size() == header_bytes + face_bytes * std::size_t{promised_faces(bytes)};
    return !as_promised && bytes.substr(0, 1000).find('\0') == std::string_view::npos;
}

/// Numbers of 32 bits, little endian.
float float_at(std::string_view bytes, std::size_t at) {
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        bits |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
    }
    float value = 0.0F;
    std::memcpy(&value, &bits, sizeof value);
    return value;
}

void add_face(MeshFile& mesh, const std::array<Eigen::Vector3d, 3>& corners) {
    const auto first = static_cast<std::uint32_t>(mesh.points_m.size());
    mesh.points_m.insert(mesh.points_m.end(), corners.begin(), corners.end());
    mesh.faces.push_back({first, first + 1, first + 2});
}

MeshFile read_binary(std::string_view bytes, const std::string& file) {
    MeshFile mesh;
    mesh.format = "STL, binary";
    mesh.single_precision = true;
    if (bytes.size() < header_bytes) {
        fail(ExitCode::data, {file}, std::to_string(bytes.size()) + " bytes",
             "an STL file, of 84 bytes and more");
    }
    const std::size_t promised = promised_faces(bytes);
    const std::size_t held = (bytes.size() - header_bytes) / face_bytes;
    if (bytes.size() != header_bytes + face_bytes * promised) {
        fail(ExitCode::data, {file},
             std::to_string(bytes.size()) + " bytes, which hold " + counted(held, "face"),
             counted(promised, "face") + ", as its header says");
    }
    for (std::size_t f = 0; f < promised; ++f) {
        std::array<Eigen::Vector3d, 3> corners;
        for (std::size_t corner = 0; corner < 3; ++corner) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const std::size_t at = header_bytes + face_bytes * f + 4 * (3 * (corner + 1) + axis);
                corners[corner][static_cast<Eigen::Index>(axis)] = float_at(bytes, at);
            }
            if (!corners[corner].allFinite()) {
                fail(ExitCode::data, {file},
                     "a coordinate that is no finite number in face " + std::to_string(f + 1) + " of " +
                         std::to_string(promised),
                     "metres");
            }
        }
        add_face(mesh, corners);
    }
    return mesh;
}

/// The words of a text with their lines.
class Words {
public:
    Words(std::string_view text, const std::string& file) : text_{text}, file_{file} {}

    [[nodiscard]] bool at_end() {
        skip_blanks();
        return at_ == text_.size();
    }
    std::string_view next(const char* expected) {
        skip_blanks();
        if (at_ == text_.size()) {
            fail(ExitCode::data, {file_, line_}, "the end of the file", expected);
        }
        const std::size_t end = std::min(text_.find_first_of(" \t\r\n", at_), text_.size());
        const std::string_view word = text_.substr(at_, end - at_);
        at_ = end;
        return word;
    }
    void expect(const char* word) {
        const std::string_view found = next(word);
        if (found != word) {
            refuse(found, word);
        }
    }
    [[noreturn]] void refuse(std::string_view found, const char* expected) const {
        fail(ExitCode::data, {file_, line_}, config::in_quotes(found), expected);
    }
    double number() {
        const std::string_view word = next("a number");
        const auto value = config::parse_number(word);
        if (!value) {
            refuse(word, "a finite number");
        }
        return *value;
    }
    void skip_line() { at_ = std::min(text_.find('\n', at_), text_.size()); }

private:
    void skip_blanks() {
        for (; at_ < text_.size() &&
               (text_[at_] == ' ' || text_[at_] == '\t' || text_[at_] == '\r' || text_[at_] == '\n');
             ++at_) {
            line_ += text_[at_] == '\n' ? 1 : 0;
        }
    }

    std::string_view text_;
    const std::string& file_;
    std::size_t at_ = 0;
    std::size_t line_ = 1;
};

void read_facet(Words& words, MeshFile& mesh) {
    words.expect("normal");
    for (int axis = 0; axis < 3; ++axis) {
        words.next("a number");  // normals of many programs are `nan` where a face is thin: not read
    }
    words.expect("outer");
    words.expect("loop");
    std::array<Eigen::Vector3d, 3> corners;
    for (Eigen::Vector3d& corner : corners) {
        words.expect("vertex");
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
            corner[axis] = words.number();
        }
    }
    words.expect("endloop");
    words.expect("endfacet");
    add_face(mesh, corners);
}

MeshFile read_text(std::string_view text, const std::string& file) {
    MeshFile mesh;
    mesh.format = "STL, ascii";
    Words words{text, file};
    while (!words.at_end()) {
        words.expect("solid");
        words.skip_line();
        while (true) {
            const std::string_view word = words.next("facet or endsolid");
            if (word == "endsolid") {
                words.skip_line();
                break;
            }
            if (word != "facet") {
                words.refuse(word, "facet or endsolid");
            }
            read_facet(words, mesh);
        }
    }
    return mesh;
}

}  // namespace

MeshFile read_stl(std::string_view bytes, const std::string& file) {
    return is_text(bytes) ? read_text(bytes, file) : read_binary(bytes, file);
}

}  // namespace coupling::meshes
