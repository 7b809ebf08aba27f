#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "coupling/results/geopackage/package.hpp"

namespace coupling::geopackage {

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
