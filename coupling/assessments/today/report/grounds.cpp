#include "coupling/assessments/today/figures/grounds.hpp"

#include <algorithm>
#include <cmath>

#include "config/text/joined.hpp"
#include "coupling/assessments/today/figures/ground_columns.hpp"
#include "coupling/assessments/today/report/sections.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/report/html_table.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"
#include "coupling/results/text/phrases.hpp"
#include "rockfall/motion/models.hpp"

namespace coupling::report {
namespace {

using config::joined;

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

/// The columns in which any ground type has something, without repetitions.
std::vector<std::size_t> shown_columns(const std::vector<GroundFigures>& grounds) {
    std::vector<std::size_t> shown;
    for (std::size_t i = 0; i < ground_columns().size(); ++i) {
        const bool is_soil = ground_columns()[i].name == soil_column;
        if (std::any_of(grounds.begin(), grounds.end(),
                        [&](const GroundFigures& ground) {
                            return is_soil ? !ground.soil.empty() : ground.has(i);
                        }) &&
            !is_repeated(grounds, i)) {
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
        page_text("Parameters of each ground type that occurs, as the motion model uses them ({model}).",
                  {{"model", in_page_language(model.title)}});
    for (const std::size_t place : shown) {
        const std::string_view note = ground_columns()[place].page_note;
        caption += note.empty() ? "" : joined(" ", page_text(note));
    }
    return joined(caption, " ",
                  page_text("The mean diameter is {middle_diameter_m} m.",
                            {{"middle_diameter_m", fixed(middle_diameter_m(results), 2)}}));
}

}  // namespace

std::string grounds(const RunResults& results) {
    const std::vector<GroundFigures> all = grounds_of(results);
    const std::vector<std::size_t> shown = shown_columns(all);
    std::vector<std::string> head{page_text("Ground type"), page_text("code"),
                                  page_text("share of the area")};
    for (const std::size_t place : shown) {
        head.push_back(page_text(ground_columns()[place].head));
    }
    HtmlTable table{caption_of(results, shown), head};
    if (!shown.empty() && ground_columns()[shown.front()].name == soil_column) {
        table.text_columns({3});
    }
    for (const GroundFigures& ground : all) {
        std::vector<std::string> cells{escaped(in_page_language(ground.label)), std::to_string(ground.code),
                                       percent(ground.area_share)};
        for (const std::size_t place : shown) {
            cells.push_back(cell_of(ground, place));
        }
        table.row(cells);
    }
    return joined("<h2>", page_text("Ground"), "</h2>\n<section class=\"card\">", table.html(),
                  "</section>\n");
}

}  // namespace coupling::report
