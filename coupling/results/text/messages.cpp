#include "coupling/results/text/messages.hpp"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <utility>

#include "config/table/table.hpp"
#include "config/text/embedded.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/results/text/catalogue.hpp"
#include "coupling/results/text/element.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/scenario_names.hpp"
#include "coupling/results/text/writing_language.hpp"

BANNWALD_EMBED(messages, BANNWALD_EMBEDDED_FILE)

namespace coupling::report {
namespace {

using config::joined;

enum class SlotKind : std::uint8_t { number, place, text, words };

struct Slot {
    std::string name;
    SlotKind kind;
    bool is_counted = false;  ///< a number of things or units, so no year
};

/// "a{text}b{text2}c" as "a", "b", "c" and the two slots between them.
struct Pattern {
    std::vector<std::string> literals;
    std::vector<Slot> slots;

    /// "{words} (return periods: {text})": what stands behind a whole message.
    [[nodiscard]] bool is_bracket_behind() const {
        return slots.size() >= 2 && literals.front().empty() && slots.front().kind == SlotKind::words &&
               literals[1].starts_with(" (") && literals.back() == ")";
    }
    [[nodiscard]] std::size_t bytes() const {
        std::size_t sum = 0;
        for (const std::string& literal : literals) {
            sum += literal.size();
        }
        return sum;
    }
};

SlotKind kind_of(std::string_view name) {
    while (!name.empty() && std::isdigit(static_cast<unsigned char>(name.back())) != 0) {
        name.remove_suffix(1);
    }
    if (name == "number") {
        return SlotKind::number;
    }
    if (name == "place") {
        return SlotKind::place;
    }
    if (name == "words") {
        return SlotKind::words;
    }
    if (name != "text") {
        throw std::logic_error(joined("messages.csv: no such placeholder: {", name, "}"));
    }
    return SlotKind::text;
}

/// Whether what follows a number in English says of what it is: " trees stand there", but not " to ".
bool names_a_thing(std::string_view text) {
    constexpr std::array no_things{"to", "in", "with", "that", "between", "measured", "stand", "wholly"};
    if (text.size() < 2 || text[0] != ' ' || std::isalpha(static_cast<unsigned char>(text[1])) == 0) {
        return false;
    }
    const std::string_view word = text.substr(1, std::min(text.find_first_of(" ,;:.", 1), text.size()) - 1);
    return std::find(no_things.begin(), no_things.end(), word) == no_things.end();
}

Pattern pattern_of(std::string_view text) {
    Pattern pattern;
    std::size_t at = 0;
    for (std::size_t open = text.find('{'); open != std::string_view::npos; open = text.find('{', at)) {
        const std::size_t close = std::min(text.find('}', open), text.size() - 1);
        pattern.literals.emplace_back(text.substr(at, open - at));
        const std::string_view name = text.substr(open + 1, close - open - 1);
        pattern.slots.push_back({std::string{name}, kind_of(name)});
        at = close + 1;
    }
    pattern.literals.emplace_back(text.substr(at));
    for (std::size_t i = 0; i < pattern.slots.size(); ++i) {
        pattern.slots[i].is_counted = names_a_thing(pattern.literals[i + 1]);
    }
    return pattern;
}

struct Message {
    Pattern english;
    std::array<Pattern, 6> languages;
};

/// Brackets behind whole messages come first, as a text at the end of a message would take them in. Then
/// those that say most: a whole sentence before the parts that it could be made of.
std::vector<Message> read_messages() {
    std::vector<Message> messages;
    for (const auto& row : all_messages()) {
        Message message{pattern_of(row[0]), {}};
        std::transform(row.begin(), row.end(), message.languages.begin(), pattern_of);
        message.languages[4] = pattern_of(swiss_german(row[1]));
        message.languages[5] = pattern_of(with_swiss_terms(row[2]));
        messages.push_back(std::move(message));
    }
    std::stable_sort(messages.begin(), messages.end(), [](const Message& a, const Message& b) {
        return std::pair{a.english.is_bracket_behind(), a.english.bytes()} >
               std::pair{b.english.is_bracket_behind(), b.english.bytes()};
    });
    return messages;
}

const std::vector<Message>& messages() {
    static const std::vector<Message> all = read_messages();
    return all;
}

/// "-1234.5" but not "nan" or "1,5".
bool is_plain_number(std::string_view text) {
    const std::string_view digits = text.substr(text.starts_with('-') ? 1 : 0);
    return !digits.empty() && std::isdigit(static_cast<unsigned char>(digits.front())) != 0 &&
           std::isdigit(static_cast<unsigned char>(digits.back())) != 0 && config::parse_number(text);
}

/// What may be a year stays in one piece.
bool may_be_year(std::string_view number) {
    const auto value = number.size() == 4 ? config::parse_whole(number) : std::nullopt;
    return value && *value >= 1500 && *value < 2200;
}

/// Thousands apart from each other, but not in a year.
std::string number_in(std::string_view number, bool is_counted, config::Language language) {
    constexpr std::size_t longest_in_one_piece = 3;
    const std::size_t sign = number.starts_with('-') ? 1 : 0;
    const std::size_t whole = std::min(number.find('.'), number.size()) - sign;
    if (whole > longest_in_one_piece && number.find_first_of("eE") == std::string_view::npos &&
        (is_counted || !may_be_year(number))) {
        return config::for_people(number, language);
    }
    std::string text{number};
    std::replace(text.begin(), text.end(), '.', config::decimal_sign(language));
    return text;
}

/// Translates a message and, by the same rows, the parts of it that are messages.
class Translator {
public:
    explicit Translator(config::Language language) : language_{language} {}

