#include "coupling/results/geopackage/packed_index.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>
#include <utility>

#include "config/text/joined.hpp"

namespace coupling::geopackage {
namespace {

using config::joined;

/// Of a table of two dimensions with pages of 4096 bytes (rtree.c: getNodeSize): 51 cells of a number and
/// four floats behind a header of four bytes.
constexpr std::size_t cells_a_node = 51;
constexpr std::size_t node_bytes = 4 + cells_a_node * (8 + 4 * sizeof(float));

/// Floats that a rectangle does not reach beyond, rounded as SQLite does.
float rounded_down(double value) {
    const auto nearest = static_cast<float>(value);
    constexpr double step = 1.0 / 8388608.0;
    return static_cast<double>(nearest) > value
               ? static_cast<float>(value * (value < 0.0 ? 1.0 + step : 1.0 - step))
               : nearest;
}
float rounded_up(double value) {
    return -rounded_down(-value);
}

template <class Whole>
void append_whole(std::vector<std::uint8_t>& bytes, Whole value) {
    for (std::size_t i = sizeof(Whole); i-- > 0;) {
        bytes.push_back(static_cast<std::uint8_t>((static_cast<std::uint64_t>(value) >> (8 * i)) & 0xFFU));
    }
}

/// Pairs of numbers into a table, many in a statement.
void insert_pairs(Database& database, const std::string& table,
                  std::span<const std::pair<std::int64_t, std::int64_t>> pairs) {
    constexpr std::size_t at_once = 100;
    const auto statement_of = [&](std::size_t rows) {
        std::string sql = joined("INSERT INTO ", sql_name(table), " VALUES ");
        for (std::size_t i = 0; i < rows; ++i) {
            sql += i == 0 ? "(?, ?)" : ", (?, ?)";
        }
        return sql;
    };
    std::size_t at = 0;
    for (const std::size_t rows : {at_once, std::size_t{1}}) {
        Statement insert = database.prepare(statement_of(rows));
        for (; at + rows <= pairs.size(); at += rows) {
            for (std::size_t i = 0; i < rows; ++i) {
                insert.bind(static_cast<int>(2 * i + 1), pairs[at + i].first);
                insert.bind(static_cast<int>(2 * i + 2), pairs[at + i].second);
            }
            insert.run();
        }
    }
}

}  // namespace

void PackedIndex::add(const Extent& extent) {
    rows_.push_back({static_cast<std::int64_t>(rows_.size() + 1),
                     {rounded_down(extent.low_x_m), rounded_up(extent.high_x_m), rounded_down(extent.low_y_m),
                      rounded_up(extent.high_y_m)}});
}

PackedIndex::Entry PackedIndex::Node::entry(std::int64_t number) const {
    Entry whole{number, entries.front().box};
    for (const Entry& e : entries) {
        whole.box = {std::min(whole.box[0], e.box[0]), std::max(whole.box[1], e.box[1]),
                     std::min(whole.box[2], e.box[2]), std::max(whole.box[3], e.box[3])};
    }
    return whole;
}

/// Slices from west to east with about as many nodes as there are slices, each from south to north.
std::vector<PackedIndex::Node> PackedIndex::packed(std::vector<Entry> entries) {
    const auto along = [](std::size_t low) {
        return [low](const Entry& a, const Entry& b) {
            const float of_a = a.box[low] + a.box[low + 1];
            const float of_b = b.box[low] + b.box[low + 1];
            return of_a != of_b ? of_a < of_b : a.number < b.number;
        };
    };
    const std::size_t nodes = (entries.size() + cells_a_node - 1) / cells_a_node;
    const auto slices = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(nodes))));
    const std::size_t of_slice = slices * cells_a_node;
    std::sort(entries.begin(), entries.end(), along(0));
    std::vector<Node> packed;
    for (std::size_t begin = 0; begin < entries.size(); begin += of_slice) {
        const std::size_t end = std::min(entries.size(), begin + of_slice);
        const auto from = entries.begin() + static_cast<std::ptrdiff_t>(begin);
        const auto to = entries.begin() + static_cast<std::ptrdiff_t>(end);
        std::sort(from, to, along(2));
        for (std::size_t first = begin; first < end; first += cells_a_node) {
            const std::size_t last = std::min(end, first + cells_a_node);
            packed.push_back({{entries.begin() + static_cast<std::ptrdiff_t>(first),
                               entries.begin() + static_cast<std::ptrdiff_t>(last)}});
        }
    }
    return packed;
}

std::vector<std::uint8_t> PackedIndex::bytes_of(const Node& node, std::uint16_t depth) {
    std::vector<std::uint8_t> bytes;
    bytes.reserve(node_bytes);
    append_whole(bytes, depth);
    append_whole(bytes, static_cast<std::uint16_t>(node.entries.size()));
    for (const Entry& entry : node.entries) {
        append_whole(bytes, entry.number);
        for (const float side : entry.box) {
            append_whole(bytes, std::bit_cast<std::uint32_t>(side));
        }
    }
    bytes.resize(node_bytes, 0);
    return bytes;
}

void PackedIndex::write(Database& database, const std::string& name) const {
    if (rows_.empty()) {
        return;
    }
    // From the leaves up until one node is left: the root, which has the number 1. The leaves begin with 2.
    std::vector<std::vector<Node>> levels{packed(rows_)};
    std::vector<std::int64_t> first_numbers{2};
    while (levels.back().size() > 1) {
        std::vector<Entry> entries;
        for (const Node& node : levels.back()) {
            entries.push_back(node.entry(first_numbers.back() + static_cast<std::int64_t>(entries.size())));
        }
        first_numbers.push_back(first_numbers.back() + static_cast<std::int64_t>(levels.back().size()));
        levels.push_back(packed(std::move(entries)));
    }
    first_numbers.back() = 1;

    std::vector<std::pair<std::int64_t, std::int64_t>> parents;
    std::vector<std::pair<std::int64_t, std::int64_t>> leaves(rows_.size());
    Statement insert =
        database.prepare(joined("INSERT OR REPLACE INTO ", sql_name(name + "_node"), " VALUES (?, ?)"));
    for (std::size_t level = 0; level < levels.size(); ++level) {
        std::int64_t number = first_numbers[level];
        for (const Node& node : levels[level]) {
            const bool is_root = number == 1;
            const std::vector<std::uint8_t> bytes =
                bytes_of(node, is_root ? static_cast<std::uint16_t>(levels.size() - 1) : std::uint16_t{0});
            insert.bind(1, number).bind_bytes(2, bytes);
            insert.run();
            for (const Entry& entry : node.entries) {
                if (level == 0) {
                    leaves[static_cast<std::size_t>(entry.number - 1)] = {entry.number, number};
                } else {
                    parents.emplace_back(entry.number, number);
                }
            }
            ++number;
        }
    }
    std::sort(parents.begin(), parents.end());
    insert_pairs(database, name + "_rowid", leaves);
    insert_pairs(database, name + "_parent", parents);
}

}  // namespace coupling::geopackage
