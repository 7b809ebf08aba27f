#include "coupling/results/text/phrases.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "coupling/results/text/page_text.hpp"
#include "coupling/results/text/writing_language.hpp"

namespace coupling::report {
namespace {

/// English phrases and what stands for them, the longest ones first.
std::vector<std::pair<std::string, std::string>> phrases_in_use() {
    std::vector<std::pair<std::string, std::string>> english;
    {
        const WritingLanguage in_english{config::Language::en};
        english = all_page_texts();
    }
    std::vector<std::pair<std::string, std::string>> phrases;
    for (const auto& [key, text] : english) {
        if (key.starts_with("phrase.")) {
            phrases.emplace_back(text, page_text(key));
        }
    }
    std::stable_sort(phrases.begin(), phrases.end(),
                     [](const auto& a, const auto& b) { return a.first.size() > b.first.size(); });
    return phrases;
}

}  // namespace

std::string in_page_language(std::string_view words) {
    if (language_in_use() == config::Language::en) {
        return std::string{words};
    }
    const std::vector<std::pair<std::string, std::string>> phrases = phrases_in_use();
    std::string text;
    for (std::size_t at = 0; at < words.size();) {
        const auto here = std::find_if(phrases.begin(), phrases.end(), [&](const auto& phrase) {
            return words.substr(at).starts_with(phrase.first);
        });
        if (here == phrases.end()) {
            text += words[at++];
        } else {
            text += here->second;
            at += here->first.size();
        }
    }
    return text;
}

}  // namespace coupling::report
