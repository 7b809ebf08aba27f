#include "coupling/inputs/grids/grid_file.hpp"

#include <algorithm>
#include <utility>

#include "config/grid/ascii_grid.hpp"
#include "config/text/gunzip.hpp"
#include "config/text/joined.hpp"
#include "config/text/reading.hpp"
#include "coupling/inputs/files/file_bytes.hpp"
#include "coupling/inputs/files/file_part.hpp"
#include "coupling/inputs/formats/tiff_bytes.hpp"
#include "coupling/inputs/grids/raw_grid.hpp"
#include "coupling/inputs/grids/xyz_grid.hpp"
#include "coupling/inputs/tables/point_file.hpp"

namespace coupling::grids {
namespace {

using config::joined;

/// Points of a grid; nothing for a text of other points.
std::optional<formats::PlacedGrid> grid_of_xyz(std::string_view bytes, const std::string& file,
                                               const formats::BytesBeside& beside) {
    tables::PointFile read = tables::read_point_file(bytes, file);
    std::optional<config::Raster<double>> grid = grid_of_points(read.points);
    if (!grid) {
        return std::nullopt;
    }
    formats::PlacedGrid placed{std::move(*grid), std::string{config::trimmed(beside(".prj"))}, {}};
    for (std::string& sentence : read.notes) {
        const std::string opening = joined(file, ": ");
        placed.remarks.push_back(sentence.starts_with(opening) ? sentence.substr(opening.size()) : sentence);
    }
    placed.remarks.emplace_back("points in rows and columns, taken as the centres of the cells of a grid");
    return placed;
}

/// Whether bytes are a text of points and nothing that is recognised by a signature.
bool is_text_of_points(std::string_view bytes) {
    return !formats::is_gis_raster(bytes) && !formats::is_gis_layer(bytes) &&
           !config::most_grid_bytes(bytes.substr(0, std::size_t{1} << 16U)) &&
           formats::is_list_of_points(bytes);
}

}  // namespace

formats::PlacedGrid read_grid_file(std::string_view bytes, const std::string& file,
                                   const formats::BytesBeside& beside) {
    if (is_raw_grid(file) && !bytes.empty()) {
        return {read_raw_grid(bytes, beside(".hdr"), file), std::string{config::trimmed(beside(".prj"))}, {}};
    }
    if (is_text_of_points(bytes)) {
        if (auto grid = grid_of_xyz(bytes, file, beside)) {
            return std::move(*grid);
        }
    }
    return formats::read_grid_file(bytes, file, beside);
}

formats::GridHead read_grid_head(const std::filesystem::path& path, const config::Place& asked_at,
                                 const std::string& file, const formats::BytesBeside& beside) {
    constexpr std::size_t beginning_bytes = std::size_t{1} << 16U;
    const FilePart part{path, asked_at, grid_expected};
    const std::string beginning = part.beginning(beginning_bytes);
    const auto system_beside = [&] { return std::string{config::trimmed(beside(".prj"))}; };
    if (is_raw_grid(file) && !beginning.empty()) {
        return {read_raw_frame(beside(".hdr"), file), system_beside()};
    }
    if (formats::is_tiff(beginning)) {
        formats::TiffBytes source{
            part.bytes(), [&](std::uint64_t at, char* to, std::size_t count) { part.read(at, to, count); }};
        formats::GridHead head = formats::read_geotiff_head(source, file, formats::world_file_beside(beside));
        if (head.projection.empty()) {
            head.projection = system_beside();
        }
        return head;
    }
    if (!config::is_gzip(beginning) && config::most_grid_bytes(beginning)) {
        return {config::read_ascii_frame(beginning, file), std::string{beside(".prj")}};
    }
    const FileBytes bytes = open_file(path, asked_at, grid_expected);
    formats::PlacedGrid grid = read_grid_file(bytes.text(), file, beside);
    return {grid.raster.frame, std::move(grid.projection)};
}

}  // namespace coupling::grids
