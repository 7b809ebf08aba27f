#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "config/errors/input_error.hpp"
#include "config/geometry/shape.hpp"
#include "config/table/table.hpp"
#include "config/text/numbers.hpp"
#include "config/units/angle.hpp"

/// The columns of a table that is read, declared once: from the declaration come the typed rows, all that can
/// be wrong with single fields, misspelt and unknown columns, and the tables of columns in manuals.
///
///     struct SoilRow { long long code = 0; std::optional<double> ph; };
///     const Schema<SoilRow> soils{{.role = "soils", .setting = "soil.types", .row = "soil"},
///         {{"code", &SoilRow::code, "as in the map", {.range = {.low = 0.0}, .unique = true}},
///          {"ph", &SoilRow::ph, "of the upper soil", {.range = {2.5, 9.0}}}}};
///
/// A field of type `std::optional` may be empty and its column missing. What depends on several fields or on
/// settings is checked by the reader afterwards, with RowProblems.
namespace config {

/// For ranges: the lower bound itself is excluded.
inline constexpr bool above = true;

/// What a field may hold, besides what its type says.
struct FieldRules {
    std::string_view unit{};           ///< where the name of the column does not end in it
    NumberRange range{};               ///< of a number, or of an angle in degrees
    bool optional = false;             ///< may be empty, its column missing: the row keeps what it has
    bool may_be_empty = false;         ///< may be empty, its column not missing
    bool unique = false;               ///< each value in one row alone
    std::vector<std::string> words{};  ///< the legal words; of an enumeration in its order
    std::vector<Shape::Kind> shapes{};
    bool single = false;         ///< one point, line or polygon, not several at once
    std::string_view advice{};   ///< what to do about a field that is wrong
    std::string_view instead{};  ///< what else helps where the column is needed and missing: "set x.y"
};

/// `words` and `numbers` are several in a field, separated by blanks.
enum class FieldKind : std::uint8_t { text, word, number, whole, flag, shape, words, numbers };

/// A column and what it may hold.
struct ColumnRules {
    std::string name;
    std::string meaning;
    FieldKind kind = FieldKind::text;
    FieldRules rules;

    /// Whether a table must have the column; otherwise the field may be empty too.
    [[nodiscard]] bool is_needed() const { return !rules.optional; }
    [[nodiscard]] bool may_be_empty() const { return rules.optional || rules.may_be_empty; }
    /// In the words of messages and manuals: "a number in (0, 500]", "living, snag or stump", "yes or no".
    [[nodiscard]] std::string values_in_words() const;
    /// From the rules or the end of the name, "" where there is none.
    [[nodiscard]] std::string unit() const;
};

/// What is wrong with a table, by the rows and columns of its fields.
class RowProblems : public Problems {
public:
    /// Keeps a reference.
    explicit RowProblems(const Table& table) : table_{table} {}

    /// The place of a field; of the first one of the row where the table lacks the column.
    [[nodiscard]] Place place(std::size_t row, std::string_view column) const;
    void refuse(std::size_t row, std::string_view column, std::string found, std::string expected = "",
                std::string advice = "");
    /// The same of the whole file.
    void refuse(std::string found, std::string expected, std::string advice = "");
    /// Throws the first 20 by line, with a word on how many more there are; does nothing without any.
    void throw_first() const;

private:
    const Table& table_;
};

/// The field of a row on its way into a typed member. Each `read` returns whether the field is good, and adds
/// a problem if not.
class TypedField {
public:
    TypedField(const Table& table, std::size_t row, const ColumnRules& rules, Problems& problems)
        : table_{table}, row_{row}, text_{table.text(row, rules.name)}, column_{rules}, problems_{problems} {}

    bool read(double& to) const;
    bool read(Angle& to) const;
    bool read(bool& to) const;
    bool read(std::string& to) const;
    bool read(Shape& to) const;
    bool read(std::vector<std::string>& to) const;
    bool read(std::vector<double>& to) const;
    template <class Whole>
    requires(std::is_integral_v<Whole>) bool read(Whole& to) const {
        const std::optional<long long> value = whole();
        to = value ? static_cast<Whole>(*value) : to;
        return value.has_value();
    }
    template <class Enum>
    requires(std::is_enum_v<Enum>) bool read(Enum& to) const {
        const std::optional<std::size_t> place = word();
        to = place ? static_cast<Enum>(*place) : to;
        return place.has_value();
    }
    template <class T>
    bool read(std::optional<T>& to) const {
        T value{};
        const bool is_good = read(value);
        to = is_good ? std::optional{std::move(value)} : std::nullopt;
        return is_good;
    }

    [[nodiscard]] bool is_empty() const { return text_.empty(); }
    /// Adds the problem of a field that may not be empty, in a row that is a `thing`.
    void refuse_empty(const std::string& thing) const;

private:
    [[nodiscard]] std::optional<long long> whole() const;
    [[nodiscard]] std::optional<std::size_t> word() const;
    [[nodiscard]] std::vector<std::string> several() const;
    void refuse(std::string found, std::string expected) const;
    void take(const Problems& found) const;

