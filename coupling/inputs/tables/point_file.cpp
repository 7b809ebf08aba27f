#include "coupling/inputs/tables/point_file.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <utility>

#include "config/text/encoding.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "config/text/reading.hpp"
#include "coupling/inputs/formats/column_names.hpp"
#include "coupling/inputs/tables/prepare.hpp"
#include "coupling/inputs/tables/words.hpp"

namespace coupling::tables {
namespace {

using config::joined;

constexpr std::string_view blanks = " \t";
constexpr std::string_view not_commas = " \t;";
constexpr std::string_view any_separator = " \t;,";

/// Fields between separators; several separators in a row count as one, as columns are often lined up.
void split(std::string_view line, std::string_view separators, std::vector<std::string_view>& fields) {
    fields.clear();
    while (true) {
        const std::size_t start = line.find_first_not_of(separators);
        if (start == std::string_view::npos) {
            return;
        }
        line.remove_prefix(start);
        const std::size_t end = std::min(line.find_first_of(separators), line.size());
        fields.push_back(line.substr(0, end));
        line.remove_prefix(end);
    }
}

/// Fields between single separators, as below a header: an empty field counts, and a separator in quotes is
/// none.
void split_each(std::string_view line, char separator, std::vector<std::string_view>& fields) {
    fields.clear();
    while (true) {
        const std::size_t quote = line.starts_with('"') ? line.find('"', 1) : std::string_view::npos;
        const std::size_t end =
            std::min(line.find(separator, quote == std::string_view::npos ? 0 : quote), line.size());
        fields.push_back(config::trimmed(line.substr(0, end)));
        if (end == line.size()) {
            return;
        }
        line.remove_prefix(end + 1);
    }
}

bool is_digit_at(std::string_view text, std::size_t place) {
    return place < text.size() && std::isdigit(static_cast<unsigned char>(text[place])) != 0;
}

/// Whether a field has one comma, between digits: "0,25".
bool has_decimal_comma(std::string_view field) {
    const std::size_t comma = field.find(',');
    return comma != std::string_view::npos && comma > 0 && is_digit_at(field, comma - 1) &&
           is_digit_at(field, comma + 1) && field.find(',', comma + 1) == std::string_view::npos;
}

/// The lines of a text without comments and blanks at their ends.
class Lines {
public:
    explicit Lines(std::string_view text) : text_{text} {}

    /// The next line that holds anything; false at the end.
    bool next() {
        while (!text_.empty()) {
            const std::size_t end = std::min(text_.find('\n'), text_.size());
            whole_ = config::trimmed(text_.substr(0, end));
            text_.remove_prefix(std::min(end + 1, text_.size()));
            ++number_;
            line_ = config::trimmed(whole_.substr(0, whole_.find('#')));
            if (!line_.empty()) {
                return true;
            }
            if (whole_.starts_with('#') && comment_.empty()) {
                comment_ = config::trimmed(whole_.substr(1));
            }
        }
        return false;
    }
    [[nodiscard]] std::string_view line() const { return line_; }
    [[nodiscard]] std::size_t number() const { return number_; }
    /// The first comment above the lines so far.
    [[nodiscard]] std::string_view comment() const { return comment_; }

private:
    std::string_view text_;
    std::string_view whole_;
    std::string_view line_;
    std::string_view comment_;
    std::size_t number_ = 0;
};

/// Where commas stand in a number: in files whose first line with a comma has other separators.
bool has_decimal_commas(std::string_view text) {
    std::vector<std::string_view> fields;
    for (Lines lines{text}; lines.next();) {
        if (lines.line().find(',') == std::string_view::npos) {
            continue;
        }
        split(lines.line(), not_commas, fields);
        const bool all_inside = std::all_of(fields.begin(), fields.end(), [](std::string_view field) {
            return field.find(',') == std::string_view::npos || has_decimal_comma(field);
        });
        if (fields.size() < 3 || !config::parse_number(fields[0].substr(0, fields[0].find(',')))) {
            if (fields.size() >= 3) {
                continue;  // a header
            }
            return false;
        }
        return all_inside;
    }
    return false;
}

/// Which fields of a line are x, y and z.
struct PointColumns {
    std::array<std::size_t, 3> places{0, 1, 2};
    std::size_t count = 0;  ///< of the header; 0 without one
    char separator = ' ';   ///< of the header; a blank stands for all that may lie between fields
    std::vector<std::string> notes;
};

char separator_of(std::string_view header) {
    for (const char separator : {';', '\t', ','}) {
        if (header.find(separator) != std::string_view::npos) {
            return separator;
        }
    }
    return ' ';
}

/// The columns that a header names; nothing where x, y or z is missing.
std::optional<PointColumns> columns_of(std::string_view header, const std::string& file) {
    PointColumns columns;
    columns.separator = separator_of(header);
    std::string text{header};
    if (columns.separator == ' ') {
        std::vector<std::string_view> names;
        split(header, blanks, names);
        text.clear();
        for (const std::string_view name : names) {
            text += joined(text.empty() ? "" : ",", name);
        }
    }
    config::Table table =
        config::Table::read(std::string_view{text.append("\n")}, file, config::FirstColumn::may_lack_name);
    const std::vector<config::Problem> errors = formats::name_columns(table, "points");
    if (!errors.empty()) {
        throw config::InputError{errors};
    }
    table.forget_use();
    const std::size_t before = table.lacks_first_name() ? 1 : 0;
    columns.count = table.columns().size() + before;
    constexpr std::array<const char*, 3> names{"x_m", "y_m", "z_m"};
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (!table.has(names[i])) {
            return std::nullopt;
        }
        columns.places[i] = *table.find(names[i]) + before;
    }
    Findings use = findings_of_use(*table.use());
    if (!use.errors.empty()) {
        throw config::InputError{use.errors};
    }
    columns.notes = std::move(use.notes);
    return columns;
}

/// The columns, by the header if there is one; `lines` stands on the first line of points then.
PointColumns read_header(Lines& lines, bool& is_on_point, const std::string& file) {
    is_on_point = lines.next();
    if (!is_on_point) {
        return {};
    }
    std::string_view line = lines.line();
    const bool begins_with_number =
        config::parse_number(line.substr(0, line.find_first_of(any_separator))).has_value() ||
        has_decimal_comma(line.substr(0, line.find_first_of(not_commas)));
    if (begins_with_number) {
        if (const std::string_view comment = lines.comment(); !comment.empty()) {
            try {
                if (auto named = columns_of(comment, file)) {
                    return *named;
                }
            } catch (const config::InputError&) {
                return {};  // a sentence, no header
            }
        }
        return {};
    }
    while (line.starts_with('/')) {
        line.remove_prefix(1);
    }
    auto named = columns_of(config::trimmed(line), file);
    if (!named) {
        config::fail(config::ExitCode::data, {file, lines.number(), 1},
                     joined("a header without x, y and z: ", config::in_quotes(line)),
                     "columns called x, y and z, or easting, northing and elevation",
                     "name them so, or put a # before a line that is no header");
    }
    is_on_point = lines.next();
    return *named;
}

/// Reads the lines of a file one after another.
class PointReader {
public:
    PointReader(PointColumns columns, bool decimal_commas)
        : columns_{std::move(columns)}, decimal_commas_{decimal_commas} {}

