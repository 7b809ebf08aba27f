#pragma once

#include <compare>
#include <optional>
#include <string_view>
#include <vector>

#include "config/table/schema.hpp"
#include "config/table/table.hpp"

namespace coupling::climate {

/// A day of the calendar, or a month of it where `day` is 0.
struct Date {
    int year = 0;
    int month = 0;
    int day = 0;
    auto operator<=>(const Date&) const = default;
};

struct DeliveredRow;
/// Columns of days and dates that stand beside those of months (forest/climate/series.hpp) or instead of
/// them.
const config::Schema<DeliveredRow>& delivered_columns();

/// Which of two numbers before a year is the month, as in 02/11/1981.
enum class DateOrder : bool { day_first, month_first };

/// Reads 19811102, 198111, 1981-11-02, 1981/11, 2.11.1981 and 02/11/1981, each perhaps with a time of the day
/// behind it, which does not count. Nothing for what is no date.
std::optional<Date> date_of(std::string_view text, DateOrder order = DateOrder::day_first);

int days_of_month(int year, int month);

/// Day and month of a day of the year from 1; nothing past its end.
std::optional<Date> date_of_day(int year, int day_of_year);

/// Whether a month has several of the dates.
bool is_of_days(const std::vector<Date>& dates);

/// The date of each row, from the columns year, month, day, or year and day_of_year, or date. Nothing where a
/// table has none of them, or only year and month. Throws InputError for a field that is no date.
std::optional<std::vector<Date>> dates_of(const config::Table& table);

}  // namespace coupling::climate
