#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "coupling/results/geopackage/package.hpp"

namespace coupling::vectors {

/// A column as the table of a Shapefile (dBASE) has it.
struct DbfField {
    std::string name;  ///< at most ten characters, no other's of the table
    char type = 'C';   ///< C: words; N: a number
    int width = 1;     ///< bytes
    int decimals = 0;
    bool is_cut = false;  ///< it has words that are longer than a field takes
};

/// The fields of a table, found from its columns and from every row: wide enough for each of them. Numbers
/// have as many decimals as their table writes, or more where a row needs more to be the same number.
class DbfFields {
public:
    /// `decimals`: of each column, as geopackage::Written has them.
    DbfFields(std::span<const geopackage::Column> columns, std::span<const std::size_t> decimals);
    void add_row(std::span<const std::string> fields);
    [[nodiscard]] const std::vector<DbfField>& fields() const { return fields_; }

    /// Bytes of a row.
    [[nodiscard]] std::size_t row_bytes() const;
    /// The row as its bytes; what is not known are blanks.
    [[nodiscard]] std::string row(std::span<const std::string> fields) const;

private:
    struct Size {
        std::size_t before_point = 1;  ///< digits and sign
        std::size_t decimals = 0;
        std::size_t longest = 1;  ///< of words, and of numbers that need an exponent
        bool has_exponent = false;
    };
    void settle(std::size_t column);

    std::vector<DbfField> fields_;
    std::vector<Size> sizes_;
};

/// Names of columns cut to ten characters, so that no two are equal, whatever the case of their letters.
std::vector<std::string> short_names(std::span<const geopackage::Column> columns);

/// The number with at least so many decimals: "12.5" with 3 is "12.500". What has an exponent stays.
std::string with_decimals(const std::string& number, std::size_t decimals);

}  // namespace coupling::vectors