    std::optional<Eigen::Vector3d> point_of(std::string_view line) {
        const bool by_header = columns_.count > 0 && columns_.separator != ' ';
        if (by_header) {
            split_each(line, columns_.separator, fields_);
        } else {
            split(line, decimal_commas_ ? not_commas : any_separator, fields_);
        }
        if (columns_.count > 0 && fields_.size() > columns_.count && !fields_.back().empty()) {
            return std::nullopt;
        }
        std::array<double, 3> numbers{};
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            const std::size_t place = columns_.places[i];
            const auto number = place < fields_.size() ? number_of(fields_[place]) : std::nullopt;
            if (!number) {
                return std::nullopt;
            }
            numbers[i] = *number;
        }
        return Eigen::Vector3d{numbers[0], numbers[1], numbers[2]};
    }
    [[nodiscard]] std::size_t fields() const { return fields_.size(); }

private:
    [[nodiscard]] std::optional<double> number_of(std::string_view field) const {
        if (field.size() > 1 && field.front() == '"' && field.back() == '"') {
            field = field.substr(1, field.size() - 2);
        }
        const bool below_other_separator = columns_.count > 0 && columns_.separator != ',';
        if ((decimal_commas_ || below_other_separator) && has_decimal_comma(field) &&
            field.find('.') == std::string_view::npos) {
            std::string with_point{field};
            std::replace(with_point.begin(), with_point.end(), ',', '.');
            return config::parse_number(with_point);
        }
        return config::parse_number(field);
    }

    PointColumns columns_;
    bool decimal_commas_;
    std::vector<std::string_view> fields_;
};

/// Whether the first coordinates are 0, 1, 2, ... or 1, 2, 3, ...: numbers of points, no places.
bool count_points(const std::vector<Eigen::Vector3d>& points) {
    constexpr std::size_t fewest = 3;  // two points may lie a metre apart
    if (points.size() < fewest || (points.front().x() != 0.0 && points.front().x() != 1.0)) {
        return false;
    }
    for (std::size_t i = 1; i < points.size(); ++i) {
        if (points[i].x() != points[i - 1].x() + 1.0) {
            return false;
        }
    }
    return true;
}

}  // namespace

PointFile read_point_file(std::string_view text, const std::string& file) {
    text = config::without_byte_order_mark(text);
    std::string converted;
    if (!config::is_utf8(text)) {  // only a header can hold such letters
        converted = config::to_utf8(text, config::Encoding::windows_1252);
        text = converted;
    }
    Lines lines{text};
    bool is_on_point = false;
    PointColumns columns = read_header(lines, is_on_point, file);
    PointFile result;
    result.notes = columns.notes;
    const bool has_header = columns.count > 0;
    PointReader reader{std::move(columns), has_decimal_commas(text)};
    config::Problems problems;
    std::size_t most_fields = 0;
    for (; is_on_point; is_on_point = lines.next()) {
        if (const auto point = reader.point_of(lines.line())) {
            result.points.push_back(*point);
            most_fields = std::max(most_fields, reader.fields());
        } else {
            problems.add(config::ExitCode::data, {file, lines.number(), 1}, config::in_quotes(lines.line()),
                         has_header ? "fields as in the header, with numbers for x, y and z in metres"
                                    : "three numbers: x y z in metres");
        }
    }
    config::Problems shown;
    add_first(shown, problems, file);
    shown.throw_if_any();
    if (!has_header && most_fields > 3) {
        if (count_points(result.points)) {
            config::fail(config::ExitCode::data, {file},
                         "a first column that counts the points, and no header",
                         "x, y and z in the first three columns, or a header that names them",
                         "write a first line with the names of the columns, such as id,x,y,z");
        }
        result.notes.push_back(joined(file, ": no header: the first three of ", std::to_string(most_fields),
                                      " columns are taken as x, y and z"));
    }
    return result;
}

}  // namespace coupling::tables
