#include "config/text/numbers.hpp"

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

template <class Number>
std::string shortest(Number value) {
    std::array<char, 32> buffer{};
    const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    return {buffer.data(), result.ptr};
}

}  // namespace

std::string to_string(const NumberRange& range) {
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
    if (const std::optional<long long> value = parse_all<long long>(text)) {
        return value;
    }
    const std::optional<double> value = parse_number(text);
    if (!value || *value != std::trunc(*value) || std::abs(*value) > 0x1p53) {
        return std::nullopt;
    }
    return static_cast<long long>(*value);
}

std::string to_text(double value) {
    return shortest(value);
}
std::string to_text(float value) {
    return shortest(value);
}

}  // namespace config
