#include "coupling/assessments/collapse/series_tables.hpp"

#include "config/text/joined.hpp"
#include "coupling/assessments/collapse/block_series.hpp"
#include "coupling/assessments/collapse/building_damage.hpp"
#include "coupling/results/tables/figure_columns.hpp"

namespace coupling::collapse {
namespace {

struct SeriesRow {
    const SeriesBlock& block;
    BlockMoment moment;
};

std::string reasons_of(const SeriesBlock& block) {
    std::string words;
    for (const Chosen reason : block.reasons) {
        words += words.empty() ? "" : " ";
        words += reason == Chosen::fastest ? "fastest" : reason == Chosen::farthest ? "farthest" : "median";
    }
    return words;
}

template <class Row, class Value>
ColumnsOf<Row> energy_column(const char* name, const char* meaning, const Value& value_j) {
    return {name, 3, meaning, [value_j](const Row& row) { return value_j(row) / 1e3; }};
}

TableOf<SeriesRow> series_table() {
    return {
        "block_series.csv",
        "Chosen blocks, or all of them, over time: place, speed, acceleration, energies.",
        "a block at a time",
        {{"block", "number of the block", [](const auto& row) { return row.block.number; }},
         {"chosen",
          "fastest: largest speed of all; farthest: largest way in plan; median: in the middle by its way "
          "among those that moved by more than 1 m; blanks between several",
          [](const auto& row) { return reasons_of(row.block); }},
         {"time_s", 3, "time since the start", [](const auto& row) { return row.moment.time_s; }},
         {"x_m", 2, "easting of its middle", [](const auto& row) { return row.moment.place_m.x(); }},
         {"y_m", 2, "northing of its middle", [](const auto& row) { return row.moment.place_m.y(); }},
         {"z_m", 2, "height of its middle above sea", [](const auto& row) { return row.moment.place_m.z(); }},
         {"displacement_m", 3, "distance of its middle from its start",
          [](const auto& row) { return row.moment.displacement_m; }},
         {"speed_mps", 3, "its speed", [](const auto& row) { return row.moment.speed_mps; }},
         {"acceleration_mps2", 3,
          "change of its velocity since the time before (collapse.frame_s), by the time between",
          [](const auto& row) { return row.moment.acceleration_mps2; }},
         energy_column<SeriesRow>("kinetic_kj", "its kinetic energy, translation and rotation",
                                  [](const auto& row) { return row.moment.kinetic_j; }),
         energy_column<SeriesRow>("released_kj", "its weight times its height below its start",
                                  [](const auto& row) { return row.moment.released_j; }),
         energy_column<SeriesRow>(
             "given_up_kj",
             "released and not kinetic: taken by contacts, bonds, ground and trees so far; below "
             "0 where other blocks push it",
             [](const auto& row) { return row.moment.given_up_j(); })}};
}

struct MeanRow {
    double time_s;
    MeanMoment mean;
};

TableOf<MeanRow> mean_table() {
    const auto energy = [](const char* name, const char* meaning, double MeanMoment::*part) {
        return energy_column<MeanRow>(name, meaning, [part](const MeanRow& row) { return row.mean.*part; });
    };
    return {
        "mean_block.csv",
        "The mean block over time: speed, acceleration, displacement, energies.",
        "a time",
        {{"time_s", 3, "time since the start", &MeanRow::time_s},
         {"speed_mps", 3, "mean speed of all blocks, by mass",
          [](const auto& row) { return row.mean.speed_mps; }},
         {"acceleration_mps2", 3,
          "mean change of the velocity of a block since the row before, by the time between; by mass",
          [](const auto& row) { return row.mean.acceleration_mps2; }},
         {"displacement_m", 3, "mean distance of the blocks from their start, by mass",
          [](const auto& row) { return row.mean.displacement_m; }},
         energy("kinetic_kj", "kinetic energy of all blocks by their number", &MeanMoment::kinetic_j),
         energy("friction_kj", "taken by friction so far, by the number of blocks", &MeanMoment::friction_j),
         energy("fracture_kj", "taken by broken bonds so far, by the number of blocks",
                &MeanMoment::fracture_j),
         energy("strain_kj", "held by contacts and bonds, by the number of blocks", &MeanMoment::strain_j),
         energy("given_up_kj", "released by gravity and not kinetic, by the number of blocks",
                &MeanMoment::given_up_j)}};
}

struct BuildingRow {
    const rockfall::Target& target;
    const BuildingDamage& damage;
};

ColumnsOf<BuildingRow> name_columns() {
    return {{Column{"target_id", "text", "id of the target", "input targets.file"},
             [](const auto& row) { return row.target.id; }},
            {"name", "its name", "input targets.file", [](const auto& row) { return row.target.name; }}};
}

TableOf<BuildingRow> building_table() {
    constexpr const char* floor =
        "floor in plan of the target, in square cells of a hundredth of its longer side";
    return {
        "collapse_buildings.csv",
        "Targets that are areas: floor that blocks reached, energy at walls.",
        "a target that is an area",
        {name_columns(),
         {"floor_m2", 2, floor, [](const auto& row) { return row.damage.floor_m2; }},
         {"reached_m2", 2,
          "part of it over which the sphere of equal volume of a block passed in plan, at any height; the "
          "target holds none",
          [](const auto& row) { return row.damage.reached_m2; }},
         {"reached_percent", 2, "the same by the floor",
          [](const auto& row) { return 100.0 * row.damage.reached_share(); }},
         {"reached_30_kj_m2", "m2", 2, "part of the floor that a block of at least 30 kJ reached",
          from_simulation, [](const auto& row) { return row.damage.reached_low_m2; }},
         {"reached_300_kj_m2", "m2", 2, "part of the floor that a block of at least 300 kJ reached",
          from_simulation, [](const auto& row) { return row.damage.reached_high_m2; }},
         {"walls", "sides of the polygon", [](const auto& row) { return row.damage.walls.size(); }},
         {"walls_hit", "sides at which some block first reached it",
          [](const auto& row) { return row.damage.walls_hit(); }},
         {"largest_energy_kj", 3, "largest kinetic energy of a block when it first reached a wall",
          [](const auto& row) { return row.damage.largest_on_wall_j() / 1e3; }},
         {"energy_sum_mj", 4, "sum of these energies of all blocks that reached it",
          [](const auto& row) { return row.damage.energy_on_walls_j() / j_per_mj; }}}};
}

struct WallRow : BuildingRow {
    const WallLoad& load;
    Eigen::Vector2d origin_m;
};

TableOf<WallRow> wall_table() {
    const auto at = [](const char* name, const char* meaning, Eigen::Vector2d Wall::*end, int axis) {
        return ColumnsOf<WallRow>{name, 2, meaning, "input targets.file", [end, axis](const WallRow& row) {
                                      return (row.load.wall.*end)[axis] + row.origin_m[axis];
                                  }};
    };
    return {"collapse_walls.csv",
            "Walls of targets that are areas: blocks that first reached the target there, and their energy.",
            "a side of a target that is an area",
            {name_columns(),
             {"wall", "number of the side, from 0, ring by ring", "input targets.file",
              [](const auto& row) { return row.load.number; }},
             at("x_start_m", "easting of its first end", &Wall::from_m, 0),
             at("y_start_m", "northing of its first end", &Wall::from_m, 1),
             at("x_end_m", "easting of its second end", &Wall::to_m, 0),
             at("y_end_m", "northing of its second end", &Wall::to_m, 1),
             {"length_m", 2, "its length", "input targets.file",
              [](const auto& row) { return row.load.wall.length_m(); }},
             {"blocks", "blocks that first reached the target at this side",
              [](const auto& row) { return row.load.blocks; }},
             {"largest_energy_kj", 3, "largest kinetic energy of one of them then",
              [](const auto& row) { return row.load.largest_j / 1e3; }},
             {"energy_sum_mj", 4, "sum of their kinetic energies then",
              [](const auto& row) { return row.load.energy_j / j_per_mj; }}}};
}

/// The chosen blocks, or all of them with the reasons of those that are chosen.
std::vector<SeriesBlock> blocks_of_table(const CollapseResults& results) {
    std::vector<SeriesBlock> chosen = chosen_blocks(results);
    if (!results.scenario.settings.series_of_all) {
        return chosen;
    }
    std::vector<SeriesBlock> all(results.site.count.free);
    for (std::size_t i = 0; i < all.size(); ++i) {
        all[i].number = i;
    }
    for (SeriesBlock& block : chosen) {
        all[block.number] = std::move(block);
    }
    return all;
}

}  // namespace

std::vector<TableLayout> series_layouts() {
    return {series_table(), mean_table(), building_table(), wall_table()};
}

void write_series_tables(const CollapseResults& results, const std::filesystem::path& folder,
                         const WriteWatch& watch, std::vector<WrittenFile>& files) {
    const auto write = [&](const auto& table, const auto& fill) {
        watch(table.file, 0.0);
        files.push_back(table.write(folder, fill));
    };
    const std::size_t frames = results.record.rows.size();
    const std::vector<SeriesBlock> blocks = blocks_of_table(results);
    write(series_table(), [&](auto& rows) {
        for (const SeriesBlock& block : blocks) {
            for (std::size_t frame = 0; frame < frames; ++frame) {
                rows.add({block, moment_of(results, block.number, frame)});
            }
        }
    });
    write(mean_table(), [&](auto& rows) {
        for (std::size_t frame = 0; frame < frames; ++frame) {
            rows.add({results.record.rows[frame].time_s, mean_moment(results, frame)});
        }
    });
    const std::vector<BuildingDamage> buildings = building_damage(results);
    if (buildings.empty()) {
        return;
    }
    write(building_table(), [&](auto& rows) {
        for (const BuildingDamage& damage : buildings) {
            rows.add({results.site.targets[damage.target], damage});
        }
    });
    write(wall_table(), [&](auto& rows) {
        for (const BuildingDamage& damage : buildings) {
            for (const WallLoad& load : damage.walls) {
                rows.add({{results.site.targets[damage.target], damage}, load, results.site.origin_m});
            }
        }
    });
}

}  // namespace coupling::collapse
