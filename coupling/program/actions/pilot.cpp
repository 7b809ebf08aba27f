#include "coupling/program/actions/pilot.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <vector>

#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/inputs/site_falls.hpp"

namespace coupling {
namespace {

/// A pilot ends after this CPU time, but not before it has seen a few rocks [choice].
constexpr double enough_s = 1.0;
constexpr std::uint64_t least_rocks = 8;
constexpr std::uint64_t most_rocks = 2048;

/// Cells of larger maps are taken together to those of the tiles of distributions: maps for so many cells
/// take long to set up, and the pilot needs no more than the tiles.
constexpr std::size_t most_cells = 1'000'000;

bool has_tiles_as_cells(const config::GridFrame& frame) {
    return frame.size() > most_cells;
}

config::GridFrame frame_of_pilot(const config::GridFrame& frame) {
    if (!has_tiles_as_cells(frame)) {
        return frame;
    }
    constexpr auto side = static_cast<int>(rockfall::histogram_tile_side);
    config::GridFrame tiles = frame;
    tiles.columns = (frame.columns + side - 1) / side;
    tiles.rows = (frame.rows + side - 1) / side;
    tiles.cell_width_m *= side;
    tiles.cell_height_m *= side;
    return tiles;
}

/// Tiles with a marked cell, of both slopes together.
double tiles_of(const rockfall::FedCells& fed, const config::GridFrame& frame, bool tiles_as_cells) {
    const std::vector<std::uint8_t> marks = fed.marks();
    if (tiles_as_cells) {
        return static_cast<double>(std::count(marks.begin(), marks.end(), std::uint8_t{1}));
    }
    const std::size_t side = rockfall::histogram_tile_side;
    const auto columns = static_cast<std::size_t>(frame.columns);
    const std::size_t tile_columns = (columns + side - 1) / side;
    const std::size_t tiles = tile_columns * ((static_cast<std::size_t>(frame.rows) + side - 1) / side);
    std::vector<bool> touched(rockfall::covers * tiles);
    for (std::size_t i = 0; i < marks.size(); ++i) {
        if (marks[i] != 0) {
            const std::size_t cell = i % frame.size();
            touched[i / frame.size() * tiles + cell / columns / side * tile_columns + cell % columns / side] =
                true;
        }
    }
    return static_cast<double>(std::count(touched.begin(), touched.end(), true));
}

/// A chunk of a single rock.
rockfall::Chunk chunk_of(std::span<const rockfall::ReleaseSource> sources, std::uint64_t rock) {
    const auto behind = std::upper_bound(sources.begin(), sources.end(), rock,
                                         [](std::uint64_t number, const rockfall::ReleaseSource& source) {
                                             return number < source.first_rock;
                                         });
    const auto source = static_cast<std::uint32_t>(behind - sources.begin()) - 1;
    return {source, source + 1, rock, rock + 1, false, false};
}

/// The k-th of rocks in an order that is spread evenly however early it ends: steps of the golden section.
std::uint64_t spread(std::uint64_t k, std::uint64_t rocks) {
    constexpr double golden = 0.6180339887498949;
    const double share = std::fmod(static_cast<double>(k) * golden, 1.0);
    return std::min(rocks - 1, static_cast<std::uint64_t>(share * static_cast<double>(rocks)));
}

/// Tiles of so many rocks from those of 1, 2, 4, ...: each doubling adds a smaller share than the one before,
/// by the same factor as at the end of the pilot.
double tiles_of_all(const std::vector<double>& tiles, std::uint64_t rocks) {
    if (tiles.size() < 3 || !(tiles[tiles.size() - 3] > 0.0)) {
        return tiles.empty() ? 0.0 : tiles.back() * static_cast<double>(rocks);
    }
    const auto growth_before = [&](std::size_t from_end) {
        return std::log2(tiles[tiles.size() - from_end] / tiles[tiles.size() - from_end - 1]);
    };
    const double factor =
        growth_before(2) > 0.0 ? std::clamp(growth_before(1) / growth_before(2), 0.0, 1.0) : 0.0;
    double doublings = std::log2(static_cast<double>(rocks)) - static_cast<double>(tiles.size() - 1);
    double found = tiles.back();
    for (double growth = growth_before(1) * factor; doublings > 0.0; --doublings, growth *= factor) {
        found *= std::exp2(growth * std::min(1.0, doublings));
    }
    return found;
}

}  // namespace

double process_cpu_s() {
    return static_cast<double>(std::clock()) / static_cast<double>(CLOCKS_PER_SEC);
}

PilotFalls pilot_falls(const Scenario& scenario, const Site& site, const std::function<double()>& clock_s) {
    const std::uint64_t rocks = site.rocks();
    if (rocks == 0) {
        return {};
    }
    const config::GridFrame whole = site.map_frame_on_terrain();
    const bool tiles_as_cells = has_tiles_as_cells(whole);
    const config::GridFrame frame = frame_of_pilot(whole);
    const SiteFalls falls{scenario, site, frame};
    rockfall::FedCells fed{frame.size()};
    rockfall::ChunkRows rows;
    rockfall::Worker worker{falls.assessment, {nullptr, nullptr}};
    const std::uint64_t most = std::min(rocks, most_rocks);
    std::vector<double> tiles;  // after 1, 2, 4, ... rocks
    const double begin_s = clock_s();
    std::uint64_t done = 0;
    while (done < most && (done < least_rocks || clock_s() - begin_s < enough_s)) {
        rows.clear();
        worker.run(chunk_of(site.sources, spread(done, rocks)), rows, &fed, {});
        ++done;
        if (done == std::uint64_t{1} << tiles.size()) {
            tiles.push_back(tiles_of(fed, frame, tiles_as_cells));
        }
    }
    return {(clock_s() - begin_s) / static_cast<double>(done), tiles_of_all(tiles, rocks)};
}

}  // namespace coupling
