#include "config/table/schema.hpp"

#include <algorithm>
#include <array>
#include <map>

#include "config/options/values.hpp"
#include "config/table/column_form.hpp"
#include "config/table/shape_field.hpp"
#include "config/text/joined.hpp"
#include "config/text/words_of_list.hpp"

namespace config {
namespace {

std::string words_joined(const std::vector<std::string>& words, std::string_view last) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i) {
        text += joined(i == 0 ? "" : i + 1 == words.size() ? last : ", ", words[i]);
    }
    return text;
}

/// What to do about a field that is wrong by itself: the advice of a column whose values come once is about a
/// second one.
std::string_view advice_on_field(const FieldRules& rules) {
    return rules.unique ? std::string_view{} : rules.advice;
}

/// The name that a column of another name may stand for: the nearest, else one that it begins with, as
/// "r_t [%]" does with "r_t". "" where there is none.
std::string meant_by(const std::string& other, const std::vector<std::string>& names) {
    std::string meant = nearest_word(other, names);
    for (std::size_t i = 0; i < names.size() && meant.empty(); ++i) {
        meant = other.starts_with(names[i]) ? names[i] : "";
    }
    return meant;
}

}  // namespace

std::string ColumnRules::values_in_words() const {
    switch (kind) {
        case FieldKind::word:
            return words_joined(rules.words, " or ");
        case FieldKind::number:
            return describe("a number", rules.range);
        case FieldKind::whole:
            return describe("a whole number", rules.range);
        case FieldKind::flag:
            return "yes or no";
        case FieldKind::shape:
            return kinds_in_words(rules.shapes);
        case FieldKind::words:
            return "one or more, separated by blanks";
        case FieldKind::numbers:
            return joined(describe("numbers", rules.range), ", separated by blanks");
        case FieldKind::text:
            break;
    }
    return "text";
}

std::string ColumnRules::unit() const {
    const bool is_number =
        kind == FieldKind::number || kind == FieldKind::whole || kind == FieldKind::numbers;
    return !rules.unit.empty() ? std::string{rules.unit} : is_number ? form_of(name).unit : "";
}

Place RowProblems::place(std::size_t row, std::string_view column) const {
    return table_.place(row, table_.has(column) ? column : table_.columns().front());
}

void RowProblems::refuse(std::size_t row, std::string_view column, std::string found, std::string expected,
                         std::string advice) {
    add(ExitCode::data, place(row, column), std::move(found), std::move(expected), std::move(advice));
}

void RowProblems::refuse(std::string found, std::string expected, std::string advice) {
    add(ExitCode::data, {table_.file()}, std::move(found), std::move(expected), std::move(advice));
}

void RowProblems::throw_first() const {
    constexpr std::size_t most = 20;
    std::vector<Problem> sorted = list();
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const Problem& a, const Problem& b) { return a.place.line < b.place.line; });
    Problems shown;
    for (std::size_t i = 0; i < std::min(most, sorted.size()); ++i) {
        shown.add(std::move(sorted[i]));
    }
    if (sorted.size() > most) {
        shown.add(ExitCode::data, {table_.file()},
                  joined(std::to_string(sorted.size() - most), " more such problems"));
    }
    shown.throw_if_any();
}

void TypedField::refuse(std::string found, std::string expected) const {
    problems_.add(ExitCode::data, table_.place(row_, column_.name), std::move(found), std::move(expected),
                  std::string{advice_on_field(column_.rules)});
}

/// What the table says of a number, with the advice of the column where it has none.
void TypedField::take(const Problems& found) const {
    for (Problem problem : found.list()) {
        if (problem.advice.empty()) {
            problem.advice = advice_on_field(column_.rules);
        }
        problems_.add(std::move(problem));
    }
}

void TypedField::refuse_empty(const std::string& thing) const {
    double number = 0.0;
    Shape shape;
    if (column_.kind == FieldKind::number) {
        read(number);
    } else if (column_.kind == FieldKind::whole) {
        static_cast<void>(whole());
    } else if (column_.kind == FieldKind::shape) {
        read(shape);
    } else {
        const bool is_text = column_.kind == FieldKind::text;
        refuse(joined("no ", column_.name),
               is_text ? joined("one ", column_.name, " for each ", thing) : column_.values_in_words());
    }
}

bool TypedField::read(double& to) const {
    std::optional<double> value = parse_number(text_);
    if (!value || !column_.rules.range.contains(*value)) {
        Problems found;
        value = table_.number(row_, column_.name, column_.rules.range, found);
        take(found);
    }
    to = value.value_or(to);
    return value.has_value();
}

bool TypedField::read(Angle& to) const {
    double degrees = to.in_degrees();
    const bool is_good = read(degrees);
    to = Angle::from_degrees(degrees);
    return is_good;
}

std::optional<long long> TypedField::whole() const {
    std::optional<long long> value = parse_whole(text_);
    if (!value || !column_.rules.range.contains(static_cast<double>(*value))) {
        Problems found;
        value = table_.whole(row_, column_.name, column_.rules.range, found);
        take(found);
    }
    return value;
}

bool TypedField::read(bool& to) const {
    const std::optional<bool> value = flag_in(text_);
    if (!value) {
        refuse(joined(column_.name, " ", in_quotes(text_)), "yes or no");
    }
    to = value.value_or(to);
    return value.has_value();
}

