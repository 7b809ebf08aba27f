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

/// Lines in their order; of a kind with many lines the first one, which counts the others.
std::vector<BriefMessage> shortened(const std::vector<std::string>& lines,
                                    const std::vector<std::string>& kinds) {
    std::map<std::string, std::size_t> count;
    for (const std::string& kind : kinds) {
        ++count[kind];
    }
    std::vector<BriefMessage> kept;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        std::size_t& left = count[kinds[i]];
        if (left == 0) {
            continue;
        }
        const bool many = left > printed_of_a_kind;
        kept.push_back({lines[i], many ? left - 1 : 0});
        left = many ? 0 : left;
    }
    return kept;
}

}  // namespace

std::vector<BriefMessage> brief(const std::vector<Problem>& problems) {
    std::vector<std::string> lines;
    std::vector<std::string> kinds;
    for (const Problem& problem : problems) {
        lines.push_back(to_string(problem));
        kinds.push_back(problem.place.file + '\n' + without_values(problem.found) + '\n' +
                        without_values(problem.expected));
    }
    return shortened(lines, kinds);
}

std::vector<BriefMessage> brief(const std::vector<std::string>& sentences) {
    std::vector<std::string> kinds;
    kinds.reserve(sentences.size());
    for (const std::string& sentence : sentences) {
        kinds.push_back(without_values(sentence));
    }
    return shortened(sentences, kinds);
}

std::string to_string(const BriefMessage& message) {
    return message.more == 0 ? message.sentence
                             : message.sentence + " (and " + std::to_string(message.more) +
                                   " more like this; --verbose prints all)";
}

}  // namespace config
