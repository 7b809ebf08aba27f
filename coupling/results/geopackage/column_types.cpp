#include "coupling/results/geopackage/column_types.hpp"

#include <algorithm>

#include "coupling/results/geopackage/plain_number.hpp"

namespace coupling::geopackage {
namespace {

bool is_whole(std::string_view field) {
    const std::string_view digits = field.substr(field.front() == '-' ? 1 : 0);
    constexpr std::size_t most_digits = 18;  // any such number fits into 64 bits
    return !digits.empty() && digits.size() <= most_digits &&
           std::all_of(digits.begin(), digits.end(), [](char c) { return c >= '0' && c <= '9'; });
}

}  // namespace

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
