#pragma once

#include <string>

namespace coupling::text_checks {

/// What is wrong with the tags of an XML or XHTML text: the first tag that closes another than the open one,
/// attributes without quotes, bare ampersands; "" if all is well. Skips declarations, comments, and the
/// contents of <style> and <script>.
std::string markup_fault(const std::string& text);

/// The text without the contents of its <script> elements.
std::string without_scripts(const std::string& text);

}  // namespace coupling::text_checks
