#include "config/geometry/wkt.hpp"

#include <algorithm>
#include <cctype>
#include <optional>
#include <string>

#include "config/text/numbers.hpp"

namespace config {

namespace {

constexpr std::string_view known_types =
    "POINT, LINESTRING, POLYGON, MULTIPOINT, MULTILINESTRING or MULTIPOLYGON";

bool is_blank(char c) {
    return std::isspace(static_cast<unsigned char>(c)) != 0;
}

class WktReader {
public:
    WktReader(std::string_view text, const Place& start) : text_{text}, start_{start} {}

    Shape read() {
        Shape shape;
        const std::string type = read_type();
        if (type == "POINT" || type == "MULTIPOINT") {
            shape.kind = Shape::Kind::point;
        } else if (type == "LINESTRING" || type == "MULTILINESTRING") {
            shape.kind = Shape::Kind::line;
        } else {
            shape.kind = Shape::Kind::polygon;
        }
        const bool several = type.starts_with("MULTI");
        if (several) {
            read_list([&] { read_member(shape); });
        } else if (shape.kind == Shape::Kind::point) {
            read_point_in_brackets(shape);
        } else {
            read_member(shape);
        }
        skip_blanks();
        if (at_ != text_.size()) {
            refuse(at_, "nothing after the last bracket");
        }
        return shape;
    }

    /// Of the points read so far, in order.
    [[nodiscard]] const std::vector<std::optional<double>>& heights() const { return heights_; }

private:
    /// The type in capitals, without the Z and M that announce further coordinates.
    std::string read_type() {
        skip_blanks();
        const std::size_t start = at_;
        std::string type = read_word();
        while (type.size() > 1 && (type.back() == 'Z' || type.back() == 'M')) {
            type.pop_back();  // no type ends in either letter
        }
        if (type != "POINT" && type != "LINESTRING" && type != "POLYGON" && type != "MULTIPOINT" &&
            type != "MULTILINESTRING" && type != "MULTIPOLYGON") {
            refuse(start, std::string{known_types});
        }
        skip_blanks();
        const std::size_t suffix = at_;
        const std::string dimensions = read_word();
        if (!dimensions.empty() && dimensions != "Z" && dimensions != "M" && dimensions != "ZM") {
            refuse(suffix, "Z, M or an opening bracket");
        }
        return type;
    }

    std::string read_word() {
        std::string word;
        while (at_ < text_.size() && std::isalpha(static_cast<unsigned char>(text_[at_])) != 0) {
            word += static_cast<char>(std::toupper(static_cast<unsigned char>(text_[at_++])));
        }
        return word;
    }

    /// One line, one polygon, or one point with or without brackets of its own.
    void read_member(Shape& shape) {
        skip_blanks();
        if (shape.kind == Shape::Kind::line) {
            shape.parts.push_back(read_points(2));
        } else if (shape.kind == Shape::Kind::polygon) {
            read_list([&] { shape.parts.push_back(read_ring()); });
        } else if (at_ < text_.size() && text_[at_] == '(') {
            read_point_in_brackets(shape);
        } else {
            shape.parts.push_back({read_point()});
        }
    }

    void read_point_in_brackets(Shape& shape) {
        expect('(', "an opening bracket");
        shape.parts.push_back({read_point()});
        expect(')', "a closing bracket");
    }

    std::vector<Point2> read_ring() {
        skip_blanks();
        const std::size_t start = at_;
        std::vector<Point2> ring = read_points(4);
        if (ring.front() != ring.back()) {
            fail(ExitCode::data, place(start), "a ring that is not closed", "the first point again as last");
        }
        return ring;
    }

    std::vector<Point2> read_points(std::size_t fewest) {
        skip_blanks();
        const std::size_t start = at_;
        std::vector<Point2> points;
        read_list([&] { points.push_back(read_point()); });
        if (points.size() < fewest) {
            fail(ExitCode::data, place(start),
                 std::to_string(points.size()).append(points.size() == 1 ? " point" : " points"),
                 std::string{"at least "}.append(std::to_string(fewest)));
        }
        return points;
    }

    /// Members between brackets, divided by commas.
    template <class ReadMember>
    void read_list(ReadMember&& read_one) {
        expect('(', "an opening bracket");
        read_one();
        for (skip_blanks(); at_ < text_.size() && text_[at_] == ','; skip_blanks()) {
            ++at_;
            read_one();
        }
        expect(')', "a comma or a closing bracket");
    }

    Point2 read_point() {
        const double x_m = read_number("x");
        const double y_m = read_number("y");
        const bool has_height = next_is_number();
        heights_.push_back(has_height ? std::optional{read_number("z")} : std::nullopt);
        if (has_height && next_is_number()) {
            read_number("m");
        }
        return {x_m, y_m};
    }

    double read_number(const char* name) {
        skip_blanks();
        const std::size_t end = std::min(text_.find_first_of(" \t\r\n,()", at_), text_.size());
        const std::optional<double> value = parse_number(text_.substr(at_, end - at_));
        if (!value) {
            refuse(at_, std::string{"the number "}.append(name));
        }
        at_ = end;
        return *value;
    }

    bool next_is_number() {
        skip_blanks();
        return at_ < text_.size() && text_[at_] != ',' && text_[at_] != ')' && text_[at_] != '(';
    }

    void expect(char c, const char* in_words) {
        skip_blanks();
        if (at_ == text_.size() || text_[at_] != c) {
            refuse(at_, in_words);
        }
        ++at_;
    }

    void skip_blanks() {
        while (at_ < text_.size() && is_blank(text_[at_])) {
            ++at_;
        }
    }

    [[nodiscard]] Place place(std::size_t at) const { return place_in(text_, at, start_); }

    [[noreturn]] void refuse(std::size_t at, std::string expected) const {
        if (at == text_.size()) {
            fail(ExitCode::data, place(at), "the end of the text", std::move(expected));
        }
        const std::size_t end = std::min(text_.find_first_of(" \t\r\n,()", at), text_.size());
        fail(ExitCode::data, place(at), in_quotes(text_.substr(at, std::max<std::size_t>(end - at, 1))),
             std::move(expected));
    }

    std::string_view text_;
    Place start_;
    std::size_t at_ = 0;
    std::vector<std::optional<double>> heights_;  ///< of all points in order
};

}  // namespace

Shape read_wkt(std::string_view text, const Place& start) {
    return WktReader{text, start}.read();
}

std::vector<std::vector<double>> read_wkt_heights(std::string_view text, const Place& start) {
    WktReader reader{text, start};
    const Shape shape = reader.read();
    std::vector<std::vector<double>> heights;
    auto next = reader.heights().begin();
    for (const std::vector<Point2>& part : shape.parts) {
        const auto end = next + static_cast<std::ptrdiff_t>(part.size());
        const bool all = std::all_of(next, end, [](const auto& height) { return height.has_value(); });
        std::vector<double>& of_part = heights.emplace_back();
        for (; next != end; ++next) {
            if (all) {
                of_part.push_back(**next);
            }
        }
    }
    return heights;
}

}  // namespace config
