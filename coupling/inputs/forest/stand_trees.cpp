#include "coupling/inputs/forest/stand_trees.hpp"

#include <cstdint>
#include <map>
#include <utility>

#include "config/text/joined.hpp"
#include "coupling/inputs/forest/crown_cover_input.hpp"
#include "coupling/inputs/forest/dbh_class_input.hpp"
#include "coupling/inputs/forest/forest_species.hpp"
#include "coupling/inputs/forest/obstacle_size.hpp"
#include "coupling/inputs/forest/patch_input.hpp"
#include "coupling/inputs/forest/stand_input.hpp"
#include "coupling/inputs/scenario/forest_settings.hpp"
#include "coupling/inputs/scenario/run_settings.hpp"
#include "forest/start/height_curve.hpp"
#include "forest/start/starting_stand.hpp"

namespace coupling {
namespace {

using config::joined;

/// No climate says how high trees grow here. Returns for how many records heights were filled in.
std::size_t fill_heights(std::map<std::uint32_t, InventoriedStand>& stands) {
    std::size_t filled = 0;
    for (auto& [number, stand] : stands) {
        for (forest::SpeciesRecord& record : stand.species) {
            const double dbh_cm = mean_dbh_cm(record);
            if (!record.mean_height_m && dbh_cm > 0.0) {
                record.mean_height_m = forest::curve_of_prealps.height_m(dbh_cm);
                ++filled;
            }
        }
    }
    return filled;
}

/// The file that says what stands there.
std::string file_of_records(const Reading& reading) {
    const ForestSettings& settings = reading.forest();
    return reading.shown(settings.stand_records.empty() ? settings.dbh_classes : settings.stand_records);
}

std::vector<TreeRecord> placed(const std::vector<forest::StandRecord>& inventory, const ForestGround& ground,
                               const ForestSpecies& species, std::uint64_t seed) {
    std::vector<TreeRecord> trees;
    std::uint64_t next_id = 1;
    for (const forest::StandRecord& record : inventory) {
        const auto of_stand = forest::trees_from_record(record, ground.grid, species.table, seed, 0, next_id);
        for (std::size_t i = 0; i < of_stand.size(); ++i) {
            const forest::Tree& tree = of_stand[i];
            if (tree.dbh_cm >= least_obstacle_cm) {
                trees.push_back({.id = std::to_string(next_id + i),
                                 .species = species.table[tree.species].code,
                                 .stem = {tree.x_m, tree.y_m, tree.dbh_cm, tree.height_m,
                                          species.fracture_energy[forest::index_of(tree.species)]}});
            }
        }
        next_id += of_stand.size();
    }
    return trees;
}

}  // namespace

std::optional<std::vector<TreeRecord>> trees_of_stands(const config::Raster<double>& heights_m,
                                                       const std::string& heights_file,
                                                       const rockfall::Terrain& terrain, Reading& reading) {
    const std::optional<ForestSpecies> species = read_forest_species(reading);
    const std::optional<StandCover> cover =
        cover_on_heights(read_stand_cover(reading), heights_m.frame, reading);
    if (!species || !cover) {
        return std::nullopt;
    }
    std::optional<std::map<std::uint32_t, InventoriedStand>> stands{std::in_place};
    if (!reading.forest().stand_records.empty()) {
        stands = read_records(*species, reading);
    }
    if (!stands || !add_dbh_classes(*species, reading, *stands)) {
        return std::nullopt;
    }
    const std::size_t filled = fill_heights(*stands);
    const auto cover_at = [&](double x_m, double y_m) -> std::optional<PatchCover> {
        const std::uint32_t stand = cover->at(x_m, y_m);
        return stand == 0 ? std::nullopt : std::optional{PatchCover{.stand = stand}};
    };
    const auto ground =
        reading.attempt([&] { return make_ground(heights_m, heights_file, cover->file, cover_at, reading); });
    if (!ground) {
        return std::nullopt;
    }
    warn_of_stands_without_patch(*cover, ground->grid, reading);
    std::vector<forest::StandRecord> inventory =
        place_records(std::move(*stands), ground->grid, *cover, reading);
    add_crown_cover(inventory, ground->grid, reading);
    if (!reading.problems().empty()) {
        return std::nullopt;
    }
    std::vector<TreeRecord> trees = placed(inventory, *ground, *species, reading.run().seed);
    // Patches reach half a cell of the heights over the terrain, where no rock comes.
    const Eigen::Vector2d origin_m = terrain.origin_m();
    std::erase_if(trees, [&](const TreeRecord& tree) {
        return !terrain.locate(tree.stem.x_m - origin_m.x(), tree.stem.y_m - origin_m.y());
    });
    reading.warn(
        {file_of_records(reading)}, joined(counted(trees.size(), "tree"), " derived from stand records"),
        "a list of mapped trees",
        "places and single diameters are drawn: run with other values of run.seed, and look for gaps "
        "that the records do not name");
    if (filled > 0) {
        reading.note(joined(file_of_records(reading), ": ", counted(filled, "stand record"),
                            " without heights: mean heights are those of trees as thick in a stand in the "
                            "French Prealps; what stops a rock is the diameter"));
    }
    return trees;
}

}  // namespace coupling
