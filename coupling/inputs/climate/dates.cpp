#include "coupling/inputs/climate/dates.hpp"

#include <algorithm>
#include <cctype>
#include <string>
#include <utility>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "config/text/reading.hpp"

namespace coupling::climate {
namespace {

constexpr std::size_t digits_of_year = 4;

bool is_leap(int year) {
    return (year % 4 == 0 && year % 100 != 0) || year % 400 == 0;
}

std::optional<Date> checked(int year, int month, int day, bool has_day) {
    constexpr int months = 12;
    const bool is_good =
        month >= 1 && month <= months && (!has_day || (day >= 1 && day <= days_of_month(year, month)));
    return is_good ? std::optional{Date{year, month, has_day ? day : 0}} : std::nullopt;
}

int number_of(std::string_view digits) {
    return static_cast<int>(config::parse_whole(std::string{digits}).value_or(0));
}

/// The groups of digits before a time of the day.
std::vector<std::string_view> groups_of(std::string_view text) {
    std::vector<std::string_view> groups;
    std::size_t at = 0;
    while (at < text.size() && std::isdigit(static_cast<unsigned char>(text[at])) != 0) {
        std::size_t end = at;
        while (end < text.size() && std::isdigit(static_cast<unsigned char>(text[end])) != 0) {
            ++end;
        }
        groups.push_back(text.substr(at, end - at));
        const bool goes_on =
            end + 1 < text.size() && std::string_view{"-./"}.find(text[end]) != std::string_view::npos;
        at = goes_on ? end + 1 : text.size();
    }
    return groups;
}

/// 19811102, or with an hour 1981110206; 198111 for a month.
std::optional<Date> date_of_digits(std::string_view digits) {
    constexpr std::size_t of_month = 6;
    constexpr std::size_t of_day = 8;
    constexpr std::size_t of_hour = 10;
    if (digits.size() != of_month && digits.size() != of_day && digits.size() != of_hour) {
        return std::nullopt;
    }
    const bool has_day = digits.size() > of_month;
    return checked(number_of(digits.substr(0, digits_of_year)), number_of(digits.substr(digits_of_year, 2)),
                   has_day ? number_of(digits.substr(of_month, 2)) : 0, has_day);
}

[[noreturn]] void refuse_date(const config::Table& table, std::size_t row, const char* column) {
    config::fail(config::ExitCode::data, table.place(row, column),
                 config::joined(column, " ", config::in_quotes(table.text(row, column))),
                 "a day or month such as 1981-11-02, 19811102, 2.11.1981 or 1981-11");
}

int whole_at(const config::Table& table, std::size_t row, const char* column, int low, int high) {
    config::Problems problems;
    const auto value = table.whole(
        row, column, {.low = static_cast<double>(low), .high = static_cast<double>(high)}, problems);
    problems.throw_if_any();
    return static_cast<int>(*value);
}

/// The order that all fields of the table allow.
DateOrder order_of(const config::Table& table) {
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const std::string& text = table.text(row, "date");
        if (!date_of(text) && date_of(text, DateOrder::month_first)) {
            return DateOrder::month_first;
        }
    }
    return DateOrder::day_first;
}

std::vector<Date> from_dates(const config::Table& table) {
    const DateOrder order = order_of(table);
    std::vector<Date> dates;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const auto date = date_of(table.text(row, "date"), order);
        if (!date) {
            refuse_date(table, row, "date");
        }
        dates.push_back(*date);
    }
    return dates;
}

}  // namespace

int days_of_month(int year, int month) {
    constexpr int february = 2;
    constexpr int longest = 31;
    constexpr int shorter = 30;
    if (month == february) {
        return is_leap(year) ? 29 : 28;
    }
    return month == 4 || month == 6 || month == 9 || month == 11 ? shorter : longest;
}

std::optional<Date> date_of(std::string_view text, DateOrder order) {
    const std::vector<std::string_view> groups = groups_of(config::trimmed(text));
    if (groups.size() == 1) {
        return date_of_digits(groups[0]);
    }
    if (groups.size() < 2) {
        return std::nullopt;
    }
    if (groups[0].size() == digits_of_year) {
        const bool has_day = groups.size() > 2;
        return checked(number_of(groups[0]), number_of(groups[1]), has_day ? number_of(groups[2]) : 0,
                       has_day);
    }
    if (groups.size() < 3 || groups[2].size() != digits_of_year) {
        return std::nullopt;
    }
    const bool day_first = order == DateOrder::day_first;
    return checked(number_of(groups[2]), number_of(groups[day_first ? 1 : 0]),
                   number_of(groups[day_first ? 0 : 1]), true);
}

std::optional<Date> date_of_day(int year, int day_of_year) {
    constexpr int months = 12;
    for (int month = 1; month <= months && day_of_year >= 1; ++month) {
        if (day_of_year <= days_of_month(year, month)) {
            return Date{year, month, day_of_year};
        }
        day_of_year -= days_of_month(year, month);
    }
    return std::nullopt;
}

bool is_of_days(const std::vector<Date>& dates) {
    return std::any_of(dates.begin(), dates.end(), [&](const Date& date) {
        return &date != &dates.front() && date.year == dates.front().year &&
               date.month == dates.front().month;
    });
}

std::optional<std::vector<Date>> dates_of(const config::Table& table) {
    constexpr int last_year = 9999;
    if (!table.find("year")) {
        return table.find("date") ? std::optional{from_dates(table)} : std::nullopt;
    }
    const bool has_day = table.find("month") && table.find("day");
    if (!has_day && !table.find("day_of_year")) {
        return !table.find("month") && table.find("date") ? std::optional{from_dates(table)} : std::nullopt;
    }
    std::vector<Date> dates;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const int year = whole_at(table, row, "year", 0, last_year);
        const auto date = has_day ? checked(year, whole_at(table, row, "month", 1, 12),
                                            whole_at(table, row, "day", 1, 31), true)
                                  : date_of_day(year, whole_at(table, row, "day_of_year", 1, 366));
        if (!date) {
            refuse_date(table, row, has_day ? "day" : "day_of_year");
        }
        dates.push_back(*date);
    }
    return dates;
}

}  // namespace coupling::climate
