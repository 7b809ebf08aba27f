#include "coupling/inputs/forest/forest_site.hpp"

#include <algorithm>
#include <set>

#include "config/table/shape_field.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/forest/crown_cover_input.hpp"
#include "coupling/inputs/forest/dbh_class_input.hpp"
#include "coupling/inputs/forest/forest_doubts.hpp"
#include "coupling/inputs/forest/patch_input.hpp"
#include "coupling/inputs/forest/soil_input.hpp"
#include "coupling/inputs/forest/spin_up.hpp"
#include "coupling/inputs/forest/stand_input.hpp"
#include "coupling/inputs/forest/start_input.hpp"
#include "coupling/inputs/forest/tree_input.hpp"
#include "coupling/inputs/reading/declared_tables.hpp"
#include "coupling/inputs/scenario/forest_settings.hpp"
#include "coupling/inputs/scenario/run_settings.hpp"
#include "coupling/inputs/scenario/tree_settings.hpp"
#include "forest/stand/height_growth.hpp"
#include "forest/start/height_curve.hpp"
#include "forest/treatment/area.hpp"

namespace coupling {

struct TreeAreaRow {
    config::Shape shape;
};

const config::Schema<TreeAreaRow>& tree_area_columns() {
    // clang-format off
    static const config::Schema<TreeAreaRow> columns{
        {.role = "tree_area", .setting = "stands.tree_area", .row = "area"},
        {{"wkt", &TreeAreaRow::shape, "inside, the trees are those of trees.file", {.shapes = {config::Shape::Kind::polygon}}}}};
    // clang-format on
    return columns;
}
namespace {

using config::joined;

/// Trees that come up later get numbers above all of these.
constexpr double highest_listed_id = 1e12;
constexpr std::uint64_t first_inventoried_id = 1'000'000'000'001;

/// Everything as read from the files; what could not be read is missing.
struct Files {
    std::optional<ForestSpecies> species;
    std::optional<forest::Parameters> parameters;
    std::vector<NamedClimate> climates;  ///< empty: not read
    std::optional<SoilCover> soils;
    std::optional<StandCover> stands;
    std::optional<std::vector<ListedRow>> rows;
    std::optional<std::map<std::uint32_t, InventoriedStand>> records;
};

bool has_records(const ForestSettings& settings) {
    return !settings.stand_records.empty() || !settings.dbh_classes.empty();
}

std::vector<ListedRow> read_rows(const ForestSpecies& species, Reading& reading) {
    const config::Table table = tree_table(reading);
    ListedTrees trees = read_listed_rows(table, species.lookup(), reading, false);
    warn_of_stand_ins(trees.species, species, table.file(), reading);
    return std::move(trees.rows);
}

Files read_files(Reading& reading) {
    Files files;
    files.species = read_forest_species(reading);
    files.climates = read_climates(reading);
    files.soils = read_soils(reading);
    files.stands = read_stand_cover(reading);
    if (!files.species) {
        return files;  // nothing can be said about species in other files
    }
    files.parameters = read_forest_parameters(*files.species, reading);
    files.rows.emplace();
    files.records.emplace();
    if (!reading.trees().source().empty()) {
        files.rows = reading.attempt([&] { return read_rows(*files.species, reading); });
    }
    if (!reading.forest().stand_records.empty()) {
        files.records = read_records(*files.species, reading);
    }
    if (files.records && !add_dbh_classes(*files.species, reading, *files.records)) {
        files.records.reset();
    }
    if (reading.trees().source().empty() && !has_records(reading.forest())) {
        reading.note(joined("neither trees.file nor stands.records: the forest begins on bare ground"));
    }
    return files;
}

/// The ground with its stands and soils; refuses forest without a soil.
std::optional<ForestGround> lay_ground(const config::Raster<double>& heights_m,
                                       const std::string& heights_file, const StandCover& stands,
                                       const SoilCover& soils, Reading& reading) {
    std::size_t without_soil = 0;
    const auto cover_at = [&](double x_m, double y_m) -> std::optional<PatchCover> {
        const std::uint32_t stand = stands.at(x_m, y_m);
        if (stand == 0) {
            return std::nullopt;
        }
        const auto soil = soils.at(x_m, y_m);
        without_soil += soil ? 0U : 1U;
        return PatchCover{stand, soil.value_or(forest::Soil{})};
    };
    auto ground =
        reading.attempt([&] { return make_ground(heights_m, heights_file, stands.file, cover_at, reading); });
    if (without_soil > 0) {
        reading.refuse({soils.file},
                       joined("no soil code for ", counted(without_soil, "forest cell"), " of 10 m"),
                       "a code wherever there is forest, or soil.type for the rest");
    }
    if (ground) {
        warn_of_stands_without_patch(stands, ground->grid, reading);
    }
    return ground;
}

/// Mean rise of the ground from the first line of cells to the one beyond the last, along x or up the page.
double gain_m(const config::Raster<double>& heights_m, bool along_x) {
    const config::GridFrame& frame = heights_m.frame;
    const int cells = along_x ? frame.columns : frame.rows;
    const int lines = along_x ? frame.rows : frame.columns;
    double sum_m = 0.0;
    for (int line = 0; line < lines; ++line) {
        sum_m += along_x ? heights_m.at({cells - 1, line}) - heights_m.at({0, line})
                         : heights_m.at({line, 0}) - heights_m.at({line, cells - 1});
    }
    return cells > 1 ? sum_m / lines * cells / (cells - 1) : 0.0;
}

/// Whether the forest has patches along all sides of its frame: a rim without them would be part of what
/// periodic edges repeat.
bool reaches_all_sides(const forest::PatchGrid& grid) {
    const config::GridFrame& frame = grid.frame();
    bool west = false;
    bool east = false;
    bool north = false;
    bool south = false;
    for (const forest::Patch& patch : grid.patches()) {
        west = west || patch.cell.column == 0;
        east = east || patch.cell.column == frame.columns - 1;
        north = north || patch.cell.row == 0;
        south = south || patch.cell.row == frame.rows - 1;
    }
    return west && east && north && south;
}

forest::Site site_on(const ForestGround& ground, const ClimateSource& climate,
                     const ForestSettings& settings) {
    const config::Angle latitude = config::Angle::from_degrees(settings.latitude_deg);
    forest::SkySettings sky;
    sky.latitude = latitude;
    forest::LightGround light_ground;
    light_ground.elevation_m = ground.elevation_m;
    light_ground.edges = settings.edges;
    light_ground.gain_x_m = gain_m(ground.elevation_m, true);
    light_ground.gain_y_m = gain_m(ground.elevation_m, false);
    return {ground.grid, latitude,
            forest::LightFrame{
                .sky = forest::Sky{sky, forest::split_radiation(latitude, climate.mean_radiation_mjpm2())},
                .ground = std::move(light_ground),
                .horizons = ground.horizons}};
}

double mean_elevation_m(const forest::PatchGrid& grid, const std::vector<forest::PatchId>& patches) {
    double sum_m = 0.0;
    for (const forest::PatchId patch : patches) {
        sum_m += grid[patch].ground_m;
    }
    return sum_m / static_cast<double>(patches.size());
}

std::vector<forest::PatchId> all_patches(const forest::PatchGrid& grid) {
    std::vector<forest::PatchId> patches;
    for (std::uint32_t i = 0; i < grid.size(); ++i) {
        patches.push_back(forest::PatchId{i});
    }
    return patches;
}

/// The user's own numbers where they are different whole numbers, else those of the rows, with a warning.
std::vector<std::uint64_t> numbers_of(const std::vector<ListedRow>& rows, const std::string& file,
                                      Reading& reading) {
    std::vector<std::uint64_t> numbers;
    std::set<std::uint64_t> seen;
    for (const ListedRow& row : rows) {
        const auto number = config::parse_whole(row.id);
        if (number && *number >= 0 && static_cast<double>(*number) < highest_listed_id) {
            numbers.push_back(static_cast<std::uint64_t>(*number));
            seen.insert(numbers.back());
        }
    }
    if (seen.size() == rows.size()) {
        return numbers;
    }
    reading.note(
        joined(file, ": tree_id are not different whole numbers; trees are numbered as the rows from 1 on"));
    numbers.clear();
    for (const ListedRow& row : rows) {
        numbers.push_back(row.row + 1);
    }
    return numbers;
}

/// The polygons in which the list of trees holds; none without stands.tree_area.
std::optional<std::vector<config::Shape>> read_tree_area(Reading& reading) {
    const std::string& name = reading.forest().tree_area;
    std::vector<config::Shape> polygons;
    if (name.empty()) {
        return polygons;
    }
    return reading.attempt([&] {
        for (config::Read<TreeAreaRow>& row : rows_of(tree_area_columns(), name, reading)) {
            polygons.push_back(std::move(row.shape));
        }
        return polygons;
    });
}

/// Patches of the tree area are no patches of the records.
void leave_out(const std::vector<config::Shape>& tree_area, const forest::PatchGrid& grid,
               std::vector<forest::StandRecord>& inventory) {
    for (forest::StandRecord& record : inventory) {
        std::erase_if(record.patches, [&](forest::PatchId patch) {
            return forest::belongs({tree_area, {}}, grid, grid.x_centre_m(patch), grid.y_centre_m(patch));
        });
    }
    std::erase_if(inventory, [](const forest::StandRecord& record) { return record.patches.empty(); });
}

/// Listed trees outside of the area would stand among those of the records.
void keep_inside(const std::vector<config::Shape>& tree_area, std::optional<std::vector<ListedRow>>& rows,
                 Reading& reading) {
    if (!rows) {
        return;
    }
    const std::size_t outside = std::erase_if(*rows, [&](const ListedRow& row) {
        return std::none_of(tree_area.begin(), tree_area.end(), [&](const config::Shape& polygon) {
            return config::point_in_polygon(polygon, {row.x_m, row.y_m});
        });
    });
    if (outside > 0) {
        reading.note(joined(reading.shown(reading.trees().source()), ": ", counted(outside, "tree"),
                            " outside of stands.tree_area left out: the records hold there"));
    }
}

/// Puts the trees of the list where they grow, or among the obstacles.
void plant(const std::vector<ListedRow>& rows, ForestSite& site, Reading& reading) {
    const std::string file = reading.shown(reading.trees().source());
    const std::vector<std::uint64_t> numbers = numbers_of(rows, file, reading);
    const forest::SpeciesTable& table = site.species.table;
    std::vector<forest::ListedTree> list;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        list.push_back({.id = numbers[i],
                        .x_m = rows[i].x_m,
                        .y_m = rows[i].y_m,
                        .species = forest::SpeciesId{static_cast<std::uint16_t>(rows[i].species)},
                        .dbh_cm = rows[i].dbh_cm,
                        .height_m = rows[i].height_m,
                        .age_years = rows[i].age_years});
    }
    const double degree_days =
        site.climates.front().source.degree_days(mean_elevation_m(site.grid, all_patches(site.grid)));
    config::Warnings found;
    forest::StartingTrees start = forest::trees_from_list(list, site.grid, table, degree_days, found);
    reading.take(found, joined(file, ": "));
    site.listed = std::move(start.trees);
    std::size_t filled = 0;
    for (const std::size_t i : start.outside) {
        const forest::ListedTree& tree = list[i];
        const forest::Species& kind = table[tree.species];
        const double height_m =
            tree.height_m.value_or(forest::height_by_growth(kind, tree.dbh_cm, degree_days));
        filled += tree.height_m ? 0U : 1U;
        const double energy =
            site.species.fracture_energy.empty() ? 1.0 : site.species.fracture_energy[rows[i].species];
        site.obstacles.push_back(
            {std::to_string(tree.id), kind.code, {tree.x_m, tree.y_m, tree.dbh_cm, height_m, energy}});
    }
    if (filled > 0) {
        reading.note(joined(file, ": ", counted(filled, "height"),
                            " of trees outside the forest filled in from the growth law of the species"));
    }
}

}  // namespace

