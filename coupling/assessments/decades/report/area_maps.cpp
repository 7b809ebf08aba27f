#include "coupling/assessments/decades/report/area_maps.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "config/text/joined.hpp"
#include "coupling/results/report/map/map_sheet.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::decades {
namespace {

using config::joined;
using report::escaped;
using report::page_text;

/// P. Tol's bright scheme (SRON/EPS/TN/09-002), with dashes for those without colour.
struct AreaLook {
    const char* colour;
    const char* dashes;
};
constexpr std::array<AreaLook, 7> area_looks{{{"#4477AA", ""},
                                              {"#EE6677", "9 4"},
                                              {"#228833", "3 3"},
                                              {"#CCBB44", "12 4 3 4"},
                                              {"#66CCEE", "6 2"},
                                              {"#AA3377", "2 5"},
                                              {"#BBBBBB", "14 6"}}};

std::string style_of(std::size_t row) {
    const AreaLook& look = area_looks[row % area_looks.size()];
    return joined("fill=\"", look.colour, "\" fill-opacity=\"0.35\" stroke=\"", look.colour,
                  "\" stroke-width=\"2.5\"",
                  *look.dashes == '\0' ? "" : joined(" stroke-dasharray=\"", look.dashes, "\""));
}

/// The grounds of the rows of a regime on one map: the largest below, so that none hides another.
class Grounds {
public:
    void add(double area_ha, std::string drawing) { rows_.emplace_back(area_ha, std::move(drawing)); }

    /// Rows on the same ground share the look of the first of them, and it is drawn once. `shape`: the ground
    /// without its look. Returns the row whose look it has.
    std::size_t look_of(std::size_t row, const std::string& shape) {
        return looks_.try_emplace(shape, row).first->second;
    }

    [[nodiscard]] std::string drawing() const {
        std::vector<std::pair<double, std::string>> rows = rows_;
        std::stable_sort(rows.begin(), rows.end(),
                         [](const auto& a, const auto& b) { return a.first > b.first; });
        std::string all;
        for (const auto& [area_ha, drawing] : rows) {
            all += drawing;
        }
        return all;
    }

private:
    std::vector<std::pair<double, std::string>> rows_;
    std::map<std::string, std::size_t> looks_;  ///< by ground, the first row on it
};

/// "strips, clear_cut, turn 1 of 3, from year 5".
std::string when_of(const InterventionArea& area) {
    return area.first_year ? page_text("first in year {year}", {{"year", std::to_string(*area.first_year)}})
                           : page_text("when its condition holds");
}

/// The swatch of a row and its name, at the begin of a line of a legend.
std::string swatch_of(const Intervention& row, std::size_t number) {
    return joined(
        "<li><svg viewBox=\"0 0 26 14\" width=\"26\" height=\"14\" aria-hidden=\"true\"><rect x=\"2\" "
        "y=\"2\" width=\"22\" height=\"10\" ",
        style_of(number), "/></svg> <b>", escaped(row.name), "</b> ",
        row.name == name_of(row.treatment) ? "" : joined("(", name_of(row.treatment), ") "));
}

/// One line of the legend below the map: swatch, row, what, how much and when first.
std::string legend_line(const Intervention& row, std::size_t number,
                        const std::vector<const InterventionArea*>& areas) {
    double sum_ha = 0.0;
    const InterventionArea* first = areas.front();
    for (const InterventionArea* area : areas) {
        sum_ha += area->area_ha;
        if (area->first_year && (!first->first_year || *area->first_year < *first->first_year)) {
            first = area;
        }
    }
    // A corridor of several pieces counts once.
    std::vector<std::uint32_t> numbers;
    for (const InterventionArea* area : areas) {
        numbers.push_back(area->number);
    }
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    if (row.ground.where == Where::corridors) {
        sum_ha = 0.0;
        for (const std::uint32_t n : numbers) {
            sum_ha += (*std::find_if(areas.begin(), areas.end(), [&](const InterventionArea* a) {
                          return a->number == n;
                      }))->area_ha;
        }
    }
    const std::size_t count = first->at_the_start ? areas.size() : numbers.size();
    const std::string hectares = report::fixed(sum_ha, 2);
    const std::string legend =
        count == 1
            ? page_text("1 area, {hectares} ha of forest, {when}",
                        {{"hectares", hectares}, {"when", when_of(*first)}})
            : page_text(
                  "{areas} areas, {hectares} ha of forest, {when}",
                  {{"areas", std::to_string(count)}, {"hectares", hectares}, {"when", when_of(*first)}});
    return joined(swatch_of(row, number), legend,
                  first->at_the_start
                      ? joined(" ", page_text("(holes as the forest of the start would get them)"))
                      : "",
                  "</li>");
}

/// Rows that need no map: they act on the whole forest, or where another row has cut.
std::string rows_without_area(const Regime& regime) {
    std::string html;
    for (std::size_t row = 0; row < regime.interventions().size(); ++row) {
        if (regime.cuts_of(row)) {
            html += joined("<li><b>", escaped(regime.interventions()[row].name), "</b> ",
                           page_text("acts where {row} has cut",
                                     {{"row", escaped(regime.interventions()[*regime.cuts_of(row)].name)}}),
                           "</li>");
        }
    }
    return html;
}

/// One regime in the first climate: the ground of each row over all years, and the years with its hectares.
std::string made_map(const report::MapSheet& sheet, const Regime& regime, std::size_t place,
                     const DrawnCuts& made) {
    constexpr double patch_ha = forest::patch_area_m2 / 10'000.0;
    Grounds grounds;
    std::string legend;
    for (std::size_t row = 0; row < regime.interventions().size(); ++row) {
        std::vector<forest::PatchId> ground;
        std::vector<std::string> years;
        for (const CutMade& cut : made.cuts) {
            if (cut.course == made.names->course(place, 0) && cut.intervention == row) {
                ground.insert(ground.end(), cut.patches.begin(), cut.patches.end());
                years.push_back(
                    report::with_label(std::to_string(cut.year),
                                       report::fixed(static_cast<double>(cut.patches.size()) * patch_ha, 2)));
            }
        }
        if (!ground.empty()) {
            std::sort(ground.begin(), ground.end());
            ground.erase(std::unique(ground.begin(), ground.end()), ground.end());
            grounds.add(static_cast<double>(ground.size()) * patch_ha,
                        sheet.polygon(outline_of(*made.grid, ground), style_of(row)));
            legend += joined(swatch_of(regime.interventions()[row], row),
                             page_text("hectares of these patches by year: {years}",
                                       {{"years", report::join_with_semicolons(years)}}),
                             "</li>");
        }
    }
    return legend.empty()
               ? ""
               : sheet.figure(
                     {escaped(regime.name()), joined(page_text("Cuts made"), ", ", escaped(regime.name())),
                      grounds.drawing(), "", joined("<ul class=\"areas\">", legend, "</ul>")},
                     report::MapSize::half);
}

std::string made_maps(const report::MapSheet& sheet, const Management& management, const DrawnCuts& made) {
    std::string figures;
    for (std::size_t place = 0; place < management.regimes.size() && made.names != nullptr; ++place) {
        figures += made_map(sheet, management.regimes[place], place, made);
    }
    return figures.empty()
               ? ""
               : joined("<h3>", page_text("Cuts made"), "</h3><p>",
                        page_text("Where trees were cut or girdled in the first replicate, in the first "
                                  "climate: patches of 10 m that lost a tree. The layer cuts_made of "
                                  "results.gpkg has each year and climate by itself."),
                        "</p><div class=\"halves\">", figures, "</div>");
}

}  // namespace

