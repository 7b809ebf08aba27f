#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "coupling/results/disk/byte_archive.hpp"
#include "rockfall/tally/ensemble_tally.hpp"
#include "rockfall/tally/zeroed_list.hpp"

namespace coupling {

// Tallies in part files. What is read replaces a tally that is empty so far.

void write(ByteWriter& out, const rockfall::ArrivalTally& t);
void read(ByteReader& in, rockfall::ArrivalTally& t);
void write(ByteWriter& out, const rockfall::RunTally& t);
void read(ByteReader& in, rockfall::RunTally& t);
void write(ByteWriter& out, const rockfall::TargetTally& t);
void read(ByteReader& in, rockfall::TargetTally& t);
void write(ByteWriter& out, const rockfall::StratumTally& t);
void read(ByteReader& in, rockfall::StratumTally& t);

/// Only the blocks that are not all zero: of a large map few cells are reached.
template <Plain T>
void write(ByteWriter& out, const rockfall::ZeroedList<T>& values) {
    out.value(static_cast<std::uint64_t>(values.size()));
    values.for_each_block([&](std::size_t from, std::size_t count) {
        out.value(static_cast<std::uint64_t>(from));
        out.list(std::span<const T>{values.begin() + from, count});
    });
    out.value(static_cast<std::uint64_t>(values.size()));
}
template <Plain T>
void read(ByteReader& in, rockfall::ZeroedList<T>& values) {
    values = rockfall::ZeroedList<T>{in.value<std::uint64_t>()};
    for (auto from = in.value<std::uint64_t>(); from != values.size(); from = in.value<std::uint64_t>()) {
        const std::vector<T> block = in.list<T>();
        in.require(from < values.size() && block.size() <= values.size() - from);
        std::copy(block.begin(), block.end(), values.begin() + from);
    }
}

}  // namespace coupling
