#include "coupling/assessments/decades/report/area_maps.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

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

/// "first in year 5", "when its condition holds".
std::string when_of(const InterventionArea& area) {
    return area.first_year ? page_text("first in year {year}", {{"year", std::to_string(*area.first_year)}})
                           : page_text("when its condition holds");
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

/// What a row does, how much and when first.
PageFields planned_fields(const Intervention& row, std::size_t number,
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
    return swatch_of(row, number,
                     {{"planned", PageFields{{"is_one", count == 1},
                                             {"areas", std::to_string(count)},
                                             {"hectares", report::fixed(sum_ha, 2)},
                                             {"when", when_of(*first)},
                                             {"as_holes", first->at_the_start}}},
                      {"made", false}});
}

/// Rows that need no map: they act where another row has cut.
std::vector<PageFields> rows_without_area(const Regime& regime) {
    std::vector<PageFields> rows;
    for (std::size_t row = 0; row < regime.interventions().size(); ++row) {
        if (const auto cuts = regime.cuts_of(row)) {
            rows.push_back(
                {{"name", regime.interventions()[row].name}, {"row", regime.interventions()[*cuts].name}});
        }
    }
    return rows;
}

std::string map_of(const report::MapSheet& sheet, const Regime& regime, const std::string& title,
                   const Grounds& grounds, const std::vector<PageFields>& swatches,
                   const std::vector<PageFields>& following) {
    return swatches.empty()
               ? ""
               : sheet.figure(
                     {regime.name(), report::join_with_commas({title, regime.name()}), grounds.drawing(), "",
                      report::filled_template("area_legend.html",
                                              {{"swatches", swatches}, {"following", following}})},
                     report::MapSize::half);
}

/// One regime in the first climate: the ground of each row over all years, and the years with its hectares.
std::string made_map(const report::MapSheet& sheet, const Regime& regime, std::size_t place,
                     const DrawnCuts& made) {
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
                    report::with_label(std::to_string(cut.year),
                                       report::fixed(static_cast<double>(cut.patches.size()) * patch_ha, 2)));
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
    return map_of(sheet, regime, page_text("Cuts made"), grounds, swatches, {});
}

std::string made_maps(const report::MapSheet& sheet, const Management& management, const DrawnCuts& made) {
    std::string figures;
    for (std::size_t place = 0; place < management.regimes.size() && made.names != nullptr; ++place) {
        figures += made_map(sheet, management.regimes[place], place, made);
    }
    return figures;
}

/// One regime: the ground of its rows as it is known before the run.
std::string planned_map(const report::MapSheet& sheet, const Regime& regime, std::size_t place,
                        std::span<const InterventionArea> areas) {
    Grounds grounds;
    std::vector<PageFields> swatches;
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
        }
        swatches.push_back(planned_fields(regime.interventions()[row], look, here));
    }
    return map_of(sheet, regime, page_text("Where the regimes act"), grounds, swatches,
                  rows_without_area(regime));
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
        maps += planned_map(sheet, management.regimes[place], place, areas);
    }
    const std::string cuts = made_maps(sheet, management, made);
    return report::filled_template("area_maps.html", {{"definitions", defines ? sheet.definitions() : ""},
                                                      {"maps", maps},
                                                      {"cuts", !cuts.empty()},
                                                      {"maps_of_cuts", cuts}});
}

}  // namespace coupling::decades
