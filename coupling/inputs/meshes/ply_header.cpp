#include "coupling/inputs/meshes/ply_header.hpp"

#include <algorithm>
#include <map>

#include "config/errors/input_error.hpp"
#include "config/text/numbers.hpp"

namespace coupling::meshes::ply {
namespace {

using config::ExitCode;
using config::fail;
using config::in_quotes;

std::optional<Type> type_of(std::string_view word) {
    static const std::map<std::string_view, Type> types{
        {"char", Type::int8},      {"int8", Type::int8},       {"uchar", Type::uint8},
        {"uint8", Type::uint8},    {"short", Type::int16},     {"int16", Type::int16},
        {"ushort", Type::uint16},  {"uint16", Type::uint16},   {"int", Type::int32},
        {"int32", Type::int32},    {"uint", Type::uint32},     {"uint32", Type::uint32},
        {"float", Type::float32},  {"float32", Type::float32}, {"double", Type::float64},
        {"float64", Type::float64}};
    const auto found = types.find(word);
    return found == types.end() ? std::nullopt : std::optional{found->second};
}

std::vector<std::string_view> words_of(std::string_view line) {
    std::vector<std::string_view> words;
    while (true) {
        const std::size_t start = line.find_first_not_of(" \t\r");
        if (start == std::string_view::npos) {
            return words;
        }
        line.remove_prefix(start);
        const std::size_t end = std::min(line.find_first_of(" \t\r"), line.size());
        words.push_back(line.substr(0, end));
        line.remove_prefix(end);
    }
}

class HeaderReader {
public:
    HeaderReader(std::string_view bytes, const std::string& file) : bytes_{bytes}, file_{file} {}

    Header read() {
        next_line();  // "ply"
        bool has_format = false;
        while (true) {
            const std::vector<std::string_view> words = words_of(next_line());
            if (words.empty() || words[0] == "comment" || words[0] == "obj_info") {
                continue;
            }
            if (words[0] == "end_header") {
                break;
            }
            if (words[0] == "format") {
                read_format(words);
                has_format = true;
            } else if (words[0] == "element") {
                read_element(words);
            } else if (words[0] == "property") {
                read_property(words);
            } else {
                refuse(words[0], "format, element, property, comment or end_header");
            }
        }
        if (!has_format) {
            fail(ExitCode::data, place(), "a header without format", "format ascii 1.0 or binary");
        }
        header_.bytes = at_;
        header_.lines = line_;
        return header_;
    }

private:
    [[nodiscard]] config::Place place() const { return {file_, line_, 1}; }

    [[noreturn]] void refuse(std::string_view found, const std::string& expected) const {
        fail(ExitCode::data, place(), in_quotes(found), expected);
    }

    std::string_view next_line() {
        ++line_;
        const std::size_t end = bytes_.find('\n', at_);
        if (end == std::string_view::npos) {
            fail(ExitCode::data, place(), "the end of the file within its header", "end_header");
        }
        const std::string_view line = bytes_.substr(at_, end - at_);
        at_ = end + 1;
        return line;
    }

    void read_format(const std::vector<std::string_view>& words) {
        const std::string_view name = words.size() > 1 ? words[1] : "";
        if (name == "ascii") {
            header_.encoding = Encoding::ascii;
        } else if (name == "binary_little_endian") {
            header_.encoding = Encoding::little_endian;
        } else if (name == "binary_big_endian") {
            header_.encoding = Encoding::big_endian;
        } else {
            refuse(name, "ascii, binary_little_endian or binary_big_endian");
        }
    }

    void read_element(const std::vector<std::string_view>& words) {
        const auto count = words.size() == 3 ? config::parse_whole(words[2]) : std::nullopt;
        constexpr long long most = 4'000'000'000LL;
        if (!count || *count < 0 || *count > most) {
            refuse(words.size() == 3 ? words[2] : "element", "element, a name and a number up to 4e9");
        }
        const bool doubled = std::any_of(header_.elements.begin(), header_.elements.end(),
                                         [&](const Element& other) { return other.name == words[1]; });
        if (doubled) {
            fail(ExitCode::data, place(), "element " + in_quotes(words[1]) + " a second time",
                 "each element once");
        }
        header_.elements.push_back({std::string{words[1]}, static_cast<std::uint64_t>(*count), {}});
    }

    void read_property(const std::vector<std::string_view>& words) {
        const bool is_list = words.size() == 5 && words[1] == "list";
        const auto type = words.size() >= 3 ? type_of(words[is_list ? 3 : 1]) : std::nullopt;
        const auto count_type = is_list ? type_of(words[2]) : std::nullopt;
        if (header_.elements.empty() || !type || (is_list ? !count_type : words.size() != 3)) {
            fail(ExitCode::data, place(), "a property that cannot be read",
                 "property, a type and a name; or property list, two types and a name; after an element");
        }
        std::vector<Property>& properties = header_.elements.back().properties;
        const bool doubled = std::any_of(properties.begin(), properties.end(),
                                         [&](const Property& other) { return other.name == words.back(); });
        if (doubled) {
            fail(ExitCode::data, place(), "property " + in_quotes(words.back()) + " a second time",
                 "each property of an element once");
        }
        properties.push_back({std::string{words.back()}, *type, count_type});
    }

    std::string_view bytes_;
    const std::string& file_;
    std::size_t at_ = 0;
    std::size_t line_ = 0;
    Header header_;
};

}  // namespace

Header read_header(std::string_view bytes, const std::string& file) {
    return HeaderReader{bytes, file}.read();
}

}  // namespace coupling::meshes::ply
