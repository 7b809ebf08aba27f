#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "config/text/numbers.hpp"

namespace config {

/// The values of settings, read strictly: the whole text or nothing, and only inside the range.

std::optional<double> number_in(std::string_view text, const NumberRange& range);

/// A whole number from 0 to 2^64 - 1; `1e6` is whole too.
std::optional<std::uint64_t> count_in(std::string_view text, const NumberRange& range);

/// yes/no, true/false, on/off, 1/0 in any case.
std::optional<bool> flag_in(std::string_view text);

/// Numbers between commas or blanks; an empty text is an empty list. Nothing for what may be decimal commas:
/// "0,5 1,0" and "1,5" have no decimal point and no blank after a comma.
std::optional<std::vector<double>> numbers_in(std::string_view text, const NumberRange& range);

/// Whole numbers between commas or blanks, with or without a blank after a comma: no comma can be a decimal
/// one.
std::optional<std::vector<double>> whole_numbers_in(std::string_view text, const NumberRange& range);

/// "0.5, 1, 1.5", as numbers_in reads it back.
std::string list_text(const std::vector<double>& values);

/// Whether a text has no line break nor other control character but the tab.
bool is_one_line(std::string_view text);

}  // namespace config