std::string area_maps(const Site& site, const Management& management, std::span<const InterventionArea> areas,
                      const report::MapWindow& window, const DrawnCuts& made) {
    if (areas.empty()) {
        return "";
    }
    const report::MapSheet sheet{site, window};
    std::string figures;
    for (std::size_t place = 0; place < management.regimes.size(); ++place) {
        const Regime& regime = management.regimes[place];
        Grounds grounds;
        std::string legend;
        for (std::size_t row = 0; row < regime.interventions().size(); ++row) {
            std::vector<const InterventionArea*> here;
            std::string shape;
            double area_ha = 0.0;
            for (const InterventionArea& area : areas) {
                if (area.regime == place && area.intervention == row) {
                    here.push_back(&area);
                    shape += sheet.polygon(area.shape, "");
                    area_ha += area.area_ha;
                }
            }
            if (here.empty()) {
                continue;
            }
            const std::size_t look = grounds.look_of(row, shape);
            if (look == row) {
                std::string drawing;
                for (const InterventionArea* area : here) {
                    drawing += sheet.polygon(area->shape, style_of(row));
                }
                grounds.add(area_ha, std::move(drawing));
            }
            legend += legend_line(regime.interventions()[row], look, here);
        }
        if (legend.empty()) {
            continue;
        }
        figures += sheet.figure(
            {escaped(regime.name()), joined(page_text("Where the regimes act"), ", ", escaped(regime.name())),
             grounds.drawing(), "",
             joined("<ul class=\"areas\">", legend, rows_without_area(regime), "</ul>")},
            report::MapSize::half);
    }
    return joined(
        "<section class=\"card\"><p>",
        page_text("The ground of each row of a regime, as it is known before the run. With several turns all "
                  "of them are drawn. Rows on the same ground share a colour here. The layer "
                  "intervention_areas of results.gpkg has each area with its turn and first year."),
        "</p>", sheet.definitions(), "<div class=\"halves\">", figures, "</div>",
        made_maps(sheet, management, made), "</section>\n");
}

}  // namespace coupling::decades
