#include "coupling/assessments/today/pieces.hpp"

#include <algorithm>
#include <set>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/files/path_checks.hpp"
#include "coupling/run/output_folder.hpp"

namespace coupling {
namespace {

using config::joined;

namespace fs = std::filesystem;

constexpr std::string_view before_number = "piece_";
constexpr std::string_view before_count = "_of_";

/// What the name of a folder says; nothing for other names.
std::optional<Piece> piece_named(const std::string& name) {
    const auto of = name.find(before_count);
    if (!name.starts_with(before_number) || of == std::string::npos) {
        return std::nullopt;
    }
    const auto number = config::parse_whole(name.substr(before_number.size(), of - before_number.size()));
    const auto count = config::parse_whole(name.substr(of + before_count.size()));
    constexpr long long most = 1'000'000'000;
    if (!number || !count || *number < 1 || *count < *number || *count > most) {
        return std::nullopt;
    }
    return Piece{static_cast<std::uint32_t>(*number - 1), static_cast<std::uint32_t>(*count)};
}

}  // namespace

std::span<const rockfall::Chunk> chunks_of(std::span<const rockfall::Chunk> chunks, const Piece& piece) {
    if (chunks.empty()) {
        return chunks;
    }
    const std::uint64_t rocks = chunks.back().last_rock;
    // The first chunk at or after a share of the rocks that begins a source.
    const auto begin_of = [&](std::uint32_t number) {
        if (number == piece.count) {
            return chunks.size();
        }
        const double share = static_cast<double>(number) / static_cast<double>(piece.count);
        const auto wanted = static_cast<std::uint64_t>(share * static_cast<double>(rocks));
        std::size_t i = 0;
        while (i < chunks.size() && (chunks[i].first_rock < wanted ||
                                     (i > 0 && !chunks[i - 1].whole_sources && !chunks[i - 1].last_piece))) {
            ++i;
        }
        return i;
    };
    const std::size_t begin = begin_of(piece.number);
    return chunks.subspan(begin, begin_of(piece.number + 1) - begin);
}

fs::path folder_of(const fs::path& parts, const Piece& piece) {
    return parts /
           joined(before_number, std::to_string(piece.number + 1), before_count, std::to_string(piece.count));
}

std::optional<std::uint32_t> pieces_in(const fs::path& parts) {
    std::set<std::uint32_t> counts;
    std::error_code error;
    for (fs::directory_iterator entry{parts, error}, end; !error && entry != end; entry.increment(error)) {
        const std::optional<Piece> piece = piece_named(entry->path().filename().string());
        if (piece && is_there(OutputFolder::checkpoint_of(entry->path()))) {
            counts.insert(piece->count);
        }
    }
    if (counts.size() > 1) {
        config::fail(
            config::ExitCode::settings, {parts.string()},
            joined("pieces of runs in ", std::to_string(*counts.begin()), " and in ",
                   std::to_string(*counts.rbegin()), " pieces"),
            "the same number of shards and processes for all; --overwrite starts from the beginning");
    }
    return counts.empty() ? std::nullopt : std::optional{*counts.begin()};
}

std::vector<fs::path> all_pieces(std::span<const fs::path> folders_of_parts) {
    std::set<std::uint32_t> counts;
    for (const fs::path& parts : folders_of_parts) {
        const std::optional<std::uint32_t> count = pieces_in(parts);
        if (!count) {
            config::fail(config::ExitCode::file, {parts.string()}, "no parts in this folder",
                         "the --out folder of a shard");
        }
        counts.insert(*count);
    }
    if (counts.size() > 1) {
        config::fail(config::ExitCode::settings, {folders_of_parts.front().string()},
                     joined("shards of runs in ", std::to_string(*counts.begin()), " and in ",
                            std::to_string(*counts.rbegin()), " pieces"),
                     "the shards of one run");
    }
    const std::uint32_t count = *counts.begin();
    std::vector<fs::path> pieces;
    for (std::uint32_t number = 0; number < count; ++number) {
        const auto found =
            std::find_if(folders_of_parts.begin(), folders_of_parts.end(), [&](const fs::path& parts) {
                return is_there(OutputFolder::checkpoint_of(folder_of(parts, {number, count})));
            });
        if (found == folders_of_parts.end()) {
            config::fail(
                config::ExitCode::file, {},
                joined("no piece ", std::to_string(number + 1), " of ", std::to_string(count)),
                "the folders of all shards",
                joined("name the folder of that shard, too; with one process for each, `bannwald run "
                       "SCENARIO --shard ",
                       std::to_string(number + 1), "/", std::to_string(count), " --out DIR` simulates it"));
        }
        pieces.push_back(folder_of(*found, {number, count}));
    }
    return pieces;
}

}  // namespace coupling
