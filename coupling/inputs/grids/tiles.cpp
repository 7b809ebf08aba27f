#include "coupling/inputs/grids/tiles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "config/text/reading.hpp"
#include "coupling/inputs/files/files_beside.hpp"
#include "coupling/inputs/files/path_checks.hpp"
#include "coupling/inputs/grids/grid_file.hpp"
#include "coupling/inputs/grids/tile_names.hpp"
#include "coupling/inputs/systems/coordinate_systems.hpp"
#include "coupling/inputs/systems/same_system.hpp"
#include "coupling/inputs/tables/words.hpp"

namespace coupling::grids {
namespace {

using config::joined;

/// Tiles of one survey differ by less where they overlap [choice].
constexpr double slight_difference_m = 0.1;
/// Two surveys of one ground differ by less on average; a surface of crowns or another unit by more [choice].
constexpr double most_mean_difference_m = 5.0;

config::Problem problem(std::string file, std::string found, std::string expected, std::string advice = "") {
    return {
        config::ExitCode::data, {std::move(file)}, std::move(found), std::move(expected), std::move(advice)};
}

/// Tiles that names lead to, and the virtual raster that lists them.
struct Tiles {
    std::vector<TileName> list;
    std::optional<VirtualRaster> raster;
    std::string title;  ///< what messages call all of them
    std::vector<std::string> notes;
};

/// Puts the tiles of a name on a list; false where the name leads to a single grid, whose bytes stay open.
class Finder {
public:
    Finder(const config::Place& asked_at, const GridFiles& files) : asked_at_{asked_at}, files_{files} {}

    Tiles find(const std::vector<std::string>& names) {
        Tiles tiles;
        tiles.title = files_.shown(names.front());
        if (names.size() > 1) {
            tiles.title += joined(" (+", std::to_string(names.size() - 1), ")");
        }
        for (const std::string& name : names) {
            take(name, names.size() == 1, tiles);
        }
        return tiles;
    }
    /// The bytes of the only file, where it is a grid.
    std::optional<FileBytes> grid{};

private:
    void take(const std::string& name, bool is_only, Tiles& tiles) {
        if (is_folder(files_.path(name))) {
            take_folder(name, tiles);
            return;
        }
        if (!is_only && is_tile_name(name)) {
            tiles.list.push_back({name, asked_at_});
            return;
        }
        FileBytes bytes = files_.open(name, asked_at_, false);
        if (is_virtual_raster(bytes.text())) {
            if (!is_only) {
                config::fail(
                    config::ExitCode::data, asked_at_,
                    joined("the virtual raster ", path_in_quotes(files_.shown(name)), " among other files"),
                    "one virtual raster, or tiles", "name its tiles, or it alone");
            }
            tiles.raster = read_virtual_raster(bytes.text(), files_.shown(name));
            tiles.list = tiles_of_vrt(*tiles.raster, name, files_.shown(name));
        } else if (is_list_of_tiles(bytes.text())) {
            std::vector<TileName> listed = tiles_of_list(bytes.text(), name, files_.shown(name));
            tiles.list.insert(tiles.list.end(), listed.begin(), listed.end());
        } else if (is_only) {
            grid = std::move(bytes);
        } else {
            tiles.list.push_back({name, asked_at_});
        }
    }
    void take_folder(const std::string& name, Tiles& tiles) {
        FolderOfTiles folder = tiles_of_folder(name, files_.path(name), asked_at_);
        tiles.list.insert(tiles.list.end(), folder.tiles.begin(), folder.tiles.end());
        if (folder.others > 0) {
            tiles.notes.push_back(joined(files_.shown(name), ": ", counted(folder.others, "other file"),
                                         " in the folder of tiles, such as ", path_in_quotes(folder.other),
                                         ", passed over"));
        }
    }

    const config::Place& asked_at_;
    const GridFiles& files_;
};

/// A mosaic on its way: heads, plan, cells.
class Reader {
public:
    Reader(Tiles tiles, GridValues values, const GridFiles& files)
        : tiles_{std::move(tiles)}, values_{values}, files_{files} {
        read_.notes = std::move(tiles_.notes);
        read_.is_mosaic = true;
    }