std::optional<std::size_t> TypedField::word() const {
    const std::vector<std::string>& words = column_.rules.words;
    const auto found = std::find(words.begin(), words.end(), text_);
    if (found == words.end()) {
        const std::string nearest = nearest_word(text_, words);
        refuse(joined(column_.name, " ", in_quotes(text_)),
               joined(column_.values_in_words(), nearest.empty() ? "" : joined(" (", nearest, "?)")));
        return std::nullopt;
    }
    return static_cast<std::size_t>(found - words.begin());
}

bool TypedField::read(std::string& to) const {
    if (column_.kind == FieldKind::word && !word()) {
        return false;
    }
    to = text_;
    return true;
}

bool TypedField::read(Shape& to) const {
    std::optional<Shape> shape = shape_of(table_, row_, column_.rules.shapes, problems_);
    if (shape && column_.rules.single && shape->parts.size() != 1) {
        constexpr std::array names{"point", "line", "polygon"};
        const std::string kind = names[static_cast<std::size_t>(shape->kind)];
        refuse(joined(std::to_string(shape->parts.size()), " ", kind, "s"),
               joined("one ", kind, " in each row"));
        shape.reset();
    }
    if (shape) {
        to = std::move(*shape);
    }
    return shape.has_value();
}

/// The words of a field, at least one; a problem where it has nothing but blanks.
std::vector<std::string> TypedField::several() const {
    std::vector<std::string> words = words_between_blanks(text_);
    if (words.empty()) {
        refuse_empty("");
    }
    return words;
}

bool TypedField::read(std::vector<std::string>& to) const {
    to = several();
    return !to.empty();
}

bool TypedField::read(std::vector<double>& to) const {
    const std::vector<std::string> words = several();
    for (const std::string& word : words) {
        const std::optional<double> value = parse_number(word);
        if (value && column_.rules.range.contains(*value)) {
            to.push_back(*value);
        } else {
            refuse(joined(column_.name, " ", in_quotes(word)), describe("a number", column_.rules.range));
        }
    }
    return !words.empty() && to.size() == words.size();
}

std::vector<std::string> TableSchema::names() const {
    std::vector<std::string> names;
    for (const ColumnRules& column : columns_) {
        names.push_back(column.name);
    }
    return names;
}

void TableSchema::require(const Table& table) const {
    Problems problems;
    std::vector<std::string> needed;
    for (const ColumnRules& column : columns_) {
        if (column.is_needed()) {
            needed.push_back(column.name);
        }
    }
    table.require(needed, problems);
    problems.throw_if_any();
}

std::vector<bool> TableSchema::columns_in(const Table& table, Problems& problems) const {
    require(table);
    if (rules_.others_refused) {
        for (const std::string& other : table.columns_beside(names())) {
            const std::string meant = meant_by(other, names());
            problems.add(ExitCode::data, {table.file()},
                         joined("column ", in_quotes(other), ", which has no meaning"),
                         meant.empty() ? joined("one of ", words_joined(names(), ", ")) : meant,
                         "correct its name, or remove it");
        }
    }
    if (table.rows() == 0 && !rules_.no_rows.empty()) {
        problems.add(ExitCode::data, {table.file()},
                     joined("no ", rules_.row, rules_.row.ends_with('s') ? "" : "s"), rules_.no_rows);
    }
    std::vector<bool> is_there;
    for (const ColumnRules& column : columns_) {
        is_there.push_back(table.has(column.name));
        const bool has_unit = rules_.checks_units && is_there.back() && !table.units().empty();
        const std::string unit = has_unit ? table.units()[*table.find(column.name)] : "";
        if (!unit.empty() && !column.unit().empty() && unit != column.unit()) {
            problems.add(ExitCode::data, {table.file()},
                         joined("unit ", in_quotes(unit), " of column ", column.name),
                         in_quotes(column.unit()));
        }
    }
    return is_there;
}

void TableSchema::refuse_repetitions(const Table& table, const std::vector<std::size_t>& rows,
                                     Problems& problems) const {
    const auto holds_numbers = [&](const std::string& name) {
        return std::any_of(columns_.begin(), columns_.end(), [&](const ColumnRules& column) {
            return column.name == name &&
                   (column.kind == FieldKind::number || column.kind == FieldKind::whole);
        });
    };
    const auto refuse_in = [&](const std::vector<std::string>& columns, std::string_view advice) {
        std::map<std::string, std::size_t> first_rows;
        for (const std::size_t row : rows) {
            std::string key;
            std::string found;
            for (const std::string& column : columns) {
                const std::string text = table.has(column) ? table.text(row, column) : "";
                // The numbers 1 and 1.0 are the same, the names 1 and 01 are not.
                const std::optional<double> number =
                    holds_numbers(column) ? parse_number(text) : std::nullopt;
                key += number ? to_text(*number) : text;
                key += '\n';
                found += text.empty() ? ""
                                      : joined(found.empty() ? "" : ", ", column, " ",
                                               number ? text : in_quotes(text));
            }
            const auto [first, is_new] = first_rows.emplace(std::move(key), row);
            if (!is_new && !found.empty()) {
                problems.add(ExitCode::data, table.place(row, columns.back()),
                             joined(found, " a second time, as in line ",
                                    std::to_string(table.place(first->second, columns.back()).line)),
                             joined("one ", words_joined(columns, " and "), " for each ", rules_.row),
                             advice.empty() ? "correct or remove one of the two rows" : std::string{advice});
            }
        }
    };
    for (const ColumnRules& column : columns_) {
        if (column.rules.unique) {
            refuse_in({column.name}, column.rules.advice);
        }
    }
    for (const std::vector<std::string>& columns : rules_.unique_together) {
        refuse_in(columns, "");
    }
}

}  // namespace config
