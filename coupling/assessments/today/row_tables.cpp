#include "coupling/assessments/today/row_tables.hpp"

#include <algorithm>
#include <optional>
#include <string_view>

#include "config/errors/input_error.hpp"
#include "coupling/assessments/today/rows.hpp"
#include "coupling/inputs/own_files/file_reader.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/disk/disk.hpp"

namespace coupling {
namespace {

namespace fs = std::filesystem;

enum Which : std::size_t { rocks_table, arrivals_table, hits_table, log_hits_table };

constexpr const char* kept_table_remedy =
    "the table of that part; restore it, or run with --overwrite to start from the beginning";

/// Of the first bytes of a file; nothing if it has fewer.
std::optional<std::uint64_t> sum_of_first(const fs::path& file, std::uint64_t bytes) {
    if (!is_there(file)) {
        return std::nullopt;
    }
    FileReader in{file};
    return in.bytes() < bytes ? std::nullopt : std::optional{checksum_of(in, bytes).value()};
}

void refuse_changed(const fs::path& file, const KeptTable& kept) {
    const auto sum = sum_of_first(file, kept.end.bytes);
    if (!sum) {
        config::fail(config::ExitCode::file, {file.string()}, "shorter than its last finished part",
                     kept_table_remedy);
    }
    if (*sum != kept.sum) {
        config::fail(config::ExitCode::file, {file.string()},
                     "changed or damaged since its last finished part: its checksum differs",
                     kept_table_remedy);
    }
}

/// Takes a table back to the end of a part: what was written later belongs to no part.
void cut_to(const fs::path& file, const KeptTable& kept) {
    refuse_changed(file, kept);
    std::error_code error;
    if (fs::file_size(file, error) != kept.end.bytes && !error) {
        fs::resize_file(file, kept.end.bytes, error);
    }
    if (error) {
        config::fail(config::ExitCode::file, {file.string()},
                     "cannot be cut to its last finished part: " + error.message());
    }
}

/// Code of the ground type at a place, in coordinates of the terrain; none beyond it.
std::optional<int> ground_at(const rockfall::Slope& slope, const Eigen::Vector3d& place_m) {
    const auto triangle = slope.terrain.locate(place_m.x(), place_m.y());
    return triangle ? std::optional{slope.type_at(*triangle, place_m.x(), place_m.y()).code} : std::nullopt;
}

}  // namespace

/// One table: its file, or none if it is not wanted.
struct RowTables::Table {
    std::string name;
    std::string sentence;
    std::optional<OutFile> file;