    ReadGrid read(const std::optional<MapWindow>& window) {
        MosaicPlan plan = plan_mosaic(places());
        if (tiles_.raster) {
            plan = within_raster(std::move(plan));
        }
        const std::size_t all = tiles_.list.size();
        if (window) {
            plan = plan_of(std::move(plan), cells_in(plan.frame, *window, tiles_.title));
        }
        if (plan.tiles.empty()) {
            config::fail(config::ExitCode::data, {tiles_.title}, "no tile within terrain.extent_m",
                         "a part of the map that tiles reach", "correct terrain.extent_m");
        }
        record_others(plan);
        Mosaic mosaic{plan, tiles_.title};
        for (std::size_t i = 0; i < plan.tiles.size(); ++i) {
            mosaic.lay(i, cells_of(plan.tiles[i]));
        }
        judge_overlap(mosaic.overlap(), plan);
        judge_gaps(gaps_of(plan), plan);
        read_.notes.push_back(
            joined(tiles_.title, ": ", counted(plan.tiles.size(), "tile"),
                   plan.tiles.size() < all ? joined(" of ", std::to_string(all)) : std::string{},
                   " laid side by side, ", to_string(plan.frame)));
        read_.raster = std::move(mosaic).taken();
        return std::move(read_);
    }

private:
    /// Tiles of which no cell is taken are inputs too: their places decide where cells lie.
    void record_others(const MosaicPlan& plan) {
        std::vector<bool> is_laid(tiles_.list.size());
        for (const TilePlace& place : plan.tiles) {
            is_laid[place.number] = true;
        }
        for (std::size_t number = 0; number < tiles_.list.size(); ++number) {
            const TileName& tile = tiles_.list[number];
            if (!is_laid[number]) {
                (void)files_.open(tile.name, tile.asked_at, true);
                (void)read_grid_head(files_.path(tile.name), tile.asked_at, files_.shown(tile.name),
                                     files_.beside(tile.name, true));
            }
        }
    }
    /// Reads the heads of all tiles and compares their systems. A file that is named twice counts once.
    std::vector<TilePlace> places() {
        std::vector<TilePlace> places;
        std::sort(tiles_.list.begin(), tiles_.list.end(), [](const TileName& a, const TileName& b) {
            return a.name != b.name ? a.name < b.name : a.asked_at.line < b.asked_at.line;
        });
        const auto is_same = [](const TileName& a, const TileName& b) {
            return a.name == b.name && !a.part && !b.part;
        };
        tiles_.list.erase(std::unique(tiles_.list.begin(), tiles_.list.end(), is_same), tiles_.list.end());
        std::string with_system;
        for (const TileName& tile : tiles_.list) {
            FilesBeside beside{files_.path(tile.name)};
            const std::string shown = files_.shown(tile.name);
            const formats::GridHead head =
                read_grid_head(files_.path(tile.name), tile.asked_at, shown, beside.bytes());
            compare_system(head.projection, shown, with_system);
            places.push_back({shown, part_of(head.frame, tile, shown), places.size(), {}});
        }
        if (tiles_.raster && !tiles_.raster->system.empty()) {
            compare_system(tiles_.raster->system, tiles_.title, with_system);
        }
        return places;
    }
    void compare_system(const std::string& system, const std::string& file, std::string& first_file) {
        if (const auto unit =
                values_ == GridValues::heights ? plausible::height_unit_in(system) : std::nullopt) {
            if (const auto wrong = plausible::contradiction_of_heights(*unit)) {
                config::fail(config::ExitCode::data, {file}, wrong->found, wrong->expected, wrong->advice);
            }
        }
        if (read_.projection.empty()) {
            read_.projection = system;
            first_file = file;
            return;
        }
        if (plausible::compare_systems(read_.projection, system) == plausible::Sameness::other) {
            config::fail(config::ExitCode::data, {file},
                         joined("coordinates in ", plausible::name_of_system(system)),
                         joined("those of ", first_file, ", ", plausible::name_of_system(read_.projection)),
                         "take tiles of one system: grids are never resampled here");
        }
    }
    /// The cells of a tile that its virtual raster takes.
    config::GridFrame part_of(const config::GridFrame& frame, const TileName& tile,
                              const std::string& shown) {
        if (!tile.part) {
            return frame;
        }
        const CellWindow& from = tile.part->from;
        if (from.first.column + from.columns > frame.columns || from.first.row + from.rows > frame.rows) {
            config::fail(config::ExitCode::data, {shown}, to_string(frame),
                         joined("at least the ", std::to_string(from.first.column + from.columns), " x ",
                                std::to_string(from.first.row + from.rows), " cells that ",
                                tile.asked_at.file, " takes of it"),
                         "make the virtual raster again (gdalbuildvrt)");
        }
        config::GridFrame part = grids::frame_of(frame, from);
        const config::GridFrame& whole = tiles_.raster->frame;
        const double x_m = whole.x_west_m + tile.part->to.column * whole.cell_width_m;
        const double y_m = whole.y_north_m() - tile.part->to.row * whole.cell_height_m;
        constexpr double slack = 0.01;
        // Over the whole raster, so that no small difference adds up.
        const bool has_other_cells =
            std::abs(whole.cell_width_m - part.cell_width_m) * whole.columns > slack * part.cell_width_m ||
            std::abs(whole.cell_height_m - part.cell_height_m) * whole.rows > slack * part.cell_height_m;
        if (has_other_cells || std::abs(x_m - part.x_west_m) > slack * part.cell_width_m ||
            std::abs(y_m - part.y_north_m()) > slack * part.cell_height_m) {
            config::fail(config::ExitCode::data, {shown},
                         joined(has_other_cells ? "other cells than " : "another place than ",
                                tile.asked_at.file, " gives it"),
                         "one place and size of cells for each tile",
                         "make the virtual raster again (gdalbuildvrt), or write it out (gdal_translate "
                         "IN.vrt dem.tif)");
        }
        return part;
    }
    /// The plan on the cells of the virtual raster, which may cut its tiles or reach beyond them.
    MosaicPlan within_raster(MosaicPlan plan) const {
        const config::GridFrame& whole = tiles_.raster->frame;
        const auto steps = [](double from_m, double to_m, double cell_m) {
            return static_cast<int>(std::round((to_m - from_m) / cell_m));
        };
        const CellWindow cells{{steps(plan.frame.x_west_m, whole.x_west_m, plan.frame.cell_width_m),
                                steps(whole.y_north_m(), plan.frame.y_north_m(), plan.frame.cell_height_m)},
                               whole.columns,
                               whole.rows};
        return plan_of(std::move(plan), cells);
    }
    /// Reads the cells of a tile.
    config::Raster<double> cells_of(const TilePlace& place) {
        const TileName& tile = tiles_.list[place.number];
        const FileBytes bytes = files_.open(tile.name, tile.asked_at, true);
        formats::PlacedGrid grid = read_grid_file(bytes.text(), place.file, files_.beside(tile.name, true));
        for (const std::string& remark : grid.remarks) {
            read_.notes.push_back(joined(place.file, ": ", remark));
        }
        if (tile.part) {
            for (double& value : grid.raster.values) {
                const bool is_none =
                    std::find(tile.part->none.begin(), tile.part->none.end(), value) != tile.part->none.end();
                value = is_none ? std::numeric_limits<double>::quiet_NaN() : value;
            }
            return cut_out(grid.raster, tile.part->from);
        }
        return std::move(grid.raster);
    }
    void judge_overlap(const MosaicOverlap& overlap, const MosaicPlan& plan) {
        if (overlap.different == 0) {
            return;
        }
        const std::string largest = config::to_text(std::round(1000.0 * overlap.largest) / 1000.0);
        const std::string found =
            joined(counted(overlap.different, "cell"), " of ", std::to_string(overlap.cells),
                   " in which tiles overlap with different values, by up to ", largest, " in ",
                   cell_in_words(plan.frame, overlap.first));
        const double mean = overlap.sum_of_differences / static_cast<double>(overlap.cells);
        if (values_ == GridValues::heights && mean > most_mean_difference_m) {
            config::fail(
                config::ExitCode::data, {overlap.file}, found, "heights of one ground",
                "take tiles of one model of the ground alone (no surface of crowns and roofs), in one unit");
        }
        if (values_ == GridValues::heights && overlap.largest <= slight_difference_m) {
            read_.notes.push_back(
                joined(overlap.file, ": ", found, "; the northern tile counts, then the western"));
        } else {
            read_.warnings.push_back(
                problem(overlap.file, found, "one value for each cell",
                        "the northern tile counts, then the western: take the others out if "
                        "they are older"));
        }
    }
    void judge_gaps(const MosaicGaps& gaps, const MosaicPlan& plan) {
        if (gaps.between > 0) {
            read_.warnings.push_back(problem(
                tiles_.title,
                joined(counted(gaps.between, "cell"), " between the tiles that none of them reaches, from ",
                       cell_in_words(plan.frame, gaps.first_between), " on"),
                "tiles side by side", "add the missing tiles; rocks that come there leave the terrain"));
        }
        if (gaps.beside > 0) {
            read_.notes.push_back(joined(tiles_.title, ": ", counted(gaps.beside, "cell"),
                                         " beside the tiles, which make no rectangle, are NODATA"));
        }
    }

