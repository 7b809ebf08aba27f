#include "coupling/results/text/page_text.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>

#include "config/text/embedded.hpp"
#include "config/text/joined.hpp"
#include "coupling/results/text/writing_language.hpp"

BANNWALD_EMBED(texts_en, BANNWALD_TEXTS_DIR "/texts_en.csv")
BANNWALD_EMBED(texts_de, BANNWALD_TEXTS_DIR "/texts_de.csv")
BANNWALD_EMBED(texts_fr, BANNWALD_TEXTS_DIR "/texts_fr.csv")
BANNWALD_EMBED(texts_it, BANNWALD_TEXTS_DIR "/texts_it.csv")

namespace coupling::report {
namespace {

using config::joined;
using Texts = std::map<std::string, std::string, std::less<>>;

[[noreturn]] void broken(std::string_view what, std::string_view where) {
    throw std::logic_error(joined("texts of the pages: ", what, ": ", where));
}

/// The text of a line `key,"text"`; quotes within are doubled.
std::string unquoted(std::string_view line, std::size_t begin) {
    std::string text;
    std::size_t at = begin;
    for (; at < line.size(); ++at) {
        if (line[at] != '"') {
            text += line[at];
        } else if (at + 1 < line.size() && line[at + 1] == '"') {
            text += line[at++];
        } else {
            break;
        }
    }
    if (at + 1 != line.size()) {
        broken("found a line that does not end with its text", line);
    }
    return text;
}

Texts read_texts(std::string_view table) {
    constexpr std::string_view between = ",\"";
    Texts texts;
    for (std::size_t at = table.find('\n') + 1; at < table.size();) {
        const std::size_t end = std::min(table.find('\n', at), table.size());
        const std::string_view line = table.substr(at, end - at);
        const std::size_t comma = line.find(between);
        if (comma == std::string_view::npos) {
            broken("found a line without a quoted text", line);
        }
        const bool is_new =
            texts.emplace(line.substr(0, comma), unquoted(line, comma + between.size())).second;
        if (!is_new) {
            broken("found a key twice", line);
        }
        at = end + 1;
    }
    return texts;
}

/// Those of the language in use.
const Texts& texts() {
    static const std::array<Texts, 4> all{
        read_texts(BANNWALD_EMBEDDED(texts_en)), read_texts(BANNWALD_EMBEDDED(texts_de)),
        read_texts(BANNWALD_EMBEDDED(texts_fr)), read_texts(BANNWALD_EMBEDDED(texts_it))};
    return all[static_cast<std::size_t>(language_in_use())];
}

}  // namespace

const std::string& page_text(std::string_view key) {
    const auto found = texts().find(key);
    if (found == texts().end()) {
        broken("no such key", key);
    }
    return found->second;
}

std::string page_text(std::string_view key, std::initializer_list<TextField> fields) {
    const std::string_view pattern = page_text(key);
    std::string text;
    std::vector<bool> used(fields.size());
    for (std::size_t at = 0; at < pattern.size();) {
        const std::size_t open = std::min(pattern.find('{', at), pattern.size());
        text += pattern.substr(at, open - at);
        if (open == pattern.size()) {
            break;
        }
        const std::size_t close = pattern.find('}', open);
        const std::string_view name = pattern.substr(open + 1, close - open - 1);
        const TextField* field = std::find_if(fields.begin(), fields.end(),
                                              [&](const TextField& one) { return one.name == name; });
        if (close == std::string_view::npos || field == fields.end()) {
            broken("no value for a placeholder", joined(key, " {", name, "}"));
        }
        used[static_cast<std::size_t>(field - fields.begin())] = true;
        text += field->value;
        at = close + 1;
    }
    if (std::find(used.begin(), used.end(), false) != used.end()) {
        broken("a value without a placeholder", key);
    }
    return text;
}

std::vector<std::pair<std::string, std::string>> all_page_texts() {
    return {texts().begin(), texts().end()};
}

}  // namespace coupling::report
