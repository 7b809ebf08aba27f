#include "tests/runs/page_figures/figure_rules.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "coupling/results/text/page_text.hpp"

namespace coupling::page_figures {
namespace {

bool has_digit(std::string_view text) {
    return std::any_of(text.begin(), text.end(), is_digit);
}

constexpr std::string_view dash = "\u2013";
constexpr std::string_view not_known = "not known";

/// Length of the number, or of the dash, with which a text begins; 0: there is none.
std::size_t number_length(std::string_view text) {
    for (const std::string_view none : {dash, not_known}) {
        if (text.starts_with(none)) {
            return none.size();
        }
    }
    std::size_t at = text.starts_with('-') ? 1 : 0;
    const auto digits = [&] {
        const std::size_t begin = at;
        while (at < text.size() && is_digit(text[at])) {
            ++at;
        }
        return at > begin;
    };
    if (!digits()) {
        return 0;
    }
    if (at + 1 < text.size() && text[at] == '.' && is_digit(text[at + 1])) {
        ++at;
        digits();
    }
    if (at + 2 < text.size() && text[at] == 'e' && (text[at + 1] == '-' || is_digit(text[at + 1]))) {
        ++at;
        at += text[at] == '-' ? 1 : 0;
        digits();
    }
    return at;
}

struct Match {
    std::vector<std::string> numbers;
    Words words;
};

bool match(std::string_view pattern, std::string_view text, Match& found);

bool match_number(std::string_view pattern, std::string_view text, Match& found) {
    const std::size_t length = number_length(text);
    if (length == 0) {
        return false;
    }
    found.numbers.emplace_back(text.substr(0, length));
    if (match(pattern.substr(1), text.substr(length), found)) {
        return true;
    }
    found.numbers.pop_back();
    return false;
}

bool match_words(std::string_view pattern, std::string_view text, Match& found) {
    const std::size_t end = pattern.find('}');
    const bool may_count = pattern[end - 1] == '!';
    const std::string name{pattern.substr(1, end - 1 - (may_count ? 1 : 0))};
    for (std::size_t length = may_count ? 0 : 1; length <= text.size(); ++length) {
        if (!may_count && is_digit(text[length - 1])) {
            return false;
        }
        found.words[name] = std::string{text.substr(0, length)};
        if (match(pattern.substr(end + 1), text.substr(length), found)) {
            return true;
        }
    }
    return false;
}

/// With what stands in brackets, else without; then its numbers are dashes.
bool match_optional(std::string_view pattern, std::string_view text, Match& found) {
    const std::size_t end = pattern.find(']');
    const std::string_view inside = pattern.substr(1, end - 1);
    const std::string_view behind = pattern.substr(end + 1);
    const Match before = found;
    if (match(std::string{inside} + std::string{behind}, text, found)) {
        return true;
    }
    found = before;
    found.numbers.resize(
        found.numbers.size() + static_cast<std::size_t>(std::count(inside.begin(), inside.end(), '#')),
        std::string{dash});
    return match(behind, text, found);
}

bool match(std::string_view pattern, std::string_view text, Match& found) {
    if (pattern.empty()) {
        return text.empty();
    }
    switch (pattern.front()) {
        case '#':
            return match_number(pattern, text, found);
        case '{':
            return match_words(pattern, text, found);
        case '[':
            return match_optional(pattern, text, found);
        default:
            return !text.empty() && pattern.front() == text.front() &&
                   match(pattern.substr(1), text.substr(1), found);
    }
}

/// Sentences that say the same on each page.
const std::set<std::string>& fixed_sentences() {
    static const std::set<std::string> all = [] {
        std::set<std::string> sentences;
        for (const std::string& text : report::english_page_texts()) {
            const std::string plain = as_in_blocks(text);
            if (plain.find('{') == std::string::npos) {
                sentences.insert(plain);
            }
            for (const std::string& sentence : sentences_of(plain)) {
                if (sentence.find('{') == std::string::npos) {
                    sentences.insert(sentence);
                }
            }
        }
        return sentences;
    }();
    return all;
}

std::vector<std::string> cells_of(std::string_view row) {
    std::vector<std::string> cells;
    std::size_t begin = 0;
    for (std::size_t at = row.find(" | "); at != std::string_view::npos; at = row.find(" | ", begin)) {
        cells.emplace_back(row.substr(begin, at - begin));
        begin = at + 3;
    }
    cells.emplace_back(row.substr(begin));
    return cells;
}

bool is_fixed(const std::string& text) {
    return fixed_sentences().contains(text);
}

bool is_row(std::string_view text) {
    return text.find(" | ") != std::string_view::npos;
}

/// What of a block is to be judged: a row as it is, a paragraph sentence by sentence.
std::vector<std::string> statements_of(const PageBlock& block) {
    if (is_fixed(block.text)) {
        return {};
    }
    std::vector<std::string> parts = is_row(block.text) ? cells_of(block.text) : sentences_of(block.text);
    parts.erase(std::remove_if(parts.begin(), parts.end(), is_fixed), parts.end());
    if (is_row(block.text)) {
        return parts.empty() ? parts : std::vector<std::string>{block.text};
    }
    return parts;
}

bool is_without(const PageBlock& block, const std::vector<NoFigures>& no_figures) {
    return std::any_of(no_figures.begin(), no_figures.end(), [&](const NoFigures& none) {
        return (none.section == "*" || none.section == block.section) &&
               (none.part == "*" || none.part == block.part);
    });
}

/// What groups of rows speak of, as the columns of tables name it.
const std::map<std::string, std::pair<std::string, std::string>> quantities{
    {"Energy, kJ", {"energy", "kj"}},
    {"Speed, m/s", {"speed", "mps"}},
    {"Height above ground, m", {"height", "m"}},
    {"Height of passage, m", {"height", "m"}}};

/// The rule of a statement with its numbers and words.
struct Ruled {
    const FigureRule* rule;
    Match match;
};

/// Outcomes at a net, as net_crossings.csv names them.
const std::map<std::string, std::string> outcomes{
    {"Held", "held"}, {"Pass over", "over"}, {"Pass below", "below"}, {"Break through", "broke"}};

/// What sources may use beside the words of the sentence itself.
void add_words(Match& found, const PageBlock& block, const std::string& before) {
    found.words["section"] = block.section;
    found.words["part"] = block.part;
    found.words["group"] = block.group;
    found.words["before"] = before;
    found.words["block"] = block.text;
    const auto quantity = quantities.find(block.group);
    if (quantity != quantities.end()) {
        found.words["quantity"] = quantity->second.first;
        found.words["unit"] = quantity->second.second;
    }
    const auto outcome = outcomes.find(found.words["what"]);
    if (outcome != outcomes.end()) {
        found.words["outcome"] = outcome->second;
    }
    for (std::size_t i = 0; i < found.numbers.size(); ++i) {
        found.words["n" + std::to_string(i + 1)] = found.numbers[i];
    }
}

/// `carried`: words of the sentences before it in its block.
std::optional<Ruled> rule_of(const std::string& statement, const PageBlock& block, const std::string& before,
                             const Rules& rules, Words& carried) {
    for (const FigureRule& rule : rules.figures) {
        Match found;
        if ((rule.section == "*" || rule.section == block.section) && match(rule.pattern, statement, found)) {
            for (const auto& [name, word] : found.words) {
                carried[name] = word;
            }
            found.words.insert(carried.begin(), carried.end());
            const auto group = rules.groups.find(block.group);
            if (group != rules.groups.end()) {
                found.words.insert(group->second.begin(), group->second.end());
            }
            add_words(found, block, before);
            return Ruled{&rule, std::move(found)};
        }
    }
    return std::nullopt;
}

/// Reads "Volume, m3/ha | table=stands column=volume_m3pha".
void add_group(const std::string& line, Rules& rules) {
    const std::size_t at = line.find(" | ");
    Words& words = rules.groups[line.substr(0, at)];
    std::istringstream parts{line.substr(at + 3)};
    for (std::string part; parts >> part;) {
        const std::size_t sign = part.find('=');
        words[part.substr(0, sign)] = part.substr(sign + 1);
    }
}

void check(const Ruled& ruled, const std::string& statement, const Tables& tables, Judged& judged) {
    const FigureRule& rule = *ruled.rule;
    const Match& found = ruled.match;
    if (rule.sources.size() != found.numbers.size()) {
        throw std::logic_error{std::to_string(found.numbers.size()) + " numbers and " +
                               std::to_string(rule.sources.size()) + " sources: " + rule.pattern};
    }
    const auto fault = [&](const std::string& what) {
        judged.faults.push_back(what + "\n    in: " + statement);
    };
    for (std::size_t i = 0; i < rule.sources.size(); ++i) {
        try {
            const TableFigure figure = figure_of(rule.sources[i], found.words, tables);
            judged.figures.push_back({found.numbers[i], figure, statement});
            if (!agree(found.numbers[i], figure)) {
                fault("found " + found.numbers[i] + ", the tables have " +
                      (figure.is_empty ? "none" : std::to_string(figure.value)) + ": " + rule.sources[i]);
            }
        } catch (const std::exception& error) {
            fault(std::string{error.what()} + ": " + rule.sources[i]);
        }
    }
    for (const std::string& words : rule.words) {
        const std::size_t at = words.find(" = ");
        const std::string& shown = found.words.at(words.substr(0, at));
        const std::string field = text_of(words.substr(at + 3), found.words, tables);
        if (!shown.starts_with(field)) {
            fault("found '" + shown + "', the tables have '" + field + "': " + words);
        }
    }
}

}  // namespace

void add_rules(const std::string& text, Rules& rules) {
    std::istringstream lines{text};
    std::string section;
    for (std::string line; std::getline(lines, line);) {
        if (line.empty() || line.starts_with(';')) {
            continue;
        }
        if (line.starts_with("++ ")) {
            add_group(line.substr(3), rules);
        } else if (line.starts_with("-- ")) {
            const std::size_t at = line.find(" | ");
            rules.without.push_back({line.substr(3, at - 3), line.substr(at + 3)});
        } else if (line.starts_with("==")) {
            section = line.size() > 3 ? line.substr(3) : "";
        } else if (!line.starts_with("    ")) {
            const bool is_rare = line.starts_with("? ");
            rules.figures.push_back({section, line.substr(is_rare ? 2 : 0), {}, {}, !is_rare});
        } else if (line.find(" = ") == std::string::npos) {
            rules.figures.back().sources.push_back(line.substr(4));
        } else {
            rules.figures.back().words.push_back(line.substr(4));
        }
    }
}

Judged judge(std::string_view page, const Rules& rules, const Tables& tables) {
    Judged judged;
    std::string before;
    std::string here;
    for (const PageBlock& block : blocks_of(page)) {
        before = block.is_drawn ? before : std::exchange(here, block.text);
        if (is_without(block, rules.without)) {
            continue;
        }
        Words carried;
        for (const std::string& statement : statements_of(block)) {
            const std::optional<Ruled> ruled = rule_of(statement, block, before, rules, carried);
            if (!ruled && !has_digit(statement)) {
                continue;
            }
            if (!ruled) {
                judged.faults.push_back("no rule says where this comes from ([" + block.section + "] [" +
                                        block.part + "] [" + block.group + "]):\n    " + statement);
                continue;
            }
            judged.used.push_back(ruled->rule->pattern);
            check(*ruled, statement, tables, judged);
        }
    }
    return judged;
}

}  // namespace coupling::page_figures
