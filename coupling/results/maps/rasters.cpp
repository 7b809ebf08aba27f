#include "coupling/results/maps/rasters.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "config/grid/ascii_grid.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/maps/raster_style.hpp"
#include "rockfall/tally/cell_quantile.hpp"
#include "rockfall/tally/cell_spread.hpp"

namespace coupling {
namespace {

using rockfall::CellHistograms;
using rockfall::CellSums;

constexpr float no_value = std::numeric_limits<float>::quiet_NaN();
constexpr double per_kilo = 1e-3;

float mean_of(std::uint64_t sum, std::uint32_t count) {
    return static_cast<float>(static_cast<double>(sum) / count * per_kilo);
}

/// Percentiles never exceed the exact maximum that is kept beside the bins.
template <int percent>
float energy_percentile_kj(const CellSums& sums, const CellHistograms* histograms, std::size_t cell) {
    const double found_j = rockfall::cell_quantile(rockfall::energy_bins, histograms->energy(cell),
                                                   sums.passages, sums.energy_max_j, percent / 100.0);
    return static_cast<float>(std::min(found_j, static_cast<double>(sums.energy_max_j)) * per_kilo);
}

template <int percent>
float speed_percentile_mps(const CellSums& sums, const CellHistograms* histograms, std::size_t cell) {
    const double found_mps = rockfall::cell_quantile(rockfall::speed_bins, histograms->speed(cell),
                                                     sums.passages, sums.speed_max_mps, percent / 100.0);
    return std::min(static_cast<float>(found_mps), sums.speed_max_mps);
}

template <int percent>
float height_percentile_m(const CellSums& sums, const CellHistograms* histograms, std::size_t cell) {
    const double found_m = rockfall::cell_quantile(rockfall::height_bins, histograms->height(cell),
                                                   sums.passages, sums.height_max_m, percent / 100.0);
    return std::min(static_cast<float>(found_m), sums.height_max_m);
}

float reach_percent(const CellSums& sums, const CellHistograms*, std::size_t) {
    if (sums.fed_rocks == 0) {
        return no_value;
    }
    return static_cast<float>(std::min(100.0, 100.0 * sums.passages / static_cast<double>(sums.fed_rocks)));
}

float energy_line_angle_deg(const CellSums& sums, const CellHistograms*, std::size_t) {
    if (sums.passages == 0 || !std::isfinite(sums.energy_line_slope_min)) {
        return no_value;
    }
    return static_cast<float>(std::atan(static_cast<double>(sums.energy_line_slope_min)) * 180.0 /
                              std::numbers::pi);
}

void add_energy(std::vector<RasterKind>& kinds) {
    const auto add = [&](std::string_view stem, std::string_view meaning, bool percentile, bool compared,
                         auto value) {
        kinds.push_back({stem, "kJ", meaning, RasterStyle::energy_classes, Palette::deposits, percentile,
                         compared, value});
    };
    add("E_mean", "mean of the largest kinetic energy of each rock in the cell", false, true,
        [](const CellSums& s, const CellHistograms*, std::size_t) {
            return mean_of(s.energy_sum_j, s.passages);
        });
    add("E_50", "median of the largest energy of each rock in the cell", true, false,
        energy_percentile_kj<50>);
    add("E_90", "90th percentile of the largest energy of each rock in the cell", true, false,
        energy_percentile_kj<90>);
    add("E_95", "95th percentile of the largest energy of each rock in the cell", true, true,
        energy_percentile_kj<95>);
    add("E_98", "98th percentile of the largest energy of each rock in the cell", true, false,
        energy_percentile_kj<98>);
    add("E_99", "99th percentile of the largest energy of each rock in the cell", true, false,
        energy_percentile_kj<99>);
    add("E_max", "largest energy of all rocks in the cell", false, true,
        [](const CellSums& s, const CellHistograms*, std::size_t) { return s.energy_max_j * 1e-3F; });
}

void add_speed(std::vector<RasterKind>& kinds) {
    const auto add = [&](std::string_view stem, std::string_view meaning, bool percentile, bool compared,
                         auto value) {
        kinds.push_back(
            {stem, "m/s", meaning, RasterStyle::linear, Palette::passages, percentile, compared, value});
    };
    add("V_mean", "mean of the highest speed of each rock in the cell", false, false,
        [](const CellSums& s, const CellHistograms*, std::size_t) {
            return mean_of(s.speed_sum_mmps, s.passages);
        });
    add("V_50", "median of the highest speed of each rock in the cell", true, false,
        speed_percentile_mps<50>);
    add("V_90", "90th percentile of the highest speed of each rock in the cell", true, false,
        speed_percentile_mps<90>);
    add("V_95", "95th percentile of the highest speed of each rock in the cell", true, false,
        speed_percentile_mps<95>);
    add("V_98", "98th percentile of the highest speed of each rock in the cell", true, false,
        speed_percentile_mps<98>);
    add("V_99", "99th percentile of the highest speed of each rock in the cell", true, false,
        speed_percentile_mps<99>);
    add("V_max", "highest speed of all rocks in the cell", false, true,
        [](const CellSums& s, const CellHistograms*, std::size_t) { return s.speed_max_mps; });
}

void add_height(std::vector<RasterKind>& kinds) {
    const auto add = [&](std::string_view stem, std::string_view meaning, bool percentile, bool compared,
                         auto value) {
        kinds.push_back(
            {stem, "m", meaning, RasterStyle::linear, Palette::height, percentile, compared, value});
    };
    add("Ph_mean", "mean of the largest passing height of each rock, normal to the slope", false, false,
        [](const CellSums& s, const CellHistograms*, std::size_t) {
            return mean_of(s.height_sum_mm, s.passages);
        });
    add("Ph_50", "median of the passing heights, normal to the slope", true, false, height_percentile_m<50>);
    add("Ph_90", "90th percentile of the passing heights, normal to the slope", true, false,
        height_percentile_m<90>);
    add("Ph_95", "95th percentile of the passing heights, normal to the slope", true, true,
        height_percentile_m<95>);
    add("Ph_98", "98th percentile of the passing heights, normal to the slope", true, false,
        height_percentile_m<98>);
    add("Ph_99", "99th percentile of the passing heights, normal to the slope", true, false,
        height_percentile_m<99>);
    add("Ph_max", "largest passing height of all rocks, normal to the slope", false, false,
        [](const CellSums& s, const CellHistograms*, std::size_t) { return s.height_max_m; });
}

void add_counts(std::vector<RasterKind>& kinds) {
    kinds.push_back({"Nr_passages", "rocks", "rocks that passed the cell, each counted once",
                     RasterStyle::logarithmic, Palette::passages, false, true,
                     [](const CellSums& s, const CellHistograms*, std::size_t) {
                         return static_cast<float>(s.passages);
                     }});
    kinds.push_back({"Nr_deposited", "rocks", "rocks that came to rest in the cell", RasterStyle::logarithmic,
                     Palette::deposits, false, false,
                     [](const CellSums& s, const CellHistograms*, std::size_t) {
                         return static_cast<float>(s.deposited);
                     }});
    kinds.push_back({"Nr_tree_impacts", "hits", "hits on trees in the cell", RasterStyle::logarithmic,
                     Palette::impacts, false, false,
                     [](const CellSums& s, const CellHistograms*, std::size_t) {
                         return static_cast<float>(s.tree_impacts);
                     }});
    kinds.push_back({"Reach_probability", "%",
                     "rocks that passed the cell in percent of all rocks from the sources that feed it",
                     RasterStyle::linear, Palette::reach, false, true, reach_percent});
    kinds.push_back(
        {"Density", "%", "rocks that passed the cell in percent of all rocks that fell", RasterStyle::linear,
         Palette::passages, false, true,
         [](const CellSums& s, const CellHistograms*, std::size_t) { return static_cast<float>(s.passages); },
         true});
    kinds.push_back({"EL_angles", "deg", "smallest energy-line angle from a release point down to the cell",
                     RasterStyle::linear, Palette::height, false, false, energy_line_angle_deg});
}

template <class Style>
WrittenFile write_styled(const std::filesystem::path& folder, const DrawnRaster& drawn,
                         const std::string& projection, const Style& style) {
    OutFile grid{folder / (drawn.path + ".asc")};
    config::write_ascii_grid(grid.stream(), drawn.raster);
    grid.close();
    if (!projection.empty()) {
        OutFile place{folder / (drawn.path + ".prj")};
        place.stream() << projection;
        place.close();
    }
    OutFile look{folder / (drawn.path + ".qml")};
    style(look.stream());
    look.close();
    return {drawn.path + ".asc", drawn.sentence};
}

/// What a value is multiplied by.
float unit_of(const RasterKind& kind, const RunResults& results) {
    return kind.of_all && results.rocks > 0 ? static_cast<float>(100.0 / static_cast<double>(results.rocks))
                                            : 1.0F;
}

/// What writing one quantity needs to know of a run.
struct Writer {
    const RunResults& results;
    const std::filesystem::path& folder;
    std::vector<WrittenFile>& written;

