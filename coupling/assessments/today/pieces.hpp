#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "rockfall/ensemble.hpp"

namespace coupling {

// A run of today in pieces, for machines (shards) and processes (ranks) that share it. Each piece has a
// folder of its own beside the others, with a checkpoint and tables as a run alone has, and its rocks are
// those of sources that follow one another. All counts are whole numbers and rows are put one after the
// other, so that pieces give the bytes of a run alone.

/// Which of how many.
struct Piece {
    std::uint32_t number = 0;  ///< from 0
    std::uint32_t count = 1;
};

/// Its chunks: about as many rocks as in the others, of whole sources. Pieces may be empty.
std::span<const rockfall::Chunk> chunks_of(std::span<const rockfall::Chunk> chunks, const Piece& piece);

/// Where a piece keeps what it has, in the folder of all parts.
std::filesystem::path folder_of(const std::filesystem::path& parts, const Piece& piece);

/// Of how many pieces there are some in a folder of parts; nothing without any. Throws InputError (settings)
/// for pieces of different counts.
std::optional<std::uint32_t> pieces_in(const std::filesystem::path& parts);

/// The folders of all pieces, in order, each from the first of these folders of parts that has it. Throws
/// InputError (file) where some are missing.
std::vector<std::filesystem::path> all_pieces(std::span<const std::filesystem::path> folders_of_parts);

}  // namespace coupling
