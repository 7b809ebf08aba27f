#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace config {

/// What a number in a table or a setting may be.
struct NumberRange {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    bool low_excluded = false;  ///< (low, high] instead of [low, high]

    [[nodiscard]] bool contains(double value) const {
        return (low_excluded ? value > low : value >= low) && value <= high;
    }
};

/// "[0, 2]", "(0, 2]", ">= 0", "> 0", "<= 2", or "" for any number.
std::string to_string(const NumberRange& range);
/// "a number in [0, 2]", "a number >= 0", "a number": `kind` and the range in words.
std::string describe(std::string_view kind, const NumberRange& range);

/// The whole text as a finite number: no `nan`, no `inf`, no `1,5`, no `3abc`; a leading plus is fine.
std::optional<double> parse_number(std::string_view text);
/// The whole text as a whole number; `12.0` and `1e6` are whole too (up to 2^53). Not `2.000`, which may
/// be two or two thousand: a point before three digits separates thousands in much of Europe.
std::optional<long long> parse_whole(std::string_view text);

/// A number written with separators of thousands, without them: "2.000", "2,000", "2'000", "2 000" (and the
/// blanks and apostrophes of typesetters) give "2000", "1.234,5" and "1'234.5" give "1234.5". Nothing for
/// other texts. Of "2.000" the same text may also be a number without separators: the caller decides.
std::optional<std::string> without_separators(std::string_view text);

/// The shortest text that reads back the same; no exponent from a millionth to 2^53, so none in coordinates.
std::string to_text(double value);
std::string to_text(float value);

}  // namespace config
