#include "coupling/results/text/markup.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "config/text/joined.hpp"
#include "config/text/language.hpp"
#include "config/text/numbers.hpp"
#include "coupling/results/text/page_text.hpp"
#include "coupling/results/text/writing_language.hpp"

namespace coupling::report {
namespace {

using config::joined;

/// Smaller shares say nothing to people [choice].
constexpr double least_percent = 0.01;

/// As the language of the page writes it.
std::string with_groups(std::string_view digits) {
    return config::for_people(digits, language_in_use());
}

std::string plain(double value, int decimals) {
    std::array<char, 400> digits;
    const auto end =
        std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed, decimals)
            .ptr;
    std::string text{digits.data(), end};
    // A small negative number that is rounded away reads as 0, not as -0.0.
    return text.starts_with('-') && text.find_first_not_of("-0.") == std::string::npos ? text.substr(1)
                                                                                       : text;
}

}  // namespace

std::string escaped(std::string_view text) {
    std::string safe;
    safe.reserve(text.size());
    for (const char c : text) {
        switch (c) {
            case '&':
                safe += "&amp;";
                break;
            case '<':
                safe += "&lt;";
                break;
            case '>':
                safe += "&gt;";
                break;
            case '"':
                safe += "&quot;";
                break;
            default:
                safe += c;
        }
    }
    return safe;
}

std::string fixed(double value, int decimals) {
    return std::isfinite(value) ? with_groups(plain(value, decimals)) : "–";
}

std::string three_digits(double value) {
    if (!std::isfinite(value)) {
        return "–";
    }
    if (value == 0.0) {
        return "0";
    }
    const auto exponent_of = [](double number) {
        return static_cast<int>(std::floor(std::log10(std::abs(number)) + 1e-12));
    };
    const double unit = std::pow(10.0, exponent_of(value) - 2);
    const double rounded = std::round(value / unit) * unit;
    return with_groups(plain(rounded, std::clamp(2 - exponent_of(rounded), 0, 9)));
}

std::string tick_text(double value) {
    std::string digits = three_digits(value);
    if (digits.find(config::decimal_sign(language_in_use())) != std::string::npos) {
        digits.erase(digits.find_last_not_of('0') + 1);
        if (digits.ends_with(config::decimal_sign(language_in_use()))) {
            digits.pop_back();
        }
    }
    return digits;
}

std::string exact(double value) {
    const std::string digits = config::to_text(value);
    return digits.find('e') == std::string::npos ? with_groups(digits) : digits;
}

std::string grouped(std::uint64_t value) {
    return with_groups(std::to_string(value));
}

std::string percent(double share) {
    const double value = 100.0 * share;
    if (!std::isfinite(value)) {
        return "–";
    }
    if (value != 0.0 && std::abs(value) < least_percent) {
        return value < 0.0
                   ? joined(fixed(value, 2), "\u00a0%")
                   : page_text("less than {share}", {{"share", joined(fixed(least_percent, 2), "\u00a0%")}});
    }
    // Halves of the last digit go up, as in warnings about the same share: 414 of 800 are 51.8 %.
    constexpr double tenths = 10.0;
    const double rounded = std::round(value * tenths * (1.0 + 1e-13)) / tenths;
    const std::string digits = std::abs(value) < 10.0 ? three_digits(value) : fixed(rounded, 1);
    return joined(digits, "\u00a0%");
}

std::string hectares(double area_ha) {
    constexpr double least_ha = 0.01;
    if (area_ha == 0.0) {
        return "0";
    }
    if (area_ha > 0.0 && area_ha < least_ha) {
        return page_text("less than {share}", {{"share", fixed(least_ha, 2)}});
    }
    constexpr double from_ha = 9.995;  // shown as 10.0
    return fixed(area_ha, area_ha < from_ha ? 2 : 1);
}

std::string place(double value) {
    std::string digits = plain(value, 1);
    if (digits.ends_with(".0")) {
        digits.resize(digits.size() - 2);
    }
    return digits == "-0" ? "0" : digits;
}

double nice_step(double least) {
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * power >= least * (1.0 - 1e-9)) {
            return factor * power;
        }
    }
    return 10.0 * power;
}

}  // namespace coupling::report
