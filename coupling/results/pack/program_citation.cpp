#include "coupling/results/pack/program_citation.hpp"

#include <sstream>
#include <string_view>

#include "config/text/embedded.hpp"

BANNWALD_EMBED(citation_cff, BANNWALD_EMBEDDED_FILE)

namespace coupling::pack {
namespace {

std::string without_quotes(std::string_view text) {
    const auto first = text.find_first_not_of(" \t\r");
    if (first == std::string_view::npos) {
        return "";
    }
    text = text.substr(first, text.find_last_not_of(" \t\r") + 1 - first);
    if (text.size() > 1 && text.front() == '"' && text.back() == '"') {
        text = text.substr(1, text.size() - 2);
    }
    return std::string{text};
}

/// The value of `key:` in a line that begins with it.
bool take(const std::string& line, std::string_view key, std::string& value) {
    if (!line.starts_with(key) || line.size() <= key.size() || line[key.size()] != ':') {
        return false;
    }
    value = without_quotes(std::string_view{line}.substr(key.size() + 1));
    return true;
}

/// An author begins with "  - "; family and given names stand in lines of their own.
void take_author(const std::string& line, std::vector<std::string>& authors) {
    constexpr std::string_view item = "  - ";
    constexpr std::string_view more = "    ";
    if (line.starts_with(item)) {
        authors.emplace_back();
    }
    if (authors.empty() || !(line.starts_with(item) || line.starts_with(more))) {
        return;
    }
    std::string value;
    if (const std::string key = line.substr(item.size());
        take(key, "name", value) || take(key, "family-names", value)) {
        authors.back() = value;
    } else if (take(key, "given-names", value)) {
        authors.back() += ", " + value;
    }
}

}  // namespace

ProgramCitation read_citation(const std::string& text) {
    ProgramCitation citation;
    std::istringstream in{text};
    bool of_authors = false;
    for (std::string line; std::getline(in, line);) {
        if (of_authors && line.starts_with(' ')) {
            take_author(line, citation.authors);
            continue;
        }
        of_authors = line.starts_with("authors:");
        take(line, "title", citation.title);
        take(line, "version", citation.version);
        take(line, "license", citation.licence);
        take(line, "repository-code", citation.repository);
    }
    return citation;
}

const ProgramCitation& program_citation() {
    static const ProgramCitation citation = read_citation(std::string{BANNWALD_EMBEDDED(citation_cff)});
    return citation;
}

}  // namespace coupling::pack