    template <class Style>
    void write(const RasterKind& kind, const char* part, const std::string& sentence,
               const config::Raster<float>& raster, Style style) {
        const std::string stem = std::string{"rasters/"}.append(part).append("/").append(kind.stem);
        written.push_back(write_styled(folder, {stem, sentence, raster}, results.site.projection, style));
    }
};

std::string sentence_of(const RasterKind& kind, const char* where) {
    std::string sentence{kind.meaning};
    sentence.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(sentence.front())));
    return sentence.append(" [").append(kind.unit).append("], ").append(where).append(".");
}

void write_kind(Writer& writer, const RasterKind& kind) {
    const RunResults& results = writer.results;
    const config::Raster<float> bare = raster_of(kind, results, Cover::bare);
    ValueRange range = range_of(bare);
    config::Raster<float> forest;
    if (results.with_forest) {
        forest = raster_of(kind, results, Cover::forest);
        range.high = std::max(range.high, range_of(forest).high);
    }
    const auto style = [&](std::ostream& out) { write_style(out, kind, range); };
    const bool of_trees = kind.stem == "Nr_tree_impacts";
    if (results.with_forest) {
        writer.write(kind, "forest", sentence_of(kind, "with forest"), forest, style);
    }
    if (!of_trees) {
        writer.write(kind, "bare", sentence_of(kind, "on the bare slope"), bare, style);
    }
    if (results.with_forest && kind.compared) {
        const config::Raster<float> difference = difference_of(kind, results);
        writer.write(kind, "difference", sentence_of(kind, "with forest minus bare slope"), difference,
                     [&](std::ostream& out) { write_difference_style(out, kind, range_of(difference)); });
    }
}

