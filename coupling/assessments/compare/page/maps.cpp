#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "config/text/joined.hpp"
#include "coupling/assessments/compare/page/parts.hpp"
#include "coupling/inputs/files/path_checks.hpp"
#include "coupling/results/maps/rasters.hpp"
#include "coupling/results/maps/read_raster.hpp"
#include "coupling/results/report/map/map_colours.hpp"
#include "coupling/results/report/map/map_furniture.hpp"
#include "coupling/results/report/map/map_sheet.hpp"
#include "coupling/results/report/map/png.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"
#include "coupling/run/file_sums.hpp"

namespace coupling::compare {
namespace {

using config::joined;
using config::Raster;
using report::ColourScale;

constexpr double sheet_width = 1000.0;
/// Cells a side that a picture shows at most.
constexpr int most_cells = 400;

std::optional<Raster<float>> raster_of(const FinishedRun& run, const std::string& cover, const char* stem) {
    const std::filesystem::path path = run.folder / "rasters" / cover / joined(stem, ".asc");
    refuse_changed(run.folder, joined("rasters/", cover, "/", stem, ".asc"));
    if (!path_exists(path)) {
        return std::nullopt;
    }
    return report::without_zeros(read_raster(path));
}

std::string figure(const Raster<float>& raster, const ColourScale& scale, const std::string& title,
                   const std::string& legend) {
    const config::GridFrame& frame = raster.frame;
    const int block = (std::max(frame.columns, frame.rows) + most_cells - 1) / most_cells;
    const Raster<float> shown = report::in_blocks(raster, block);
    report::IndexedPicture picture{shown.frame.columns, shown.frame.rows,
                                   std::vector<std::uint8_t>(shown.values.size()), scale.palette()};
    std::transform(shown.values.begin(), shown.values.end(), picture.pixels.begin(),
                   [&](float value) { return scale.index_of(value); });
    const double width_m = frame.x_east_m() - frame.x_west_m;
    const double height_m = frame.y_north_m() - frame.y_south_m;
    const report::SheetSize sheet{.width = sheet_width,
                                  .height = sheet_width * height_m / width_m,
                                  .units_per_m = sheet_width / width_m,
                                  .lettering = 36.0};
    using report::attribute;
    // Blocks at the eastern and southern rim reach over it.
    const double over_x = static_cast<double>(shown.frame.columns * block) / frame.columns;
    const double over_y = static_cast<double>(shown.frame.rows * block) / frame.rows;
    return joined(
        "<figure class=\"map\"><h4>", title, "</h4><svg class=\"sheet\" viewBox=\"0 0 ",
        report::place(sheet.width), " ", report::place(sheet.height), "\" role=\"img\" aria-label=\"", title,
        "\"><image", attribute("width", sheet.width * over_x), attribute("height", sheet.height * over_y),
        " preserveAspectRatio=\"none\" href=\"", report::data_address(report::png(picture)),
        "\"/><rect class=\"neat\"", attribute("width", sheet.width), attribute("height", sheet.height), "/>",
        report::scale_bar(sheet), report::north_arrow(sheet), "</svg>", legend, "</figure>");
}

struct ShownMap {
    const char* stem;
    const char* name;
    const char* meaning;
};
constexpr std::array shown_maps{
    ShownMap{"Reach_probability", "Reach probability",
             "Rocks that pass a cell, in percent of all rocks from the sources that feed it; colours by "
             "powers of ten."},
    ShownMap{"E_95", "Energy, 95th percentile",
             "Of the largest kinetic energy of each rock in a cell: one rock in twenty has more."},
    ShownMap{"V_max", "Highest speed", "Of any rock in a cell."},
    ShownMap{"Ph_95", "Passing height, 95th percentile",
             "Underside of the rocks above the ground: one rock in twenty is higher."},
    ShownMap{"Nr_deposited", "Where rocks come to rest", "Rocks in a cell; colours by powers of ten."}};

std::string row(const ShownMap& shown, const std::string& cover, std::span<const FinishedRun> runs,
                const SideBySide& comparison, int& legends) {
    std::vector<std::optional<Raster<float>>> rasters;
    ValueRange range{std::numeric_limits<float>::infinity(), 0.0F};
    for (const FinishedRun& run : runs) {
        rasters.push_back(raster_of(run, cover, shown.stem));
        if (rasters.back()) {
            const ValueRange here = range_of(*rasters.back());
            range = {here.high > 0.0F ? std::min(range.low, here.low) : range.low,
                     std::max(range.high, here.high)};
        }
    }
    if (!(range.high > 0.0F)) {
        return "";
    }
    const ColourScale scale = report::scale_for(raster_kind(shown.stem), range);
    std::string figures;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        if (rasters[i]) {
            figures += figure(
                *rasters[i], scale,
                report::with_label(comparison.letters[i], report::escaped(report::page_text(shown.name))),
                scale.legend(joined("compare-ramp", std::to_string(++legends))));
        }
    }
    return joined("<h4>", report::escaped(report::page_text(shown.name)), "</h4><p class=\"soft\">",
                  report::escaped(report::page_text(shown.meaning)), "</p>\n<div class=\"thirds\">", figures,
                  "</div>\n");
}

}  // namespace

std::string maps(std::span<const FinishedRun> runs, const SideBySide& comparison) {
    if (runs.front().summary.kind != "today") {
        return "";
    }
    std::string html;
    int legends = 0;
    for (const char* cover : {"forest", "bare"}) {
        std::string rows;
        for (const ShownMap& shown : shown_maps) {
            rows += row(shown, cover, runs, comparison, legends);
        }
        if (!rows.empty()) {
            html += joined("<h3>",
                           std::string{cover} == "bare" ? report::page_text("Bare slope")
                                                        : report::page_text("With forest"),
                           "</h3>\n", rows);
        }
    }
    return html.empty()
               ? ""
               : joined("<h2>", report::page_text("Maps"), "</h2>\n<p class=\"soft\">",
                        report::page_text("A quantity has the same colours in all runs. North is up. The "
                                          "runs' own pages show them on hillshade with sources and targets."),
                        "</p>\n", html);
}

}  // namespace coupling::compare
