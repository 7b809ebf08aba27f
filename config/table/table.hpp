#pragma once

#include <cstddef>
#include <cstdint>
#include <istream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "config/errors/input_error.hpp"
#include "config/text/numbers.hpp"

namespace config {

/// Rows of a layer that is no text: shapes of a GIS as well-known text in the column `wkt`, and attributes.
struct Features {
    std::string file;
    std::vector<std::string> columns;
    std::vector<std::vector<std::string>> cells;  ///< a row may end early: the rest of it is empty
    std::vector<std::uint32_t> numbers;           ///< of each feature, for messages

    /// Adds a column of attributes. One that is called as the shapes are, or as one before, gets a number.
    void add_column(std::string name);
};

/// A CSV table: a header line, perhaps a unit row (first field `unit`), then rows of fields.
///
/// Reads UTF-8 with or without byte-order mark, LF or CRLF, comma, semicolon (German and French Excel) or
/// tab, a first line `sep=;` (Excel), quoted fields with doubled quotes and line breaks inside, `#` comment
/// lines. Blanks around a field that is not quoted do not count; empty lines and rows of empty fields, as
/// spreadsheets leave them, are skipped. Where commas do not separate fields and no number of the table has a
/// decimal point, numbers such as `0,35` are written with a decimal comma and become `0.35`.
/// Every field knows the line and column it stood on.
class Table {
public:
    /// A record with more fields, or a longer field, is none of a table of ours: reading ends there. The
    /// longest fields are outlines of areas, at about 30 bytes a corner [choice].
    static constexpr std::size_t most_columns = 1000;
    static constexpr std::size_t longest_field_bytes = 10'000'000;

    /// Throws one InputError (data) with line and column for uneven rows (the first 100 of them), open
    /// quotes, doubled or unnamed columns, no header, text that is not UTF-8, a record or a field that is too
    /// long.
    static Table read(std::istream& in, std::string file);
    /// The same of a text in memory, without a copy of it.
    static Table read(std::string_view text, std::string file);
    /// A table of features. The place of a field is the number of its feature and that of its column from 1.
    /// Requires at least as many columns as a row has cells.
    static Table of(Features features);

    /// Calls a column by another name. Requires that there is one of the old name and none of the new one.
    void rename(std::string_view column, std::string name);
    /// Adds a column behind all others, with the places of `like` in messages. Requires a value for each row
    /// and a column `like`.
    void add_column(std::string name, std::vector<std::string> values, std::string_view like);

    [[nodiscard]] std::size_t rows() const { return cells_.size(); }
    [[nodiscard]] const std::vector<std::string>& columns() const { return columns_; }
    [[nodiscard]] const std::vector<std::string>& units() const {
        return units_;
    }  ///< empty without unit row
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
    struct TextPlace {
        std::uint32_t line;
        std::uint32_t column;
    };
    [[nodiscard]] std::size_t index_of(std::string_view column) const;
    void add_problem(std::size_t row, std::string_view column, std::string_view kind,
                     const NumberRange& range, Problems& problems) const;

    std::string file_;
    std::vector<std::string> columns_;
    std::vector<std::string> units_;
    std::vector<std::vector<std::string>> cells_;
    std::vector<std::vector<TextPlace>> places_;
};

/// A field as CSV wants it: quoted if it holds a comma, a quote or a line break.
std::string csv_field(std::string_view text);

}  // namespace config
