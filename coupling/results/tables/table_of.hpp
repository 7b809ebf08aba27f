#pragma once

#include <cmath>
#include <concepts>
#include <filesystem>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "config/text/numbers.hpp"
#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/tables/table_layout.hpp"

namespace coupling {

/// Where values come from unless a column says something else.
inline constexpr const char* from_simulation = "simulated";

/// What may be missing: std::optional, or a pointer.
template <class Value>
concept MayBeMissing = !std::convertible_to<Value, std::string_view> && requires(const Value& value) {
    static_cast<bool>(value);
    *value;
};

/// What a column that shows such a value holds.
template <class Value>
constexpr Holds held() {
    if constexpr (MayBeMissing<Value>) {
        return held<std::remove_cvref_t<decltype(*std::declval<Value>())>>();
    } else if constexpr (std::floating_point<Value>) {
        return Holds::number;
    } else {
        return std::integral<Value> && !std::same_as<Value, bool> ? Holds::whole : Holds::text;
    }
}

/// Decimals of a number that is written as short as it can be read back.
inline constexpr int as_given = -1;

/// Writes a value as a field: yes or no, a whole number, words, or a number with so many decimals. A missing
/// value and a number that is not finite are an empty field.
template <class Value>
void put_field(CsvRow& row, const Value& value, int decimals) {
    if constexpr (MayBeMissing<Value>) {
        value ? put_field(row, *value, decimals) : static_cast<void>(row.empty());
    } else if constexpr (std::same_as<Value, bool>) {
        row.text(value ? "yes" : "no");
    } else if constexpr (std::floating_point<Value>) {
        if (decimals != as_given) {
            row.number(static_cast<double>(value), decimals);
        } else {
            std::isfinite(value) ? row.text(config::to_text(value)) : row.empty();
        }
    } else if constexpr (std::unsigned_integral<Value>) {
        row.whole(value);
    } else if constexpr (std::integral<Value>) {
        row.text(std::to_string(value));
    } else {
        row.text(value);
    }
}

/// Columns of a table whose rows are made from a `Row`, one after the other: a single column, several, or
/// those of a part of the row. A column is declared in one line with the function (or member) that gives its
/// value: bool (yes or no), a whole number, text, a number, or a std::optional or pointer to one of these.
template <class Row>
class ColumnsOf {
public:
    using Write = std::function<void(CsvRow&, const Row&)>;

    ColumnsOf() = default;
    /// Numbers, with so many decimals. The unit is that which the name ends with.
    template <class Value>
    ColumnsOf(std::string_view name, int decimals, std::string_view meaning, std::string_view source,
              Value value)
        : ColumnsOf{Column{std::string{name}, {}, std::string{meaning}, std::string{source}}, decimals,
                    std::move(value)} {}
    template <class Value>
    ColumnsOf(std::string_view name, int decimals, std::string_view meaning, Value value)
        : ColumnsOf{name, decimals, meaning, from_simulation, std::move(value)} {}
    /// Words and whole numbers.
    template <class Value>
    ColumnsOf(std::string_view name, std::string_view meaning, std::string_view source, Value value)
        : ColumnsOf{Column{std::string{name}, {}, std::string{meaning}, std::string{source}},
                    std::move(value)} {}
    template <class Value>
    ColumnsOf(std::string_view name, std::string_view meaning, Value value)
        : ColumnsOf{name, meaning, from_simulation, std::move(value)} {}
    /// With a unit that the name does not end with, such as "as the row says".
    template <class Value>
    ColumnsOf(std::string_view name, std::string_view unit, int decimals, std::string_view meaning,
              std::string_view source, Value value)
        : ColumnsOf{Column{std::string{name}, std::string{unit}, std::string{meaning}, std::string{source}},
                    decimals, std::move(value)} {}
    template <class Value>
    ColumnsOf(Column column, int decimals, Value value) {
        static_assert(held<Result<Value>>() == Holds::number, "only numbers have decimals");
        add(std::move(column), decimals, std::move(value));
    }
    template <class Value>
    ColumnsOf(Column column, Value value) {
        static_assert(held<Result<Value>>() != Holds::number, "say with how many decimals");
        add(std::move(column), 0, std::move(value));
    }
    /// Those of a row that this one is derived from.
    template <class Base>
    requires(std::derived_from<Row, Base> && !std::same_as<Row, Base>)
        ColumnsOf(const ColumnsOf<Base>& of_base)
        : ColumnsOf{of_base, [](const Row& row) -> const Base& { return row; }} {}
    ColumnsOf(std::initializer_list<ColumnsOf> several) {
        for (const ColumnsOf& each : several) {
            *this += each;
        }
    }
    /// The columns of a part of the row: `part` gives it, or an optional or pointer to it. All their fields
    /// are empty where it is missing.
    template <class Part, class Value>
    ColumnsOf(const ColumnsOf<Part>& of_part, Value part) : columns_{of_part.columns()} {
        for (const typename ColumnsOf<Part>::Write& write : of_part.writes()) {
            writes_.push_back([write, part](CsvRow& row, const Row& of) {
                decltype(auto) found = std::invoke(part, of);
                if constexpr (MayBeMissing<std::remove_cvref_t<decltype(found)>>) {
                    found ? write(row, *found) : static_cast<void>(row.empty());
                } else {
                    write(row, found);
                }
            });
        }
    }

