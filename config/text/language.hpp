#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace config {

/// Languages of pages and workbooks. Files for machines know none: they have a decimal point everywhere.
/// `de_CH` is the German of Switzerland: "ss", 1’000.5. `fr_CH` is its French: "degré de danger" where France
/// has "niveau d’aléa", 1’000.5.
enum class Language : std::uint8_t { en, de, fr, it, de_CH, fr_CH };

/// "en", "de", "fr", "it", "de-CH", "fr-CH": in HTML. Settings may have "de_CH", too.
std::string_view tag_of(Language language);
std::optional<Language> language_of(std::string_view tag);

/// French, whatever the country.
bool is_french(Language language);

/// "." in English and in Switzerland, "," in the others.
char decimal_sign(Language language);

/// A number with decimal point, such as "12345.6" or "-3", as people of a language read it: "12 345,6" and
/// "−3" with narrow no-break blanks between thousands (a point or comma there reads as a decimal sign in the
/// neighbouring language), in Switzerland with apostrophes.
std::string for_people(std::string_view number, Language language);

/// A day of the calendar.
struct Date {
    int year = 0;
    int month = 1;
    int day = 1;
    friend bool operator==(const Date&, const Date&) = default;
};

/// "2026-11-24" or "24.11.2026"; nothing for other texts and for days that no calendar has.
std::optional<Date> parse_date(std::string_view text);

/// "24 November 2026" in English, "24.11.2026" in the others.
std::string for_people(const Date& date, Language language);

}  // namespace config
