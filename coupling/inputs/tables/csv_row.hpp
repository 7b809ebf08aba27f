#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <stdexcept>
#include <string>
#include <string_view>

#include "config/table/table.hpp"

namespace coupling {

/// Writes the fields of CSV rows into a small buffer: no formatting by streams, nothing allocated for
/// numbers.
///
/// Numbers come with a fixed count of decimals, so that columns line up and hide no false digits. What is not
/// finite becomes an empty field.
class CsvRow {
public:
    /// `columns`: as many fields has each row; 0: any number.
    explicit CsvRow(std::ostream& out, std::size_t columns = 0) : out_{out}, columns_{columns} {}
    CsvRow(const CsvRow&) = delete;
    CsvRow& operator=(const CsvRow&) = delete;

    CsvRow& text(std::string_view value) {
        separate();
        needs_quotes(value) ? put(config::csv_field(value)) : put(value);
        return *this;
    }
    CsvRow& whole(std::unsigned_integral auto value) {
        separate();
        make_room();
        next_ = std::to_chars(next_, buffer_.data() + buffer_.size(), value).ptr;
        return *this;
    }
    template <int decimals>
    CsvRow& number(double value) {
        return number(value, decimals);
    }
    /// Requires 0 to 6 decimals.
    CsvRow& number(double value, int decimals) {
        separate();
        if (!std::isfinite(value)) {
            return *this;
        }
        make_room();
        put_fixed(value, decimals);
        return *this;
    }
    CsvRow& empty() {
        separate();
        return *this;
    }
    /// Throws std::logic_error for a row that has not as many fields as its table has columns.
    void end() {
        if (columns_ != 0 && fields_ != columns_) {
            throw std::logic_error{"a row of " + std::to_string(fields_) + " fields in a table of " +
                                   std::to_string(columns_) + " columns"};
        }
        make_room();
        *next_++ = '\n';
        flush();
        fields_ = 0;
    }

private:
    static constexpr std::ptrdiff_t longest_number = 400;  // 1e308 with decimals

    /// As csv_field: what its readers would cut or take for something else.
    static bool needs_quotes(std::string_view value) {
        const auto is_blank = [](char c) { return c == ' ' || c == '\t'; };
        const auto separates = [](char c) {
            return c == ',' || c == ';' || c == '"' || c == '\n' || c == '\r';
        };
        return !value.empty() && (value.front() == '#' || is_blank(value.front()) || is_blank(value.back()) ||
                                  std::any_of(value.begin(), value.end(), separates));
    }
    void separate() {
        if (fields_++ > 0) {
            make_room();
            *next_++ = ',';
        }
    }
    void make_room() {
        if (buffer_.data() + buffer_.size() - next_ < longest_number) {
            flush();
        }
    }
    void flush() {
        out_.write(buffer_.data(), next_ - buffer_.data());
        next_ = buffer_.data();
    }
    void put(std::string_view value) {
        make_room();
        if (value.size() > static_cast<std::size_t>(longest_number)) {
            flush();
            out_.write(value.data(), static_cast<std::streamsize>(value.size()));
            return;
        }
        next_ = std::copy(value.begin(), value.end(), next_);
    }
    /// As std::llround below 2^53, which is a call.
    static long long nearest(double value) {
        const auto whole = static_cast<long long>(value);
        const double rest = value - static_cast<double>(whole);
        return whole + (rest >= 0.5 ? 1 : 0) - (rest <= -0.5 ? 1 : 0);
    }
    /// Through a whole number where that is exact: several times faster than the general way.
    void put_fixed(double value, int decimals) {
        constexpr std::array<double, 7> powers{1.0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6};
        char* const end = buffer_.data() + buffer_.size();
        const double power = powers[static_cast<std::size_t>(decimals)];
        if (std::abs(value) * power >= 9e15) {
            next_ = std::to_chars(next_, end, value, std::chars_format::fixed, decimals).ptr;
            return;
        }
        const long long scaled = nearest(value * power);
        if (scaled < 0) {
            *next_++ = '-';
        }
        const auto size = static_cast<std::uint64_t>(scaled < 0 ? -scaled : scaled);
        const auto unit = static_cast<std::uint64_t>(power);
        next_ = std::to_chars(next_, end, size / unit).ptr;
        if (decimals > 0) {
            *next_++ = '.';
            std::uint64_t rest = size % unit;
            for (char* digit = next_ + decimals; digit != next_;) {
                *--digit = static_cast<char>('0' + rest % 10);
                rest /= 10;
            }
            next_ += decimals;
        }
    }

    std::ostream& out_;
    std::array<char, 1024> buffer_;
    char* next_ = buffer_.data();
    std::size_t columns_;
    std::size_t fields_ = 0;
};

}  // namespace coupling
