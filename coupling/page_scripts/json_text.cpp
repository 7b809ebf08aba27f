#include "coupling/page_scripts/json_text.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "config/text/base64.hpp"
#include "config/text/formatted.hpp"
#include "config/text/joined.hpp"

namespace coupling::page_scripts {
namespace {

using config::joined;

constexpr int significant_digits = 6;

std::string in_quotes(const std::string& plain) {
    return joined("\"", plain, "\"");
}

/// Lower bytes first.
template <class Whole>
void append(std::string& bytes, Whole value) {
    for (std::size_t i = 0; i < sizeof(Whole); ++i) {
        bytes += static_cast<char>((value >> (8U * i)) & 0xFFU);
    }
}

}  // namespace

std::string json_string(std::string_view text) {
    constexpr std::string_view digits = "0123456789abcdef";
    std::string json = "\"";
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') {
            json += '\\';
            json += c;
        } else if (code < 0x20U || c == '<' || c == '>' || c == '&') {
            json += "\\u00";
            json += digits[code >> 4U];
            json += digits[code & 15U];
        } else {
            json += c;
        }
    }
    return json + '"';
}

std::string json_number(double value) {
    if (!std::isfinite(value)) {
        return "null";
    }
    return config::with_digits(value, significant_digits);
}

std::string json_numbers(std::span<const double> values) {
    std::string json = "[";
    for (const double value : values) {
        json += json.size() > 1 ? "," : "";
        json += json_number(value);
    }
    return json + "]";
}

std::string json_array(const std::vector<std::string>& items) {
    std::string json = "[";
    for (const std::string& item : items) {
        json += json.size() > 1 ? "," : "";
        json += item;
    }
    return json + "]";
}

JsonObject& JsonObject::add(std::string_view name, const std::string& json) {
    members_ += members_.empty() ? "" : ",";
    members_ += joined(json_string(name), ":", json);
    return *this;
}

std::string JsonObject::json() const {
    return joined("{", members_, "}");
}

std::string json_packed(std::span<const std::uint16_t> values) {
    std::string bytes;
    bytes.reserve(2 * values.size());
    for (const std::uint16_t value : values) {
        append(bytes, value);
    }
    return in_quotes(config::base64(bytes));
}

std::string json_packed(std::span<const std::uint32_t> values) {
    std::string bytes;
    bytes.reserve(sizeof(std::uint32_t) * values.size());
    for (const std::uint32_t value : values) {
        append(bytes, value);
    }
    return in_quotes(config::base64(bytes));
}

std::string json_packed(std::span<const double> values) {
    const bool is_short = std::all_of(values.begin(), values.end(), [](double value) {
        constexpr double largest = std::numeric_limits<float>::max();
        return std::isnan(value) ||
               (std::abs(value) <= largest && static_cast<double>(static_cast<float>(value)) == value);
    });
    std::string bytes;
    bytes.reserve((is_short ? sizeof(float) : sizeof(double)) * values.size());
    for (const double value : values) {
        if (is_short) {
            append(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(value)));
        } else {
            append(bytes, std::bit_cast<std::uint64_t>(value));
        }
    }
    return in_quotes(joined(is_short ? "f4:" : "f8:", config::base64(bytes)));
}

std::string json_packed(std::span<const std::uint8_t> values) {
    std::string bytes;
    for (const std::uint8_t value : values) {
        bytes += static_cast<char>(value);
    }
    return in_quotes(config::base64(bytes));
}

}  // namespace coupling::page_scripts