/// Of one slope, in percent of all repeats.
config::Raster<float> repeats_raster(const RunResults& results, Cover cover) {
    config::Raster<float> raster{results.site.map_frame, no_value};
    const rockfall::CellTally& tally = results.tally.cells[index_of(cover)];
    for (std::size_t cell = 0; cell < tally.repeats.size(); ++cell) {
        if (tally.cells[cell].passages > 0) {
            raster.values[cell] = 100.0F * static_cast<float>(std::popcount(tally.repeats[cell])) /
                                  static_cast<float>(results.scenario.output.repeats);
        }
    }
    return raster;
}

void write_repeats(Writer& writer) {
    const RasterKind& kind = repeats_kind();
    const auto style = [&](std::ostream& out) { write_style(out, kind, {0.0F, 100.0F}); };
    if (writer.results.with_forest) {
        writer.write(kind, "forest", sentence_of(kind, "with forest"),
                     repeats_raster(writer.results, Cover::forest), style);
    }
    writer.write(kind, "bare", sentence_of(kind, "on the bare slope"),
                 repeats_raster(writer.results, Cover::bare), style);
}

/// Of one slope: standard deviations over the draws.
config::Raster<float> spread_raster(const RasterKind& kind, const RunResults& results, Cover cover) {
    config::Raster<float> raster{results.site.map_frame, no_value};
    const rockfall::CellTally& tally = results.tally.cells[index_of(cover)];
    const auto strata = static_cast<std::uint32_t>(results.draws->falls.size());
    const bool of_reach = &kind == &spread_kinds().front();
    for (std::size_t cell = 0; cell < tally.spread.size(); ++cell) {
        raster.values[cell] = static_cast<float>(
            of_reach ? 100.0 * rockfall::reach_spread(tally.spread[cell], tally.cells[cell].fed_rocks, strata)
                     : per_kilo * rockfall::energy_spread_j(tally.spread[cell], strata));
    }
    return raster;
}

void write_spread(Writer& writer, const RasterKind& kind) {
    const config::Raster<float> bare = spread_raster(kind, writer.results, Cover::bare);
    ValueRange range = range_of(bare);
    config::Raster<float> forest;
    if (writer.results.with_forest) {
        forest = spread_raster(kind, writer.results, Cover::forest);
        range.high = std::max(range.high, range_of(forest).high);
    }
    const auto style = [&](std::ostream& out) { write_style(out, kind, range); };
    if (writer.results.with_forest) {
        writer.write(kind, "forest", sentence_of(kind, "with forest"), forest, style);
    }
    writer.write(kind, "bare", sentence_of(kind, "on the bare slope"), bare, style);
}

}  // namespace

const std::vector<RasterKind>& spread_kinds() {
    constexpr auto not_of_sums = [](const CellSums&, const CellHistograms*, std::size_t) { return no_value; };
    static const std::vector<RasterKind> kinds{
        {"Reach_spread", "%",
         "standard deviation of the reach probability over the draws of what is not known, without the "
         "chance of the rocks",
         RasterStyle::linear, Palette::reach, false, false, not_of_sums},
        {"E_mean_spread", "kJ",
         "standard deviation of the mean of the largest kinetic energies over the draws of what is not "
         "known, without the chance of the rocks",
         RasterStyle::linear, Palette::height, false, false, not_of_sums}};
    return kinds;
}

