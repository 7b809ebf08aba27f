#include "coupling/inputs/forest/botanical_name.hpp"

#include <algorithm>
#include <array>
#include <cctype>

#include "config/text/joined.hpp"
#include "config/text/reading.hpp"
#include "config/text/words_of_list.hpp"

namespace coupling {
namespace {

using NameWords = std::vector<std::string>;

template <std::size_t N>
bool is_among(std::string word, const std::array<std::string_view, N>& words) {
    std::erase(word, '.');
    word = config::in_lower_case(word);
    return std::find(words.begin(), words.end(), word) != words.end();
}

bool is_open(const std::string& word) {
    constexpr std::array<std::string_view, 8> open{"sp",   "spp",     "cf",    "aff",
                                                   "spec", "species", "indet", "agg"};
    return is_among(word, open);
}

bool is_rank(const std::string& word) {
    constexpr std::array<std::string_view, 8> ranks{"subsp", "ssp",   "var", "f",
                                                    "fo",    "forma", "cv",  "convar"};
    return is_among(word, ranks);
}

bool is_hybrid_sign(const std::string& word) {
    return word == "x" || word == "X" || word == "\u00d7";
}

bool is_upper(char c) {
    return std::isupper(static_cast<unsigned char>(c)) != 0;
}

bool is_lower(char c) {
    return std::islower(static_cast<unsigned char>(c)) != 0;
}

bool is_of_letters(const std::string& word) {
    return word.size() > 1 && std::all_of(word.begin(), word.end(), [](char c) {
               return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '-';
           });
}

std::string with_replaced(std::string text, std::string_view what, std::string_view with) {
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size())) {
        text.replace(at, what.size(), with);
    }
    return text;
}

/// Without what stands between two signs; an opening one counts behind a blank alone, as "L'Her." has one
/// too.
std::string without_between(std::string text, char open, char close) {
    for (std::size_t from = text.find(open); from != std::string::npos; from = text.find(open, from + 1)) {
        const std::size_t to = text.find(close, from + 1);
        const bool begins = open == '(' || from == 0 || text[from - 1] == ' ';
        if (begins && to != std::string::npos) {
            text.replace(from, to - from + 1, " ");
        }
    }
    return text;
}

/// Signs of one kind, and what is no word of the name left out.
std::string plain_name(std::string_view name) {
    std::string text{name};
    for (const auto& [sign, simple] :
         {std::pair{"\u00a0", " "}, std::pair{"_", " "}, std::pair{"\u2018", "'"}, std::pair{"\u2019", "'"},
          std::pair{"`", "'"}, std::pair{"\u00b4", "'"}, std::pair{"\u201c", "\""}, std::pair{"\u201d", "\""},
          std::pair{"\u201e", "\""}, std::pair{"(", " ("}, std::pair{",", " "}}) {
        text = with_replaced(std::move(text), sign, simple);
    }
    for (const auto& [open, close] : {std::pair{'\'', '\''}, std::pair{'"', '"'}, std::pair{'(', ')'}}) {
        text = without_between(std::move(text), open, close);
    }
    return text;
}

/// Whether an author begins here, and no epithet.
bool is_author(const std::string& word) {
    return is_upper(word.front()) && (word.back() == '.' || word == "L");
}

}  // namespace

std::string without_open_words(std::string_view name) {
    std::string kept;
    for (const std::string& word : config::words_between_blanks(name)) {
        if (kept.empty() || !is_open(word)) {
            kept += config::joined(kept.empty() ? "" : " ", word);
        }
    }
    return kept;
}

std::vector<std::string> botanical_readings(std::string_view name) {
    const std::string text = plain_name(name);
    const NameWords words = config::words_between_blanks(text);
    if (words.empty() || !is_of_letters(words.front())) {
        return {};
    }
    const bool has_case = std::any_of(text.begin(), text.end(), is_lower);
    const auto is_epithet = [&](const std::string& word) {
        return is_of_letters(word) && (is_lower(word.front()) || !has_case) && !is_open(word) &&
               !is_rank(word) && !is_hybrid_sign(word);
    };
    const std::string& genus = words.front();
    std::size_t next = 1;
    const auto skip = [&](auto is_skipped) {
        while (next < words.size() && is_skipped(words[next])) {
            ++next;
        }
    };
    skip(is_open);
    if (next == words.size() || is_author(words[next])) {
        return {genus};
    }
    if (!is_epithet(words[next])) {
        return {};
    }
    std::vector<std::string> readings{config::joined(genus, " ", words[next])};
    for (std::size_t i = next + 1; i + 1 < words.size(); ++i) {
        if (is_rank(words[i]) && is_epithet(words[i + 1])) {
            readings.insert(readings.begin(), config::joined(genus, " ", words[i + 1]));
        }
    }
    return readings;
}

}  // namespace coupling
