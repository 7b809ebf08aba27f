#include "tests/runs/page_figures/figure_sources.hpp"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <iomanip>
#include <map>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace coupling::page_figures {
namespace {

using config::Table;

std::vector<std::string> split(std::string_view text) {
    std::istringstream in{std::string{text}};
    std::vector<std::string> parts;
    for (std::string part; in >> part;) {
        parts.push_back(part);
    }
    return parts;
}

std::string filled(std::string text, const Words& words) {
    for (std::size_t at = text.find('{'); at != std::string::npos; at = text.find('{', at + 1)) {
        const std::size_t end = text.find('}', at);
        const std::string name = text.substr(at + 1, end - at - 1);
        const auto word = words.find(name);
        if (word == words.end()) {
            throw std::runtime_error{"no word '" + name + "'"};
        }
        text.replace(at, end + 1 - at, word->second);
    }
    return text;
}

std::string as_cover(const std::string& words) {
    const bool with_forest =
        words.find("orest") != std::string::npos && words.find("without") == std::string::npos;
    return with_forest ? "forest" : "bare";
}

double as_number(const std::string& text) {
    return text.empty() ? std::nan("") : std::stod(text);
}

bool equal(const std::string& field, const std::string& wanted) {
    if (field == wanted) {
        return true;
    }
    const auto is_number = [](const std::string& text) {
        return !text.empty() && text.find_first_not_of("0123456789.-") == std::string::npos;
    };
    return is_number(field) && is_number(wanted) && as_number(field) == as_number(wanted);
}

/// A part of a source that names a table.
struct Reference {
    std::string table;
    std::string column;
    std::string of_rows;  ///< "", "count", "sum", "max", "mean", "low90" or "high90"
    std::vector<std::size_t> rows;
};

/// What a row must have in a column.
struct Condition {
    std::string column;
    char sign;
    std::string wanted;
    [[nodiscard]] bool holds(const std::string& field) const {
        return sign == '='   ? equal(field, wanted)
               : sign == '!' ? !equal(field, wanted)
               : sign == '>' ? as_number(field) > as_number(wanted)
                             : as_number(field) < as_number(wanted);
    }
};

Reference find(const std::vector<std::string>& parts, const Words& words, const Tables& tables) {
    Reference found;
    found.table = filled(parts.front(), words);
    found.column = filled(parts.back(), words);
    const Table& table = tables(found.table);
    const std::size_t bracket = found.column.find('(');
    if (bracket != std::string::npos) {
        found.of_rows = found.column.substr(0, bracket);
        found.column = found.column.substr(bracket + 1, found.column.size() - bracket - 2);
    }
    const auto require = [&](const std::string& column) {
        const std::vector<std::string>& known = table.columns();
        if (!column.empty() && std::find(known.begin(), known.end(), column) == known.end()) {
            throw std::runtime_error{found.table + " has no column '" + column + "'"};
        }
    };
    std::istringstream columns{found.column};
    for (std::string column; std::getline(columns, column, '+');) {
        require(column);
    }
    std::vector<Condition> conditions;
    for (auto part = parts.begin() + 1; part != parts.end() - 1; ++part) {
        const std::string text = filled(*part, words);
        const std::size_t at = text.find_first_of("=<>!");
        Condition condition{text.substr(0, at), text[at], text.substr(at + 1)};
        require(condition.column);
        if (condition.column == "cover") {
            condition.wanted = as_cover(condition.wanted);
        }
        conditions.push_back(std::move(condition));
    }
    for (std::size_t row = 0; row < table.rows(); ++row) {
        if (std::all_of(conditions.begin(), conditions.end(), [&](const Condition& condition) {
                return condition.holds(table.text(row, condition.column));
            })) {
            found.rows.push_back(row);
        }
    }
    if (found.of_rows.empty() && found.rows.size() != 1) {
        throw std::runtime_error{std::to_string(found.rows.size()) + " rows of " + found.table};
    }
    return found;
}

double half_of_last_digit(const std::string& field) {
    const std::size_t point = field.find('.');
    if (point == std::string::npos) {
        return 0.0;
    }
    return 0.5 * std::pow(10.0, -static_cast<double>(field.size() - point - 1));
}

/// What a row has in a column, or in several that are joined by "+".
TableFigure field_of(const Table& table, std::size_t row, const std::string& columns) {
    TableFigure all;
    std::istringstream in{columns};
    for (std::string column; std::getline(in, column, '+');) {
        const std::string& field = table.text(row, column);
        all.value += as_number(field);
        all.rounding += half_of_last_digit(field);
        all.is_empty = all.is_empty || field.empty();
    }
    return all;
}

/// The mean over the replicates of what their rows have together, or an end of its 90 % interval by Student's
/// t, which is not below 0.
TableFigure over_replicates(const Reference& found, const Table& table) {
    std::map<std::string, double> of_replicates;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        of_replicates[table.text(row, "replicate")] = 0.0;
    }
    const auto replicates = static_cast<double>(of_replicates.size());
    double digits = 0.0;
    TableFigure mean;
    for (const std::size_t row : found.rows) {
        const TableFigure field = field_of(table, row, found.column);
        of_replicates[table.text(row, "replicate")] += field.value;
        mean.value += field.value / replicates;
        mean.rounding += field.rounding / replicates;
        digits += field.rounding / replicates;
    }
    if (found.of_rows == "mean") {
        return mean;
    }
    double squares = 0.0;
    for (const auto& [replicate, value] : of_replicates) {
        squares += std::pow(value - mean.value, 2.0);
    }
    const double t = boost::math::quantile(boost::math::students_t{replicates - 1.0}, 0.95);
    const double half = t * std::sqrt(squares / (replicates - 1.0) / replicates);
    TableFigure end{found.of_rows == "high90" ? mean.value + half : std::max(0.0, mean.value - half),
                    (1.0 + t) * digits};
    // Rounded values may be equal where those that they were made of are not.
    end.may_be_empty = half <= t * digits;
    return end;
}