    const Table& table_;
    std::size_t row_;
    const std::string& text_;
    const ColumnRules& column_;
    Problems& problems_;
};

template <class T>
constexpr FieldKind kind_of_field() {
    if constexpr (std::is_same_v<T, std::string>) {
        return FieldKind::text;
    } else if constexpr (std::is_same_v<T, bool>) {
        return FieldKind::flag;
    } else if constexpr (std::is_same_v<T, Shape>) {
        return FieldKind::shape;
    } else if constexpr (std::is_enum_v<T>) {
        return FieldKind::word;
    } else if constexpr (std::is_same_v<T, std::vector<std::string>>) {
        return FieldKind::words;
    } else if constexpr (std::is_same_v<T, std::vector<double>>) {
        return FieldKind::numbers;
    } else {
        return std::is_integral_v<T> ? FieldKind::whole : FieldKind::number;
    }
}

/// A column and the member of a row that it fills.
template <class Row>
struct ColumnOf : ColumnRules {
    /// @param of  pointer to a member, or a function from `Row&` to a reference
    template <class Of>
    ColumnOf(std::string column, Of of, std::string meant, FieldRules what = {})
        : ColumnRules{std::move(column), std::move(meant), {}, std::move(what)},
          read{[of](Row& row, const TypedField& field) { return field.read(std::invoke(of, row)); }} {
        using Member = std::remove_reference_t<std::invoke_result_t<Of, Row&>>;
        if constexpr (requires(Member member) { member.has_value(); }) {
            kind = kind_of_field<typename Member::value_type>();
            rules.optional = true;
        } else {
            kind = kind_of_field<Member>();
        }
        if (kind == FieldKind::text && !rules.words.empty()) {
            kind = FieldKind::word;
        }
    }
    /// A column that the reader looks at by itself, empty or not.
    ColumnOf(std::string column, std::string meant, FieldRules what = {.may_be_empty = true})
        : ColumnRules{std::move(column), std::move(meant), {}, std::move(what)},
          read{[](Row&, const TypedField&) { return true; }} {}

    std::function<bool(Row&, const TypedField&)> read;
};

/// What a table holds, and what is said about it as a whole.
struct TableRules {
    std::string role{};           ///< by which files are recorded and words for columns found: "trees"
    std::string setting;          ///< that names the file: "trees.file"
    std::string row;              ///< what a row is: "tree"
    std::string no_rows{};        ///< what is expected of a table without rows; "" where it may have none
    bool others_refused = false;  ///< columns without a meaning are errors
    bool checks_units = false;    ///< a row of units must give ours: a factor of 1000 is silent
    std::vector<std::vector<std::string>> unique_together{};  ///< columns that no two rows have the same in
};

/// The declaration of a table without the type of its rows.
class TableSchema {
public:
    virtual ~TableSchema() = default;

    [[nodiscard]] const TableRules& rules() const { return rules_; }
    [[nodiscard]] const std::vector<ColumnRules>& columns() const { return columns_; }
    [[nodiscard]] std::vector<std::string> names() const;
    /// Throws one InputError (data) where columns are missing, with the names that may be meant.
    void require(const Table& table) const;
    /// Reads all rows and adds what is wrong with them. Throws as `require` does.
    virtual void check(const Table& table, Problems& problems) const = 0;

protected:
    TableSchema(TableRules rules, std::vector<ColumnRules> columns)
        : rules_{std::move(rules)}, columns_{std::move(columns)} {}
    TableSchema(const TableSchema&) = default;
    TableSchema(TableSchema&&) = default;
    TableSchema& operator=(const TableSchema&) = default;
    TableSchema& operator=(TableSchema&&) = default;

    /// Whether a table has each of the columns; what is wrong with it as a whole joins `problems`.
    [[nodiscard]] std::vector<bool> columns_in(const Table& table, Problems& problems) const;

    /// Adds a problem for each of the rows that repeats what may come once.
    void refuse_repetitions(const Table& table, const std::vector<std::size_t>& rows,
                            Problems& problems) const;

private:
    TableRules rules_;
    std::vector<ColumnRules> columns_;
};

/// A row and its place in the table.
template <class Row>
struct Read : Row {
    std::size_t row = 0;
};

template <class Row>
class Schema : public TableSchema {
public:
    Schema(TableRules rules, std::vector<ColumnOf<Row>> columns)
        : TableSchema{std::move(rules), {columns.begin(), columns.end()}} {
        for (ColumnOf<Row>& field : columns) {
            readers_.push_back(std::move(field.read));
        }
    }

    /// The rows whose fields are all good, in order; what is wrong with the others joins `problems`. Throws
    /// as `require` does.
    [[nodiscard]] std::vector<Read<Row>> rows(const Table& table, Problems& problems) const {
        const std::vector<bool> is_there = columns_in(table, problems);
        std::vector<Read<Row>> good;
        std::vector<std::size_t> good_rows;
        good.reserve(table.rows());
        for (std::size_t row = 0; row < table.rows(); ++row) {
            Read<Row> read{};
            read.row = row;
            bool is_good = true;
            for (std::size_t i = 0; i < readers_.size(); ++i) {
                is_good = (!is_there[i] || read_field(table, row, i, read, problems)) && is_good;
            }
            if (is_good) {
                good.push_back(std::move(read));
                good_rows.push_back(row);
            }
        }
        refuse_repetitions(table, good_rows, problems);
        return good;
    }
    /// The rows of a table whose reader has no checks of its own: throws what is wrong with them.
    [[nodiscard]] std::vector<Read<Row>> all(const Table& table) const {
        RowProblems wrong{table};
        std::vector<Read<Row>> good = rows(table, wrong);
        wrong.throw_first();
        return good;
    }
    void check(const Table& table, Problems& problems) const override {
        static_cast<void>(rows(table, problems));
    }

private:
    bool read_field(const Table& table, std::size_t row, std::size_t field, Row& into,
                    Problems& problems) const {
        const TypedField cell{table, row, columns()[field], problems};
        if (!cell.is_empty()) {
            return readers_[field](into, cell);
        }
        if (!columns()[field].may_be_empty()) {
            cell.refuse_empty(rules().row);
        }
        return columns()[field].may_be_empty();
    }

    std::vector<std::function<bool(Row&, const TypedField&)>> readers_;
};

}  // namespace config
