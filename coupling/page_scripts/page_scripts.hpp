#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace coupling::page_scripts {

/// A script that is built into the program and written into pages.
struct Script {
    std::string_view text;        ///< JavaScript, minified, with all libraries it needs
    std::string_view sha256_hex;  ///< of the text
};

/// Makes the charts of a page interactive: values under the pointer, series to switch; and maps to choose
/// from.
Script charts();
/// Draws the slope with trees, paths and targets in three dimensions.
Script slope();
/// Lets nets be dragged on a page and counts the rocks at them (assessments/nets/moving).
Script nets();

/// The policy that forbids a page everything but its own styles, pictures in its own text and these scripts
/// (Content Security Policy Level 2, hashes of inline scripts): no other script, no evaluation of texts, no
/// network.
std::string policy(const std::vector<Script>& scripts);

}  // namespace coupling::page_scripts