TableFigure part_of(const std::vector<std::string>& parts, const Words& words, const Tables& tables) {
    if (parts.size() == 1 && (parts.front() == "none" || parts.front() == "map")) {
        TableFigure figure;
        figure.is_empty = parts.front() == "none";
        figure.is_of_map = parts.front() == "map";
        return figure;
    }
    if (parts.size() == 1) {
        return {as_number(filled(parts.front(), words)), 0.0, false};
    }
    const Reference found = find(parts, words, tables);
    TableFigure figure;
    if (found.of_rows == "count") {
        figure.value = static_cast<double>(found.rows.size());
        return figure;
    }
    const Table& table = tables(found.table);
    if (found.of_rows.ends_with("90") || found.of_rows == "mean") {
        return over_replicates(found, table);
    }
    figure.value = found.of_rows == "max" ? -1e300 : 0.0;
    for (const std::size_t row : found.rows) {
        const TableFigure field = field_of(table, row, found.column);
        figure.is_empty = figure.is_empty || field.is_empty;
        figure.value =
            found.of_rows == "max" ? std::max(figure.value, field.value) : figure.value + field.value;
        figure.rounding += field.rounding;
    }
    return figure;
}

/// The unit of the last digit that says something: of whole numbers with noughts at their end at least the
/// third.
double unit_of(const std::string& shown) {
    const std::size_t power = shown.find('e');
    const std::string digits = shown.substr(0, power);
    const double scale =
        power == std::string::npos ? 1.0 : std::pow(10.0, std::stod(shown.substr(power + 1)));
    const std::size_t point = digits.find('.');
    if (point != std::string::npos) {
        return scale * std::pow(10.0, -static_cast<double>(digits.size() - point - 1));
    }
    const std::string whole = digits.starts_with('-') ? digits.substr(1) : digits;
    const std::size_t last = whole.find_last_not_of('0');
    const std::size_t noughts = last == std::string::npos ? 0 : whole.size() - 1 - last;
    const std::size_t beyond_three = whole.size() > 3 ? whole.size() - 3 : 0;
    return scale * std::pow(10.0, static_cast<double>(std::min(noughts, beyond_three)));
}

bool is_dash(const std::string& shown) {
    return shown == "\u2013" || shown == "not known";
}

}  // namespace

TableFigure figure_of(std::string_view source, const Words& words, const Tables& tables) {
    TableFigure all;
    char sign = 0;
    std::vector<std::string> part;
    const auto take = [&] {
        const TableFigure next = part_of(part, words, tables);
        const double before = all.value;
        switch (sign) {
            case '*':
                all.rounding = std::abs(next.value) * all.rounding + std::abs(before) * next.rounding;
                all.value *= next.value;
                break;
            case '/':
                all.rounding = all.rounding / std::abs(next.value) +
                               std::abs(before) * next.rounding / (next.value * next.value);
                all.value /= next.value;
                break;
            case '-':
                all.value -= next.value;
                all.rounding += next.rounding;
                break;
            default:
                all.value += next.value;
                all.rounding += next.rounding;
        }
        all.is_empty = all.is_empty || next.is_empty;
        all.is_of_map = all.is_of_map || next.is_of_map;
        all.may_be_empty = all.may_be_empty || next.may_be_empty;
        part.clear();
    };
    for (const std::string& word : split(source)) {
        if (word.size() == 1 && std::string_view{"*/+-"}.find(word.front()) != std::string_view::npos) {
            take();
            sign = word.front();
        } else {
            part.push_back(word);
        }
    }
    take();
    return all;
}

std::string text_of(std::string_view source, const Words& words, const Tables& tables) {
    const Reference found = find(split(source), words, tables);
    return tables(found.table).text(found.rows.front(), found.column);
}

bool agree(const std::string& shown, const TableFigure& figure) {
    if (figure.is_of_map) {
        return true;
    }
    if (is_dash(shown) || figure.is_empty) {
        return is_dash(shown) && (figure.is_empty || figure.may_be_empty);
    }
    const double slack = 1e-9 * std::max(1e-9, std::abs(figure.value));
    return std::abs(std::stod(shown) - figure.value) <= 0.5 * unit_of(shown) + figure.rounding + slack;
}

std::string changed(const std::string& shown, double rounding) {
    if (is_dash(shown)) {
        return "1";
    }
    const std::size_t power = std::min(shown.find('e'), shown.size());
    const std::string digits = shown.substr(0, power);
    const std::size_t point = digits.find('.');
    const std::size_t decimals = point == std::string::npos ? 0 : digits.size() - point - 1;
    const double unit = unit_of(digits);
    const double scale = power == shown.size() ? 1.0 : std::pow(10.0, std::stod(shown.substr(power + 1)));
    const double least = std::ceil(2.0 * rounding / (scale * unit)) + 2.0;
    // Where the new number ends with more noughts, its last digit says less: then the next one.
    for (const double units : {least, least + 1.0, -least, -least - 1.0}) {
        std::ostringstream text;
        text << std::fixed << std::setprecision(static_cast<int>(decimals))
             << std::stod(digits) + units * unit;
        if (unit_of(text.str()) <= unit) {
            return text.str() + shown.substr(power);
        }
    }
    throw std::logic_error{"no other number for " + shown};
}

}  // namespace coupling::page_figures