    [[nodiscard]] bool wanted() const { return file.has_value(); }
};

RowTables::~RowTables() = default;

RowTables::RowTables(const Scenario& scenario, const Site& site, const fs::path& folder,
                     const std::vector<KeptTable>& kept)
    : site_{site}, folder_{folder} {
    const auto open = [&](const auto& declared, bool wanted) {
        auto table = std::make_unique<Table>();
        table->name = declared.file;
        table->sentence = declared.sentence;
        const std::size_t number = tables_.size();
        if (wanted) {
            const fs::path file = folder / table->name;
            if (number < kept.size()) {
                cut_to(file, kept[number]);
                table->file.emplace(file, OutFile::Begin::at_end);
                table->file->keep_sum(Checksum{kept[number].sum});
                table->file->count_table(kept[number].end);
            } else {
                table->file.emplace(file);
                table->file->keep_sum({});
                table->file->count_table();
                write_header(table->file->stream(), declared);
            }
        }
        tables_.push_back(std::move(table));
    };
    open(rock_table(), scenario.output.rock_table);
    open(arrival_table(), scenario.output.arrival_table && !site.targets.empty());
    open(tree_hit_table(), scenario.output.tree_hit_table && !site.trees.empty());
    open(log_hit_table(), scenario.output.tree_hit_table && !site.logs.empty());
}

void RowTables::add(const rockfall::ChunkRows& rows) {
    for (const rockfall::Cover cover : {rockfall::Cover::forest, rockfall::Cover::bare}) {
        add_rocks(rows, cover);
        add_arrivals(rows, cover);
    }
    add_tree_hits(rows);
    add_log_hits(rows);
    for (const auto& table : tables_) {
        if (table->wanted()) {
            table->file->check();
        }
    }
}

void RowTables::append(const fs::path& folder, const std::vector<KeptTable>& kept) {
    std::vector<char> block(std::size_t{1} << 20U);
    for (std::size_t number = 0; number < tables_.size(); ++number) {
        Table& table = *tables_[number];
        if (!table.wanted()) {
            continue;
        }
        const fs::path file = folder / table.name;
        refuse_changed(file, kept[number]);
        FileReader in{file};
        bool in_header = true;
        for (std::uint64_t left = kept[number].end.bytes; left > 0;) {
            const std::size_t got =
                in.read(block.data(), static_cast<std::size_t>(std::min<std::uint64_t>(left, block.size())));
            left -= got;
            const std::string_view bytes{block.data(), got};
            const auto end_of_header = in_header ? bytes.find('\n') : std::string_view::npos;
            if (!in_header || end_of_header != std::string_view::npos) {
                const std::size_t from = in_header ? end_of_header + 1 : 0;
                table.file->stream().write(bytes.data() + from, static_cast<std::streamsize>(got - from));
                in_header = false;
            }
        }
        table.file->check();
    }
}

void RowTables::add_rocks(const rockfall::ChunkRows& rows, rockfall::Cover cover) {
    if (!tables_[rocks_table]->wanted()) {
        return;
    }
    TableOf<RockRow>::Rows out{tables_[rocks_table]->file->stream(), rock_table()};
    const Eigen::Vector2d origin_m = site_.origin_m();
    for (const rockfall::RockRecord& record : rows.rocks[static_cast<std::size_t>(cover)]) {
        out.add({record, cover, origin_m, site_.sources[record.source].zone,
                 ground_at(site_.slope, record.end_m)});
    }
}

void RowTables::add_arrivals(const rockfall::ChunkRows& rows, rockfall::Cover cover) {
    if (!tables_[arrivals_table]->wanted()) {
        return;
    }
    const auto c = static_cast<std::size_t>(cover);
    TableOf<ArrivalOfRock>::Rows out{tables_[arrivals_table]->file->stream(), arrival_table()};
    const Eigen::Vector2d origin_m = site_.origin_m();
    for (const rockfall::ArrivalRecord& arrived : rows.arrivals[c]) {
        out.add({arrived.rock, site_.targets[arrived.target].id, cover, origin_m, arrived.arrival});
    }
}

void RowTables::add_tree_hits(const rockfall::ChunkRows& rows) {
    if (!tables_[hits_table]->wanted()) {
        return;
    }
    TableOf<HitRow<rockfall::TreeHitRecord>>::Rows out{tables_[hits_table]->file->stream(), tree_hit_table()};
    const Eigen::Vector2d origin_m = site_.origin_m();
    for (const auto& [rock, hit] : rows.tree_hits) {
        out.add({rock, site_.trees[hit.stem].id, origin_m, hit});
    }
}

void RowTables::add_log_hits(const rockfall::ChunkRows& rows) {
    if (!tables_[log_hits_table]->wanted()) {
        return;
    }
    TableOf<HitRow<rockfall::LogHitRecord>>::Rows out{tables_[log_hits_table]->file->stream(),
                                                      log_hit_table()};
    const Eigen::Vector2d origin_m = site_.origin_m();
    for (const auto& [rock, hit] : rows.log_hits) {
        out.add({rock, site_.logs[hit.log].id, origin_m, hit});
    }
}

std::vector<KeptTable> RowTables::sync() {
    std::vector<KeptTable> kept;
    for (const auto& table : tables_) {
        if (!table->wanted()) {
            kept.emplace_back();
            continue;
        }
        table->file->sync();
        kept.push_back({*table->file->end(), table->file->sum()});
    }
    return kept;
}

std::vector<WrittenFile> RowTables::close() {
    std::vector<WrittenFile> written;
    for (const auto& table : tables_) {
        if (table->wanted()) {
            table->file->close();
            written.push_back({"tables/" + table->name, table->sentence, table->file->end()});
        }
    }
    return written;
}

void RowTables::link_to(const fs::path& folder) {
    for (const auto& table : tables_) {
        if (table->wanted()) {
            link_or_copy(table->file->file(), folder / table->name);
        }
    }
}

}  // namespace coupling
