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

enum WkbKind : std::uint32_t { wkb_point = 1, wkb_line = 2, wkb_polygon = 3, wkb_polygons = 6 };

constexpr std::array<std::string_view, 7> wkt_names{"",           "POINT",           "LINESTRING",  "POLYGON",
                                                    "MULTIPOINT", "MULTILINESTRING", "MULTIPOLYGON"};
constexpr std::array<std::string_view, 18> other_kinds{"geometry",
                                                       "",
                                                       "",
                                                       "",
                                                       "",
                                                       "",
                                                       "",
                                                       "collection",
                                                       "circular string",
                                                       "compound curve",
                                                       "curve polygon",
                                                       "multi-curve",
                                                       "multi-surface",
                                                       "curve",
                                                       "surface",
                                                       "polyhedral surface",
                                                       "TIN",
                                                       "triangle"};

class WkbReader {
public:
    explicit WkbReader(std::string_view bytes) : bytes_{bytes} {}

    std::string read() {
        const Head head = read_head();
        WktText text{std::string{wkt_names[head.kind]} + (head.has_z ? " Z " : " ")};
        body(head, text);
        return is_empty_ ? std::string{} : text.text();
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
        if (code >= 4000U || head.kind < wkb_point || head.kind > wkb_polygons) {
            throw std::invalid_argument{head.kind < other_kinds.size() && !other_kinds[head.kind].empty()
                                            ? "a shape of the kind " + std::string{other_kinds[head.kind]}
                                            : std::string{"no geometry"}};
        }
        return head;
    }

    void corner(const Head& head, WktText& text) {
        const auto x = number<double>();
        const auto y = number<double>();
        const double z = head.has_z ? number<double>() : 0.0;
        if (head.has_m) {
            number<double>();
        }
        if (std::isnan(x) && std::isnan(y)) {
            is_empty_ = true;  // as an empty point is written
            return;
        }
        if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z)) {
            throw std::invalid_argument{"a coordinate that is no number"};
        }
        head.has_z ? text.point(x, y, z) : text.point(x, y);
    }

    /// Counts are believed only as far as bytes follow: each item takes one at least.
    std::uint32_t count() {
        const auto items = number<std::uint32_t>();
        is_empty_ = is_empty_ || items == 0;
        if (items > bytes_.size() - at_) {
            throw std::invalid_argument{"a geometry that is cut off"};
        }
        return items;
    }

    void corners(const Head& head, WktText& text) {
        text.open();
        for (std::uint32_t left = count(); left > 0; --left) {
            corner(head, text);
        }
        text.close();
    }

    void body(const Head& head, WktText& text) {
        if (head.kind == wkb_point) {
            text.open();
            corner(head, text);
            text.close();
        } else if (head.kind == wkb_line) {
            corners(head, text);
        } else {
            text.open();
            for (std::uint32_t left = count(); left > 0; --left) {
                if (head.kind == wkb_polygon) {
                    corners(head, text);
                } else {
                    member(head, text);
                }
            }
            text.close();
        }
    }

    /// A geometry of several: of the single kind, not again of several.
    void member(const Head& whole, WktText& text) {
        const Head head = read_head();
        if (head.kind + 3 != whole.kind || head.has_z != whole.has_z) {
            throw std::invalid_argument{"shapes of different kinds in one"};
        }
        body(head, text);
    }

    std::string_view bytes_;
    std::size_t at_ = 0;
    bool is_little_ = true;
    bool is_empty_ = false;
};

}  // namespace

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
