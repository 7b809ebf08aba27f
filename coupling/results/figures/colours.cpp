#include "coupling/results/figures/colours.hpp"

#include <algorithm>
#include <cmath>

namespace coupling {
namespace {

constexpr Colour rgb(std::uint32_t code) {
    return {static_cast<std::uint8_t>(code >> 16), static_cast<std::uint8_t>((code >> 8) & 0xFFU),
            static_cast<std::uint8_t>(code & 0xFFU)};
}

constexpr std::array viridis_reversed{rgb(0xfde725), rgb(0xaadc32), rgb(0x5ec962),
                                      rgb(0x27ad81), rgb(0x21918c), rgb(0x2c728e),
                                      rgb(0x3b528b), rgb(0x472d7b), rgb(0x440154)};
constexpr std::array pu_bu{rgb(0xece7f2), rgb(0xd0d1e6), rgb(0xa6bddb), rgb(0x74a9cf),
                           rgb(0x3690c0), rgb(0x0570b0), rgb(0x045a8d), rgb(0x023858)};
constexpr std::array greens{rgb(0xe5f5e0), rgb(0xc7e9c0), rgb(0xa1d99b), rgb(0x74c476),
                            rgb(0x41ab5d), rgb(0x238b45), rgb(0x006d2c), rgb(0x00441b)};
constexpr std::array yl_or_br{rgb(0xfff7bc), rgb(0xfee391), rgb(0xfec44f), rgb(0xfe9929),
                              rgb(0xec7014), rgb(0xcc4c02), rgb(0x993404), rgb(0x662506)};
constexpr std::array bu_pu{rgb(0xe0ecf4), rgb(0xbfd3e6), rgb(0x9ebcda), rgb(0x8c96c6),
                           rgb(0x8c6bb1), rgb(0x88419d), rgb(0x810f7c), rgb(0x4d004b)};
constexpr std::array rd_bu{rgb(0x053061), rgb(0x2166ac), rgb(0x4393c3), rgb(0x92c5de),
                           rgb(0xd1e5f0), rgb(0xf7f7f7), rgb(0xfddbc7), rgb(0xf4a582),
                           rgb(0xd6604d), rgb(0xb2182b), rgb(0x67001f)};

std::uint8_t between(std::uint8_t from, std::uint8_t to, double part) {
    return static_cast<std::uint8_t>(std::lround(from + part * (to - from)));
}

}  // namespace

std::string to_hex(Colour colour) {
    constexpr char digits[] = "0123456789abcdef";
    std::string text = "#";
    for (const std::uint8_t part : {colour.red, colour.green, colour.blue}) {
        text += digits[part >> 4];
        text += digits[part & 15];
    }
    return text;
}

double luminance(Colour colour) {
    const auto linear = [](std::uint8_t part) {
        const double value = part / 255.0;
        return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(colour.red) + 0.7152 * linear(colour.green) + 0.0722 * linear(colour.blue);
}

std::span<const Colour> colours_of(Palette palette) {
    switch (palette) {
        case Palette::reach:
            return viridis_reversed;
        case Palette::passages:
            return pu_bu;
        case Palette::impacts:
            return greens;
        case Palette::deposits:
            return yl_or_br;
        case Palette::height:
            return bu_pu;
        case Palette::difference:
            break;
    }
    return rd_bu;
}

Colour colour_at(Palette palette, double place) {
    const std::span<const Colour> steps = colours_of(palette);
    const double at = std::clamp(place, 0.0, 1.0) * static_cast<double>(steps.size() - 1);
    const auto first = std::min(static_cast<std::size_t>(at), steps.size() - 2);
    const double part = at - static_cast<double>(first);
    const Colour& from = steps[first];
    const Colour& to = steps[first + 1];
    return {between(from.red, to.red, part), between(from.green, to.green, part),
            between(from.blue, to.blue, part)};
}

}  // namespace coupling
