#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "coupling/results/geopackage/database.hpp"
#include "coupling/results/geopackage/geometry.hpp"

namespace coupling::geopackage {

/// The R-tree of a layer, written at once: rows are sorted into full nodes (sort-tile-recursive, Leutenegger
/// et al. 1997), which go into the tables behind SQLite's virtual table. Entering rows one by one takes ten
/// times as long and makes a larger file.
class PackedIndex {
public:
    /// Notes the extent of the next row; rows count from 1.
    void add(const Extent& extent);
    /// Fills the empty virtual table `name`, as it was made in the same database.
    void write(Database& database, const std::string& name) const;

private:
    /// Number of a row or node, and its rectangle in the floats of SQLite's R-tree.
    struct Entry {
        std::int64_t number;
        std::array<float, 4> box;  ///< low x, high x, low y, high y
    };
    struct Node {
        std::vector<Entry> entries;
        [[nodiscard]] Entry entry(std::int64_t number) const;
    };
    [[nodiscard]] static std::vector<Node> packed(std::vector<Entry> entries);
    [[nodiscard]] static std::vector<std::uint8_t> bytes_of(const Node& node, std::uint16_t depth);

    std::vector<Entry> rows_;
};

}  // namespace coupling::geopackage
