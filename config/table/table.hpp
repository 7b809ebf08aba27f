#pragma once

#include <cstddef>
#include <istream>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "config/errors/input_error.hpp"

namespace config {

/// What a number in a table may be.
struct NumberRange {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    bool low_excluded = false;  ///< (low, high] instead of [low, high]
};

/// A CSV table: a header line, perhaps a unit row (first field `unit`), then rows of fields.
///
/// Reads UTF-8 with or without byte-order mark, LF or CRLF, comma or (German and French Excel) semicolon,
/// quoted fields, `#` comment lines. Every row knows the line it stood on.
class Table {
public:
    /// Throws InputError (data) with line and column on uneven rows, open quotes, doubled columns, no header.
    static Table read(std::istream& in, std::string file);

    [[nodiscard]] std::size_t rows() const { return cells_.size(); }
    [[nodiscard]] const std::vector<std::string>& columns() const { return columns_; }
    [[nodiscard]] const std::vector<std::string>& units() const { return units_; }  ///< empty without unit row
    [[nodiscard]] const std::string& file() const { return file_; }
    [[nodiscard]] bool has(std::string_view column) const;
    [[nodiscard]] Place place(std::size_t row, std::string_view column) const;

    /// Adds a problem for each of `wanted` that is missing, with the nearest present name; true if none is.
    bool require(const std::vector<std::string>& wanted, Problems& problems) const;

    /// Requires an existing column and row.
    [[nodiscard]] const std::string& text(std::size_t row, std::string_view column) const;

    /// A finite number in the range; otherwise adds a problem (file, line, column, found, expected) and
    /// returns nothing. An empty field counts as a problem too; see `text` for optional fields.
    std::optional<double> number(std::size_t row, std::string_view column, NumberRange range,
                                 Problems& problems) const;
    /// A whole number in the range, same rules.
    std::optional<long long> whole(std::size_t row, std::string_view column, NumberRange range,
                                   Problems& problems) const;

private:
    std::string file_;
    std::vector<std::string> columns_;
    std::vector<std::string> units_;
    std::vector<std::vector<std::string>> cells_;
    std::vector<std::size_t> lines_;
};

/// The whole text as a finite number: no `nan`, no `inf`, no `1,5`, no `3abc`; a leading plus is fine.
std::optional<double> parse_number(std::string_view text);
/// The whole text as a whole number.
std::optional<long long> parse_whole(std::string_view text);

/// The shortest text that reads back as the same number.
std::string to_text(double value);

/// A field as CSV wants it: quoted if it holds a comma, a quote or a line break.
std::string csv_field(std::string_view text);

}  // namespace config
