#include "config/table/table.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

#include "config/table/preamble.hpp"
#include "config/table/records.hpp"
#include "config/text/reading.hpp"

namespace config {

namespace {

/// The columns by name, for a message; long names cut off, and very many of them.
std::string some_of(const std::vector<std::string>& columns) {
    constexpr std::size_t most = 40;
    std::string text;
    for (std::size_t i = 0; i < std::min(most, columns.size()); ++i) {
        const std::string quoted = in_quotes(columns[i]);  // one line, and no half letter at its end
        text.append(i == 0 ? "" : ", ").append(quoted, 1, quoted.size() - 2);
    }
    return columns.size() > most ? text.append(", ...") : text;
}

/// A thing that is called `unit` has numbers or a shape behind its name, which no row of units has.
bool is_unit_row(const Record& record) {
    const std::string first = in_lower_case(record.front().text);
    return (first == "unit" || first == "units") &&
           std::none_of(record.begin() + 1, record.end(), [](const Field& field) {
               const bool is_number = parse_number(field.text).has_value() && field.text != "1";
               return is_number || field.text.find('(') != std::string::npos;
           });
}

std::vector<std::string> texts_of(Record record) {
    std::vector<std::string> texts;
    texts.reserve(record.size());
    for (Field& field : record) {
        texts.push_back(std::move(field.text));
    }
    return texts;
}

void check_header(const Record& header, FirstColumn first, const Place& end, Problems& problems) {
    if (header.empty()) {
        problems.add(ExitCode::data, end, "no header line", "a line of column names");
    }
    for (auto field = header.begin(); field != header.end(); ++field) {
        if (field->text.empty()) {
            if (field == header.begin() && first == FirstColumn::may_lack_name && header.size() > 1) {
                continue;
            }
            problems.add(ExitCode::data, field->place, "a column without a name", "a name",
                         field == header.begin() ? "name it, or delete it: R's write.csv adds row names "
                                                   "unless row.names = FALSE"
                                                 : "");
        } else if (first == FirstColumn::named && std::any_of(header.begin(), field, [&](const Field& f) {
                       return f.text == field->text;
                   })) {
            problems.add(ExitCode::data, field->place, "column " + in_quotes(field->text) + " a second time",
                         "each column once");
        }
    }
}

/// Columns of the user of one name get a number, as exports of spreadsheets repeat what nobody reads. A
/// column that is read and repeated is refused when all has been read.
void number_repeated(std::vector<std::string>& columns) {
    for (std::size_t i = 1; i < columns.size(); ++i) {
        const std::string name = columns[i];
        const auto before = [&] { return columns.begin() + static_cast<std::ptrdiff_t>(i); };
        for (int number = 2; !name.empty() && std::find(columns.begin(), before(), columns[i]) != before();
             ++number) {
            columns[i] = name + " (" + std::to_string(number) + ")";
        }
    }
}

/// Without those that are empty.
std::vector<std::string> first_lines(std::string_view text, std::size_t count) {
    std::vector<std::string> lines;
    for (; count > 0; --count) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        if (const std::string_view line = trimmed(text.substr(0, end)); !line.empty()) {
            lines.emplace_back(line);
        }
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

/// Whether a record fits the header; empty fields past the last column are cut off.
bool fits(Record& record, std::size_t columns, Problems& problems) {
    while (record.size() > columns && record.back().text.empty()) {
        record.pop_back();
    }
    if (record.size() == columns) {
        return true;
    }
    const Place& place = record.size() > columns ? record[columns].place : record.back().place;
    problems.add(ExitCode::data, place, std::to_string(record.size()) + " fields",
                 std::to_string(columns) + " as in the header");
    return false;
}

/// Whether a text is digits, perhaps with a sign, and one mark between or before digits.
bool is_decimal_with(char mark, std::string_view text) {
    if (text.starts_with('-') || text.starts_with('+')) {
        text.remove_prefix(1);
    }
    const std::size_t at = text.find(mark);
    const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
    return at != std::string_view::npos && at + 1 < text.size() &&
           std::all_of(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), is_digit) &&
           std::all_of(text.begin() + static_cast<std::ptrdiff_t>(at) + 1, text.end(), is_digit);
}

/// Decimal commas become points, unless some numbers have points: then either may be a fault.
void take_decimal_commas(std::vector<std::vector<std::string>>& rows) {
    const auto any_with = [&](char mark) {
        return std::any_of(rows.begin(), rows.end(), [mark](const std::vector<std::string>& cells) {
            return std::any_of(cells.begin(), cells.end(),
                               [mark](const std::string& cell) { return is_decimal_with(mark, cell); });
        });
    };
    if (!any_with(',') || any_with('.')) {
        return;
    }
    for (std::vector<std::string>& cells : rows) {
        for (std::string& cell : cells) {
            if (is_decimal_with(',', cell)) {
                std::replace(cell.begin(), cell.end(), ',', '.');
            }
        }
    }
}

}  // namespace

void Features::add_column(std::string name) {
    const auto is_taken = [&](const std::string& wanted) {
        return wanted == "wkt" || std::find(columns.begin(), columns.end(), wanted) != columns.end();
    };
    std::string free = name.empty() ? "column" : std::move(name);
    const std::string stem = free;
    for (int number = 2; is_taken(free); ++number) {
        free = stem + "_" + std::to_string(number);
    }
    columns.push_back(std::move(free));
}

Table Table::of(Features features) {
    Table table;
    table.file_ = std::move(features.file);
    table.columns_ = std::move(features.columns);
    table.found_ = table.columns_;
    table.cells_ = std::move(features.cells);
    table.places_.reserve(table.cells_.size());
    for (std::size_t row = 0; row < table.cells_.size(); ++row) {
        assert(table.cells_[row].size() <= table.columns_.size());
        table.cells_[row].resize(table.columns_.size());
        std::vector<TextPlace>& places = table.places_.emplace_back();
        for (std::uint32_t column = 0; column < table.columns_.size(); ++column) {
            places.push_back({features.numbers[row], column + 1});
        }
    }
    return table;
}

void Table::add_column(std::string name, std::vector<std::string> values, std::string_view like) {
    assert(values.size() == rows());
    const std::size_t place = index_of(like);
    columns_.push_back(std::move(name));
    found_.push_back(columns_.back());
    by_form_.clear();
    if (use_) {
        use_->columns.push_back({columns_.back(), columns_.back(), true});
    }
    if (!units_.empty()) {
        units_.emplace_back();
    }
    for (std::size_t row = 0; row < values.size(); ++row) {
        cells_[row].push_back(std::move(values[row]));
        places_[row].push_back(places_[row][place]);
    }
}

Table Table::read(std::istream& in, std::string file) {
    const std::string text = read_text(in, file);
    return read(std::string_view{text}, std::move(file));
}

Table Table::read(std::string_view bytes, std::string file, FirstColumn first_column) {
    constexpr std::size_t most_uneven_rows = 100;
    const std::string_view text = checked_text(bytes, file);
    const auto read_below = [&](std::size_t lines_above, Problems& problems) {
        Records records{text, file, problems, lines_above};
        Table table;
        table.file_ = file;
        table.lines_above_ = first_lines(text, lines_above);
        Record header = records.next();
        while (!header.empty() && header.back().text.empty()) {
            header.pop_back();  // a separator at the end of the line names no column
        }
        check_header(header, first_column, records.place(), problems);
        table.columns_ = texts_of(std::move(header));
        if (first_column == FirstColumn::may_lack_name) {
            number_repeated(table.columns_);
        }
        table.lacks_first_name_ = first_column == FirstColumn::may_lack_name && table.columns_.size() > 1 &&
                                  table.columns_.front().empty();

        bool first = true;
        for (Record record = records.next(); !record.empty(); record = records.next()) {
            const bool unit_row = std::exchange(first, false) && is_unit_row(record);
            if (!fits(record, table.columns_.size(), problems)) {
                if (problems.list().size() >= most_uneven_rows) {
                    break;  // hardly a table, or not with this header
                }
                continue;
            }
            if (unit_row) {
                table.units_ = texts_of(std::move(record));
                continue;
            }
            std::vector<TextPlace> places;
            places.reserve(record.size());
            for (const Field& field : record) {
                places.push_back({static_cast<std::uint32_t>(field.place.line),
                                  static_cast<std::uint32_t>(field.place.column)});
            }
            table.places_.push_back(std::move(places));
            table.cells_.push_back(texts_of(std::move(record)));
        }
        if (records.separator() != ',') {
            take_decimal_commas(table.cells_);
        }
        return table;
    };
    Problems problems;
    Table table = read_below(0, problems);
    // Lines above the header are looked for only where the first line is none: what reads without, is read
    // so.
    if (const std::size_t explained = problems.empty() ? 0 : lines_above_header(text); explained > 0) {
        Problems fewer;
        Table below = read_below(explained, fewer);
        if (fewer.list().size() < problems.list().size()) {
            problems = std::move(fewer);
            table = std::move(below);
        }
    }
    problems.throw_if_any();
    if (table.lacks_first_name_) {
        table.columns_.erase(table.columns_.begin());
        for (std::size_t row = 0; row < table.cells_.size(); ++row) {
            table.cells_[row].erase(table.cells_[row].begin());
            table.places_[row].erase(table.places_[row].begin());
        }
        if (!table.units_.empty()) {
            table.units_.erase(table.units_.begin());
        }
    }
    table.found_ = table.columns_;
    return table;
}

Place Table::place(std::size_t row, std::string_view column) const {
    const TextPlace& place = places_[row][index_of(column)];
    return {file_, place.line, place.column};
}

Problem other_unit_problem(const std::string& file, const std::string& found, const std::string& wanted) {
    const ColumnForm from = form_of(found);
    const ColumnForm to = form_of(wanted);
    const double factor = unit_factor(from.unit, to.unit);
    std::string advice = "name the column " + wanted + " and give its numbers in " + to.unit;
    if (factor > 0.0) {
        advice = "multiply its numbers by " + to_text(factor) + " and name the column " + wanted;
    }
    return {ExitCode::data,
            {file},
            "column " + in_quotes(found) + ", which is in " + from.unit,
            wanted + ", in " + to.unit,
            std::move(advice)};
}

bool Table::require(const std::vector<std::string>& wanted, Problems& problems) const {
    bool complete = true;
    const std::vector<std::string> others = columns_beside(wanted);
    for (const std::string& name : wanted) {
        if (has(name)) {
            continue;
        }
        complete = false;
        const ColumnForm form = form_of(name);
        const auto in_other_unit = std::find_if(others.begin(), others.end(), [&](const std::string& column) {
            return is_other_unit(form_of(column), form);
        });
        if (in_other_unit != others.end()) {
            problems.add(other_unit_problem(file_, *in_other_unit, name));
            continue;
        }
        const std::string nearest = nearest_word(name, others);
        if (nearest.empty()) {
            problems.add(ExitCode::data, {file_},
                         "no column " + in_quotes(name) + " among " + some_of(found_), "",
                         name == "wkt" ? "give each row its shape as well-known text (QGIS: Export, CSV, "
                                         "GEOMETRY = AS_WKT), or name a layer"
                                       : "add it, or rename the column that holds it");
        } else {
            problems.add(ExitCode::data, {file_},
                         "no column " + in_quotes(name) + " (is " + in_quotes(nearest) + " meant to be it?)");
        }
    }
    return complete;
}

const std::string& Table::text(std::size_t row, std::string_view column) const {
    return cells_[row][index_of(column)];
}

const std::string& Table::seen_text(std::size_t row, std::string_view column) const {
    return cells_[row][find(column).value()];
}

void Table::add_problem(std::size_t row, std::string_view column, std::string_view kind,
                        const NumberRange& range, Problems& problems) const {
    const auto emptied = emptied_.find({row, index_of(column)});
    const std::string& field = emptied == emptied_.end() ? text(row, column) : emptied->second;
    std::string expected = describe(kind, range);
    std::string advice;
    const auto plain = without_separators(field);
    if (plain && range.contains(parse_number(*plain).value_or(range.low))) {
        advice.append("write ").append(*plain).append(" without separators of thousands");
    } else if (field.starts_with("\u2212") || field.starts_with("\u2013")) {
        advice = "write the minus sign of the keyboard, -, right before the number";
    }
    constexpr double least_percent = 5.0;  // 1.4 is a slip of another kind
    constexpr double most_percent = 100.0;
    const double value = parse_number(field).value_or(0.0);
    if (advice.empty() && range.low >= 0.0 && range.high <= 1.0 && value >= least_percent &&
        value <= most_percent) {
        advice = "write a share of 1: divide percents by 100";
    }
    if (!plain && field.find(',') != std::string::npos) {
        expected += ", with a decimal point";
    }
    problems.add(ExitCode::data, place(row, column),
                 std::string{column} + " " + (field.empty() ? "empty" : in_quotes(field)), expected, advice);
}

std::optional<double> Table::number(std::size_t row, std::string_view column, NumberRange range,
                                    Problems& problems) const {
    const std::optional<double> value = parse_number(text(row, column));
    if (value && range.contains(*value)) {
        return value;
    }
    add_problem(row, column, "a number", range, problems);
    return std::nullopt;
}

std::optional<long long> Table::whole(std::size_t row, std::string_view column, NumberRange range,
                                      Problems& problems) const {
    const std::optional<long long> value = parse_whole(text(row, column));
    if (value && range.contains(static_cast<double>(*value))) {
        return value;
    }
    add_problem(row, column, "a whole number", range, problems);
    return std::nullopt;
}

std::string csv_field(std::string_view text) {
    if (text.find_first_of(",;\"\n\r") == std::string_view::npos && trimmed(text) == text &&
        !text.starts_with('#')) {
        return std::string{text};
    }
    std::string quoted{"\""};
    quoted.reserve(text.size() + 2);
    for (std::size_t quote = text.find('"'); quote != std::string_view::npos; quote = text.find('"')) {
        quoted.append(text.substr(0, quote + 1)).append(1, '"');
        text.remove_prefix(quote + 1);
    }
    return quoted.append(text).append(1, '"');
}

}  // namespace config
