#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "config/errors/input_error.hpp"
#include "config/text/numbers.hpp"
#include "config/text/reading.hpp"
#include "coupling/inputs/formats/mesh_file.hpp"
#include "coupling/inputs/meshes/ply_header.hpp"

namespace coupling::meshes {

namespace {

using config::ExitCode;
using config::fail;
using config::in_quotes;
using ply::Element;
using ply::Encoding;
using ply::Header;
using ply::Property;
using ply::Type;

template <class T>
double number_at(const char* bytes, bool swap) {
    std::array<char, sizeof(T)> raw{};
    std::memcpy(raw.data(), bytes, sizeof(T));
    if (swap) {
        std::reverse(raw.begin(), raw.end());
    }
    return static_cast<double>(std::bit_cast<T>(raw));
}

/// The values after the header, one after the other.
class Values {
public:
    Values(std::string_view bytes, const Header& header, const std::string& file)
        : bytes_{bytes},
          file_{file},
          encoding_{header.encoding},
          at_{header.bytes},
          line_{header.lines + 1} {}

    /// Names what is read, for messages.
    void begin(const Element& element, std::uint64_t number) {
        element_ = &element;
        number_ = number;
    }

    double next(Type type) { return encoding_ == Encoding::ascii ? next_word() : next_binary(type); }

    [[noreturn]] void refuse(std::string found, std::string expected) const {
        fail(ExitCode::data, place(), found + in_words(), std::move(expected));
    }
    [[nodiscard]] bool at_end() {
        if (encoding_ == Encoding::ascii) {
            skip_blanks();
        }
        return at_ >= bytes_.size();
    }

private:
    [[nodiscard]] config::Place place() const {
        return encoding_ == Encoding::ascii ? config::Place{file_, line_, 0} : config::Place{file_};
    }
    [[nodiscard]] std::string in_words() const {
        return " in " + element_->name + " " + std::to_string(number_ + 1) + " of " +
               std::to_string(element_->count);
    }
    void skip_blanks() {
        for (; at_ < bytes_.size() &&
               (bytes_[at_] == ' ' || bytes_[at_] == '\n' || bytes_[at_] == '\r' || bytes_[at_] == '\t');
             ++at_) {
            line_ += bytes_[at_] == '\n' ? 1 : 0;
        }
    }
    double next_word() {
        skip_blanks();
        if (at_ == bytes_.size()) {
            refuse("the end of the file", "as many values as the header says");
        }
        const std::size_t end = std::min(bytes_.find_first_of(" \t\r\n", at_), bytes_.size());
        const std::string_view word = bytes_.substr(at_, end - at_);
        const auto value = config::parse_number(word);
        if (!value) {
            refuse(in_quotes(word), "a finite number");
        }
        at_ = end;
        return *value;
    }
    double next_binary(Type type) {
        static constexpr std::array<std::size_t, 8> sizes{1, 1, 2, 2, 4, 4, 4, 8};
        const std::size_t size = sizes[static_cast<std::size_t>(type)];
        if (bytes_.size() - at_ < size) {
            refuse("the end of the file", "as many values as the header says");
        }
        const char* bytes = bytes_.data() + at_;
        const bool swap = (encoding_ == Encoding::big_endian) == (std::endian::native == std::endian::little);
        at_ += size;
        switch (type) {
            case Type::int8:
                return number_at<std::int8_t>(bytes, swap);
            case Type::uint8:
                return number_at<std::uint8_t>(bytes, swap);
            case Type::int16:
                return number_at<std::int16_t>(bytes, swap);
            case Type::uint16:
                return number_at<std::uint16_t>(bytes, swap);
            case Type::int32:
                return number_at<std::int32_t>(bytes, swap);
            case Type::uint32:
                return number_at<std::uint32_t>(bytes, swap);
            case Type::float32:
                return number_at<float>(bytes, swap);
            case Type::float64:
                break;
        }
        return number_at<double>(bytes, swap);
    }

