#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace coupling {

struct Colour {
    std::uint8_t red = 0;
    std::uint8_t green = 0;
    std::uint8_t blue = 0;
    friend bool operator==(const Colour&, const Colour&) = default;
};

/// "#rrggbb".
std::string to_hex(Colour colour);
/// Relative luminance of sRGB [0, 1]: what a black-and-white print keeps.
double luminance(Colour colour);

/// Sequences of colours that stay apart for colour-blind readers. All but `difference` grow darker from end
/// to end, so they keep their order in black and white too. Those of ColorBrewer 2.0 (Brewer & Harrower,
/// Apache-2.0) or viridis (van der Walt & Smith, CC0).
enum class Palette : std::uint8_t {
    reach,       ///< viridis from yellow to dark violet
    passages,    ///< PuBu: white to dark blue
    impacts,     ///< Greens
    deposits,    ///< YlOrBr
    height,      ///< BuPu
    difference,  ///< RdBu from blue (less with forest) over white to red (more)
};
std::span<const Colour> colours_of(Palette palette);
/// Colour at a place [0, 1] along a palette, straight between its steps.
Colour colour_at(Palette palette, double place);

/// Intensities by energy: below 30 kJ, 30 to 300 kJ, above 300 kJ (the Swiss federal recommendation).
inline constexpr std::array<double, 2> intensity_limits_kj{30.0, 300.0};
inline constexpr std::array<Colour, 3> intensity_class_colours{
    Colour{0xfe, 0xe0, 0x8b}, Colour{0xf4, 0x6d, 0x43}, Colour{0x7f, 0x00, 0x2d}};
/// In files for GIS programs.
inline constexpr std::array<const char*, 3> intensity_class_names{"below 30 kJ", "30 to 300 kJ",
                                                                  "above 300 kJ"};

/// Classes of energy on pages: the limits of intensities, and between and above them those of usual nets.
/// Their names are in report/energy_classes.hpp.
inline constexpr std::array<double, 5> energy_class_limits_kj{30.0, 100.0, 300.0, 1000.0, 3000.0};
inline constexpr std::array<Colour, 6> energy_class_colours{
    Colour{0xfe, 0xe0, 0x8b}, Colour{0xf5, 0x9a, 0x45}, Colour{0xe0, 0x60, 0x3a},
    Colour{0xbb, 0x2f, 0x2a}, Colour{0x86, 0x12, 0x2d}, Colour{0x42, 0x00, 0x1c}};
constexpr std::size_t energy_class(double energy_kj) {
    if (energy_kj < energy_class_limits_kj[0]) {
        return 0U;
    }
    std::size_t place = 1;
    while (place < energy_class_limits_kj.size() && energy_kj > energy_class_limits_kj[place]) {
        ++place;
    }
    return place;
}

/// A class of a map in its colour.
struct ClassColour {
    double value;  ///< that stands for it
    std::string label;
    Colour colour;
};

}  // namespace coupling
