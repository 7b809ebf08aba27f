#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace coupling::report {

// Whole texts one after the other, as the language in use joins them; empty ones are left out.

/// Sentences with a blank between them.
std::string join_sentences(std::initializer_list<std::string_view> sentences);
/// "a", "a, b, c".
std::string join_with_commas(const std::vector<std::string>& texts);
/// "a", "a; b; c".
std::string join_with_semicolons(const std::vector<std::string>& texts);
/// "a", "a and b", "a, b and c".
std::string join_with_and(const std::vector<std::string>& texts);
/// "label: text", with the blank that French has before a colon.
std::string with_label(const std::string& label, const std::string& text);

}  // namespace coupling::report
