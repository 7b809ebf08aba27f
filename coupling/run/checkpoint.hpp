#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "coupling/inputs/nets/net_record.hpp"
#include "coupling/inputs/own_files/table_count.hpp"
#include "coupling/run/fall_rocks.hpp"
#include "rockfall/ensemble.hpp"

namespace coupling {

/// A streamed table at the end of a part: its first bytes and rows, and the checksum of these bytes.
struct KeptTable {
    TableEnd end;
    std::uint64_t sum = 0;
};

/// Where a long run stands after its last finished part: all that is needed to go on as if it had never
/// stopped.
struct Checkpoint {
    std::string settings_hash;  ///< of settings, inputs and version
    std::uint64_t chunks_done = 0;
    SourcesUnderWay::Begun begun;    ///< by them, and not yet through
    std::uint64_t not_started = 0;   ///< rocks whose place lay outside the terrain
    std::vector<KeptTable> tables;   ///< each streamed table; of one that is not wanted nothing
    std::vector<std::uint8_t> gone;  ///< broken stems, where they fall
    std::vector<rockfall::PathRecord> paths;
    std::vector<NetRow> net_rows;  ///< crossings of nets, in the order of rocks
};

/// Writes a checkpoint with tallies and distributions, under a temporary name first, renamed when whole and
/// on the disk. Throws config::InputError (file) if the disk does not take it.
void write_checkpoint(const std::filesystem::path& file, const Checkpoint& checkpoint,
                      const rockfall::EnsembleTally& tally,
                      const std::array<rockfall::CellHistograms*, rockfall::covers>& histograms);

/// Writes a checkpoint that holds nothing but the hash: of runs that keep their parts in files of their own.
/// Throws config::InputError (file) if the disk does not take it.
void write_marker(const std::filesystem::path& file, const std::string& settings_hash);

/// The hash in a checkpoint file; nothing if there is no such file. Throws InputError (file) if it is not a
/// checkpoint whose checksum fits.
std::optional<std::string> checkpoint_hash(const std::filesystem::path& file);

/// Reads a checkpoint back into tallies and distributions of the same shape.
/// Throws InputError (file) if the file is cut off or damaged.
Checkpoint read_checkpoint(const std::filesystem::path& file, rockfall::EnsembleTally& tally,
                           const std::array<rockfall::CellHistograms*, rockfall::covers>& histograms);

}  // namespace coupling
