#include "coupling/results/geopackage/csv_rows.hpp"

#include <algorithm>
#include <cassert>

#include "coupling/results/geopackage/plain_number.hpp"

namespace coupling::geopackage {
namespace {

bool is_whole(std::string_view field) {
    const std::string_view digits = field.substr(field.front() == '-' ? 1 : 0);
    constexpr std::size_t most_digits = 18;  // any such number fits into 64 bits
    return !digits.empty() && digits.size() <= most_digits &&
           std::all_of(digits.begin(), digits.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// Where the field that begins at a place ends: at a comma, a line end or the end of the text.
std::size_t end_of_field(std::string_view text, std::size_t at) {
    while (at < text.size() && text[at] != ',' && text[at] != '\n') {
        ++at;
    }
    return at;
}

}  // namespace

CsvRows::CsvRows(std::string_view text) : text_{text} {
    if (read_row()) {
        columns_.assign(fields_.begin(), fields_.end());
    }
}

bool CsvRows::next() {
    while (at_ < text_.size() && text_[at_] == '\n') {
        ++at_;
    }
    return read_row();
}

bool CsvRows::read_row() {
    fields_.clear();
    unquoted_.clear();
    unquoted_.reserve(columns_.size());  // fields point into it
    if (at_ >= text_.size()) {
        return false;
    }
    for (;;) {
        if (at_ < text_.size() && text_[at_] == '"') {
            fields_.push_back(read_quoted());
        } else {
            const std::size_t end = end_of_field(text_, at_);
            fields_.push_back(text_.substr(at_, end - at_));
            at_ = end;
        }
        const bool goes_on = at_ < text_.size() && text_[at_] == ',';
        ++at_;
        if (!goes_on) {
            assert(columns_.empty() || fields_.size() == columns_.size());
            return true;
        }
    }
}

std::string_view CsvRows::read_quoted() {
    const std::size_t first = at_ + 1;
    std::size_t end = text_.find('"', first);
    bool doubled = false;
    while (end != std::string_view::npos && end + 1 < text_.size() && text_[end + 1] == '"') {
        doubled = true;
        end = text_.find('"', end + 2);
    }
    end = std::min(end, text_.size());
    at_ = end + 1;
    const std::string_view inside = text_.substr(first, end - first);
    if (!doubled) {
        return inside;
    }
    std::string plain;
    for (std::size_t i = 0; i < inside.size(); ++i) {
        plain += inside[i];
        i += inside[i] == '"' ? 1 : 0;
    }
    return unquoted_.emplace_back(std::move(plain));
}

ColumnTypes::ColumnTypes(const std::vector<std::string>& columns) {
    for (const std::string& name : columns) {
        seen_.push_back({name,
                         name == "name" || name == "regime" || name == "climate" || name.ends_with("_id"),
                         false, false});
    }
}

void ColumnTypes::see(const std::vector<std::string_view>& fields) {
    for (std::size_t i = 0; i < seen_.size(); ++i) {
        Seen& column = seen_[i];
        if (fields[i].empty() || column.word) {
            continue;
        }
        column.filled = true;
        if (!is_whole(fields[i])) {
            column.fraction = true;
            column.word = !plain_number(fields[i]);
        }
    }
}

std::vector<Column> ColumnTypes::columns() const {
    std::vector<Column> columns;
    for (const Seen& column : seen_) {
        columns.push_back({column.name, column.word                         ? ColumnType::text
                                        : column.fraction || !column.filled ? ColumnType::number
                                                                            : ColumnType::whole});
    }
    return columns;
}

}  // namespace coupling::geopackage
