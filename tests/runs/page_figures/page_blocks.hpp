#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace coupling::page_figures {

/// A sentence, or a row of a table, as a reader sees it on a page.
struct PageBlock {
    std::string section;    ///< heading of the second order above it; before the first one: ""
    std::string part;       ///< heading of the third order above it
    std::string group;      ///< in tables: the row above that has nothing but a heading
    std::string text;       ///< cells of a row have " | " between them; an empty first cell is that of above
    bool is_drawn = false;  ///< all words of a drawing but those of its axes, " | " between them
};

bool is_digit(char c);

/// What a page says outside of its scripts. Of a drawing stay away: numbers and titles of axes, coordinates,
/// scale bar and distances along lines, names of targets. Warnings of the first screen are of no section.
/// Blanks are plain and single; numbers have no signs between groups of digits and a plain minus, powers of
/// ten are written as in 1.7e-4.
std::vector<PageBlock> blocks_of(std::string_view page);

/// The same text as it would be written in a block.
std::string as_in_blocks(std::string_view html);

/// A text cut behind full stops, colons excepted, that a capital, a digit or a placeholder follows.
std::vector<std::string> sentences_of(std::string_view text);

}  // namespace coupling::page_figures