forest::Stand ForestSite::start(std::uint64_t seed, std::uint32_t replicate) const {
    std::vector<forest::Tree> trees = listed;
    // Numbers of listed trees stay theirs.
    std::uint64_t next_id = listed.empty() ? 1 : first_inventoried_id;
    for (const forest::StandRecord& record : inventory) {
        const auto of_stand =
            forest::trees_from_record(record, grid, species.table, seed, replicate, next_id);
        next_id += of_stand.size();
        trees.insert(trees.end(), of_stand.begin(), of_stand.end());
    }
    forest::Stand stand{grid, species.table.size(), std::move(trees), first_year() - 1};
    forest::SnagsAndLogs wood =
        forest::dead_wood_from_records(dead_wood, grid, species.table, first_year() - 1, seed, replicate);
    std::vector<forest::Cohort> young = forest::cohorts_from_records(saplings, seed, replicate);
    if (spin_up_years > 0) {
        SpunUp made = spin_up(*this, stand, seed, replicate);
        wood = dead_wood.empty() ? std::move(made.dead_wood) : std::move(wood);
        young = saplings.empty() ? std::move(made.saplings) : std::move(young);
    }
    stand.begin_with(std::move(wood));
    stand.add_cohorts(young);
    return stand;
}

YearWeather ForestSite::weather(std::size_t climate, int calendar_year, std::uint32_t replicate) const {
    std::vector<double> elevations_m;
    for (const forest::SiteUnit& unit : place.units()) {
        elevations_m.push_back(unit.elevation_m);
    }
    YearWeather weather = climates[climate].source.weather(calendar_year, replicate, elevations_m);
    weather.usual_summer_mm = climates[climate].usual_summer_mm;
    return weather;
}

