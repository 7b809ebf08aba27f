#include "coupling/assessments/today/figures/grounds.hpp"

#include <cstddef>

#include "coupling/assessments/today/figures/ground_columns.hpp"
#include "coupling/assessments/today/figures/static_layouts.hpp"
#include "coupling/inputs/tables/csv_row.hpp"
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

double middle_diameter_m(const RunResults& results) {
    return rockfall::diameter_range(start_law(results.scenario), results.site.sources).mean_m;
}

std::vector<GroundFigures> grounds_of(const RunResults& results) {
    const Occurrence found = occurrence_of(results.site);
    const double diameter_m = middle_diameter_m(results);
    std::vector<GroundFigures> grounds;
    for (std::size_t i = 0; i < found.cells.size(); ++i) {
        if (found.occurs[i]) {
            grounds.push_back(
                figures_of(results.site.slope.types[i], results.scenario.rockfall.fall.motion, diameter_m));
            grounds.back().area_share =
                found.all == 0 ? 0.0 : static_cast<double>(found.cells[i]) / static_cast<double>(found.all);
        }
    }
    return grounds;
}

void write_grounds(std::ostream& out, const RunResults& results) {
    TableRows row{out, static_layouts(), "grounds.csv"};
    for (const GroundFigures& ground : grounds_of(results)) {
        row.whole(static_cast<unsigned>(ground.code)).text(ground.label).number<4>(ground.area_share);
        const std::vector<GroundColumn>& columns = ground_columns();
        for (std::size_t i = 0; i < columns.size(); ++i) {
            columns[i].name == soil_column ? row.text(ground.soil)
                                           : row.number(ground.figures[i], columns[i].decimals);
        }
        row.end();
    }
}

}  // namespace coupling
