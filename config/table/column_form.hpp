#pragma once

#include <string>
#include <string_view>

namespace config {

/// The name of a column taken apart: "BHD [mm]" and "bhd_mm" are the quantity "bhd" in the unit "mm".
struct ColumnForm {
    std::string letters;   ///< all letters and digits, plain and in lower case: "bhdmm"
    std::string quantity;  ///< without the unit: "bhd"
    std::string unit;  ///< in one spelling ("m/s" is "mps"); empty where the name gives none that is known
};

/// Longer names are no spelling of a known column [bytes]; a damaged table may hold one of megabytes, which
/// would be held against every known one.
inline constexpr std::size_t longest_column_bytes = 256;

/// Takes a name apart. Capitals, accents, blanks, dots, dashes, underscores and brackets do not count. The
/// unit stands in brackets at the end, or behind the last blank, dot or underscore.
ColumnForm form_of(std::string_view name);

/// Whether two names are the same but for their form: the same letters, or the same quantity in the same
/// unit.
bool is_same_column(const ColumnForm& a, const ColumnForm& b);

/// Whether two names are one quantity in two units, such as "BHD [mm]" and "bhd_cm".
bool is_other_unit(const ColumnForm& a, const ColumnForm& b);

/// What a number in the unit `from` is multiplied by to be one in the unit `to`; 0 where that is not known.
double unit_factor(std::string_view from, std::string_view to);

}  // namespace config
