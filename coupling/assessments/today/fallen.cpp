#include "coupling/assessments/today/fallen.hpp"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <utility>

#include "config/errors/input_error.hpp"
#include "coupling/assessments/today/pieces.hpp"
#include "coupling/inputs/files/path_checks.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/run/fall_rocks.hpp"
#include "coupling/run/interrupt.hpp"

namespace coupling {
namespace {

/// Less work is kept between parts only: whoever stops a run at once wants other settings in the same folder.
constexpr std::chrono::seconds worth_keeping{20};

/// The chunks of the next part: it is finished, and kept, after about this many rocks.
std::span<const rockfall::Chunk> next_part(std::span<const rockfall::Chunk> chunks, std::size_t done,
                                           std::uint64_t rocks_per_part) {
    std::size_t end = done;
    while (end < chunks.size() &&
           (end == done || chunks[end - 1].last_rock - chunks[done].first_rock < rocks_per_part)) {
        ++end;
    }
    return chunks.subspan(done, end - done);
}

/// Rock by rock, first those of the slope with forest.
void keep_crossings(const rockfall::ChunkRows& rows, std::vector<NetRow>& kept) {
    for (const rockfall::Cover cover : {rockfall::Cover::forest, rockfall::Cover::bare}) {
        for (const auto& [rock, crossing] : rows.net_crossings[static_cast<std::size_t>(cover)]) {
            kept.push_back({rock, cover, crossing});
        }
    }
}

}  // namespace

FallingRocks::FallingRocks(const Scenario& scenario, const Site& site, const SiteFalls& falls,
                           std::string hash, int threads)
    : scenario_{scenario}, site_{site}, falls_{falls}, hash_{std::move(hash)}, threads_{threads} {}

Fallen FallingRocks::none() const {
    const config::GridFrame& frame = falls_.assessment.map_frame;
    Fallen fallen{{frame, site_.targets.size(), falls_.stems.placed().size(), falls_.logs.count()}};
    for (const rockfall::Cover cover : {rockfall::Cover::forest, rockfall::Cover::bare}) {
        if (scenario_.output.percentiles &&
            (!falls_.assessment.only_bare() || cover == rockfall::Cover::bare)) {
            fallen.histograms[static_cast<std::size_t>(cover)] =
                std::make_unique<rockfall::CellHistograms>(frame);
        }
    }
    if (scenario_.rockfall.fall.tree.remove_broken && !falls_.assessment.only_bare()) {
        fallen.state.gone.assign(falls_.stems.placed().size() + falls_.logs.count(), 0);
    }
    fallen.state.settings_hash = hash_;
    return fallen;
}

Fallen FallingRocks::kept_in(const std::filesystem::path& parts) const {
    Fallen fallen = none();
    if (const auto file = OutputFolder::checkpoint_of(parts); is_there(file)) {
        refuse_others(file);
        fallen.state = read_checkpoint(file, fallen.total, fallen.pointers());
    }
    fallen.tables = std::make_unique<RowTables>(scenario_, site_, parts, fallen.state.tables);
    return fallen;
}

void FallingRocks::fall(std::span<const rockfall::Chunk> chunks, const std::filesystem::path& parts,
                        Fallen& fallen, const Watch& watch) const {
    const auto begin = std::chrono::steady_clock::now();
    Checkpoint& state = fallen.state;
    const std::filesystem::path file = OutputFolder::checkpoint_of(parts);
    bool kept = is_there(file);
    bool is_saved = kept;
    SourcesUnderWay under_way{falls_.assessment.map_frame.size()};
    under_way.take_up(state.begun);
    const auto keep_rows = [&](const rockfall::ChunkRows& rows) {
        fallen.tables->add(rows);
        state.paths.insert(state.paths.end(), rows.paths.begin(), rows.paths.end());
        keep_crossings(rows, state.net_rows);
        state.not_started += rows.not_started;
        watch.fell(rows.rocks[static_cast<std::size_t>(rockfall::Cover::bare)].size() + rows.not_started);
    };
    const auto keep = [&] {
        state.begun = under_way.begun();
        state.tables = fallen.tables->sync();  // on the disk before the checkpoint that counts on them
        write_checkpoint(file, state, fallen.total, fallen.pointers());
        kept = is_saved = true;
        watch.kept();
    };
    while (state.chunks_done < chunks.size()) {
        const auto part = next_part(chunks, state.chunks_done, scenario_.run.rocks_per_part);
        const std::size_t done = fall_rocks(falls_.assessment, part, under_way, fallen.pointers(), state.gone,
                                            threads_, fallen.total, keep_rows);
        const bool interrupted = done < part.size();
        const bool last = part.size() == chunks.size() - state.chunks_done;
        state.chunks_done += done;
        is_saved = is_saved && done == 0;
        const bool long_enough = std::chrono::steady_clock::now() - begin >= worth_keeping;
        // An interruption that finds nothing new leaves the checkpoint as it is: it may hold gigabytes.
        if (done > 0 && (kept || long_enough || !(interrupted || last))) {
            keep();
        }
        if (interrupted) {
            throw Interrupted{};
        }
        if (watch.stopped()) {
            throw FailedElsewhere{};
        }
    }
    if (watch.keep_whole && !is_saved) {
        keep();
    }
}

Fallen FallingRocks::joined(std::span<const std::filesystem::path> pieces,
                            std::span<const rockfall::Chunk> chunks,
                            const std::filesystem::path& folder) const {
    delete_entry(folder);
    make_folder(folder);
    Fallen all = none();
    all.tables = std::make_unique<RowTables>(scenario_, site_, folder, std::vector<KeptTable>{});
    const auto count = static_cast<std::uint32_t>(pieces.size());
    for (std::uint32_t number = 0; number < count; ++number) {
        const std::filesystem::path file = OutputFolder::checkpoint_of(pieces[number]);
        refuse_others(file);
        Fallen piece = none();
        piece.state = read_checkpoint(file, piece.total, all.pointers());  // distributions add up
        if (piece.state.chunks_done < chunks_of(chunks, {number, count}).size()) {
            config::fail(config::ExitCode::file, {pieces[number].string()}, "a piece that is not finished",
                         "all rocks of its shard; run that shard again, it goes on from there");
        }
        all.total.add(piece.total);
        all.tables->append(pieces[number], piece.state.tables);
        std::move(piece.state.paths.begin(), piece.state.paths.end(), std::back_inserter(all.state.paths));
        all.state.net_rows.insert(all.state.net_rows.end(), piece.state.net_rows.begin(),
                                  piece.state.net_rows.end());
        all.state.not_started += piece.state.not_started;
    }
    return all;
}

void FallingRocks::refuse_others(const std::filesystem::path& checkpoint) const {
    if (checkpoint_hash(checkpoint) != hash_) {
        config::fail(config::ExitCode::settings, {checkpoint.parent_path().string()},
                     "parts of a run with other settings, inputs or version",
                     "the folder of a shard with the same settings and inputs");
    }
}

}  // namespace coupling
