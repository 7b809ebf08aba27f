#include "validation/engine/page/page_notes.hpp"

#include <algorithm>

#include "coupling/results/text/element.hpp"
#include "coupling/results/text/markup.hpp"

namespace coupling::validation {

std::string Notes::cite(const std::string& source) {
    if (source.empty()) {
        return "";
    }
    const auto found = std::find(sources_.begin(), sources_.end(), source);
    const auto number = std::to_string(found - sources_.begin() + 1);
    if (found == sources_.end()) {
        sources_.push_back(source);
    }
    return report::element("sup", {{"title", source}}, number);
}

std::string Notes::html() const {
    std::string items;
    for (const std::string& source : sources_) {
        items += report::element("li", {}, report::escaped(source));
    }
    return items.empty() ? "" : report::element("ol", {{"class", "sources"}}, items);
}

}  // namespace coupling::validation
