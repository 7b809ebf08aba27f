#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace coupling::report {

/// What stands for a placeholder of a text.
struct TextField {
    std::string_view name;
    std::string_view value;  ///< HTML: escape what comes from a user
};

/// A text of the pages by its key, in the language in use (writing_language.hpp). Every heading, sentence and
/// label of a page is one of them, so that a language is a file: texts_en.csv and its like. Throws
/// std::logic_error for a key that the table does not have.
const std::string& page_text(std::string_view key);

/// The same with each `{name}` replaced. Throws std::logic_error for a placeholder without a value and for a
/// value without a placeholder.
std::string page_text(std::string_view key, std::initializer_list<TextField> fields);

/// All keys with their texts in the language in use, sorted by key.
std::vector<std::pair<std::string, std::string>> all_page_texts();

}  // namespace coupling::report
