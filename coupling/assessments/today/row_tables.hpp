#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include "coupling/inputs/site.hpp"
#include "coupling/results/disk/out_file.hpp"
#include "coupling/run/checkpoint.hpp"
#include "rockfall/ensemble.hpp"

namespace coupling {

/// The tables that grow while rocks fall: a row a rock, an arrival, a tree hit. Streamed, never kept.
class RowTables {
public:
    /// Opens the tables in a folder; with `kept` (from a checkpoint) they are cut to that length and go on.
    /// Throws config::InputError (file) for a table whose kept bytes are missing or have changed.
    RowTables(const Scenario& scenario, const Site& site, const std::filesystem::path& folder,
              const std::vector<KeptTable>& kept);
    ~RowTables();

    void add(const rockfall::ChunkRows& rows);
    /// Adds the rows that tables of the same scenario hold in another folder. Throws as the constructor.
    void append(const std::filesystem::path& folder, const std::vector<KeptTable>& kept);
    /// What the tables hold so far, all of it on the disk.
    std::vector<KeptTable> sync();
    /// Where the tables lie.
    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
    /// Closes the tables; the list says what each holds.
    std::vector<WrittenFile> close();
    /// Puts the closed tables into another folder too: under a second name, or as copies where the disk does
    /// not offer that. Those here stay.
    void link_to(const std::filesystem::path& folder);

private:
    struct Table;
    void add_rocks(const rockfall::ChunkRows& rows, rockfall::Cover cover);
    void add_arrivals(const rockfall::ChunkRows& rows, rockfall::Cover cover);
    void add_tree_hits(const rockfall::ChunkRows& rows);
    void add_log_hits(const rockfall::ChunkRows& rows);

    const Site& site_;
    std::filesystem::path folder_;
    std::vector<std::unique_ptr<Table>> tables_;
};

}  // namespace coupling
