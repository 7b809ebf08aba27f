#include "config/errors/input_error.hpp"

#include <algorithm>
#include <cassert>
#include <cctype>
#include <numeric>
#include <set>
#include <string>
#include <utility>

#include "config/text/reading.hpp"

namespace config {

namespace {

/// A file may hold thousands of bad lines; nobody reads more than these.
constexpr std::size_t most_problems_shown = 25;

std::string lines_of(const std::vector<Problem>& problems) {
    std::string text;
    for (std::size_t i = 0; i < std::min(problems.size(), most_problems_shown); ++i) {
        text += i == 0 ? "" : "\n";
        text += to_string(problems[i]);
    }
    if (problems.size() > most_problems_shown) {
        text += "\n... and " + std::to_string(problems.size() - most_problems_shown) + " more";
    }
    return text;
}

/// Whether a byte continues a character of UTF-8.
bool inside_character(char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

/// Distance of Damerau and Levenshtein: letters to add, drop or change, neighbours to swap.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before_last(b.size() + 1);
    std::vector<std::size_t> last(b.size() + 1);
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        before_last.swap(last);
        last.swap(row);
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t changed = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            row[j] = std::min({changed, last[j] + 1, row[j - 1] + 1});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
                row[j] = std::min(row[j], before_last[j - 2] + 1);
            }
        }
    }
    return row[b.size()];
}

}  // namespace

std::string to_string(const Problem& problem) {
    const Place& place = problem.place;
    std::string text = place.file;
    if (place.line > 0) {
        text += text.empty() ? "line " : ":";
        text += std::to_string(place.line);
        if (place.column > 0) {
            text += ':';
            text += std::to_string(place.column);
        }
    }
    if (!text.empty()) {
        text += ": ";
    }
    if (problem.expected.empty()) {
        text.append(problem.found);
    } else {
        text.append("found ").append(problem.found).append(", expected ").append(problem.expected);
    }
    return problem.advice.empty() ? text : text.append("; ").append(problem.advice);
}

namespace {

/// A file may be read in two roles, and a check be made by two readers: what is wrong is said once.
std::vector<Problem> each_once(const std::vector<Problem>& problems) {
    std::vector<Problem> different;
    std::set<std::string> known;
    for (const Problem& problem : problems) {
        if (known.insert(to_string(problem)).second) {
            different.push_back(problem);
        }
    }
    return different;
}

}  // namespace

InputError::InputError(std::vector<Problem> problems)
    : std::runtime_error{lines_of(each_once(problems))}, problems_{each_once(problems)} {
    assert(!problems_.empty());
}

void fail(ExitCode code, Place place, std::string found, std::string expected, std::string advice) {
    throw InputError{{{code, std::move(place), std::move(found), std::move(expected), std::move(advice)}}};
}

void Problems::add(ExitCode code, Place place, std::string found, std::string expected, std::string advice) {
    problems_.push_back({code, std::move(place), std::move(found), std::move(expected), std::move(advice)});
}

void Problems::add(const InputError& error) {
    problems_.insert(problems_.end(), error.problems().begin(), error.problems().end());
}

void Problems::throw_if_any() const {
    if (!empty()) {
        throw InputError{problems_};
    }
}

std::string nearest_word(std::string_view word, const std::vector<std::string>& legal) {
    if (word.size() > longest_word_bytes) {
        return "";
    }
    const std::string wanted = in_lower_case(word);
    std::size_t best = word.size() / 3 + 1;
    std::string nearest;
    for (const std::string& candidate : legal) {
        const std::size_t longer = std::max(candidate.size(), wanted.size());
        if (longer - std::min(candidate.size(), wanted.size()) >= best) {
            continue;  // so many letters at least are to be added or dropped
        }
        const std::size_t distance = edit_distance(wanted, in_lower_case(candidate));
        if (distance < best) {
            best = distance;
            nearest = candidate;
        }
    }
    return nearest;
}

std::string in_quotes(std::string_view text) {
    constexpr std::size_t longest = 60;
    std::size_t end = std::min(text.size(), longest);
    while (end < text.size() && end > 0 && inside_character(text[end])) {
        --end;
    }
    std::string shown{"'"};
    for (const char c : text.substr(0, end)) {
        const auto byte = static_cast<unsigned char>(c);
        shown += byte < 0x20 || byte == 0x7F ? '?' : c;
    }
    return shown + (end < text.size() ? "...'" : "'");
}

Place place_in(std::string_view text, std::size_t offset, const Place& start) {
    const std::string_view before = text.substr(0, offset);
    const auto lines = static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
    const std::string_view in_line = lines == 0 ? before : before.substr(before.rfind('\n') + 1);
    const auto characters = in_line.size() - static_cast<std::size_t>(std::count_if(
                                                 in_line.begin(), in_line.end(), inside_character));
    const std::size_t first_column = lines == 0 ? std::max<std::size_t>(start.column, 1) : 1;
    return {start.file, std::max<std::size_t>(start.line, 1) + lines, first_column + characters};
}

}  // namespace config
