#include "coupling/results/text/phrases.hpp"

#include <algorithm>
#include <cctype>
#include <vector>

#include "config/text/embedded.hpp"
#include "config/text/language.hpp"
#include "coupling/results/text/catalogue.hpp"
#include "coupling/results/text/writing_language.hpp"

BANNWALD_EMBED(phrases, BANNWALD_EMBEDDED_FILE)

namespace coupling::report {
namespace {

/// English phrases and what stands for them by language, the longest ones first.
const std::vector<std::vector<std::string>>& phrases() {
    static const std::vector<std::vector<std::string>> rows = [] {
        std::vector<std::vector<std::string>> all = rows_of_all_languages(BANNWALD_EMBEDDED(phrases));
        std::stable_sort(all.begin(), all.end(),
                         [](const auto& a, const auto& b) { return a.front().size() > b.front().size(); });
        return all;
    }();
    return rows;
}

bool is_letter(char sign) {
    const auto byte = static_cast<unsigned char>(sign);
    return std::isalpha(byte) != 0 || byte >= 0x80;  // part of a letter of more than one byte
}

/// Whether a phrase stands at a place, and not as a part of a longer word.
bool stands_at(std::string_view words, std::size_t at, std::string_view phrase) {
    if (!words.substr(at).starts_with(phrase)) {
        return false;
    }
    const std::size_t end = at + phrase.size();
    return !(at > 0 && is_letter(words[at - 1]) && is_letter(phrase.front())) &&
           !(end < words.size() && is_letter(words[end]) && is_letter(phrase.back()));
}

/// What French has before a sign that joins two phrases.
std::string_view blank_before(std::string_view words) {
    if (!config::is_french(language_in_use())) {
        return "";
    }
    return words.starts_with("; ") ? "\u202f" : words.starts_with(": ") ? "\u00a0" : "";
}

}  // namespace

std::string in_page_language(std::string_view words) {
    std::string text;
    for (std::size_t at = 0; at < words.size();) {
        const auto here = std::find_if(phrases().begin(), phrases().end(), [&](const auto& phrase) {
            return stands_at(words, at, phrase.front());
        });
        if (here == phrases().end()) {
            text += blank_before(words.substr(at));
            text += words[at++];
        } else {
            text += (*here)[static_cast<std::size_t>(language_in_use())];
            at += here->front().size();
        }
    }
    return text;
}

}  // namespace coupling::report
