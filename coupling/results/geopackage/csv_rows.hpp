#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "coupling/results/geopackage/package.hpp"

namespace coupling::geopackage {

/// Goes through the rows of a table that this program wrote (CsvRow), without keeping them.
class CsvRows {
public:
    /// The text has to live as long as this object.
    explicit CsvRows(std::string_view text);

    [[nodiscard]] const std::vector<std::string>& columns() const { return columns_; }
    /// Goes on to the next row; false at the end. Empty lines are passed over.
    bool next();
    /// Share of the text that was gone through [0, 1].
    [[nodiscard]] double share() const {
        return static_cast<double>(at_) / static_cast<double>(text_.size());
    }
    /// Fields of the row, until the next one.
    [[nodiscard]] const std::vector<std::string_view>& fields() const { return fields_; }

private:
    bool read_row();
    std::string_view read_quoted();

    std::string_view text_;
    std::size_t at_ = 0;
    std::vector<std::string> columns_;
    std::vector<std::string_view> fields_;
    std::vector<std::string> unquoted_;  ///< fields that had doubled quotes
};

/// What the columns of a table hold, seen from its rows: whole numbers, numbers or words.
///
/// Names and identifiers (columns `name`, `regime`, `climate` and those that end in `_id`) are words,
/// whatever they look like, so that a key has the same type in every table. A column of empty fields counts
/// as numbers that are not known.
class ColumnTypes {
public:
    explicit ColumnTypes(const std::vector<std::string>& columns);
    void see(const std::vector<std::string_view>& fields);
    [[nodiscard]] std::vector<Column> columns() const;

private:
    struct Seen {
        std::string name;
        bool word = false;
        bool fraction = false;
        bool filled = false;
    };
    std::vector<Seen> seen_;
};

}  // namespace coupling::geopackage
