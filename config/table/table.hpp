#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <istream>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "config/errors/input_error.hpp"
#include "config/table/column_form.hpp"
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

/// What became of the columns of a table of a user: which of them anybody asked for, and what was asked for
/// in vain. Kept beside the table, so that what nobody read can be named when all has been read.
struct ColumnUse {
    struct Column {
        std::string found;     ///< as the file has it
        std::string name;      ///< as the program calls it
        bool is_made = false;  ///< not from the file
        bool is_read = false;
    };
    std::string file;
    std::vector<Column> columns;
    std::vector<std::string> missing;  ///< asked for, and not there
};

/// Whether the first column of a table may lack a name and is left out then, as R writes row names.
enum class FirstColumn : std::uint8_t { named, may_lack_name };

/// A CSV table: a header line, perhaps a unit row (first field `unit`), then rows of fields.
///
/// Reads UTF-8 with or without byte-order mark, LF or CRLF, comma, semicolon (German and French Excel) or
/// tab, a first line `sep=;` (Excel), quoted fields with doubled quotes and line breaks inside, `#` comment
/// lines, explanations above the header (config/table/preamble.hpp). Blanks around a field that is not quoted
/// do not count; empty lines and rows of empty fields, as spreadsheets leave them, are skipped. Where commas
/// do not separate fields and no number of the table has a decimal point, numbers such as `0,35` are written
/// with a decimal comma and become `0.35`. Every field knows the line and column it stood on.
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
    /// The same of a text in memory, without a copy of it. With `may_lack_name` doubled columns get a number,
    /// as "grade (2)": whether they are read, tables/prepare says.
    static Table read(std::string_view text, std::string file, FirstColumn first = FirstColumn::named);
    /// A table of features. The place of a field is the number of its feature and that of its column from 1.
    /// Requires at least as many columns as a row has cells.
    static Table of(Features features);

    /// From now on names of columns count without their form (config/table/column_form.hpp), and the table
    /// records what is asked for. For tables of users; not for several threads at once.
    void watch();
    /// What was asked for since `watch` or the last `forget_use`; nothing without `watch`.
    [[nodiscard]] std::shared_ptr<const ColumnUse> use() const { return use_; }
    void forget_use();
    /// Counts a column as dealt with, by its name in the file: a message of its own speaks of it.
    void count_as_named(std::string_view found) const;

    /// Calls a column by another name. Requires that there is one of the old name and none of the new one.
    void rename(std::string_view column, std::string name);
    /// Adds a column behind all others, with the places of `like` in messages. Requires a value for each row
    /// and a column `like`.
    void add_column(std::string name, std::vector<std::string> values, std::string_view like);
    /// Replaces what stands in a field. Requires an existing column and row.
    void set_text(std::size_t row, std::string_view column, std::string text);
    /// Takes the rows out for which the predicate holds.
    void remove_rows(const std::function<bool(std::size_t row)>& is_out);
    /// Empties fields that say in words that there is no value, such as NA, #N/A, #NV, n/a and a lone dash.
    /// Returns each spelling with its count. Columns for which `keep` holds stay as they are.
    std::map<std::string, std::size_t> take_missing_values(
        const std::function<bool(const std::string& column)>& keep);

    [[nodiscard]] std::size_t rows() const { return cells_.size(); }
    [[nodiscard]] const std::vector<std::string>& columns() const { return columns_; }
    [[nodiscard]] const std::vector<std::string>& units() const {
        return units_;
    }  ///< empty without unit row
    [[nodiscard]] const std::string& file() const { return file_; }
    [[nodiscard]] bool has(std::string_view column) const;
    /// The columns that are none of `known`, as the file has them.
    [[nodiscard]] std::vector<std::string> columns_beside(const std::vector<std::string>& known) const;
    /// The name of each column as the file has it.
    [[nodiscard]] const std::vector<std::string>& found_columns() const { return found_; }
    /// The lines that stood above the header, without those that are empty.
    [[nodiscard]] const std::vector<std::string>& lines_above() const { return lines_above_; }
    /// Whether the first column lacked a name and was left out.
    [[nodiscard]] bool lacks_first_name() const { return lacks_first_name_; }
    /// Place of the column among all; nothing where there is none. Nobody asked for it by that.
    [[nodiscard]] std::optional<std::size_t> find(std::string_view column) const;
    [[nodiscard]] Place place(std::size_t row, std::string_view column) const;

    /// Adds a problem for each of `wanted` that is missing, with the nearest present name; true if none is.
    bool require(const std::vector<std::string>& wanted, Problems& problems) const;

    /// Requires an existing column and row.
    [[nodiscard]] const std::string& text(std::size_t row, std::string_view column) const;
    /// The same for a check that makes no use of what it sees: the column counts as unread still.
    [[nodiscard]] const std::string& seen_text(std::size_t row, std::string_view column) const;

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
    void record(std::size_t column) const;
    void add_problem(std::size_t row, std::string_view column, std::string_view kind,
                     const NumberRange& range, Problems& problems) const;

    std::string file_;
    std::vector<std::string> columns_;
    std::vector<std::string> found_;  ///< the columns as the file has them
    std::vector<std::string> lines_above_;
    bool lacks_first_name_ = false;
    std::map<std::pair<std::size_t, std::size_t>, std::string>
        emptied_;  ///< by row and column: what stood there
    std::shared_ptr<ColumnUse> use_;
    /// By wanted name: its column, found by form. Only while watched.
    mutable std::map<std::string, std::optional<std::size_t>, std::less<>> by_form_;
    std::vector<std::string> units_;
    std::vector<std::vector<std::string>> cells_;
    std::vector<std::vector<TextPlace>> places_;
};

/// What is wrong with a column that is in another unit than the wanted one, and what to do.
Problem other_unit_problem(const std::string& file, const std::string& found, const std::string& wanted);

/// A field as CSV wants it: quoted if it holds a comma, a quote or a line break.
std::string csv_field(std::string_view text);

}  // namespace config