    Tiles tiles_;
    GridValues values_;
    const GridFiles& files_;
    ReadGrid read_;
};

ReadGrid single_grid(const std::string& name, const FileBytes& bytes, const std::optional<MapWindow>& window,
                     const GridFiles& files) {
    const std::string shown = files.shown(name);
    formats::PlacedGrid grid = read_grid_file(bytes.text(), shown, files.beside(name, false));
    ReadGrid read{std::move(grid.raster), std::move(grid.projection), {}, {}, false};
    for (const std::string& remark : grid.remarks) {
        read.notes.push_back(joined(shown, ": ", remark));
    }
    if (window) {
        const CellWindow cells = cells_in(read.raster.frame, *window, shown);
        if (cells.columns < read.raster.frame.columns || cells.rows < read.raster.frame.rows) {
            read.raster = cut_out(read.raster, cells);
            read.notes.push_back(joined(shown, ": cut to terrain.extent_m, ", to_string(read.raster.frame)));
        }
    }
    return read;
}

}  // namespace

ReadGrid read_grid(const std::vector<std::string>& names, const config::Place& asked_at, GridValues values,
                   const std::optional<MapWindow>& window, const GridFiles& files) {
    Finder finder{asked_at, files};
    Tiles tiles = finder.find(names);
    if (finder.grid) {
        return single_grid(names.front(), *finder.grid, window, files);
    }
    return Reader{std::move(tiles), values, files}.read(window);
}

}  // namespace coupling::grids
