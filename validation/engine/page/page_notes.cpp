#include "validation/engine/page/page_notes.hpp"

#include <algorithm>

#include "config/text/joined.hpp"
#include "coupling/results/text/markup.hpp"

namespace coupling::validation {

using config::joined;

std::string Notes::cite(const std::string& source) {
    if (source.empty()) {
        return "";
    }
    const auto found = std::find(sources_.begin(), sources_.end(), source);
    const auto number = std::to_string(found - sources_.begin() + 1);
    if (found == sources_.end()) {
        sources_.push_back(source);
    }
    return joined("<sup title=\"", report::escaped(source), "\">", number, "</sup>");
}

std::string Notes::html() const {
    std::string items;
    for (const std::string& source : sources_) {
        items += joined("<li>", report::escaped(source), "</li>\n");
    }
    return items.empty() ? "" : joined("<ol class=\"sources\">\n", items, "</ol>\n");
}

}  // namespace coupling::validation
