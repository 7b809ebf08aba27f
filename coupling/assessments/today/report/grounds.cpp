#include "coupling/assessments/today/figures/grounds.hpp"

#include <algorithm>
#include <cmath>

#include "coupling/assessments/today/figures/ground_columns.hpp"
#include "coupling/assessments/today/report/sections.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"
#include "coupling/results/text/phrases.hpp"
#include "rockfall/motion/models.hpp"

namespace coupling::report {
namespace {

/// Whether a column says for every ground type what another one says already.
bool is_repeated(const std::vector<GroundFigures>& grounds, std::size_t place) {
    const std::string_view other = ground_columns()[place].repeats;
    if (other.empty()) {
        return false;
    }
    const std::size_t first = ground_column(other);
    return std::all_of(grounds.begin(), grounds.end(), [&](const GroundFigures& ground) {
        return ground.figures[place] == ground.figures[first] || !ground.has(place);
    });
}

bool is_soil(std::size_t place) {
    return ground_columns()[place].name == soil_column;
}

/// The columns in which any ground type has something, without repetitions.
std::vector<std::size_t> shown_columns(const std::vector<GroundFigures>& grounds) {
    std::vector<std::size_t> shown;
    for (std::size_t i = 0; i < ground_columns().size(); ++i) {
        if (std::any_of(grounds.begin(), grounds.end(),
                        [&](const GroundFigures& ground) {
                            return is_soil(i) ? !ground.soil.empty() : ground.has(i);
                        }) &&
            !is_repeated(grounds, i)) {
            shown.push_back(i);
        }
    }
    return shown;
}

std::string cell_of(const GroundFigures& ground, std::size_t place) {
    if (is_soil(place)) {
        return ground.soil;
    }
    const GroundColumn& column = ground_columns()[place];
    const double value = column.page_factor * ground.figures[place];
    return column.page_decimals <= 2 ? fixed(value, column.page_decimals) : three_digits(value);
}

}  // namespace

PageFields grounds(const RunResults& results) {
    const std::vector<GroundFigures> all = grounds_of(results);
    const std::vector<std::size_t> shown = shown_columns(all);
    std::vector<PageFields> columns, notes, rows;
    for (const std::size_t place : shown) {
        columns.push_back({{"is_text", is_soil(place)}, {"column", page_text(ground_columns()[place].head)}});
        if (const std::string note = ground_columns()[place].page_note; !note.empty()) {
            notes.push_back({{"note", page_text(note)}});
        }
    }
    for (const GroundFigures& ground : all) {
        std::vector<PageFields> cells;
        for (const std::size_t place : shown) {
            cells.push_back({{"is_text", is_soil(place)}, {"cell", cell_of(ground, place)}});
        }
        rows.push_back({{"ground", in_page_language(ground.label)},
                        {"code", std::to_string(ground.code)},
                        {"area_share", percent(ground.area_share)},
                        {"cells", cells}});
    }
    const auto& model = rockfall::description_of(results.scenario.rockfall.fall.motion.model);
    return {{"model", in_page_language(model.title)},
            {"notes", notes},
            {"middle_diameter_m", fixed(middle_diameter_m(results), 2)},
            {"ground_columns", columns},
            {"grounds", rows}};
}

}  // namespace coupling::report