const RasterKind& repeats_kind() {
    static const RasterKind kind{
        "Reached_in_repeats",
        "%",
        "share of the repeats in which at least one rock passed the cell",
        RasterStyle::linear,
        Palette::reach,
        false,
        false,
        [](const CellSums&, const CellHistograms*, std::size_t) { return no_value; }};
    return kind;
}

const std::vector<RasterKind>& raster_kinds() {
    static const std::vector<RasterKind> kinds = [] {
        std::vector<RasterKind> list;
        add_energy(list);
        add_speed(list);
        add_height(list);
        add_counts(list);
        return list;
    }();
    return kinds;
}

const RasterKind& raster_kind(std::string_view stem) {
    const auto found = std::find_if(raster_kinds().begin(), raster_kinds().end(),
                                    [&](const RasterKind& kind) { return kind.stem == stem; });
    assert(found != raster_kinds().end());
    return *found;
}

WrittenFile write_raster(const std::filesystem::path& folder, const DrawnRaster& drawn,
                         const std::string& projection, const RasterKind& kind, ValueRange range) {
    return write_styled(folder, drawn, projection, [&](std::ostream& out) { write_style(out, kind, range); });
}

WrittenFile write_raster(const std::filesystem::path& folder, const DrawnRaster& drawn,
                         const std::string& projection, std::span<const ClassColour> classes) {
    return write_styled(folder, drawn, projection,
                        [&](std::ostream& out) { write_class_style(out, classes); });
}

config::Raster<float> raster_of(const RasterKind& kind, const RunResults& results, Cover cover) {
    const auto& cells = results.tally.cells[index_of(cover)].cells;
    const CellHistograms* histograms = results.histograms[index_of(cover)];
    assert(!kind.percentile || histograms != nullptr);
    assert(cells.size() == results.site.map_frame.size());
    config::Raster<float> raster{results.site.map_frame, no_value};
    for (std::size_t cell = 0; cell < cells.size(); ++cell) {
        if (cells[cell].passages > 0) {
            raster.values[cell] = unit_of(kind, results) * kind.value(cells[cell], histograms, cell);
        }
    }
    return raster;
}

config::Raster<float> difference_of(const RasterKind& kind, const RunResults& results) {
    const auto& forest = results.tally.cells[index_of(Cover::forest)].cells;
    const auto& bare = results.tally.cells[index_of(Cover::bare)].cells;
    config::Raster<float> difference{results.site.map_frame, no_value};
    for (std::size_t cell = 0; cell < bare.size(); ++cell) {
        if (forest[cell].passages == 0 && bare[cell].passages == 0) {
            continue;
        }
        CellSums with = forest[cell];
        CellSums without = bare[cell];
        with.fed_rocks = without.fed_rocks = std::max(with.fed_rocks, without.fed_rocks);
        const float of_forest =
            with.passages > 0 ? kind.value(with, results.histograms[index_of(Cover::forest)], cell) : 0.0F;
        const float of_bare = without.passages > 0
                                  ? kind.value(without, results.histograms[index_of(Cover::bare)], cell)
                                  : 0.0F;
        difference.values[cell] = unit_of(kind, results) * (of_forest - of_bare);
    }
    return difference;
}

ValueRange range_of(const config::Raster<float>& raster) {
    ValueRange range{std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity()};
    for (const float value : raster.values) {
        if (!std::isnan(value)) {
            range.low = std::min(range.low, value);
            range.high = std::max(range.high, value);
        }
    }
    return range.low <= range.high ? range : ValueRange{};
}

std::vector<WrittenFile> write_rasters(const RunResults& results, const std::filesystem::path& folder,
                                       const WriteWatch& watch) {
    std::vector<WrittenFile> written;
    make_folder(folder / "rasters/bare");
    if (results.with_forest) {
        make_folder(folder / "rasters/forest");
        make_folder(folder / "rasters/difference");
    }
    const bool with_percentiles = results.histograms[index_of(Cover::bare)] != nullptr;
    Writer writer{results, folder, written};
    for (const RasterKind& kind : raster_kinds()) {
        if (!kind.percentile || with_percentiles) {
            watch(std::string{"rasters, "}.append(kind.stem));
            write_kind(writer, kind);
        }
    }
    if (results.scenario.output.repeats > 0) {
        watch("rasters, Reached_in_repeats");
        write_repeats(writer);
    }
    if (results.scenario.output.spread_maps && results.draws != nullptr && results.draws->has_spread()) {
        for (const RasterKind& kind : spread_kinds()) {
            watch(std::string{"rasters, "}.append(kind.stem));
            write_spread(writer, kind);
        }
    }
    return written;
}

}  // namespace coupling
