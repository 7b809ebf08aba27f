#include "coupling/results/vectors/dbf_fields.hpp"

#include <algorithm>
#include <set>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "config/text/reading.hpp"

namespace coupling::vectors {
namespace {

using geopackage::Column;
using geopackage::ColumnType;

constexpr std::size_t longest_name = 10;
constexpr std::size_t longest_words = 254;

/// The words that fit into a field, cut between characters of UTF-8.
std::string_view fitting(std::string_view words, std::size_t most) {
    if (words.size() <= most) {
        return words;
    }
    std::size_t end = most;
    while (end > 0 && (static_cast<unsigned char>(words[end]) & 0xC0U) == 0x80U) {
        --end;
    }
    return words.substr(0, end);
}

}  // namespace

std::vector<std::string> short_names(std::span<const Column> columns) {
    std::set<std::string> taken;
    for (const Column& column : columns) {
        if (column.name.size() <= longest_name) {
            taken.insert(config::in_lower_case(column.name));  // short names stay as they are
        }
    }
    std::vector<std::string> names;
    for (const Column& column : columns) {
        std::string name{fitting(column.name, longest_name)};
        if (column.name.size() > longest_name) {
            for (int number = 2; !taken.insert(config::in_lower_case(name)).second; ++number) {
                const std::string end = config::joined("_", std::to_string(number));
                name = config::joined(fitting(column.name, longest_name - end.size()), end);
            }
        }
        names.push_back(std::move(name));
    }
    return names;
}

std::string with_decimals(const std::string& number, std::size_t decimals) {
    if (number.find_first_of("eE") != std::string::npos || decimals == 0) {
        return number;
    }
    const std::size_t point = number.find('.');
    const std::size_t has = point == std::string::npos ? 0 : number.size() - point - 1;
    return has >= decimals ? number
                           : config::joined(number, point == std::string::npos ? "." : "",
                                            std::string(decimals - has, '0'));
}

DbfFields::DbfFields(std::span<const Column> columns, std::span<const std::size_t> decimals)
    : sizes_(columns.size()) {
    const std::vector<std::string> names = short_names(columns);
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const bool is_number = columns[i].type != ColumnType::text;
        fields_.push_back({names[i], is_number ? 'N' : 'C'});
        sizes_[i].decimals = columns[i].type == ColumnType::number ? decimals[i] : 0;
        settle(i);
    }
}

void DbfFields::add_row(std::span<const std::string> fields) {
    for (std::size_t i = 0; i < fields.size(); ++i) {
        Size& size = sizes_[i];
        const std::string& field = fields[i];
        size.longest = std::max(size.longest, field.size());
        if (fields_[i].type == 'N' && !field.empty()) {
            const std::size_t point = std::min(field.find('.'), field.size());
            if (!config::parse_number(field)) {
                fields_[i].type = 'C';  // a word among numbers
            } else if (field.find_first_of("eE") != std::string::npos) {
                size.has_exponent = true;
            } else {
                size.before_point = std::max(size.before_point, point);
                size.decimals = std::max(size.decimals, field.size() - std::min(point + 1, field.size()));
            }
        }
        settle(i);
    }
}

void DbfFields::settle(std::size_t column) {
    const Size& size = sizes_[column];
    DbfField& field = fields_[column];
    if (field.type == 'C') {
        field.is_cut = size.longest > longest_words;
        field.width = static_cast<int>(std::min(size.longest, longest_words));
        return;
    }
    // with an exponent in a column of whole numbers, one place, or readers take it for a whole number
    const std::size_t decimals = size.has_exponent ? std::max<std::size_t>(size.decimals, 1) : size.decimals;
    const std::size_t fixed = size.before_point + (decimals > 0 ? decimals + 1 : 0);
    field.width = static_cast<int>(std::max(fixed, size.longest));
    field.decimals = static_cast<int>(decimals);
}

std::size_t DbfFields::row_bytes() const {
    std::size_t bytes = 1;
    for (const DbfField& field : fields_) {
        bytes += static_cast<std::size_t>(field.width);
    }
    return bytes;
}

std::string DbfFields::row(std::span<const std::string> fields) const {
    std::string bytes{" "};  // not deleted
    for (std::size_t i = 0; i < fields_.size(); ++i) {
        const DbfField& field = fields_[i];
        const auto width = static_cast<std::size_t>(field.width);
        if (field.type == 'C') {
            const std::string_view words = fitting(fields[i], width);
            bytes += words;
            bytes.append(width - words.size(), ' ');
        } else {
            const std::string number =
                fields[i].empty() ? std::string{}
                                  : with_decimals(fields[i], static_cast<std::size_t>(field.decimals));
            bytes.append(width - std::min(width, number.size()), ' ');
            bytes += number;
        }
    }
    return bytes;
}

}  // namespace coupling::vectors
