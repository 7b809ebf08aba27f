#pragma once

#include <cstddef>
#include <cstdint>

namespace coupling {

/// Where a table of this program ends, as its writer counted. Its reader compares: a table that is cut off
/// or read only in part never passes for a shorter one.
struct TableEnd {
    std::uint64_t bytes = 0;
    std::uint64_t rows = 0;  ///< without the header
};

/// Counts the bytes and rows of a table as it is written: a line break within quotes ends no row.
class TableCount {
public:
    TableCount() = default;
    /// Goes on behind whole rows.
    explicit TableCount(const TableEnd& so_far) : bytes_{so_far.bytes}, lines_{so_far.rows + 1} {}

    void add(const char* text, std::size_t count);
    [[nodiscard]] TableEnd end() const { return {bytes_, lines_ == 0 ? 0 : lines_ - 1}; }

private:
    std::uint64_t bytes_ = 0;
    std::uint64_t lines_ = 0;
    bool in_quotes_ = false;
};

}  // namespace coupling
