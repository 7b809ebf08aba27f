#include "coupling/results/text/catalogue.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <stdexcept>
#include <utility>

#include "config/text/joined.hpp"

namespace coupling::report {
namespace {

[[noreturn]] void broken_row(std::string_view what, std::string_view line) {
    throw std::logic_error(config::joined("table of texts: ", what, ": ", line));
}

/// Fields of a line `"a","b"`.
std::vector<std::string> fields_of(std::string_view line) {
    std::vector<std::string> fields;
    for (std::size_t at = 0; at < line.size(); ++at) {
        if (line[at] != '"') {
            broken_row("a field without quotes", line);
        }
        std::string& field = fields.emplace_back();
        for (++at; at < line.size(); ++at) {
            if (line[at] != '"') {
                field += line[at];
            } else if (at + 1 < line.size() && line[at + 1] == '"') {
                field += line[at++];
            } else {
                break;
            }
        }
        if (at >= line.size() || (at + 1 < line.size() && line[at + 1] != ',')) {
            broken_row("a field that does not end with a quote", line);
        }
        ++at;
    }
    return fields;
}

/// Terms of France and of Switzerland, whole words. The first that fits at a place counts.
constexpr std::array<std::pair<std::string_view, std::string_view>, 24> swiss_terms{
    {{"courbes de niveau", "courbes de niveau"},
     {"Courbes de niveau", "Courbes de niveau"},
     {"niveaux", "degrés"},
     {"niveau", "degré"},
     {"Niveaux", "Degrés"},
     {"Niveau", "Degré"},
     {"enjeux", "objets"},
     {"enjeu", "objet"},
     {"Enjeux", "Objets"},
     {"Enjeu", "Objet"},
     {"de l’aléa", "du danger"},
     {"à l’aléa", "au danger"},
     {"l’aléa", "le danger"},
     {"d’aléa", "de danger"},
     {"cet aléa", "ce danger"},
     {"aléas", "dangers"},
     {"aléa", "danger"},
     {"Aléas", "Dangers"},
     {"Aléa", "Danger"},
     {"merlons", "digues"},
     {"merlon", "digue"},
     {"Merlons", "Digues"},
     {"Merlon", "Digue"},
     {"Maître d’ouvrage", "Mandant"}}};

/// Whether a byte is one of a word: letters with an accent begin with 0xC3.
bool is_of_word(char byte) {
    return std::isalpha(static_cast<unsigned char>(byte)) != 0 || byte == '\xC3';
}

bool is_word_at(std::string_view text, std::size_t at, std::string_view word) {
    const std::size_t end = at + word.size();
    return text.substr(at).starts_with(word) && !(at > 0 && is_of_word(text[at - 1])) &&
           !(end < text.size() && is_of_word(text[end]));
}

}  // namespace

std::vector<std::vector<std::string>> rows_of_texts(std::string_view table) {
    const std::size_t head_end = std::min(table.find('\n'), table.size());
    const std::string_view head = table.substr(0, head_end);
    const auto columns = static_cast<std::size_t>(std::count(head.begin(), head.end(), ',')) + 1;
    std::vector<std::vector<std::string>> rows;
    for (std::size_t at = head_end + 1; at < table.size();) {
        const std::size_t end = std::min(table.find('\n', at), table.size());
        const std::string_view line = table.substr(at, end - at);
        rows.push_back(fields_of(line));
        if (rows.back().size() != columns) {
            broken_row("not as many fields as columns", line);
        }
        at = end + 1;
    }
    return rows;
}

std::string with_many(std::string_view text) {
    std::string plain;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t open = std::min(text.find('{', at), text.size());
        const std::size_t close = std::min(text.find('}', open), text.size());
        const std::size_t choice = text.find('?', open);
        plain += text.substr(at, open - at);
        if (choice < close) {
            const std::size_t line = text.find('|', choice);
            if (line >= close) {
                broken_row("a choice without |", text);
            }
            plain += text.substr(line + 1, close - line - 1);
        } else {
            plain += text.substr(open, close + 1 - open);
        }
        at = close + 1;
    }
    return plain;
}

namespace {

bool is_digit_at(const std::string& text, std::size_t at) {
    return at < text.size() && text[at] >= '0' && text[at] <= '9';
}

/// Whether a comma parts a number, as in 0,82, and not a list, as in 0,10,20.
bool parts_a_number(const std::string& text, std::size_t comma) {
    std::size_t first = comma;
    while (first > 0 && is_digit_at(text, first - 1)) {
        --first;
    }
    std::size_t last = comma + 1;
    while (is_digit_at(text, last)) {
        ++last;
    }
    const auto goes_on = [&](std::size_t at, std::size_t beyond) {
        return at < text.size() && text[at] == ',' && is_digit_at(text, beyond);
    };
    return first < comma && last > comma + 1 && !goes_on(last, last + 1) &&
           !(first > 1 && goes_on(first - 1, first - 2));
}

}  // namespace

std::string swiss_german(std::string text) {
    constexpr std::string_view sharp_s = "ß";
    for (std::size_t at = text.find(sharp_s); at != std::string::npos; at = text.find(sharp_s, at)) {
        text.replace(at, sharp_s.size(), "ss");
    }
    for (std::size_t at = text.find(','); at != std::string::npos; at = text.find(',', at + 1)) {
        if (parts_a_number(text, at)) {
            text[at] = '.';
        }
    }
    return text;
}

std::string with_swiss_terms(std::string_view text) {
    std::string swiss;
    for (std::size_t at = 0; at < text.size();) {
        const auto* const term = std::find_if(swiss_terms.begin(), swiss_terms.end(), [&](const auto& each) {
            return is_word_at(text, at, each.first);
        });
        if (term == swiss_terms.end()) {
            swiss += text[at++];
        } else {
            swiss += term->second;
            at += term->first.size();
        }
    }
    return swiss;
}

std::vector<std::vector<std::string>> rows_of_all_languages(std::string_view table) {
    std::vector<std::vector<std::string>> rows = rows_of_texts(table);
    for (std::vector<std::string>& row : rows) {
        const std::size_t italian = row.size() - 1;
        row.push_back(swiss_german(row[italian - 2]));
        row.push_back(with_swiss_terms(row[italian - 1]));
    }
    return rows;
}

}  // namespace coupling::report
