#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace coupling::page_scripts {

// JSON that may stand inside a <script>: no "<" in it.

std::string json_string(std::string_view text);
/// Up to six significant digits; null where not finite.
std::string json_number(double value);
std::string json_numbers(std::span<const double> values);
/// [item,item,...] of JSON texts.
std::string json_array(const std::vector<std::string>& items);

/// An object in the making, in the order in which members are added.
class JsonObject {
public:
    /// `json` is JSON already.
    JsonObject& add(std::string_view name, const std::string& json);
    JsonObject& text(std::string_view name, std::string_view value) { return add(name, json_string(value)); }
    JsonObject& number(std::string_view name, double value) { return add(name, json_number(value)); }
    JsonObject& flag(std::string_view name, bool value) { return add(name, value ? "true" : "false"); }
    [[nodiscard]] std::string json() const;

private:
    std::string members_;
};

/// Whole numbers from 0 to 65 535, two bytes each, lower one first, as base64 in quotes.
std::string json_packed(std::span<const std::uint16_t> values);
/// The same of whole numbers of four bytes.
std::string json_packed(std::span<const std::uint32_t> values);
/// Numbers with all their bits, lower bytes first, as base64 in quotes: behind "f4:" with four bytes each
/// where none loses a bit by it, else behind "f8:".
std::string json_packed(std::span<const double> values);
/// Bytes as base64 in quotes.
std::string json_packed(std::span<const std::uint8_t> values);

}  // namespace coupling::page_scripts
