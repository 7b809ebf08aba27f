#include "coupling/inputs/grids/tile_names.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "config/text/joined.hpp"
#include "config/text/reading.hpp"
#include "coupling/inputs/files/file_part.hpp"
#include "coupling/inputs/files/path_checks.hpp"
#include "coupling/inputs/formats/file_kinds.hpp"
#include "coupling/inputs/grids/grid_file.hpp"

namespace coupling::grids {
namespace {

namespace fs = std::filesystem;
using config::joined;

constexpr std::array tile_endings{".tif", ".tiff", ".asc", ".xyz", ".flt", ".bil"};
/// What belongs to a tile or describes it. A text may hold heights itself.
constexpr std::array endings_beside{".prj", ".hdr", ".tfw", ".tifw", ".tiffw", ".wld",
                                    ".xml", ".ovr", ".qml", ".pdf",  ".html",  ".md"};

std::string lower_name_without_gz(const std::string& name) {
    std::string low = config::in_lower_case(name);
    if (low.ends_with(".gz")) {
        low.erase(low.size() - 3);
    }
    return low;
}

template <class Endings>
bool ends_with_any(const std::string& low, const Endings& endings) {
    return std::any_of(endings.begin(), endings.end(),
                       [&](const char* ending) { return low.ends_with(ending); });
}

/// A name from the folder of another file.
std::string name_beside(const std::string& name, const std::string& of_file) {
    return fs::path{name}.is_absolute() ? name : (fs::path{of_file}.parent_path() / name).generic_string();
}

/// What a folder without tiles holds and what to do with it.
[[noreturn]] void refuse_folder(const std::vector<fs::path>& entries, const std::string& name,
                                const config::Place& asked_at) {
    std::string found = joined("the folder ", path_in_quotes(name), " without a grid");
    std::string advice = "name the folder that holds the tiles";
    for (const fs::path& entry : entries) {
        if (is_folder(entry)) {
            found += joined("; the folder ", path_in_quotes(entry.filename()), " in it is not looked into");
            break;
        }
        const std::string beginning = FilePart{entry, asked_at, "a grid"}.beginning(std::size_t{1} << 16U);
        if (const formats::FileKind* kind = formats::other_file_kind(beginning, entry.filename().string())) {
            found += joined(", but with ", path_in_quotes(entry.filename()), ": ", kind->name);
            advice = kind->way_out;
            break;
        }
    }
    config::fail(config::ExitCode::data, asked_at, std::move(found),
                 "tiles: .tif, .asc, .xyz, .flt or .bil, perhaps with .gz behind", std::move(advice));
}

}  // namespace

bool is_tile_name(const std::string& name) {
    return ends_with_any(lower_name_without_gz(name), tile_endings);
}

FolderOfTiles tiles_of_folder(const std::string& name, const fs::path& path, const config::Place& asked_at) {
    FolderOfTiles folder;
    const std::vector<fs::path> entries = entries_of(path);
    for (const fs::path& entry : entries) {
        const std::string file = entry.filename().string();
        if (file.starts_with('.')) {
            continue;
        }
        if (is_tile_name(file) && !is_folder(entry)) {
            folder.tiles.push_back({(fs::path{name} / file).generic_string(), asked_at});
        } else if (is_folder(entry) || !ends_with_any(lower_name_without_gz(file), endings_beside)) {
            folder.other = folder.others++ == 0 ? file : folder.other;
        }
    }
    if (folder.tiles.empty()) {
        refuse_folder(entries, name, asked_at);
    }
    return folder;
}

bool is_list_of_tiles(std::string_view text) {
    constexpr std::size_t longest_name = 4096;
    text = config::without_byte_order_mark(text);
    bool any = false;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = config::trimmed(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
        if (line.empty() || line.starts_with('#')) {
            continue;
        }
        if (line.size() > longest_name || line.find('\0') != std::string_view::npos ||
            !is_tile_name(std::string{line})) {
            return false;
        }
        any = true;
    }
    return any;
}

std::vector<TileName> tiles_of_list(std::string_view text, const std::string& name,
                                    const std::string& shown) {
    text = config::without_byte_order_mark(text);
    std::vector<TileName> tiles;
    for (std::size_t number = 1; !text.empty(); ++number) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string line{config::trimmed(text.substr(0, end))};
        text.remove_prefix(std::min(end + 1, text.size()));
        if (!line.empty() && !line.starts_with('#')) {
            tiles.push_back({name_beside(line, name), {shown, number}});
        }
    }
    return tiles;
}

std::vector<TileName> tiles_of_vrt(const VirtualRaster& raster, const std::string& name,
                                   const std::string& shown) {
    std::vector<TileName> tiles;
    for (const VrtSource& source : raster.sources) {
        tiles.push_back({name_beside(source.file, name), {shown, source.line}, source});
    }
    return tiles;
}

}  // namespace coupling::grids
