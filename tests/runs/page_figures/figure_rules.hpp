#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "tests/runs/page_figures/figure_sources.hpp"
#include "tests/runs/page_figures/page_blocks.hpp"

namespace coupling::page_figures {

/// Where the numbers of a sentence or of a row come from.
struct FigureRule {
    std::string section;  ///< heading of the second order; "*": any
    std::string pattern;
    std::vector<std::string> sources;  ///< of each `#`, as `figure_of` reads them
    std::vector<std::string> words;    ///< "level = hazard_targets name={part} level": begins with that field
    bool is_always_there = true;       ///< else a form that some runs have
};

/// Parts of a page whose numbers are settings, names of files or words, not results.
struct NoFigures {
    std::string section;  ///< "*": any
    std::string part;     ///< "*": any
};

struct Rules {
    std::vector<FigureRule> figures;
    std::vector<NoFigures> without;
    std::map<std::string, Words> groups;  ///< words that a group of rows stands for
};

/// Adds the rules of a file:
///
///     ; a remark
///     -- Settings | *                  a section and a part without figures
///     ++ Volume, m3/ha | table=stands column=volume_m3pha       words of a group of rows
///     == Rocks that arrive             the rules below are of this section; *: of all
///     # % of the {kind} reach {target}
///         targets name={target} share_percent
///     ? a form that some runs have
///
/// A pattern is the text itself: `#` stands for a number or a dash, `{name}` for words without a number,
/// `{name!}` for words that may hold numbers of which no table knows; what stands in `[ ]` may be missing,
/// its numbers are dashes then. Below it stands a source for each number, and for words that must begin with
/// a field of a table `name = source`. Sources may use these words, the numbers as `{n1}`, `{n2}` ...,
/// `{section}`, `{part}` and `{group}` of the block, words of the sentences before it in the block, the text
/// of all the `{block}` and that `{before}` it, and in tables of quantities or outcomes the `{quantity}`,
/// `{unit}` and `{outcome}` that columns are named by.
void add_rules(const std::string& text, Rules& rules);

/// A number of a page and what its source has.
struct CheckedFigure {
    std::string shown;
    TableFigure figure;
    std::string text;  ///< the sentence
};

struct Judged {
    std::vector<CheckedFigure> figures;
    std::vector<std::string> faults;  ///< numbers that their tables do not have, and those without a rule
    std::vector<std::string> used;    ///< patterns that some sentence had
};

/// Checks each number that a page shows, those of its drawings but for axes, too. Sentences of pages.csv
/// without a placeholder say the same on each page and are left out.
Judged judge(std::string_view page, const Rules& rules, const Tables& tables);

}  // namespace coupling::page_figures
