#include "coupling/collapse/collapse_results.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "config/text/joined.hpp"
#include "coupling/results/data_dictionary.hpp"
#include "coupling/results/rasters.hpp"

namespace coupling::collapse {
namespace {

using config::joined;
using rockfall::rock_mass::Block;
using rockfall::rock_mass::BlockStatus;

constexpr double j_per_mj = 1e6;

void write_energies(std::ostream& out, const CollapseResults& results) {
    TableRows row{out, collapse_layouts(), "energies.csv"};
    for (const FrameRow& frame : results.record.rows) {
        const auto& l = frame.ledger;
        row.number<3>(frame.time_s);
        for (const double energy_j :
             {l.translation_j, l.rotation_j, l.gravity_j, l.contact_normal_j, l.contact_shear_j,
              l.bonds.normal_j, l.bonds.shear_j, l.bonds.bending_j, l.bonds.twist_j, l.friction_j,
              l.dashpot_j, l.local_damping_j, l.fracture_j, l.trees_j, l.rest_j, l.left_j, l.residual_j()}) {
            row.number<6>(energy_j / j_per_mj);
        }
        row.number<4>(100.0 * frame.residual_share).number<3>(frame.mean_speed_mps);
        row.number<3>(frame.largest_speed_mps).number<2>(frame.front_m).number<2>(100.0 * frame.moving_share);
        row.number<0>(frame.bonds_intact).number<0>(frame.broken_by_tension).number<0>(frame.broken_by_shear);
        row.end();
    }
}

const char* state_of(const Block& block) {
    return block.status == BlockStatus::left     ? "left"
           : block.status == BlockStatus::moving ? "moving"
                                                 : "at_rest";
}

void write_blocks(std::ostream& out, const CollapseResults& results) {
    TableRows row{out, collapse_layouts(), "blocks.csv"};
    const std::vector<std::size_t> pieces = pieces_of(results);
    const Eigen::Vector2d origin = results.site.origin_m;
    for (std::size_t i = 0; i < results.site.count.free; ++i) {
        const Block& block = results.mass.blocks()[i];
        const Eigen::Vector3d& start = results.site.blocks[i].centre_m;
        row.whole(i).number<3>(block.volume_m3).number<3>(2.0 * block.half_side_m);
        row.number<2>(start.x() + origin.x()).number<2>(start.y() + origin.y()).number<2>(start.z());
        row.number<2>(block.centre_m.x() + origin.x()).number<2>(block.centre_m.y() + origin.y());
        row.number<2>(block.centre_m.z());
        row.number<2>((block.centre_m - start).head<2>().norm());
        row.number<3>(results.record.block_speed_mps[i]).number<3>(results.record.block_energy_j[i] / 1e3);
        row.text(state_of(block)).whole(pieces[i]);
        row.end();
    }
}

void write_targets(std::ostream& out, const CollapseResults& results) {
    TableRows row{out, collapse_layouts(), "collapse_targets.csv"};
    for (std::size_t t = 0; t < results.site.targets.size(); ++t) {
        double volume_m3 = 0.0, energy_j = 0.0, largest_j = 0.0, speed_mps = 0.0;
        double first_s = std::numeric_limits<double>::quiet_NaN();
        std::size_t blocks = 0;
        for (const TargetHit& hit : results.record.hits) {
            if (hit.target == static_cast<double>(t)) {
                first_s = blocks++ == 0 ? hit.time_s : first_s;
                volume_m3 += hit.volume_m3;
                energy_j += hit.energy_j;
                largest_j = std::max(largest_j, hit.energy_j);
                speed_mps = std::max(speed_mps, hit.speed_mps);
            }
        }
        row.text(results.site.targets[t].id).text(results.site.targets[t].name).whole(blocks);
        row.number<2>(volume_m3).number<2>(first_s).number<2>(largest_j / 1e3).number<3>(speed_mps);
        row.number<4>(energy_j / j_per_mj);
        row.end();
    }
}

void write_hits(std::ostream& out, const CollapseResults& results) {
    TableRows row{out, collapse_layouts(), "target_hits.csv"};
    for (const TargetHit& hit : results.record.hits) {
        row.text(results.site.targets[static_cast<std::size_t>(hit.target)].id);
        row.number<0>(hit.block).number<3>(hit.time_s).number<2>(hit.x_m).number<2>(hit.y_m);
        row.number<3>(hit.volume_m3).number<3>(hit.speed_mps).number<3>(hit.energy_j / 1e3);
        row.number<3>(hit.translational_j / 1e3);
        row.end();
    }
}

void write_trees(std::ostream& out, const CollapseResults& results) {
    TableRows row{out, collapse_layouts(), "tree_energies.csv"};
    // Stems stand in the order of the trees; those without ground below have none.
    for (std::size_t k = 0; k < results.mass.stems().size() && k < results.site.trees.size(); ++k) {
        const auto& stem = results.mass.stems()[k];
        if (stem.taken_j > 0.0) {
            row.text(results.site.trees[k].id).number<2>(stem.x_m + results.site.origin_m.x());
            row.number<2>(stem.y_m + results.site.origin_m.y()).number<3>(stem.strength_j / 1e3);
            row.number<3>(stem.taken_j / 1e3).text(stem.is_broken() ? "yes" : "no");
            row.end();
        }
    }
}

config::Raster<float> map_of(const CollapseResults& results, const std::vector<double>& values, double unit) {
    config::Raster<float> raster{results.site.map_frame, std::numeric_limits<float>::quiet_NaN()};
    for (std::size_t k = 0; k < values.size(); ++k) {
        if (results.record.cell_blocks[k] > 0.0) {
            raster.values[k] = static_cast<float>(values[k] / unit);
        }
    }
    return raster;
}

/// Volume by area, and largest block, of the blocks that lie in a cell with their middle at the end.
void add_deposit(const CollapseResults& results, config::Raster<float>& depth,
                 config::Raster<float>& largest) {
    std::vector<double> volume_m3(results.site.map_frame.size(), 0.0), size_m(volume_m3);
    for (std::size_t i = 0; i < results.site.count.free; ++i) {
        const Block& block = results.mass.blocks()[i];
        const config::Cell cell = results.site.map_frame.cell_at(
            block.centre_m.x() + results.site.origin_m.x(), block.centre_m.y() + results.site.origin_m.y());
        if (block.status != BlockStatus::left && results.site.map_frame.contains(cell)) {
            const std::size_t k = results.site.map_frame.index(cell);
            volume_m3[k] += block.volume_m3;
            size_m[k] = std::max(size_m[k], 2.0 * block.half_side_m);
        }
    }
    for (std::size_t k = 0; k < volume_m3.size(); ++k) {
        if (volume_m3[k] > 0.0) {
            depth.values[k] = static_cast<float>(volume_m3[k] / results.site.map_frame.cell_area_m2());
            largest.values[k] = static_cast<float>(size_m[k]);
        }
    }
}

void write_maps(const CollapseResults& results, const std::filesystem::path& folder,
                std::vector<WrittenFile>& files, std::vector<Column>& described) {
    make_folder(folder / "rasters" / "collapse");
    for (const CollapseMap& map : maps_of(results)) {
        files.push_back(write_raster(folder,
                                     {joined("rasters/collapse/", map.kind.stem),
                                      joined(map.kind.meaning, ", ", map.kind.unit, "."), map.raster},
                                     results.site.projection, map.kind, range_of(map.raster)));
        described.push_back({std::string{map.kind.stem}, std::string{map.kind.unit},
                             std::string{map.kind.meaning}, "simulated"});
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
        {kind("Deposit_depth", "m", "volume of the blocks that lie in the cell at the end, by its area",
              RasterStyle::linear),
         std::move(depth)});
    maps.push_back(
        {kind("Largest_block", "m", "side of the cube of the largest of them", RasterStyle::linear),
         std::move(largest)});
    return maps;
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
    make_folder(folder / "tables");
    std::vector<WrittenFile> files;
    const auto table = [&](const char* name, const char* sentence, const auto& write) {
        watch(name, 0.0);
        files.push_back(write_table(folder, name, sentence, [&](std::ostream& out) { write(out, results); }));
    };
    table("energies.csv", "Energies, speeds, front and bonds over time.", write_energies);
    table("blocks.csv", "Every block: size, start, end, largest speed and energy, piece.", write_blocks);
    if (!results.site.targets.empty()) {
        table("collapse_targets.csv", "What reached the targets.", write_targets);
        table("target_hits.csv", "Every block that reached a target.", write_hits);
    }
    if (!results.site.trees.empty()) {
        table("tree_energies.csv", "Trees that blocks touched, with the energy that they took.", write_trees);
    }
    std::vector<Column> described;
    write_maps(results, folder, files, described);
    if (results.scenario.scenario.gis.vtp) {
        write_series(results, folder, watch, files);
    }
    for (WrittenFile& layer : write_layers(results, folder, files, watch)) {
        files.push_back(std::move(layer));
    }
    add_data_dictionary(folder, {collapse_layouts(), described}, files);
    files.push_back({"report.html", "All results on one page; opens offline."});
    files.push_back({"summary.json", "All figures for scripts."});
    watch("report.html", 0.0);
    OutFile page{folder / "report.html"};
    write_page(page.stream(), results, files);
    page.close();
    OutFile summary{folder / "summary.json"};
    write_summary(summary.stream(), results, files);
    summary.close();
    return files;
}

}  // namespace coupling::collapse