    std::optional<std::string> of(std::string_view message) {
        const auto [known, is_new] = known_.try_emplace(std::string{message});
        if (!is_new) {
            return known->second;
        }
        for (const Message& row : report::messages()) {
            std::vector<std::string> values(row.english.slots.size());
            if (message.starts_with(row.english.literals.front()) &&
                fits(message.substr(row.english.literals.front().size()), row.english, 0, values)) {
                known->second = filled(row, values);
                break;
            }
        }
        return known->second;
    }

private:
    /// What a slot becomes; nothing if the text cannot stand there.
    std::optional<std::string> value_of(std::string_view text, const Slot& slot) {
        switch (slot.kind) {
            case SlotKind::number:
                return is_plain_number(text) ? std::optional{number_in(text, slot.is_counted, language_)}
                                             : std::nullopt;
            case SlotKind::place:
                return text.find(": ") == std::string_view::npos ? std::optional{std::string{text}}
                                                                 : std::nullopt;
            case SlotKind::words:
                return of(text);
            case SlotKind::text:
                break;
        }
        return std::string{text};
    }

    /// Whether the rest of a message is the pattern from a slot on; sets the values of its slots. Tries the
    /// shortest texts first.
    bool fits(std::string_view rest, const Pattern& pattern, std::size_t slot,
              std::vector<std::string>& values) {
        if (slot == pattern.slots.size()) {
            return rest.empty();
        }
        const std::string& next = pattern.literals[slot + 1];
        const bool is_last = slot + 1 == pattern.slots.size();
        if (is_last && (!rest.ends_with(next) || rest.size() <= next.size())) {
            return false;
        }
        for (std::size_t end = is_last ? rest.size() - next.size() : rest.find(next, 1);
             end != std::string_view::npos;
             end = is_last ? std::string_view::npos : rest.find(next, end + 1)) {
            if (auto value = value_of(rest.substr(0, end), pattern.slots[slot])) {
                values[slot] = std::move(*value);
                if (fits(rest.substr(end + next.size()), pattern, slot + 1, values)) {
                    return true;
                }
            }
        }
        return false;
    }

    [[nodiscard]] std::string filled(const Message& row, const std::vector<std::string>& values) const {
        const Pattern& pattern = row.languages[static_cast<std::size_t>(language_)];
        const std::vector<Slot>& given = row.english.slots;
        std::string text = pattern.literals.front();
        for (std::size_t i = 0; i < pattern.slots.size(); ++i) {
            const auto slot = std::find_if(given.begin(), given.end(), [&](const Slot& one) {
                return one.name == pattern.slots[i].name;
            });
            if (slot == given.end()) {
                throw std::logic_error(joined("messages.csv: no {", pattern.slots[i].name, "} in English"));
            }
            text += values[static_cast<std::size_t>(slot - given.begin())];
            text += pattern.literals[i + 1];
        }
        return text;
    }

    config::Language language_;
    std::map<std::string, std::optional<std::string>, std::less<>> known_;
};

}  // namespace

const std::vector<std::array<std::string, 4>>& all_messages() {
    static const std::vector<std::array<std::string, 4>> all = [] {
        const config::Table table = config::Table::read(BANNWALD_EMBEDDED(messages), "messages.csv");
        std::vector<std::array<std::string, 4>> rows;
        for (std::size_t row = 0; row < table.rows(); ++row) {
            rows.push_back(
                {table.text(row, "en"), table.text(row, "de"), table.text(row, "fr"), table.text(row, "it")});
        }
        return rows;
    }();
    return all;
}

std::optional<std::string> translated(std::string_view message) {
    const bool is_english = language_in_use() == config::Language::en;
    auto text =
        message.size() > longest_message_bytes ? std::nullopt : Translator{language_in_use()}.of(message);
    return text || !is_english ? text : std::optional{std::string{message}};
}

std::string message_text(std::string_view message) {
    return translated(message).value_or(std::string{message});
}

std::string message_html(std::string_view message) {
    const std::string named = with_scenario_names(std::string{message});
    const auto text = translated(named);
    return text ? escaped(*text) : element("span", {{"lang", "en"}}, escaped(named));
}

}  // namespace coupling::report
