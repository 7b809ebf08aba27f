#include "config/errors/brief.hpp"

#include <map>

namespace config {
namespace {

/// A sentence with every number and everything in quotes replaced by '#'.
std::string without_values(const std::string& sentence) {
    std::string kind;
    bool in_quotes = false;
    for (const char c : sentence) {
        in_quotes = in_quotes != (c == '\'');
        const bool after_value = !kind.empty() && kind.back() == '#';
        const bool is_digit = c >= '0' && c <= '9';
        if (!in_quotes && !is_digit && c != '\'' && (c != '.' || !after_value)) {
            kind += c;
        } else if (!after_value) {
            kind += '#';
        }
    }
    return kind;
}

/// Lines in their order; of each kind the first ones, and after the last of them how many more there are.
std::vector<std::string> shortened(const std::vector<std::string>& lines,
                                   const std::vector<std::string>& kinds, const std::string& where) {
    std::map<std::string, std::size_t> count;
    for (const std::string& kind : kinds) {
        ++count[kind];
    }
    std::map<std::string, std::size_t> printed;
    std::vector<std::string> kept;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const std::size_t number = ++printed[kinds[i]];
        const std::size_t all = count[kinds[i]];
        // One line more than the limit is printed in full: counting it would take a line as well.
        if (number <= told_of_a_kind || all == told_of_a_kind + 1) {
            kept.push_back(lines[i]);
        } else if (number == told_of_a_kind + 1) {
            kept.push_back("... and " + std::to_string(all - told_of_a_kind) + " more like this; " + where);
        }
    }
    return kept;
}

}  // namespace

std::vector<std::string> brief(const std::vector<Problem>& problems) {
    std::vector<std::string> lines;
    std::vector<std::string> kinds;
    for (const Problem& problem : problems) {
        lines.push_back(to_string(problem));
        kinds.push_back(problem.place.file + '\n' + without_values(problem.found) + '\n' +
                        without_values(problem.expected));
    }
    return shortened(lines, kinds, "--verbose prints all");
}

std::vector<std::string> brief(const std::vector<std::string>& sentences, const std::string& where) {
    std::vector<std::string> kinds;
    kinds.reserve(sentences.size());
    for (const std::string& sentence : sentences) {
        kinds.push_back(without_values(sentence));
    }
    return shortened(sentences, kinds, where);
}

}  // namespace config
