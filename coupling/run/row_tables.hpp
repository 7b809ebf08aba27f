#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include "coupling/inputs/site.hpp"
#include "coupling/results/out_file.hpp"
#include "rockfall/ensemble.hpp"

namespace coupling {

/// The tables that grow while rocks fall: a row a rock, an arrival, a tree hit. Streamed, never kept.
class RowTables {
public:
    /// Opens the tables in a folder; with `kept_bytes` (from a checkpoint) they are cut to that length and go
    /// on.
    RowTables(const Scenario& scenario, const Site& site, const std::filesystem::path& folder,
              const std::vector<std::uint64_t>& kept_bytes);
    ~RowTables();

    void add(const rockfall::ChunkRows& rows);
    /// Lengths so far, all of them on disk.
    std::vector<std::uint64_t> flush();
    /// Closes the tables; the list says what each holds.
    std::vector<WrittenFile> close();
    /// Moves the closed tables to a folder on the same disk.
    void move_to(const std::filesystem::path& folder);

private:
    struct Table;
    void add_rocks(const rockfall::ChunkRows& rows, rockfall::Cover cover);
    void add_arrivals(const rockfall::ChunkRows& rows, rockfall::Cover cover);
    void add_tree_hits(const rockfall::ChunkRows& rows);
    void add_log_hits(const rockfall::ChunkRows& rows);

    const Site& site_;
    std::vector<std::unique_ptr<Table>> tables_;
};

}  // namespace coupling
