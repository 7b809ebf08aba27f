#include "coupling/inputs/climate/dates.hpp"

#include <algorithm>
#include <cctype>
#include <chrono>
#include <set>
#include <string>
#include <utility>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "config/text/reading.hpp"

namespace coupling::climate {

struct DeliveredRow {
    std::optional<int> day;
    std::optional<int> day_of_year;
};

namespace {

constexpr std::size_t digits_of_year = 4;
constexpr int latest_calendar_year = 9999;
constexpr int december = 12;

std::optional<Date> checked(int year, int month, int day, bool has_day) {
    const std::chrono::year_month_day date{std::chrono::year{year},
                                           std::chrono::month{static_cast<unsigned>(month)},
                                           std::chrono::day{static_cast<unsigned>(has_day ? day : 1)}};
    return date.ok() ? std::optional{Date{year, month, has_day ? day : 0}} : std::nullopt;
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
                 "a day or month that exists, such as 1981-11-02, 19811102, 2.11.1981 or 1981-11");
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

const config::Schema<DeliveredRow>& delivered_columns() {
    // clang-format off
    static const config::Schema<DeliveredRow> columns{
        {.role = "climate", .setting = "climate.file", .row = "day or month of a service"},
        {{"date", std::string{"instead of year and month: 19811102, 1981-11-02, 2.11.1981, perhaps with a time"}, {.optional = true}},
         {"day", &DeliveredRow::day, "of the month", {.range = {1.0, 31.0}}},
         {"day_of_year", &DeliveredRow::day_of_year, "instead of month and day; 1 is 1 January", {.unit = "d", .range = {1.0, 366.0}}},
         {"sunshine_h", std::string{"hours of a month or day: the radiation is made of it where there is none"}, {.unit = "h", .optional = true}}}};
    // clang-format on
    return columns;
}

int days_of_month(int year, int month) {
    const std::chrono::year_month_day_last last{
        std::chrono::year{year},
        std::chrono::month_day_last{std::chrono::month{static_cast<unsigned>(month)}}};
    return static_cast<int>(static_cast<unsigned>(last.day()));
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
    using std::chrono::year_month_day;
    const std::chrono::sys_days start =
        year_month_day{std::chrono::year{year}, std::chrono::January, std::chrono::day{1}};
    const year_month_day date{start + std::chrono::days{day_of_year - 1}};
    if (static_cast<int>(date.year()) != year) {
        return std::nullopt;
    }
    return Date{year, static_cast<int>(static_cast<unsigned>(date.month())),
                static_cast<int>(static_cast<unsigned>(date.day()))};
}

bool is_of_days(const std::vector<Date>& dates) {
    std::set<std::pair<int, int>> months;
    return std::any_of(dates.begin(), dates.end(),
                       [&](const Date& date) { return !months.emplace(date.year, date.month).second; });
}

std::optional<std::vector<Date>> dates_of(const config::Table& table) {
    if (!table.find("year")) {
        return table.find("date") ? std::optional{from_dates(table)} : std::nullopt;
    }
    const bool has_day = table.find("month") && table.find("day");
    if (!has_day && !table.find("day_of_year")) {
        return !table.find("month") && table.find("date") ? std::optional{from_dates(table)} : std::nullopt;
    }
    config::RowProblems wrong{table};
    const auto rows = delivered_columns().rows(table, wrong);
    wrong.throw_first();
    std::vector<Date> dates;
    for (const auto& row : rows) {
        const auto year = config::parse_whole(table.text(row.row, "year"));
        const auto month = has_day ? config::parse_whole(table.text(row.row, "month")) : std::optional{1LL};
        const std::optional<int>& day = has_day ? row.day : row.day_of_year;
        std::optional<Date> date;
        if (year && *year >= 0 && *year <= latest_calendar_year && month && *month >= 1 &&
            *month <= december && day) {
            date = has_day ? checked(static_cast<int>(*year), static_cast<int>(*month), *day, true)
                           : date_of_day(static_cast<int>(*year), *day);
        }
        if (!date) {
            refuse_date(table, row.row, has_day ? "day" : "day_of_year");
        }
        dates.push_back(*date);
    }
    return dates;
}

}  // namespace coupling::climate
