#include "coupling/assessments/decades/report/areas/area_maps.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

#include "coupling/assessments/decades/report/areas/area_years.hpp"
#include "coupling/results/report/map/map_sheet.hpp"
#include "coupling/results/templates/page_template.hpp"
#include "coupling/results/text/element.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::decades {
namespace {

using report::page_text;
using report::PageFields;

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

report::Attributes style_of(std::size_t row) {
    const AreaLook& look = area_looks[row % area_looks.size()];
    return {{"fill", look.colour},
            {"fill-opacity", "0.35"},
            {"stroke", look.colour},
            {"stroke-width", 2.5},
            {"stroke-dasharray", look.dashes}};
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

/// When a row comes to its areas: "in 2026", or "turn 1: in 2026; turns 2, 3: not in the years of the run".
std::string when_of(const Regime& regime, const std::vector<const InterventionArea*>& areas,
                    int start_calendar_year) {
    std::map<int, const InterventionArea*> by_turn;
    for (const InterventionArea* area : areas) {
        by_turn.try_emplace(area->turn, area);
    }
    std::vector<std::pair<std::string, std::vector<std::string>>> turns_by_when;
    for (const auto& [turn, area] : by_turn) {
        const std::string when =
            when_in_words(area->planned, regime, area->intervention, start_calendar_year);
        const auto same = std::find_if(turns_by_when.begin(), turns_by_when.end(),
                                       [&](const auto& known) { return known.first == when; });
        (same == turns_by_when.end() ? turns_by_when.emplace_back(when, std::vector<std::string>{}) : *same)
            .second.push_back(std::to_string(turn));
    }
    if (turns_by_when.size() == 1) {
        return turns_by_when.front().first;
    }
    std::vector<std::string> texts;
    for (const auto& [when, turns] : turns_by_when) {
        texts.push_back(turns.size() == 1
                            ? page_text("turn {turn}: {when}", {{"turn", turns.front()}, {"when", when}})
                            : page_text("turns {turns}: {when}",
                                        {{"turns", report::join_with_commas(turns)}, {"when", when}}));
    }
    return report::join_with_semicolons(texts);
}

/// The middle of the corners of an area.
config::Point2 middle_of(const config::Shape& shape) {
    const std::vector<config::Point2>& ring = shape.parts.front();
    const std::size_t corners = ring.size() > 1 ? ring.size() - 1 : 1;  // the first stands at the end again
    config::Point2 sum{0.0, 0.0};
    for (std::size_t i = 0; i < corners; ++i) {
        sum.x_m += ring[i].x_m;
        sum.y_m += ring[i].y_m;
    }
    return {sum.x_m / static_cast<double>(corners), sum.y_m / static_cast<double>(corners)};
}

/// An entry of the legend below a map: swatch and name of a row; `more` says what it does.
PageFields swatch_of(const Intervention& row, std::size_t number, PageFields more) {
    report::Attributes sample{{"x", 2.0}, {"y", 2.0}, {"width", 22.0}, {"height", 10.0}};
    const report::Attributes style = style_of(number);
    sample.insert(sample.end(), style.begin(), style.end());
    const std::string treatment{name_of(row.treatment)};
    more.insert(more.end(), {{"sample", report::element("rect", sample)},
                             {"name", row.name},
                             {"is_named", row.name != treatment},
                             {"treatment", treatment}});
    return more;
}

/// What a row does, how much and when.
PageFields planned_fields(const Intervention& row, std::size_t number,
                          const std::vector<const InterventionArea*>& areas, const std::string& when) {
    double sum_ha = 0.0;
    for (const InterventionArea* area : areas) {
        sum_ha += area->area_ha;
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
    const bool at_the_start = areas.front()->at_the_start;
    const std::size_t count = at_the_start ? areas.size() : numbers.size();
    return swatch_of(row, number,
                     {{"planned", PageFields{{"is_one", count == 1},
                                             {"areas", std::to_string(count)},
                                             {"hectares", report::hectares(sum_ha)},
                                             {"when", when},
                                             {"as_holes", at_the_start}}},
                      {"made", false}});
}

/// Rows that need no map: they act where another row has cut or salvaged.
std::vector<PageFields> rows_without_area(const Regime& regime, const ForestSite& forest) {
    std::vector<PageFields> rows;
    for (std::size_t row = 0; row < regime.interventions().size(); ++row) {
        if (const auto cuts = regime.cuts_of(row)) {
            const Intervention& source = regime.interventions()[*cuts];
            rows.push_back({{"name", regime.interventions()[row].name},
                            {"row", source.name},
                            {"is_salvage", source.treatment == Treatment::salvage},
                            {"when", when_in_words(planned_years(regime, row, std::nullopt, forest.run_years),
                                                   regime, row, forest.first_year() - 1)}});
        }
    }
    return rows;
}

std::string map_of(const report::MapSheet& sheet, const Regime& regime, const std::string& title,
                   const std::string& drawing, const std::vector<PageFields>& swatches,
                   const std::vector<PageFields>& following) {
    return swatches.empty()
               ? ""
               : sheet.figure({regime.name(), report::join_with_commas({title, regime.name()}), drawing, "",
                               report::filled_template("area_legend.html",
                                                       {{"swatches", swatches}, {"following", following}})},
                              report::MapSize::half);
}

/// One regime in the first climate: the ground of each row over all years, and the calendar years with its
/// hectares.
std::string made_map(const report::MapSheet& sheet, const Regime& regime, std::size_t place,
                     const DrawnCuts& made, int start_calendar_year) {
    constexpr double patch_ha = forest::patch_area_m2 / 10'000.0;
    Grounds grounds;
    std::vector<PageFields> swatches;
    for (std::size_t row = 0; row < regime.interventions().size(); ++row) {
        std::vector<forest::PatchId> ground;
        std::vector<std::string> years;
        for (const CutMade& cut : made.cuts) {
            if (cut.course == made.names->course(place, 0) && cut.intervention == row) {
                ground.insert(ground.end(), cut.patches.begin(), cut.patches.end());
                years.push_back(
                    report::with_label(std::to_string(start_calendar_year + cut.year),
                                       report::hectares(static_cast<double>(cut.patches.size()) * patch_ha)));
            }
        }
        if (!ground.empty()) {
            std::sort(ground.begin(), ground.end());
            ground.erase(std::unique(ground.begin(), ground.end()), ground.end());
            grounds.add(static_cast<double>(ground.size()) * patch_ha,
                        report::element("g", style_of(row), sheet.polygon(outline_of(*made.grid, ground))));
            swatches.push_back(swatch_of(
                regime.interventions()[row], row,
                {{"planned", false}, {"made", PageFields{{"years", report::join_with_semicolons(years)}}}}));
        }
    }
    return map_of(sheet, regime, page_text("Cuts made"), grounds.drawing(), swatches, {});
}

std::string made_maps(const report::MapSheet& sheet, const Management& management, const DrawnCuts& made,
                      int start_calendar_year) {
    std::string figures;
    for (std::size_t place = 0; place < management.regimes.size() && made.names != nullptr; ++place) {
        figures += made_map(sheet, management.regimes[place], place, made, start_calendar_year);
    }
    return figures;
}

/// One regime: the ground of its rows as it is known before the run.
std::string planned_map(const report::MapSheet& sheet, const Regime& regime, std::size_t place,
                        std::span<const InterventionArea> areas, const ForestSite& forest) {
    const int start = forest.first_year() - 1;
    Grounds grounds;
    std::vector<PageFields> swatches;
    std::vector<report::MapSheet::PlacedText> years;
    for (std::size_t row = 0; row < regime.interventions().size(); ++row) {
        std::vector<const InterventionArea*> here;
        std::string shape;
        double area_ha = 0.0;
        for (const InterventionArea& area : areas) {
            if (area.regime == place && area.intervention == row) {
                here.push_back(&area);
                shape += sheet.polygon(area.shape);
                area_ha += area.area_ha;
            }
        }
        if (here.empty()) {
            continue;
        }
        const std::size_t look = grounds.look_of(row, shape);
        if (look == row) {
            grounds.add(area_ha, report::element("g", style_of(row), shape));
            for (const InterventionArea* area : here) {
                if (regime.interventions()[row].ground.entries > 1) {
                    years.push_back({middle_of(area->shape), years_on_map(area->planned, start)});
                }
            }
        }
        swatches.push_back(
            planned_fields(regime.interventions()[row], look, here, when_of(regime, here, start)));
    }
    return map_of(sheet, regime, page_text("Where the regimes act"),
                  grounds.drawing() + sheet.texts(years, report::MapSize::half), swatches,
                  rows_without_area(regime, forest));
}

}  // namespace

std::string area_maps(const Site& site, const Management& management, std::span<const InterventionArea> areas,
                      const report::MapWindow& window, const DrawnCuts& made, bool defines) {
    if (areas.empty()) {
        return "";
    }
    const report::MapSheet sheet{site, window};
    std::string maps;
    for (std::size_t place = 0; place < management.regimes.size(); ++place) {
        maps += planned_map(sheet, management.regimes[place], place, areas, *site.forest);
    }
    const std::string cuts = made_maps(sheet, management, made, site.forest->first_year() - 1);
    return report::filled_template("area_maps.html", {{"definitions", defines ? sheet.definitions() : ""},
                                                      {"maps", maps},
                                                      {"cuts", !cuts.empty()},
                                                      {"maps_of_cuts", cuts}});
}

}  // namespace coupling::decades
