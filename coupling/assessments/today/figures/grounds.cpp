#include "coupling/assessments/today/figures/grounds.hpp"

#include <cstddef>

#include "coupling/assessments/today/figures/ground_columns.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/tables/table_of.hpp"
#include "rockfall/motion/models.hpp"
#include "rockfall/release/release.hpp"

namespace coupling {
namespace {

using rockfall::SurfaceType;

GroundFigures figures_of(const SurfaceType& type, const rockfall::MotionLaws& laws, double diameter_m) {
    GroundFigures ground{.code = type.code, .label = type.label};
    ground.figures.assign(ground_columns().size(), rockfall::no_figure);
    const std::vector<rockfall::GroundColumnText> columns = rockfall::ground_columns_of(laws.model);
    const std::vector<double> figures = rockfall::ground_figures(type, laws, diameter_m);
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const std::size_t place = ground_column(columns[i].name);
        const auto converted = ground_columns()[place].converted;
        ground.figures[place] = converted == nullptr ? figures[i] : converted(figures[i]);
        if (columns[i].name == soil_column && type.soil) {
            ground.soil = type.soil->name;
        }
    }
    return ground;
}

/// Cells of the maps by ground type; a type that only faces of a mesh carry has none, but occurs.
struct Occurrence {
    std::vector<std::size_t> cells;
    std::vector<bool> occurs;
    std::size_t all = 0;
};

Occurrence occurrence_of(const Site& site) {
    Occurrence found{std::vector<std::size_t>(site.slope.types.size()),
                     std::vector<bool>(site.slope.types.size())};
    for (const std::uint8_t id : site.surface.values) {
        if (id < found.cells.size()) {
            ++found.cells[id];
            ++found.all;
            found.occurs[id] = true;
        }
    }
    for (const rockfall::Triangle& triangle : site.slope.terrain.triangles()) {
        if (triangle.surface > 0) {
            found.occurs[triangle.surface - 1] = true;
        }
    }
    return found;
}

}  // namespace

namespace {

double middle_diameter_m(const Scenario& scenario, const Site& site) {
    return rockfall::diameter_range(start_law(scenario.release), site.sources).mean_m;
}

}  // namespace

double middle_diameter_m(const RunResults& results) {
    return middle_diameter_m(results.scenario, results.site);
}

std::vector<GroundFigures> grounds_of(const RunResults& results) {
    return grounds_of(results.scenario, results.site);
}

std::vector<GroundFigures> grounds_of(const Scenario& scenario, const Site& site) {
    const Occurrence found = occurrence_of(site);
    const double diameter_m = middle_diameter_m(scenario, site);
    std::vector<GroundFigures> grounds;
    for (std::size_t i = 0; i < found.cells.size(); ++i) {
        if (found.occurs[i]) {
            grounds.push_back(figures_of(site.slope.types[i], scenario.rockfall.fall.motion, diameter_m));
            grounds.back().area_share =
                found.all == 0 ? 0.0 : static_cast<double>(found.cells[i]) / static_cast<double>(found.all);
        }
    }
    return grounds;
}

namespace {

TableOf<GroundFigures> ground_table() {
    ColumnsOf<GroundFigures> columns{
        {"code", "code of the ground type; 0 for that of terrain.ground", "input terrain",
         &GroundFigures::code},
        {"ground", "name of the ground type", "input terrain", &GroundFigures::label},
        {"area_share", 4, "share of the cells of the maps with ground", "counted over the cells",
         &GroundFigures::area_share}};
    const std::vector<Column> described = ground_table_columns();
    for (std::size_t i = 0; i < described.size(); ++i) {
        columns +=
            described[i].name == soil_column
                ? ColumnsOf<GroundFigures>{described[i], &GroundFigures::soil}
                : ColumnsOf<GroundFigures>{described[i], ground_columns()[i].decimals,
                                           [i](const GroundFigures& ground) { return ground.figures[i]; }};
    }
    return {"grounds.csv", "The ground types that occur, with the parameters that the motion model uses.",
            "a ground type that occurs", columns};
}

}  // namespace

TableLayout ground_layout() {
    return ground_table();
}

WrittenFile write_grounds(const std::filesystem::path& folder, const RunResults& results) {
    return ground_table().write(folder, [&](auto& rows) { rows.add_all(grounds_of(results)); });
}

}  // namespace coupling
