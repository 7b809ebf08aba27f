#include "config/geometry/wkt.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>

#include "config/geometry/arcs.hpp"
#include "config/text/numbers.hpp"
#include "config/text/reading.hpp"

namespace config {

namespace {

constexpr std::string_view known_types =
    "POINT, LINESTRING, POLYGON, MULTIPOINT, MULTILINESTRING, MULTIPOLYGON, or a curve of arcs";

/// What a type of text is made of.
enum class WktType : std::uint8_t {
    point,
    line,
    polygon,
    arcs,
    compound,
    curve_polygon,
    points,
    lines,
    polygons,
    curves,
    surfaces
};

struct NamedType {
    std::string_view name;
    WktType type;
};
constexpr std::array wkt_types{NamedType{"POINT", WktType::point},
                               NamedType{"LINESTRING", WktType::line},
                               NamedType{"POLYGON", WktType::polygon},
                               NamedType{"CIRCULARSTRING", WktType::arcs},
                               NamedType{"COMPOUNDCURVE", WktType::compound},
                               NamedType{"CURVEPOLYGON", WktType::curve_polygon},
                               NamedType{"MULTIPOINT", WktType::points},
                               NamedType{"MULTILINESTRING", WktType::lines},
                               NamedType{"MULTIPOLYGON", WktType::polygons},
                               NamedType{"MULTICURVE", WktType::curves},
                               NamedType{"MULTISURFACE", WktType::surfaces}};

Shape::Kind kind_of(WktType type) {
    switch (type) {
        case WktType::point:
        case WktType::points:
            return Shape::Kind::point;
        case WktType::line:
        case WktType::arcs:
        case WktType::compound:
        case WktType::lines:
        case WktType::curves:
            return Shape::Kind::line;
        default:
            return Shape::Kind::polygon;
    }
}

class WktReader {
public:
    WktReader(std::string_view text, const Place& start) : text_{text}, start_{start} {}

    Shape read() {
        const WktType type = read_type();
        Shape shape;
        shape.kind = kind_of(type);
        read_body(type, shape);
        skip_blanks();
        if (at_ != text_.size()) {
            refuse(at_, "nothing after the last bracket");
        }
        return shape;
    }

    /// Of the points read so far, in order.
    [[nodiscard]] const std::vector<std::optional<double>>& heights() const { return heights_; }

private:
    /// The type, without the Z and M that announce further coordinates.
    WktType read_type() {
        skip_blanks();
        const std::size_t start = at_;
        std::string name = read_word();
        while (name.size() > 1 && (name.back() == 'Z' || name.back() == 'M')) {
            name.pop_back();  // no type ends in either letter
        }
        const auto known = std::find_if(wkt_types.begin(), wkt_types.end(),
                                        [&](const NamedType& type) { return type.name == name; });
        if (known == wkt_types.end()) {
            refuse(start, std::string{known_types});
        }
        skip_blanks();
        const std::size_t suffix = at_;
        const std::string dimensions = read_word();
        if (!dimensions.empty() && dimensions != "Z" && dimensions != "M" && dimensions != "ZM") {
            if (dimensions == "EMPTY") {
                fail(ExitCode::data, place(suffix), "an empty shape", "coordinates in brackets",
                     "draw the shape, or delete the row");
            }
            refuse(suffix, "Z, M or an opening bracket");
        }
        return known->type;
    }

    /// The type that a member names, or else `usual`; one of `allowed`.
    WktType read_member_type(WktType usual, std::initializer_list<WktType> allowed) {
        skip_blanks();
        const std::size_t start = at_;
        if (at_ < text_.size() && text_[at_] == '(') {
            return usual;
        }
        const WktType type = read_type();
        if (type != usual && std::find(allowed.begin(), allowed.end(), type) == allowed.end()) {
            refuse(start, "a part of another type");
        }
        return type;
    }

    void read_body(WktType type, Shape& shape) {
        switch (type) {
            case WktType::point:
                return read_point_in_brackets(shape);
            case WktType::points:
                return read_list([&] { read_member_point(shape); });
            case WktType::line:
            case WktType::arcs:
            case WktType::compound:
                shape.parts.push_back(read_curve(type));
                return;
            case WktType::lines:
            case WktType::curves:
                return read_list([&] {
                    const auto member = read_member_type(WktType::line, {WktType::arcs, WktType::compound});
                    shape.parts.push_back(read_curve(member));
                });
            case WktType::polygon:
                return read_list([&] { shape.parts.push_back(read_ring(WktType::line)); });
            case WktType::curve_polygon:
                return read_list([&] {
                    skip_blanks();
                    const auto member = read_member_type(WktType::line, {WktType::arcs, WktType::compound});
                    shape.parts.push_back(read_ring(member));
                });
            case WktType::polygons:
            case WktType::surfaces:
                return read_list(
                    [&] { read_body(read_member_type(WktType::polygon, {WktType::curve_polygon}), shape); });
        }
    }