    /// More columns after these: for those that only a run knows.
    ColumnsOf& operator+=(const ColumnsOf& more) {
        columns_.insert(columns_.end(), more.columns_.begin(), more.columns_.end());
        writes_.insert(writes_.end(), more.writes_.begin(), more.writes_.end());
        return *this;
    }

    [[nodiscard]] const std::vector<Column>& columns() const { return columns_; }
    [[nodiscard]] const std::vector<Write>& writes() const { return writes_; }

private:
    template <class Value>
    using Result = std::remove_cvref_t<std::invoke_result_t<Value, const Row&>>;

    template <class Value>
    void add(Column column, int decimals, Value value) {
        column.holds = held<Result<Value>>();
        if (column.unit.empty()) {
            column.unit = unit_in(column);
        }
        columns_.push_back(std::move(column));
        writes_.push_back([value = std::move(value), decimals](CsvRow& row, const Row& of) {
            put_field(row, std::invoke(value, of), decimals);
        });
    }

    std::vector<Column> columns_;
    std::vector<Write> writes_;
};

/// A table of the results whose rows are made from a `Row`, often a small struct that refers to the record
/// and to what the record's numbers mean.
template <class Row>
class TableOf : public TableLayout {
public:
    TableOf(std::string file_name, std::string what, std::string what_a_row_is,
            const ColumnsOf<Row>& declared)
        : TableLayout{std::move(file_name), std::move(what_a_row_is), declared.columns()},
          sentence{std::move(what)},
          writes_{declared.writes()} {}

    std::string sentence;  ///< what the file holds, for lists of files

    /// Adds rows below the header of a stream.
    class Rows {
    public:
        Rows(std::ostream& out, const TableOf& table) : row_{out}, table_{table} {}
        void add(const Row& of) {
            for (const typename ColumnsOf<Row>::Write& write : table_.writes_) {
                write(row_, of);
            }
            row_.end();
        }
        void add_all(const auto& records) {
            for (const auto& each : records) {
                add(each);
            }
        }

    private:
        CsvRow row_;
        const TableOf& table_;
    };

    /// `fill` adds the rows: [&](auto& rows) { rows.add({...}); }.
    template <class Fill>
    void write_to(std::ostream& out, const Fill& fill) const {
        write_header(out, *this);
        Rows rows{out, *this};
        fill(rows);
    }
    /// Writes tables/FILE of a folder. Throws config::InputError (file).
    template <class Fill>
    WrittenFile write(const std::filesystem::path& folder, const Fill& fill) const {
        return write_as(folder, file, sentence, fill);
    }
    /// The same of a table whose file has a number in its name.
    template <class Fill>
    WrittenFile write_as(const std::filesystem::path& folder, const std::string& name,
                         const std::string& holds, const Fill& fill) const {
        make_folder(folder / "tables");
        return write_table(folder, name, holds, [&](std::ostream& out) { write_to(out, fill); });
    }

private:
    std::vector<typename ColumnsOf<Row>::Write> writes_;
};

}  // namespace coupling
