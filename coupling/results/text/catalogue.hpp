#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace coupling::report {

/// Rows of a table of texts that the program holds, without the line of its columns. Every field stands in
/// quotes, which are doubled inside; blanks at its ends belong to it. Throws std::logic_error for another
/// form and for a row with more or fewer fields than the table has columns.
std::vector<std::vector<std::string>> rows_of_texts(std::string_view table);

/// Of one thing or of more: `{rocks?rock|rocks}` in a text becomes the word before or behind the line, as
/// the value of `{rocks}` asks for. This is the text with those of many: by it a row is found.
std::string with_many(std::string_view text);

/// German as Switzerland writes it.
std::string swiss_german(std::string text);

/// French as Switzerland speaks of hazard: "degré de danger" and "objet" for "niveau d’aléa" and "enjeu" of
/// France.
std::string with_swiss_terms(std::string_view text);

/// The same of a table whose last columns are en, de, fr, it, with those languages behind them that are
/// written from another one: the German and the French of Switzerland. The order is that of config::Language.
std::vector<std::vector<std::string>> rows_of_all_languages(std::string_view table);

}  // namespace coupling::report
