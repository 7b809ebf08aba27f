#include "tests/fuzz/mutate.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <utility>
#include <vector>

namespace fuzz {
namespace {

constexpr std::array<std::string_view, 40> hostile_numbers{"nan",
                                                           "inf",
                                                           "-inf",
                                                           "NaN",
                                                           "1e308",
                                                           "-1e308",
                                                           "1e309",
                                                           "5e-324",
                                                           "-0",
                                                           "0",
                                                           "-1",
                                                           "1",
                                                           "2",
                                                           "3.5",
                                                           "1e-300",
                                                           "1e15",
                                                           "9e15",
                                                           "1e18",
                                                           "1e19",
                                                           "2147483647",
                                                           "2147483648",
                                                           "-2147483648",
                                                           "4294967295",
                                                           "4294967296",
                                                           "9223372036854775807",
                                                           "9223372036854775808",
                                                           "18446744073709551615",
                                                           "18446744073709551616",
                                                           "1e6",
                                                           "1000000",
                                                           "65536",
                                                           "255",
                                                           "256",
                                                           "0x10",
                                                           "1,5",
                                                           "1.000,5",
                                                           "--1",
                                                           "1e",
                                                           "+1",
                                                           ""};

constexpr std::array<std::string_view, 26> hostile_texts{"\xEF\xBB\xBF",
                                                         "\xFF\xFE",
                                                         "\xC3\x28",
                                                         "\xE2\x82",
                                                         "\xF0\x9F\x98\x80",
                                                         std::string_view{"\0", 1},
                                                         "\r\n",
                                                         "\r",
                                                         "\n\n",
                                                         "\"",
                                                         "\"\"",
                                                         ",",
                                                         ";",
                                                         "\t",
                                                         "#",
                                                         "=",
                                                         "[",
                                                         "]",
                                                         "%s%n",
                                                         "../../x",
                                                         "=1+1",
                                                         "EMPTY",
                                                         "((((((((",
                                                         "))",
                                                         "unit",
                                                         "<script>"};

bool is_number_byte(char c) {
    return std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '-' || c == '+' || c == 'e';
}

struct Range {
    std::size_t at = 0;
    std::size_t size = 0;
};

/// What lies between the `breaks` around a place.
Range piece_around(const std::string& text, std::size_t at, std::string_view breaks) {
    const std::size_t before = at == 0 ? std::string::npos : text.find_last_of(breaks, at - 1);
    const std::size_t first = before == std::string::npos ? 0 : before + 1;
    const std::size_t end = std::min(text.find_first_of(breaks, at), text.size());
    return {first, end - std::min(first, end)};
}

Range any_piece(const std::string& text, std::string_view breaks, Chance& chance) {
    return piece_around(text, chance.below(text.size() + 1), breaks);
}

constexpr std::string_view line_breaks = "\n";
constexpr std::string_view field_breaks = ",;\n \t=";

void replace_number(std::string& text, Chance& chance) {
    std::size_t at = chance.below(text.size() + 1);
    while (at < text.size() && !is_number_byte(text[at])) {
        ++at;
    }
    std::size_t end = at;
    while (end < text.size() && is_number_byte(text[end])) {
        ++end;
    }
    text.replace(at, end - at, chance.any(hostile_numbers));
}

void exchange_pieces(std::string& text, std::string_view breaks, Chance& chance) {
    Range a = any_piece(text, breaks, chance);
    Range b = any_piece(text, breaks, chance);
    if (b.at < a.at) {
        std::swap(a, b);
    }
    if (a.at + a.size > b.at) {
        return;
    }
    const std::string first = text.substr(a.at, a.size);
    const std::string second = text.substr(b.at, b.size);
    text.replace(b.at, b.size, first);
    text.replace(a.at, a.size, second);
}

void repeat_piece(std::string& text, Range piece, std::size_t times, Chance& chance) {
    const std::string part =
        text.substr(piece.at, std::max<std::size_t>(piece.size, 1)) + (chance.one_in(2) ? "" : ",");
    times = std::min(times, longest_input_bytes / std::max<std::size_t>(part.size(), 1));
    std::string many;
    many.reserve(part.size() * times);
    for (std::size_t i = 0; i < times; ++i) {
        many += part;
    }
    text.insert(std::min(piece.at, text.size()), many);
}

void replace_all(std::string& text, std::string_view from, std::string_view to) {
    std::string out;
    std::size_t at = 0;
    for (std::size_t found = text.find(from); found != std::string::npos; found = text.find(from, at)) {
        out.append(text, at, found - at).append(to);
        at = found + from.size();
    }
    text = out.append(text, at);
}

void as_utf16(std::string& text) {
    std::string wide{"\xFF\xFE"};
    for (const char c : text) {
        wide += c;
        wide += '\0';
    }
    text = std::move(wide);
}

void change_bytes(std::string& text, Chance& chance) {
    const std::size_t at = chance.below(text.size());
    switch (chance.below(6)) {
        case 0:
            text[at] = static_cast<char>(static_cast<unsigned char>(text[at]) ^ (1U << chance.below(8)));
            return;
        case 1:
            text[at] = static_cast<char>(chance.below(256));
            return;
        case 2:
            text.insert(at, 1, static_cast<char>(chance.below(256)));
            return;
        case 3:
            text.erase(at, 1 + chance.below(8));
            return;
        case 4:
            text.insert(at, text.substr(at, 1 + chance.below(16)));
            return;
        default:  // a word of four or eight bytes, as binary files hold counts and numbers
            for (std::size_t i = at; i < std::min(text.size(), at + (chance.one_in(2) ? 4U : 8U)); ++i) {
                text[i] = static_cast<char>(chance.one_in(3) ? chance.below(256) : 255);
            }
    }
}

void change_pieces(std::string& text, Chance& chance) {
    const std::string_view breaks = chance.one_in(3) ? line_breaks : field_breaks;
    switch (chance.below(6)) {
        case 0:
            exchange_pieces(text, breaks, chance);
            return;
        case 1: {
            const Range piece = any_piece(text, breaks, chance);
            text.erase(piece.at, piece.size + 1);
            return;
        }
        case 2: {
            const Range piece = any_piece(text, breaks, chance);
            text.insert(piece.at, text.substr(piece.at, piece.size + 1));
            return;
        }
        case 3:
            text.insert(chance.below(text.size() + 1), chance.any(hostile_texts));
            return;
        default: {  // one field in the place of another one
            const Range from = any_piece(text, field_breaks, chance);
            const Range to = any_piece(text, field_breaks, chance);
            text.replace(to.at, to.size, std::string{text, from.at, from.size});
        }
    }
}

void change_all(std::string& text, Chance& chance) {
    switch (chance.below(7)) {
        case 0:
            text.resize(chance.below(text.size()));
            return;
        case 1:
            repeat_piece(text, any_piece(text, field_breaks, chance), std::size_t{1} << chance.below(18),
                         chance);
            return;
        case 2:
            repeat_piece(text, any_piece(text, line_breaks, chance), std::size_t{1} << chance.below(10),
                         chance);
            return;
        case 3:
            replace_all(text, "\n", chance.one_in(2) ? "\r\n" : "\r");
            return;
        case 4:
            replace_all(text, ",", ";");
            return;
        case 5:
            as_utf16(text);
            return;
        default:
            text.insert(chance.below(text.size() + 1), text);
    }
}

}  // namespace

std::string mutated(const std::string& bytes, Chance& chance) {
    std::string text = bytes;
    const std::size_t changes = 1 + chance.below(4);
    for (std::size_t i = 0; i < changes; ++i) {
        if (text.empty()) {
            text = "0";
        }
        const std::size_t kind = chance.below(10);
        if (kind < 4) {
            replace_number(text, chance);
        } else if (kind < 7) {
            change_bytes(text, chance);
        } else if (kind < 9) {
            change_pieces(text, chance);
        } else {
            change_all(text, chance);
        }
    }
    text.resize(std::min(text.size(), longest_input_bytes));
    return text;
}

}  // namespace fuzz
