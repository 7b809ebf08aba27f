#pragma once

#include <string>

#include "coupling/inputs/site.hpp"

namespace coupling::report {

/// What the maps of a page show as outlines and lines.
struct OnMaps {
    bool sources = true;
    bool targets = false;
    bool nets = false;
    bool works = false;
};

/// What a MapSheet of a site draws.
OnMaps drawn_of(const Site& site);

/// What they stand for. Ready HTML.
std::string map_key(const OnMaps& drawn);

/// How far the lines of maps need more words.
struct WordsOfLines {
    bool of_longest_period = false;      ///< sources: those of the longest return period
    bool distances_along_lines = false;  ///< stand at targets
};

/// The same as sentences: "Thin outlines: release sources. Blue broken lines: nets." Text, not markup.
std::string lines_in_words(const OnMaps& drawn, WordsOfLines words = {});

}  // namespace coupling::report
