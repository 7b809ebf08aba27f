#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace coupling::report {

/// Text as HTML and SVG want it: & < > " escaped, in content and in attributes.
std::string escaped(std::string_view text);

// Numbers for people: with the decimal sign and the groups of the language of the page
// (writing_language.hpp). Attributes of HTML and SVG take `place` instead.

/// A number with a fixed count of decimals; an en dash where it is not finite.
std::string fixed(double value, int decimals);
/// Three significant digits, no exponent: 12340 -> "12 300", 0.01234 -> "0.0123".
std::string three_digits(double value);
/// A round number of an axis without needless zeros: 0.1, 20, 1 000.
std::string tick_text(double value);
/// All digits that the user gave: 0.35, 12 000.
std::string exact(double value);
/// A whole number in groups of three: "12 345", with narrow no-break spaces.
std::string grouped(std::uint64_t value);
/// A share [0, 1] as "12.3 %"; small shares keep three digits, below a hundredth of a percent it is "less
/// than 0.01 %".
std::string percent(double share);

/// An area in hectares without its unit: "0", "less than 0.01", "0.35", "12.3".
std::string hectares(double area_ha);

/// Coordinates in drawings: one decimal, no trailing zero.
std::string place(double value);

/// A length, value or width that people like to read on an axis: 1, 2 or 5 times a power of ten, at least
/// `least`.
double nice_step(double least);

}  // namespace coupling::report
