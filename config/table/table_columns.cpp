#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

#include "config/table/missing_words.hpp"
#include "config/table/table.hpp"

namespace config {

/// How spreadsheets, statistics programs and people write that there is no value.
bool says_no_value(std::string_view text) {
    constexpr std::array words{"NA",   "N/A",    "#N/A",  "#NV", "#N/D",   "#ND",   "n/a",
                               "n.a.", "k.A.",   "k. A.", "NaN", "nan",    "NULL",  "null",
                               "<NA>", "<Null>", "-",     "--",  "\u2013", "\u2014"};
    constexpr std::size_t longest = 6;
    return text.size() <= longest && std::find(words.begin(), words.end(), text) != words.end();
}

void Table::watch() {
    use_ = std::make_shared<ColumnUse>();
    use_->file = file_;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
        use_->columns.push_back({found_[i], columns_[i]});
    }
    by_form_.clear();
}

void Table::forget_use() {
    for (ColumnUse::Column& column : use_->columns) {
        column.is_read = false;
    }
    use_->missing.clear();
}

void Table::count_as_named(std::string_view found) const {
    const auto place = std::find(found_.begin(), found_.end(), found);
    if (place != found_.end()) {
        record(static_cast<std::size_t>(place - found_.begin()));
    }
}

void Table::record(std::size_t column) const {
    if (use_) {
        use_->columns[column].is_read = true;
    }
}

std::optional<std::size_t> Table::find(std::string_view column) const {
    const auto found = std::find(columns_.begin(), columns_.end(), column);
    if (found != columns_.end()) {
        return static_cast<std::size_t>(found - columns_.begin());
    }
    if (!use_) {
        return std::nullopt;
    }
    if (const auto known = by_form_.find(column); known != by_form_.end()) {
        return known->second;
    }
    const ColumnForm wanted = form_of(column);
    std::optional<std::size_t> place;
    for (std::size_t i = 0; i < columns_.size() && !place; ++i) {
        if (is_same_column(form_of(columns_[i]), wanted)) {
            place = i;
        }
    }
    by_form_.emplace(column, place);
    return place;
}

void Table::rename(std::string_view column, std::string name) {
    assert(!find(name) || find(name) == find(column));
    const std::size_t place = index_of(column);
    columns_[place] = std::move(name);
    by_form_.clear();
    if (use_) {
        use_->columns[place].name = columns_[place];
    }
}

void Table::set_text(std::size_t row, std::string_view column, std::string text) {
    cells_[row][index_of(column)] = std::move(text);
}

void Table::remove_rows(const std::function<bool(std::size_t row)>& is_out) {
    std::size_t kept = 0;
    std::map<std::pair<std::size_t, std::size_t>, std::string> emptied;
    for (std::size_t row = 0; row < cells_.size(); ++row) {
        if (is_out(row)) {
            continue;
        }
        for (auto at = emptied_.lower_bound({row, 0}); at != emptied_.end() && at->first.first == row; ++at) {
            emptied.emplace(std::pair{kept, at->first.second}, at->second);
        }
        if (kept != row) {
            cells_[kept] = std::move(cells_[row]);
            places_[kept] = std::move(places_[row]);
        }
        ++kept;
    }
    cells_.resize(kept);
    places_.resize(kept);
    emptied_ = std::move(emptied);
}

std::map<std::string, std::size_t> Table::take_missing_values(
    const std::function<bool(const std::string& column)>& keep) {
    std::map<std::string, std::size_t> counts;
    for (std::size_t column = 0; column < columns_.size(); ++column) {
        if (keep(columns_[column])) {
            continue;
        }
        for (std::size_t row = 0; row < cells_.size(); ++row) {
            std::string& cell = cells_[row][column];
            if (says_no_value(cell)) {
                ++counts[cell];
                emptied_.emplace(std::pair{row, column}, std::exchange(cell, {}));
            }
        }
    }
    return counts;
}

bool Table::has(std::string_view column) const {
    const std::optional<std::size_t> place = find(column);
    if (place) {
        record(*place);
    } else if (use_ && std::find(use_->missing.begin(), use_->missing.end(), column) == use_->missing.end()) {
        use_->missing.emplace_back(column);
    }
    return place.has_value();
}

std::vector<std::string> Table::columns_beside(const std::vector<std::string>& known) const {
    std::vector<bool> is_known(columns_.size(), false);
    for (const std::string& name : known) {
        if (const auto place = find(name)) {
            is_known[*place] = true;
        }
    }
    std::vector<std::string> others;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
        if (!is_known[i]) {
            others.push_back(found_[i]);
        }
    }
    return others;
}

std::size_t Table::index_of(std::string_view column) const {
    const std::optional<std::size_t> place = find(column);
    assert(place);
    record(*place);
    return *place;
}

}  // namespace config
