#include "coupling/assessments/collapse/collapse_results.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/assessments/collapse/block_series.hpp"
#include "coupling/assessments/collapse/deposit.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/finish.hpp"
#include "coupling/results/maps/rasters.hpp"
#include "coupling/results/text/writing_language.hpp"

namespace coupling::collapse {
namespace {

using config::joined;
config::Raster<float> map_of(const CollapseResults& results, const std::vector<double>& values, double unit) {
    config::Raster<float> raster{results.site.map_frame, std::numeric_limits<float>::quiet_NaN()};
    for (std::size_t k = 0; k < values.size(); ++k) {
        if (results.record.cell_blocks[k] > 0.0) {
            raster.values[k] = static_cast<float>(values[k] / unit);
        }
    }
    return raster;
}

/// Depth of the deposit, and the largest block in it.
void add_deposit(const CollapseResults& results, config::Raster<float>& depth,
                 config::Raster<float>& largest) {
    const Deposit deposit = deposit_of(results);
    for (std::size_t k = 0; k < deposit.volume_m3.size(); ++k) {
        if (deposit.volume_m3[k] > 0.0) {
            depth.values[k] =
                static_cast<float>(deposit.volume_m3[k] / results.site.map_frame.cell_area_m2());
            largest.values[k] = static_cast<float>(deposit.largest_m[k]);
        }
    }
}

void write_maps(const CollapseResults& results, const std::filesystem::path& folder,
                std::vector<WrittenFile>& files, std::vector<Column>& described) {
    make_folder(folder / "rasters" / "collapse");
    const report::WritingLanguage of_legends{results.scenario.scenario.report.language};
    for (const CollapseMap& map : maps_of(results)) {
        files.push_back(write_raster(folder,
                                     {joined("rasters/collapse/", map.kind.stem),
                                      joined(map.kind.meaning, ", ", map.kind.unit, "."), map.raster},
                                     results.site.projection, map.kind, range_of(map.raster)));
        described.push_back({std::string{map.kind.stem}, std::string{map.kind.unit},
                             std::string{map.kind.meaning}, "simulated"});
    }
    const std::vector<FieldMap> fields = fields_of(results);
    for (const FieldMap& field : fields) {
        files.push_back(write_raster(folder,
                                     {joined("rasters/collapse/", field.stem),
                                      joined(field.meaning, ", ", field.kind().unit, "."), field.raster},
                                     results.site.projection, field.kind(),
                                     range_of_fields(fields, field.is_speed)));
        described.push_back({field.stem, std::string{field.kind().unit}, field.meaning, "simulated"});
    }
}

void write_series(const CollapseResults& results, const std::filesystem::path& folder,
                  const WriteWatch& watch, std::vector<WrittenFile>& files) {
    make_folder(folder / "frames");
    OutFile series{folder / "frames" / "blocks.pvd"};
    series.stream()
        << "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n";
    for (std::size_t f = 0; f < results.record.rows.size(); ++f) {
        watch("frames", static_cast<double>(f) / static_cast<double>(results.record.rows.size()));
        const std::string number = std::to_string(100000 + f).substr(1);
        const std::string name = joined("blocks_", number, ".vtp");
        OutFile frame{folder / "frames" / name};
        write_blocks_vtp(frame.stream(), results, f);
        frame.close();
        files.push_back({joined("frames/", name), "Blocks at a time, for ParaView."});
        series.stream() << "<DataSet timestep=\"" << results.record.rows[f].time_s << "\" file=\"" << name
                        << "\"/>\n";
    }
    series.stream() << "</Collection>\n</VTKFile>\n";
    series.close();
    files.push_back({"frames/blocks.pvd", "All of them as a series in time: open this one."});
}

}  // namespace

std::vector<CollapseMap> maps_of(const CollapseResults& results) {
    const auto kind = [](const char* stem, const char* unit, const char* meaning, RasterStyle style) {
        RasterKind made{};
        made.stem = stem;
        made.unit = unit;
        made.meaning = meaning;
        made.style = style;
        return made;
    };
    std::vector<CollapseMap> maps;
    const auto& record = results.record;
    maps.push_back(
        {kind("Nr_blocks", "blocks", "blocks whose middle passed the cell", RasterStyle::logarithmic),
         map_of(results, record.cell_blocks, 1.0)});
    maps.push_back(
        {kind("E_max", "kJ", "largest kinetic energy of a block in the cell", RasterStyle::energy_classes),
         map_of(results, record.cell_energy_j, 1e3)});
    maps.push_back({kind("V_max", "m/s", "highest speed of a block in the cell", RasterStyle::linear),
                    map_of(results, record.cell_speed_mps, 1.0)});
    config::Raster<float> depth{results.site.map_frame, std::numeric_limits<float>::quiet_NaN()};
    config::Raster<float> largest = depth;
    add_deposit(results, depth, largest);
    maps.push_back(
        {kind("Deposit_depth", "m",
              "volume of the blocks, or parts of them, that lie in the cell at the end, by its area; blocks "
              "that moved by more than their size",
              RasterStyle::linear),
         std::move(depth)});
    maps.push_back(
        {kind("Largest_block", "m", "side of the cube of the largest of them", RasterStyle::linear),
         std::move(largest)});
    return maps;
}

RasterKind FieldMap::kind() const {
    RasterKind kind{};
    kind.stem = stem;
    kind.unit = is_speed ? "m/s" : "m";
    kind.meaning = meaning;
    kind.style = RasterStyle::linear;
    return kind;
}

std::vector<FieldMap> fields_of(const CollapseResults& results) {
    const config::GridFrame& frame = results.site.map_frame;
    std::vector<FieldMap> fields;
    std::size_t number = 0;
    for (const std::size_t picture : picture_frames(results)) {
        ++number;
        const double time_s = results.record.rows[picture].time_s;
        const config::Raster<float> nothing{frame, std::numeric_limits<float>::quiet_NaN()};
        const std::string after = joined(" after ", config::to_text(std::round(10.0 * time_s) / 10.0), " s");
        FieldMap speed{joined("Speed_", std::to_string(number)),
                       joined("largest speed of a block whose middle is in the cell", after), true, time_s,
                       nothing};
        FieldMap way{joined("Displacement_", std::to_string(number)),
                     joined("largest displacement of a block whose middle is in the cell", after), false,
                     time_s, nothing};
        for (std::size_t i = 0; i < results.site.count.free; ++i) {
            const BlockPlace& place = results.record.frames[picture][i];
            const Eigen::Vector2d at_m = place.centre().head<2>() + results.site.origin_m;
            const config::Cell cell = frame.cell_at(at_m.x(), at_m.y());
            if (frame.contains(cell)) {
                const auto raise = [&](float& value, float by) {
                    value = std::isnan(value) ? by : std::max(value, by);
                };
                const std::size_t k = frame.index(cell);
                raise(speed.raster.values[k], place.speed_mps);
                raise(way.raster.values[k],
                      static_cast<float>((place.centre() - results.site.blocks[i].centre_m).norm()));
            }
        }
        fields.push_back(std::move(speed));
        fields.push_back(std::move(way));
    }
    return fields;
}

ValueRange range_of_fields(const std::vector<FieldMap>& fields, bool speed) {
    ValueRange range;
    for (const FieldMap& field : fields) {
        if (field.is_speed == speed) {
            const ValueRange own = range_of(field.raster);
            range.low = std::min(range.low, own.low);
            range.high = std::max(range.high, own.high);
        }
    }
    return range;
}

KeyFigures key_figures(const CollapseResults& results) {
    KeyFigures figures;
    for (const FrameRow& row : results.record.rows) {
        if (row.mean_speed_mps > figures.peak_mean_speed_mps) {
            figures.peak_mean_speed_mps = row.mean_speed_mps;
            figures.peak_time_s = row.time_s;
        }
        figures.largest_speed_mps = std::max(figures.largest_speed_mps, row.largest_speed_mps);
        figures.front_m = std::max(figures.front_m, row.front_m);
        figures.largest_residual = std::max(figures.largest_residual, std::abs(row.residual_share));
    }
    for (const FrameRow& row : results.record.rows) {
        if (row.time_s > figures.peak_time_s && row.moving_share < 0.01) {
            figures.duration_s = row.time_s;
            break;
        }
    }
    figures.moving_share = results.record.rows.back().moving_m3 / results.site.count.blocks_m3;
    double left_m3 = 0.0;
    for (std::size_t i = 0; i < results.site.count.free; ++i) {
        if (results.seen(i).status == rockfall::rock_mass::BlockStatus::left) {
            ++figures.left;
            left_m3 += results.mass.blocks()[i].volume_m3;
        }
    }
    figures.left_share = left_m3 / results.site.count.blocks_m3;
    for (const double blocks : results.record.cell_blocks) {
        figures.area_m2 += blocks > 0.0 ? results.site.map_frame.cell_area_m2() : 0.0;
    }
    return figures;
}

std::vector<std::size_t> pieces_of(const CollapseResults& results) {
    std::vector<std::size_t> piece(results.mass.blocks().size());
    std::iota(piece.begin(), piece.end(), std::size_t{0});
    const auto root = [&](std::size_t i) {
        while (piece[i] != i) {
            i = piece[i] = piece[piece[i]];
        }
        return i;
    };
    for (const auto& [a, b] : results.mass.intact_bonds()) {
        const std::size_t ra = root(a), rb = root(b);
        piece[std::max(ra, rb)] = std::min(ra, rb);
    }
    for (std::size_t i = 0; i < piece.size(); ++i) {
        piece[i] = root(i);
    }
    return piece;
}

std::vector<WrittenFile> write_results(const CollapseResults& results, const std::filesystem::path& folder,
                                       const WriteWatch& watch) {
    std::vector<WrittenFile> files{{"report.html", "All results on one page; opens offline."},
                                   {"summary.json", "All figures for scripts."}};
    write_tables(results, folder, watch, files);
    std::vector<Column> described;
    write_maps(results, folder, files, described);
    if (results.scenario.scenario.output.gis.vtp) {
        write_series(results, folder, watch, files);
    }
    const Site drawn = drawn_site(results.site);
    const std::vector<geopackage::AreaLayer> areas{deposit_layer(results)};
    finish_results(
        folder,
        {.scenario = results.scenario.scenario,
         .dictionary = {layouts_of(results), described},
         .summary = [&](std::ostream& out, const auto& written) { write_summary(out, results, written); },
         .page = [&](std::ostream& out, const auto& written) { write_page(out, results, written); },
         .drawn = &drawn,
         .areas = areas},
        files, watch);
    return files;
}

}  // namespace coupling::collapse
