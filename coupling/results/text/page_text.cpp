#include "coupling/results/text/page_text.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <vector>

#include "config/text/embedded.hpp"
#include "config/text/joined.hpp"
#include "coupling/results/text/catalogue.hpp"
#include "coupling/results/text/writing_language.hpp"

BANNWALD_EMBED(page_texts, BANNWALD_EMBEDDED_FILE)

namespace coupling::report {
namespace {

using config::joined;

[[noreturn]] void broken(std::string_view what, std::string_view where) {
    throw std::logic_error(joined("texts of the pages: ", what, ": ", where));
}

/// English text -> texts by language.
using PageTexts = std::map<std::string, std::vector<std::string>, std::less<>>;

const PageTexts& page_texts() {
    static const PageTexts texts = [] {
        PageTexts all;
        for (std::vector<std::string>& row : rows_of_all_languages(BANNWALD_EMBEDDED(page_texts))) {
            const std::string english = with_many(row.front());
            if (!all.emplace(english, std::move(row)).second) {
                broken("found a text twice", english);
            }
        }
        return all;
    }();
    return texts;
}

}  // namespace

const std::string& page_text(std::string_view english) {
    const auto found = page_texts().find(english);
    if (found == page_texts().end()) {
        broken("no row in pages.csv", english);
    }
    return found->second[static_cast<std::size_t>(language_in_use())];
}

std::string page_text(std::string_view english, std::initializer_list<TextField> fields) {
    const std::string_view pattern = page_text(english);
    std::string text;
    std::vector<bool> used(fields.size());
    for (std::size_t at = 0; at < pattern.size();) {
        const std::size_t open = std::min(pattern.find('{', at), pattern.size());
        text += pattern.substr(at, open - at);
        if (open == pattern.size()) {
            break;
        }
        const std::size_t close = pattern.find('}', open);
        std::string_view name = pattern.substr(open + 1, close - open - 1);
        const std::size_t choice = name.find('?');
        const std::string_view words = choice < name.size() ? name.substr(choice + 1) : "";
        name = name.substr(0, choice);
        const TextField* field = std::find_if(fields.begin(), fields.end(),
                                              [&](const TextField& one) { return one.name == name; });
        if (close == std::string_view::npos || field == fields.end()) {
            broken("no value for a placeholder", joined(english, " {", name, "}"));
        }
        used[static_cast<std::size_t>(field - fields.begin())] = true;
        const std::size_t line = words.find('|');
        text += words.empty()             ? field->value
                : is_of_one(field->value) ? words.substr(0, line)
                                          : words.substr(line + 1);
        at = close + 1;
    }
    if (std::find(used.begin(), used.end(), false) != used.end()) {
        broken("a value without a placeholder", english);
    }
    return text;
}

bool is_of_one(std::string_view number) {
    return number == "1" || (config::is_french(language_in_use()) &&
                             (number == "0" || number.starts_with("0,") || number.starts_with("1,")));
}

std::vector<std::string> english_page_texts() {
    std::vector<std::string> texts;
    for (const auto& [english, row] : page_texts()) {
        texts.push_back(english);
    }
    return texts;
}

}  // namespace coupling::report
