#include "config/text/language.hpp"

#include <algorithm>
#include <array>
#include <charconv>

namespace config {
namespace {

constexpr std::string_view narrow_blank = "\u202f";  // no-break
constexpr std::string_view minus = "\u2212";
constexpr std::string_view apostrophe = "\u2019";
constexpr std::array<std::string_view, 6> tags{"en", "de", "fr", "it", "de-CH", "fr-CH"};

/// The whole text as digits.
std::optional<int> digits_of(std::string_view text, std::size_t least, std::size_t most) {
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool is_whole = error == std::errc{} && end == text.data() + text.size() && text.front() != '-';
    return is_whole && text.size() >= least && text.size() <= most ? std::optional{value} : std::nullopt;
}

int days_in(int year, int month) {
    constexpr std::array days{31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
    const bool leap = (year % 4 == 0 && year % 100 != 0) || year % 400 == 0;
    return days[static_cast<std::size_t>(month - 1)] + (month == 2 && leap ? 1 : 0);
}

bool is_of_switzerland(Language language) {
    return language == Language::de_CH || language == Language::fr_CH;
}

std::string two_digits(int value) {
    return value < 10 ? std::string{"0"}.append(std::to_string(value)) : std::to_string(value);
}

}  // namespace

std::string_view tag_of(Language language) {
    return tags[static_cast<std::size_t>(language)];
}

std::optional<Language> language_of(std::string_view tag) {
    std::string written{tag};
    std::replace(written.begin(), written.end(), '_', '-');
    const auto found = std::find(tags.begin(), tags.end(), written);
    return found == tags.end() ? std::nullopt : std::optional{static_cast<Language>(found - tags.begin())};
}

bool is_french(Language language) {
    return language == Language::fr || language == Language::fr_CH;
}

char decimal_sign(Language language) {
    return language == Language::en || is_of_switzerland(language) ? '.' : ',';
}

std::string for_people(std::string_view number, Language language) {
    const bool negative = number.starts_with('-');
    const std::string_view digits = number.substr(negative ? 1 : 0);
    const std::size_t point = std::min(digits.find('.'), digits.size());
    std::string text{negative ? minus : std::string_view{}};
    for (std::size_t at = 0; at < digits.size(); ++at) {
        if (at > 0 && at < point && (point - at) % 3 == 0) {
            text += is_of_switzerland(language) ? apostrophe : narrow_blank;
        }
        text += at == point ? decimal_sign(language) : digits[at];
    }
    return text;
}

std::optional<Date> parse_date(std::string_view text) {
    const bool is_iso = text.find('-') != std::string_view::npos;
    const char between = is_iso ? '-' : '.';
    const std::size_t first = text.find(between);
    const std::size_t second = first == std::string_view::npos ? first : text.find(between, first + 1);
    if (second == std::string_view::npos) {
        return std::nullopt;
    }
    const std::array parts{text.substr(0, first), text.substr(first + 1, second - first - 1),
                           text.substr(second + 1)};
    const auto year = digits_of(parts[is_iso ? 0 : 2], 4, 4);
    const auto month = digits_of(parts[1], 1, 2);
    const auto day = digits_of(parts[is_iso ? 2 : 0], 1, 2);
    if (!year || !month || !day || *year < 1 || *month < 1 || *month > 12 || *day < 1 ||
        *day > days_in(*year, *month)) {
        return std::nullopt;
    }
    return Date{*year, *month, *day};
}

std::string for_people(const Date& date, Language language) {
    constexpr std::array<std::string_view, 12> months{"January",   "February", "March",    "April",
                                                      "May",       "June",     "July",     "August",
                                                      "September", "October",  "November", "December"};
    const std::string year = std::to_string(date.year);
    if (language == Language::en) {
        return std::to_string(date.day)
            .append(" ")
            .append(months[static_cast<std::size_t>(date.month - 1)])
            .append(" ")
            .append(year);
    }
    return two_digits(date.day).append(".").append(two_digits(date.month)).append(".").append(year);
}

}  // namespace config
