#include "config/text/numbers.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace config {

namespace {

template <class Number>
std::optional<Number> parse_all(std::string_view text) {
    if (text.size() > 1 && text[0] == '+' && text[1] != '-') {
        text.remove_prefix(1);  // from_chars knows no plus
    }
    Number value{};
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc{} || stop != end) {
        return std::nullopt;
    }
    return value;
}

// Between these a number is written with all its digits, else with an exponent: whole numbers of doubles are
// exact below 2^53, and a millionth is finer than any quantity that people read here [choice].
constexpr double most_in_full = 0x1p53;
constexpr double least_in_full = 1e-6;

template <class Number>
std::string shortest(Number value) {
    // A sign, 16 digits, a point and the zeros before a small number: at most 26 characters.
    std::array<char, 40> buffer{};
    char* const end = buffer.data() + buffer.size();
    const auto size = std::abs(static_cast<double>(value));
    const bool in_full = value == Number{0} || (size >= least_in_full && size < most_in_full);
    const auto result = in_full ? std::to_chars(buffer.data(), end, value, std::chars_format::fixed)
                                : std::to_chars(buffer.data(), end, value);
    return {buffer.data(), result.ptr};
}

std::size_t leading_digits(std::string_view text) {
    return std::min(text.find_first_not_of("0123456789"), text.size());
}

}  // namespace

std::string to_string(const NumberRange& range) {
    const auto to_text = [](double limit) {
        // A reader compares a limit digit by digit: 1000000000, not 1e+09.
        constexpr double most = 1e15;
        return limit == std::trunc(limit) && std::abs(limit) < most
                   ? std::to_string(static_cast<long long>(limit))
                   : config::to_text(limit);
    };
    const bool has_low = std::isfinite(range.low);
    const bool has_high = std::isfinite(range.high);
    if (has_low && has_high) {
        std::string text{range.low_excluded ? "(" : "["};
        return text.append(to_text(range.low)).append(", ").append(to_text(range.high)).append("]");
    }
    if (has_low) {
        std::string text{range.low_excluded ? "> " : ">= "};
        return text.append(to_text(range.low));
    }
    return has_high ? std::string{"<= "}.append(to_text(range.high)) : "";
}

std::string describe(std::string_view kind, const NumberRange& range) {
    const std::string bounds = to_string(range);
    if (bounds.empty()) {
        return std::string{kind};
    }
    const bool interval = bounds.back() == ']';
    return std::string{kind} + (interval ? " in " : " ") + bounds;
}

std::optional<double> parse_number(std::string_view text) {
    const std::optional<double> value = parse_all<double>(text);
    return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<long long> parse_whole(std::string_view text) {
    if (text.find('.') != std::string_view::npos && without_separators(text)) {
        return std::nullopt;
    }
    if (const std::optional<long long> value = parse_all<long long>(text)) {
        return value;
    }
    const std::optional<double> value = parse_number(text);
    if (!value || *value != std::trunc(*value) || std::abs(*value) > 0x1p53) {
        return std::nullopt;
    }
    return static_cast<long long>(*value);
}

std::optional<std::string> without_separators(std::string_view text) {
    constexpr std::array<std::string_view, 9> separators{".",      ",",      "'",      " ",     "_",
                                                         "\u2019", "\u00A0", "\u202F", "\u2009"};
    std::string sign;
    if (text.starts_with('+') || text.starts_with('-')) {
        sign = text.front() == '-' ? "-" : "";
        text.remove_prefix(1);
    }
    const std::size_t first = leading_digits(text);
    if (first < 1 || first > 3 || text.front() == '0') {
        return std::nullopt;
    }
    for (const std::string_view separator : separators) {
        std::string digits{text.substr(0, first)};
        std::string_view rest = text.substr(first);
        while (rest.starts_with(separator) && leading_digits(rest.substr(separator.size())) == 3) {
            digits += rest.substr(separator.size(), 3);
            rest.remove_prefix(separator.size() + 3);
        }
        if (digits.size() == first) {
            continue;
        }
        const bool has_decimals = rest.size() > 1 && (rest.front() == '.' || rest.front() == ',') &&
                                  !rest.starts_with(separator) &&
                                  leading_digits(rest.substr(1)) == rest.size() - 1;
        if (rest.empty() || has_decimals) {
            sign.append(digits);
            return has_decimals ? sign.append(".").append(rest.substr(1)) : sign;
        }
    }
    return std::nullopt;
}

std::string to_text(double value) {
    return shortest(value);
}
std::string to_text(float value) {
    return shortest(value);
}

}  // namespace config
