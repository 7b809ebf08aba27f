#include "coupling/inputs/formats/wkb.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <stdexcept>

#include "config/text/numbers.hpp"

namespace coupling::formats {
namespace {

enum WkbKind : std::uint32_t {
    wkb_point = 1,
    wkb_line,
    wkb_polygon,
    wkb_points,
    wkb_lines,
    wkb_polygons,
    wkb_collection,
    wkb_arcs,
    wkb_compound,
    wkb_curve_polygon,
    wkb_curves,
    wkb_surfaces
};

/// A kind of geometry: its name in text, which kinds its members may have and which of them need no name.
struct KindOfShape {
    std::string_view name;      ///< of well-known text; empty: not read
    std::string_view in_words;  ///< in messages
    std::uint32_t usual_member = 0;
    std::array<std::uint32_t, 3> members{};  ///< besides the usual one; 0: none
};
constexpr std::array<KindOfShape, 18> kinds_of_shapes{
    {{},
     {"POINT", "point"},
     {"LINESTRING", "line"},
     {"POLYGON", "polygon"},
     {"MULTIPOINT", "points", wkb_point},
     {"MULTILINESTRING", "lines", wkb_line},
     {"MULTIPOLYGON", "polygons", wkb_polygon},
     {"", "collection"},
     {"CIRCULARSTRING", "circular string"},
     {"COMPOUNDCURVE", "compound curve", wkb_line, {wkb_arcs}},
     {"CURVEPOLYGON", "curve polygon", wkb_line, {wkb_arcs, wkb_compound}},
     {"MULTICURVE", "multi-curve", wkb_line, {wkb_arcs, wkb_compound}},
     {"MULTISURFACE", "multi-surface", wkb_polygon, {wkb_curve_polygon}},
     {"", "curve"},
     {"", "surface"},
     {"", "polyhedral surface"},
     {"", "TIN"},
     {"", "triangle"}}};

class WkbReader {
public:
    explicit WkbReader(std::string_view bytes) : bytes_{bytes} {}

    std::string read() {
        const Head head = read_head();
        WktText text{std::string{kinds_of_shapes[head.kind].name} + (head.has_z ? " Z " : " ")};
        return body(head, text) ? text.text() : std::string{};
    }

private:
    struct Head {
        std::uint32_t kind = 0;
        bool has_z = false;
        bool has_m = false;
    };

    template <class Number>
    Number number() {
        if (bytes_.size() - at_ < sizeof(Number)) {
            throw std::invalid_argument{"a geometry that is cut off"};
        }
        std::array<char, sizeof(Number)> raw{};
        std::memcpy(raw.data(), bytes_.data() + at_, sizeof(Number));
        at_ += sizeof(Number);
        if (is_little_ != (std::endian::native == std::endian::little)) {
            std::reverse(raw.begin(), raw.end());
        }
        return std::bit_cast<Number>(raw);
    }

    Head read_head() {
        const auto order = number<std::uint8_t>();
        if (order > 1) {
            throw std::invalid_argument{"no geometry"};
        }
        is_little_ = order == 1;
        auto code = number<std::uint32_t>();
        constexpr std::uint32_t z_flag = 0x80000000U;
        constexpr std::uint32_t m_flag = 0x40000000U;
        constexpr std::uint32_t system_flag = 0x20000000U;
        Head head;
        head.has_z = (code & z_flag) != 0;
        head.has_m = (code & m_flag) != 0;
        if ((code & system_flag) != 0) {
            number<std::uint32_t>();
        }
        code &= ~(z_flag | m_flag | system_flag);
        head.has_z = head.has_z || (code / 1000U) % 2U == 1U;
        head.has_m = head.has_m || code / 2000U == 1U;
        head.kind = code % 1000U;
        if (code >= 4000U || head.kind >= kinds_of_shapes.size() ||
            kinds_of_shapes[head.kind].in_words.empty()) {
            throw std::invalid_argument{"no geometry"};
        }
        if (kinds_of_shapes[head.kind].name.empty()) {
            throw OtherKindOfShape{
                "a shape of the kind " + std::string{kinds_of_shapes[head.kind].in_words},
                head.kind == wkb_collection
                    ? "split it into its parts (QGIS: Multipart to singleparts; ogr2ogr -explodecollections)"
                    : "convert it to polygons (ogr2ogr -nlt MULTIPOLYGON)"};
        }
        return head;
    }

    /// False for the coordinates of an empty point.
    bool corner(const Head& head, WktText& text) {
        const auto x = number<double>();
        const auto y = number<double>();
        const double z = head.has_z ? number<double>() : 0.0;
        if (head.has_m) {
            number<double>();
        }
        if (std::isnan(x) && std::isnan(y)) {
            return false;
        }
        if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z)) {
            throw std::invalid_argument{"a coordinate that is no number"};
        }
        head.has_z ? text.point(x, y, z) : text.point(x, y);
        return true;
    }

    /// Counts are believed only as far as bytes follow: each item takes one at least.
    std::uint32_t count() {
        const auto items = number<std::uint32_t>();
        if (items > bytes_.size() - at_) {
            throw std::invalid_argument{"a geometry that is cut off"};
        }
        return items;
    }

    bool corners(const Head& head, WktText& text) {
        bool any = false;
        text.open();
        for (std::uint32_t left = count(); left > 0; --left) {
            if (!corner(head, text)) {
                throw std::invalid_argument{"a coordinate that is no number"};
            }
            any = true;
        }
        text.close();
        return any;
    }

    /// False where nothing is in it.
    bool body(const Head& head, WktText& text) {
        if (head.kind == wkb_point) {
            text.open();
            const bool any = corner(head, text);
            text.close();
            return any;
        }
        if (head.kind == wkb_line || head.kind == wkb_arcs) {
            return corners(head, text);
        }
        bool any = false;
        text.open();
        for (std::uint32_t left = count(); left > 0; --left) {
            const WktText::Mark before = text.mark();
            if (head.kind == wkb_polygon ? corners(head, text) : member(head, text)) {
                any = true;
            } else {
                text.back_to(before);  // an empty part of a shape is no part
            }
        }
        text.close();
        return any;
    }

    /// A geometry in another one, of a kind that may stand there: nothing nests any deeper.
    bool member(const Head& whole, WktText& text) {
        const Head head = read_head();
        const KindOfShape& kind = kinds_of_shapes[whole.kind];
        const bool is_usual = head.kind == kind.usual_member;
        const bool may_stand =
            is_usual || std::find(kind.members.begin(), kind.members.end(), head.kind) != kind.members.end();
        if (!may_stand || head.has_z != whole.has_z) {
            throw std::invalid_argument{"shapes of different kinds in one"};
        }
        if (!is_usual) {
            text.name(kinds_of_shapes[head.kind].name, head.has_z);
        }
        return body(head, text);
    }

    std::string_view bytes_;
    std::size_t at_ = 0;
    bool is_little_ = true;
};

}  // namespace

void WktText::name(std::string_view kind, bool has_z) {
    separate();
    text_ += kind;
    text_ += has_z ? " Z " : " ";
    next_is_first_ = true;  // its bracket follows the name
}

void WktText::point(double x, double y) {
    separate();
    text_ += config::to_text(x);
    text_ += ' ';
    text_ += config::to_text(y);
}

void WktText::point(double x, double y, double z) {
    point(x, y);
    text_ += ' ';
    text_ += config::to_text(z);
}

std::string wkt_of_wkb(std::string_view bytes) {
    return WkbReader{bytes}.read();
}

}  // namespace coupling::formats
