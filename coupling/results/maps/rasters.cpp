#include "coupling/results/maps/rasters.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "config/grid/ascii_grid.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/maps/raster_style.hpp"
#include "coupling/results/text/writing_language.hpp"
#include "rockfall/tally/cell_spread.hpp"

namespace coupling {
namespace {

using rockfall::CellHistograms;
using rockfall::CellSums;

constexpr float no_value = std::numeric_limits<float>::quiet_NaN();
constexpr double per_kilo = 1e-3;

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

/// Of one slope.
config::Raster<float> release_raster(std::size_t from, const RunResults& results, Cover cover) {
    config::Raster<float> raster{results.site.map_frame, no_value};
    const rockfall::CellTally& tally = results.tally.cells[index_of(cover)];
    for (std::size_t cell = 0; cell < tally.releases.size(); ++cell) {
        if (tally.cells[cell].passages > 0) {
            raster.values[cell] = static_cast<float>(tally.releases[cell].per_release(from));
        }
    }
    return raster;
}

/// Writes what `raster_of(cover)` gives of each slope, with one range of colours.
template <class RasterOf>
void write_on_slopes(Writer& writer, const RasterKind& kind, const RasterOf& raster_of) {
    const config::Raster<float> bare = raster_of(Cover::bare);
    ValueRange range = range_of(bare);
    config::Raster<float> forest;
    if (writer.results.with_forest) {
        forest = raster_of(Cover::forest);
        range.high = std::max(range.high, range_of(forest).high);
    }
    const auto style = [&](std::ostream& out) { write_style(out, kind, range); };
    if (writer.results.with_forest) {
        writer.write(kind, "forest", sentence_of(kind, "with forest"), forest, style);
    }
    writer.write(kind, "bare", sentence_of(kind, "on the bare slope"), bare, style);
}

}  // namespace

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
    const report::WritingLanguage of_legends{results.scenario.report.language};
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
            write_on_slopes(writer, kind, [&](Cover cover) { return spread_raster(kind, results, cover); });
        }
    }
    if (!results.scenario.hazard.blocks.empty()) {
        watch("rasters, Per_release");
        for (std::size_t from = 0; from < release_kinds().size(); ++from) {
            write_on_slopes(writer, release_kinds()[from],
                            [&](Cover cover) { return release_raster(from, results, cover); });
        }
    }
    return written;
}

}  // namespace coupling