std::shared_ptr<ForestSite> open_forest(const config::Raster<double>& heights_m,
                                        const std::string& heights_file, Reading& reading) {
    Files files = read_files(reading);
    files.stands = cover_on_heights(std::move(files.stands), heights_m.frame, reading);
    std::optional<ForestGround> ground;
    std::vector<forest::StandRecord> inventory;
    if (files.stands && files.soils) {
        ground = lay_ground(heights_m, heights_file, *files.stands, *files.soils, reading);
    }
    if (ground && files.records && has_records(reading.forest())) {
        inventory = place_records(std::move(*files.records), ground->grid, *files.stands, reading);
    }
    const bool is_periodic = reading.forest().edges == forest::Edges::torus;
    if (ground && is_periodic && !reaches_all_sides(ground->grid)) {
        reading.refuse({heights_file}, "forest.edges = periodic, but the forest ends before the heights do",
                       "forest along all sides of the heights",
                       "use forest.edges = mirror, or cut the heights");
    }
    std::optional<std::vector<config::Shape>> tree_area = read_tree_area(reading);
    if (ground && tree_area && !tree_area->empty()) {
        leave_out(*tree_area, ground->grid, inventory);
        keep_inside(*tree_area, files.rows, reading);
    }
    if (ground) {
        add_crown_cover(inventory, ground->grid, reading);
    }
    std::optional<StartingWood> wood;
    if (ground && files.species) {
        wood = read_starting_wood(*files.species, ground->grid, reading);
    }
    if (!files.species || !files.parameters || files.climates.empty() || !ground || !files.rows ||
        !files.records || !wood || !reading.problems().empty()) {
        return nullptr;
    }
    forest::Site place = site_on(*ground, files.climates.front().source, reading.forest());
    auto site = std::make_shared<ForestSite>(
        ForestSite{.species = std::move(*files.species),
                   .parameters = std::move(*files.parameters),
                   .grid = std::move(ground->grid),
                   .place = std::move(place),
                   .climates = {},
                   .listed = {},
                   .inventory = std::move(inventory),
                   .dead_wood = std::move(wood->dead_wood),
                   .saplings = std::move(wood->saplings),
                   .obstacles = {},
                   .spin_up_years = static_cast<int>(reading.forest().spin_up_years),
                   .run_years = static_cast<int>(reading.run().years)});
    for (NamedClimate& climate : files.climates) {
        std::vector<double> usual_summer_mm;
        for (const forest::SiteUnit& unit : site->place.units()) {
            usual_summer_mm.push_back(climate.source.usual_summer_mm(unit.elevation_m));
        }
        site->climates.push_back(
            {std::move(climate.name), std::move(climate.source), std::move(usual_summer_mm)});
    }
    doubt_climates(*site, mean_elevation_m(site->grid, all_patches(site->grid)), reading);
    const ClimateSource& first = site->climates.front().source;
    for (forest::StandRecord& record : site->inventory) {
        record.degree_days = first.degree_days(mean_elevation_m(site->grid, record.patches));
    }
    for (auto& stand : site->dead_wood) {
        stand.degree_days = first.degree_days(mean_elevation_m(site->grid, stand.patches));
    }
    plant(*files.rows, *site, reading);
    doubt_dense_list(*site, reading);
    doubt_first_disturbance(*site, reading);
    doubt_events(*site, reading);
    return site;
}

}  // namespace coupling
