#include "config/options/values.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

#include "config/text/reading.hpp"

namespace config {

namespace {

/// Whether commas may be meant as decimal commas: "0,5 1,0" has no point and no blank after a comma.
bool decimal_commas_possible(std::string_view text) {
    for (std::size_t comma = text.find(','); comma != std::string_view::npos;
         comma = text.find(',', comma + 1)) {
        if (comma + 1 < text.size() && text[comma + 1] != ' ' && text[comma + 1] != '\t') {
            return text.find('.') == std::string_view::npos;
        }
    }
    return false;
}

std::optional<std::vector<double>> listed_numbers(std::string_view text, const NumberRange& range) {
    std::vector<double> values;
    std::string_view rest = trimmed(text);
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find_first_of(", \t"), rest.size());
        const std::optional<double> value = number_in(rest.substr(0, end), range);
        if (!value) {
            return std::nullopt;
        }
        values.push_back(*value);
        rest = trimmed(rest.substr(end));
        if (rest.starts_with(',')) {
            rest = trimmed(rest.substr(1));
            if (rest.empty()) {
                return std::nullopt;
            }
        }
    }
    return values;
}

}  // namespace

std::optional<double> number_in(std::string_view text, const NumberRange& range) {
    const std::optional<double> value = parse_number(text);
    return value && range.contains(*value) ? value : std::nullopt;
}

std::optional<std::uint64_t> count_in(std::string_view text, const NumberRange& range) {
    std::uint64_t value = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc{} || stop != end) {
        const std::optional<long long> whole = parse_whole(text);
        if (!whole || *whole < 0) {
            return std::nullopt;
        }
        value = static_cast<std::uint64_t>(*whole);
    }
    return range.contains(static_cast<double>(value)) ? std::optional{value} : std::nullopt;
}

std::optional<bool> flag_in(std::string_view text) {
    const std::string word = in_lower_case(text);
    if (word == "yes" || word == "true" || word == "on" || word == "1") {
        return true;
    }
    if (word == "no" || word == "false" || word == "off" || word == "0") {
        return false;
    }
    return std::nullopt;
}

std::optional<std::vector<double>> numbers_in(std::string_view text, const NumberRange& range) {
    return decimal_commas_possible(trimmed(text)) ? std::nullopt : listed_numbers(text, range);
}

std::optional<std::vector<double>> whole_numbers_in(std::string_view text, const NumberRange& range) {
    std::optional<std::vector<double>> values = listed_numbers(text, range);
    const bool are_whole = values && std::all_of(values->begin(), values->end(),
                                                 [](double value) { return value == std::floor(value); });
    return are_whole ? values : std::nullopt;
}

std::string list_text(const std::vector<double>& values) {
    std::string text;
    for (const double value : values) {
        text.append(text.empty() ? "" : ", ").append(to_text(value));
    }
    return text;
}

bool is_one_line(std::string_view text) {
    return std::all_of(text.begin(), text.end(), [](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return byte == '\t' || (byte >= 0x20 && byte != 0x7F);
    });
}

}  // namespace config
