#include "coupling/results/grounds.hpp"

#include <algorithm>
#include <cmath>

#include "config/text/joined.hpp"
#include "coupling/results/ground_columns.hpp"
#include "coupling/results/report/html_table.hpp"
#include "coupling/results/report/markup.hpp"
#include "coupling/results/report/sections.hpp"
#include "rockfall/motion/models.hpp"

namespace coupling::report {
namespace {

using config::joined;

/// The columns in which any ground type has something.
std::vector<std::size_t> shown_columns(const std::vector<GroundFigures>& grounds) {
    std::vector<std::size_t> shown;
    for (std::size_t i = 0; i < ground_columns().size(); ++i) {
        const bool is_soil = ground_columns()[i].name == soil_column;
        if (std::any_of(grounds.begin(), grounds.end(), [&](const GroundFigures& ground) {
                return is_soil ? !ground.soil.empty() : ground.has(i);
            })) {
            shown.push_back(i);
        }
    }
    return shown;
}

std::string cell_of(const GroundFigures& ground, std::size_t place) {
    const GroundColumn& column = ground_columns()[place];
    if (column.name == soil_column) {
        return joined("<code>", escaped(ground.soil), "</code>");
    }
    const double value = column.page_factor * ground.figures[place];
    return column.page_decimals <= 2 ? fixed(value, column.page_decimals)
           : std::isnan(value)       ? "–"
                                     : three_digits(value);
}

std::string caption_of(const RunResults& results, const std::vector<std::size_t>& shown) {
    const auto& model = rockfall::description_of(results.scenario.rockfall.fall.motion.model);
    std::string caption =
        joined("What the motion model uses of each ground type that occurs (", model.title, ").");
    for (const std::size_t place : shown) {
        const std::string_view note = ground_columns()[place].page_note;
        caption += joined(note.empty() ? "" : " ", note);
    }
    return caption + joined(" The mean diameter is ", fixed(middle_diameter_m(results), 2), " m.");
}

}  // namespace

std::string grounds(const RunResults& results) {
    const std::vector<GroundFigures> all = grounds_of(results);
    const std::vector<std::size_t> shown = shown_columns(all);
    std::vector<std::string> head{"Ground type", "code", "share of the area"};
    for (const std::size_t place : shown) {
        head.emplace_back(ground_columns()[place].head);
    }
    HtmlTable table{caption_of(results, shown), head};
    if (!shown.empty() && ground_columns()[shown.front()].name == soil_column) {
        table.text_columns({3});
    }
    for (const GroundFigures& ground : all) {
        std::vector<std::string> cells{escaped(ground.label), std::to_string(ground.code),
                                       percent(ground.area_share)};
        for (const std::size_t place : shown) {
            cells.push_back(cell_of(ground, place));
        }
        table.row(cells);
    }
    return joined("<h2>Ground</h2>\n<section class=\"card\">", table.html(), "</section>\n");
}

}  // namespace coupling::report