    std::string_view bytes_;
    const std::string& file_;
    Encoding encoding_;
    std::size_t at_;
    std::size_t line_;
    const Element* element_ = nullptr;
    std::uint64_t number_ = 0;
};

/// Reads over the values of a property that nobody asks for.
void pass_over(const Property& property, Values& values) {
    double count = property.count_type ? values.next(*property.count_type) : 1.0;
    for (; count >= 1.0; count -= 1.0) {
        values.next(property.type);
    }
}

void read_vertices(const Element& element, Values& values, MeshFile& mesh) {
    std::vector<int> axis_of;
    std::array<bool, 3> has{};
    for (const Property& property : element.properties) {
        const auto axis = property.count_type ? std::string::npos : std::string{"xyz"}.find(property.name);
        const bool is_axis = property.name.size() == 1 && axis != std::string::npos;
        axis_of.push_back(is_axis ? static_cast<int>(axis) : -1);
        if (is_axis) {
            has[axis] = true;
            mesh.single_precision = mesh.single_precision || property.type == Type::float32;
        } else {
            mesh.passed_over.push_back("vertex." + property.name);
        }
    }
    values.begin(element, 0);
    if (!has[0] || !has[1] || !has[2]) {
        values.refuse("properties without x, y and z", "all three");
    }
    for (std::uint64_t i = 0; i < element.count; ++i) {
        values.begin(element, i);
        Eigen::Vector3d point = Eigen::Vector3d::Zero();
        for (std::size_t k = 0; k < axis_of.size(); ++k) {
            if (axis_of[k] < 0) {
                pass_over(element.properties[k], values);
                continue;
            }
            point[axis_of[k]] = values.next(element.properties[k].type);
        }
        if (!point.allFinite()) {
            values.refuse("a coordinate that is no finite number", "metres");
        }
        mesh.points_m.push_back(point);
    }
}

void read_corners(const Property& property, std::uint64_t vertices, Values& values, MeshFile& mesh) {
    const double count = values.next(*property.count_type);
    if (count != 3.0) {
        values.refuse(config::to_text(count) + " corners", "triangles");
    }
    std::array<std::uint32_t, 3> corners{};
    for (std::uint32_t& corner : corners) {
        const double index = values.next(property.type);
        if (!(index >= 0.0 && index < static_cast<double>(vertices)) || index != std::floor(index)) {
            values.refuse("vertex " + config::to_text(index),
                          "a number from 0 to " + std::to_string(vertices - 1));
        }
        corner = static_cast<std::uint32_t>(index);
    }
    mesh.faces.push_back(corners);
}

void read_faces(const Element& element, std::uint64_t vertices, Values& values, MeshFile& mesh) {
    const auto is_corners = [](const Property& p) {
        return p.count_type && (p.name == "vertex_indices" || p.name == "vertex_index");
    };
    const auto is_surface = [](const Property& p) { return !p.count_type && p.name == "surface"; };
    values.begin(element, 0);
    if (element.count > 0 && std::none_of(element.properties.begin(), element.properties.end(), is_corners)) {
        values.refuse("properties without vertex_indices", "a list of the corners of each face");
    }
    for (const Property& property : element.properties) {
        if (!is_corners(property) && !is_surface(property)) {
            mesh.passed_over.push_back("face." + property.name);
        }
    }
    for (std::uint64_t i = 0; i < element.count; ++i) {
        values.begin(element, i);
        for (const Property& property : element.properties) {
            if (is_corners(property)) {
                read_corners(property, vertices, values, mesh);
            } else if (is_surface(property)) {
                const double code = values.next(property.type);
                if (!(code >= 0.0 && code <= largest_code) || code != std::floor(code)) {
                    values.refuse("surface " + config::to_text(code),
                                  "a whole number from 0 to " + std::to_string(largest_code));
                }
                mesh.codes.push_back(static_cast<std::uint32_t>(code));
            } else {
                pass_over(property, values);
            }
        }
    }
}

}  // namespace

MeshFile read_ply(std::string_view bytes, const std::string& file) {
    const Header header = ply::read_header(bytes, file);
    MeshFile mesh;
    mesh.format = header.encoding == Encoding::ascii           ? "PLY, ascii"
                  : header.encoding == Encoding::little_endian ? "PLY, binary, little endian"
                                                               : "PLY, binary, big endian";
    Values values{bytes, header, file};
    std::optional<std::uint64_t> vertices;
    for (const Element& element : header.elements) {
        if (element.name == "vertex") {
            read_vertices(element, values, mesh);
            vertices = element.count;
        } else if (element.name == "face" && vertices) {
            read_faces(element, *vertices, values, mesh);
        } else {
            if (element.name == "face") {
                fail(ExitCode::data, {file}, "faces before the vertices", "element vertex first");
            }
            mesh.passed_over.push_back(element.name);
            const std::uint64_t count = element.properties.empty() ? 0 : element.count;
            for (std::uint64_t i = 0; i < count; ++i) {
                values.begin(element, i);
                for (const Property& property : element.properties) {
                    pass_over(property, values);
                }
            }
        }
    }
    if (!vertices) {
        fail(ExitCode::data, {file}, "no element vertex", "vertices with x, y and z");
    }
    if (!mesh.codes.empty() && mesh.codes.size() != mesh.faces.size()) {
        fail(ExitCode::data, {file}, "both vertex_indices and vertex_index in each face",
             "one list of corners");
    }
    if (!values.at_end()) {
        fail(ExitCode::data, {file}, "more values than the header says", "the end of the file");
    }
    return mesh;
}

}  // namespace coupling::meshes