    std::vector<Point2> read_curve(WktType type) {
        return type == WktType::arcs       ? read_arcs()
               : type == WktType::compound ? read_compound()
                                           : read_points(2);
    }

    /// Arcs one behind the other, each of three points of which the last begins the next.
    std::vector<Point2> read_arcs() {
        skip_blanks();
        const std::size_t start = at_;
        const std::size_t first_height = heights_.size();
        const std::vector<Point2> given = read_points(3);
        if (given.size() % 2 == 0) {
            fail(ExitCode::data, place(start), std::to_string(given.size()).append(" points of arcs"),
                 "an odd number: each arc has a start, a middle and an end");
        }
        const std::vector<std::optional<double>> given_heights{
            heights_.begin() + static_cast<std::ptrdiff_t>(first_height), heights_.end()};
        heights_.resize(first_height + 1);
        std::vector<Point2> stroked{given.front()};
        for (std::size_t i = 0; i + 2 < given.size(); i += 2) {
            for (const ArcPoint& point : stroke_arc(given[i], given[i + 1], given[i + 2])) {
                stroked.push_back(point.place);
                heights_.push_back(height_along(&given_heights[i], point.along));
            }
            constexpr std::size_t most_points = 1'000'000;  // of one shape: above, damage [choice]
            if (heights_.size() > most_points) {
                fail(ExitCode::data, place(start), "arcs of more than a million points",
                     "arcs of common size", "convert them to lines (ogr2ogr -nlt CONVERT_TO_LINEAR)");
            }
        }
        return stroked;
    }

    /// Of three heights along an arc, the one at `along`, from 0 to 2.
    static std::optional<double> height_along(const std::optional<double>* heights, double along) {
        const std::size_t half = along < 1.0 ? 0 : 1;
        const double share = along - static_cast<double>(half);
        if (!heights[half] || !heights[half + 1]) {
            return std::nullopt;
        }
        // The ends keep the bits that were given.
        return share >= 1.0   ? *heights[half + 1]
               : share <= 0.0 ? *heights[half]
                              : (1.0 - share) * *heights[half] + share * *heights[half + 1];
    }

    /// Lines and arcs one behind the other, each of which begins where the one before it ends.
    std::vector<Point2> read_compound() {
        std::vector<Point2> whole;
        read_list([&] {
            skip_blanks();
            const std::size_t start = at_;
            const std::size_t first_height = heights_.size();
            const std::vector<Point2> part = read_curve(read_member_type(WktType::line, {WktType::arcs}));
            if (whole.empty()) {
                whole = part;
                return;
            }
            if (part.front() != whole.back()) {
                fail(ExitCode::data, place(start), "a part of a curve that begins elsewhere",
                     "a part that begins where the one before it ends");
            }
            whole.insert(whole.end(), part.begin() + 1, part.end());
            heights_.erase(heights_.begin() + static_cast<std::ptrdiff_t>(first_height));
        });
        return whole;
    }

    std::string read_word() {
        std::string word;
        while (at_ < text_.size() && std::isalpha(static_cast<unsigned char>(text_[at_])) != 0) {
            word += static_cast<char>(std::toupper(static_cast<unsigned char>(text_[at_++])));
        }
        return word;
    }

    /// A point with or without brackets of its own.
    void read_member_point(Shape& shape) {
        skip_blanks();
        if (at_ < text_.size() && text_[at_] == '(') {
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

    std::vector<Point2> read_ring(WktType type) {
        skip_blanks();
        const std::size_t start = at_;
        std::vector<Point2> ring = type == WktType::line ? read_points(4) : read_curve(type);
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
        const double x_m = read_coordinate("x");
        const double y_m = read_coordinate("y");
        const bool has_height = next_is_number();
        heights_.push_back(has_height ? std::optional{read_number("z")} : std::nullopt);
        if (has_height && next_is_number()) {
            read_number("m");
        }
        return {x_m, y_m};
    }

    double read_coordinate(const char* name) {
        skip_blanks();
        const std::size_t start = at_;
        const double value = read_number(name);
        if (std::abs(value) > farthest_coordinate_m) {
            fail(ExitCode::data, place(start),
                 std::string{name}.append(" ").append(text_.substr(start, at_ - start)),
                 "metres of a projected coordinate system, at most 1000000000", "correct the coordinate");
        }
        return value;
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
