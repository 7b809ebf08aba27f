#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "config/text/joined.hpp"
#include "coupling/assessments/compare/page/parts.hpp"
#include "coupling/inputs/files/path_checks.hpp"
#include "coupling/results/maps/rasters.hpp"
#include "coupling/results/maps/read_raster.hpp"
#include "coupling/results/report/map/blocks.hpp"
#include "coupling/results/report/map/map_colours.hpp"
#include "coupling/results/report/map/map_furniture.hpp"
#include "coupling/results/report/map/map_sheet.hpp"
#include "coupling/results/report/map/png.hpp"
#include "coupling/results/text/element.hpp"
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

/// Draws a raster with its colours, a scale bar and north.
std::string sheet_of(const Raster<float>& raster, const ColourScale& scale, const std::string& title) {
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
    // Blocks at the eastern and southern rim reach over it.
    const double over_x = static_cast<double>(shown.frame.columns * block) / frame.columns;
    const double over_y = static_cast<double>(shown.frame.rows * block) / frame.rows;
    const std::string image =
        report::element("image", {{"width", sheet.width * over_x},
                                  {"height", sheet.height * over_y},
                                  {"preserveAspectRatio", "none"},
                                  {"href", report::data_address(report::png(picture))}});
    const std::string rim =
        report::element("rect", {{"class", "neat"}, {"width", sheet.width}, {"height", sheet.height}});
    return report::element(
        "svg",
        {{"class", "sheet"},
         {"viewBox", joined("0 0 ", report::place(sheet.width), " ", report::place(sheet.height))},
         {"role", "img"},
         {"aria-label", title}},
        joined(image, rim, report::scale_bar(sheet), report::north_arrow(sheet)));
}

struct ShownMap {
    const char* stem;
    const char* name;
    const char* meaning;
    bool is_detail;  ///< not printed
};
constexpr std::array shown_maps{
    ShownMap{"Reach_probability", "Reach probability",
             "Rocks that pass a cell, in percent of all rocks from the sources that feed it; colours by "
             "powers of ten.",
             false},
    ShownMap{"E_95", "Energy, 95th percentile",
             "Of the largest kinetic energy of each rock in a cell: one rock in twenty has more.", false},
    ShownMap{"V_max", "Highest speed", "Of any rock in a cell.", true},
    ShownMap{"Ph_95", "Passing height, 95th percentile",
             "Underside of the rocks above the ground: one rock in twenty is higher.", true},
    ShownMap{"Nr_deposited", "Where rocks come to rest", "Rocks in a cell; colours by powers of ten.", true}};

/// A quantity in all runs; nothing where no run has it.
std::optional<report::PageFields> quantity_of(const ShownMap& shown, const std::string& cover,
                                              std::span<const FinishedRun> runs, const SideBySide& comparison,
                                              int& legends) {
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
        return std::nullopt;
    }
    const ColourScale scale = report::scale_for(raster_kind(shown.stem), range);
    const std::string& name = report::page_text(shown.name);
    std::vector<report::PageFields> sheets;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        if (rasters[i]) {
            const std::string title = report::with_label(comparison.letters[i], name);
            sheets.push_back({{"title", title},
                              {"drawing", sheet_of(*rasters[i], scale, title)},
                              {"legend", scale.legend(joined("compare-ramp", std::to_string(++legends)))}});
        }
    }
    return report::PageFields{{"quantity", name},
                              {"meaning", report::page_text(shown.meaning)},
                              {"is_detail", shown.is_detail},
                              {"sheets", sheets}};
}

}  // namespace

std::optional<report::PageFields> maps(std::span<const FinishedRun> runs, const SideBySide& comparison) {
    if (runs.front().summary.kind != "today") {
        return std::nullopt;
    }
    std::vector<report::PageFields> slopes;
    int legends = 0;
    for (const char* cover : {"forest", "bare"}) {
        std::vector<report::PageFields> quantities;
        for (const ShownMap& shown : shown_maps) {
            if (auto quantity = quantity_of(shown, cover, runs, comparison, legends)) {
                quantities.push_back(std::move(*quantity));
            }
        }
        if (!quantities.empty()) {
            slopes.push_back({{"slope", slope_title(cover)}, {"quantities", quantities}});
        }
    }
    return part_if_any("slopes", slopes);
}

}  // namespace coupling::compare
