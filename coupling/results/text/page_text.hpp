#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace coupling::report {

/// What stands for a placeholder of a text.
struct TextField {
    std::string_view name;
    std::string_view value;  ///< HTML: escape what comes from a user
};

/// A text of the pages in the language in use (writing_language.hpp). Every heading, sentence and label of a
/// page is written in English where it is shown, and pages.csv has what stands for it in the other languages.
/// English is that of many things: a row may have forms of one (with_many() in catalogue.hpp).
/// Throws std::logic_error for a text that the table does not have.
const std::string& page_text(std::string_view english);

/// The same with each `{name}` replaced. Throws std::logic_error for a placeholder without a value and for a
/// value without a placeholder.
std::string page_text(std::string_view english, std::initializer_list<TextField> fields);

/// Whether a number as it is written speaks of one thing in the language in use: 1, in French all below 2.
bool is_of_one(std::string_view number);

/// All texts, in English.
std::vector<std::string> english_page_texts();

}  // namespace coupling::report
