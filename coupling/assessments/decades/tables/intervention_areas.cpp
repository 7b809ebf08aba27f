#include "coupling/assessments/decades/tables/intervention_areas.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/results/tables/table_of.hpp"
#include "forest/treatment/groups.hpp"

namespace coupling::decades {
namespace {

using config::joined;

/// First year of the run in which a row comes to a turn; nothing where more than the calendar decides.
std::optional<int> first_year_of(const Regime& regime, std::size_t row, int turn) {
    const Intervention& intervention = regime.interventions()[row];
    if (intervention.has_condition() || regime.cuts_of(row)) {
        return std::nullopt;
    }
    if (const auto followed = regime.predecessor_of(row)) {
        const auto first = first_year_of(regime, *followed, turn);
        return first ? std::optional{*first + intervention.after_years} : std::nullopt;
    }
    if (!intervention.listed.empty()) {
        return intervention.listed.front().year;
    }
    return intervention.first_year + turn * intervention.every_years.value_or(0);
}

InterventionArea begun(const Regime& regime, std::size_t place, std::size_t row, const Area& area,
                       int last_year) {
    const int turn = area.order % std::max(1, regime.interventions()[row].ground.entries);
    InterventionArea found;
    found.regime = place;
    found.intervention = row;
    found.number = area.number;
    found.turn = turn + 1;
    found.first_year = first_year_of(regime, row, turn);
    found.planned = planned_years(regime, row, turn, last_year);
    found.area_ha = area.area_ha;
    return found;
}

/// Where a group cut would lie in the forest of the start.
void add_holes(const InterventionArea& frame, const Intervention& row, const Area& area,
               const ForestSite& forest, const forest::Stand& start, std::vector<InterventionArea>& areas) {
    forest::Picks candidates = forest::trees_in(start, area.place);
    std::erase_if(candidates, [&](std::size_t tree) { return start.trees()[tree].dbh_cm < row.from_dbh_cm; });
    for (config::Shape& hole :
         forest::ripest_groups(start, forest.species.table, candidates, area.place, row.groups)) {
        InterventionArea found = frame;
        found.at_the_start = true;
        found.area_ha = row.groups.side_m * row.groups.side_m / 10'000.0;
        found.shape = std::move(hole);
        areas.push_back(std::move(found));
    }
}

/// A corner of the grid of patches, counted in patches.
using Corner = std::pair<int, int>;  // column, row

}  // namespace

config::Shape outline_of(const forest::PatchGrid& grid, std::span<const forest::PatchId> patches) {
    const config::GridFrame& frame = grid.frame();
    std::set<Corner> inside;
    for (const forest::PatchId patch : patches) {
        const config::Cell cell = grid[patch].cell;
        inside.insert({cell.column, cell.row});
    }
    // Edges with the patch on their left, by the corner where they begin; rows count southwards.
    std::map<Corner, std::vector<Corner>> edges;
    const auto edge = [&](Corner from, Corner to) { edges[from].push_back(to); };
    for (const auto& [c, r] : inside) {
        if (!inside.contains({c, r + 1})) {
            edge({c, r + 1}, {c + 1, r + 1});
        }
        if (!inside.contains({c + 1, r})) {
            edge({c + 1, r + 1}, {c + 1, r});
        }
        if (!inside.contains({c, r - 1})) {
            edge({c + 1, r}, {c, r});
        }
        if (!inside.contains({c - 1, r})) {
            edge({c, r}, {c, r + 1});
        }
    }
    config::Shape outline{config::Shape::Kind::polygon, {}};
    const auto point = [&](const Corner& corner) {
        return config::Point2{frame.x_west_m + corner.first * frame.cell_width_m,
                              frame.y_north_m() - corner.second * frame.cell_height_m};
    };
    while (!edges.empty()) {
        const Corner first = edges.begin()->first;
        Corner at = first;
        Corner came{0, 0};
        std::vector<Corner> ring{first};
        do {
            auto& ways = edges.at(at);
            // Where two patches touch by a corner the ring turns left, so that each has a ring of its own.
            auto way = ways.begin();
            for (auto other = ways.begin(); other != ways.end() && ring.size() > 1; ++other) {
                const Corner out{other->first - at.first, other->second - at.second};
                if (came.first * out.second - came.second * out.first < 0) {
                    way = other;
                }
            }
            const Corner next = *way;
            came = {next.first - at.first, next.second - at.second};
            ways.erase(way);
            if (ways.empty()) {
                edges.erase(at);
            }
            at = next;
            ring.push_back(at);
        } while (at != first);
        std::vector<config::Point2> corners;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const bool is_end = i == 0 || i + 1 == ring.size();
            const bool is_straight =
                !is_end && (ring[i].first - ring[i - 1].first) == (ring[i + 1].first - ring[i].first) &&
                (ring[i].second - ring[i - 1].second) == (ring[i + 1].second - ring[i].second);
            if (!is_straight) {
                corners.push_back(point(ring[i]));
            }
        }
        outline.parts.push_back(std::move(corners));
    }
    return outline;
}

std::string wkt_of(const config::Shape& shape) {
    // Holes follow their outer ring by the even-odd rule only in our own reader: here each ring that lies in
    // another one is written as a hole of it.
    std::string text;
    std::vector<bool> is_hole(shape.parts.size(), false);
    for (std::size_t i = 0; i < shape.parts.size(); ++i) {
        for (std::size_t j = 0; j < shape.parts.size(); ++j) {
            if (i != j && config::point_in_polygon({config::Shape::Kind::polygon, {shape.parts[j]}},
                                                   shape.parts[i].front())) {
                is_hole[i] = !is_hole[i];
            }
        }
    }
    const auto ring = [](const std::vector<config::Point2>& corners) {
        std::string numbers;
        for (const config::Point2& corner : corners) {
            numbers += joined(numbers.empty() ? "" : ", ", config::to_text(corner.x_m), " ",
                              config::to_text(corner.y_m));
        }
        return joined("(", numbers, ")");
    };
    for (std::size_t i = 0; i < shape.parts.size(); ++i) {
        if (is_hole[i]) {
            continue;
        }
        std::string rings = ring(shape.parts[i]);
        for (std::size_t j = 0; j < shape.parts.size(); ++j) {
            if (is_hole[j] && config::point_in_polygon({config::Shape::Kind::polygon, {shape.parts[i]}},
                                                       shape.parts[j].front())) {
                rings += joined(", ", ring(shape.parts[j]));
            }
        }
        text += joined(text.empty() ? "" : ", ", "(", rings, ")");
    }
    return joined("MULTIPOLYGON (", text, ")");
}

std::vector<InterventionArea> intervention_areas(const Management& management, const ForestSite& forest,
                                                 std::uint64_t seed) {
    std::vector<InterventionArea> areas;
    std::optional<forest::Stand> start;
    for (std::size_t place = 0; place < management.regimes.size(); ++place) {
        const Regime& regime = management.regimes[place];
        for (std::size_t row = 0; row < regime.interventions().size(); ++row) {
            const Intervention& intervention = regime.interventions()[row];
            if (regime.cuts_of(row)) {
                continue;
            }
            for (const Area& area : regime.areas_of(row)) {
                const InterventionArea frame = begun(regime, place, row, area, forest.run_years);
                if (intervention.treatment == Treatment::group_cut) {
                    if (!start) {
                        start.emplace(forest.start(seed, 0));
                    }
                    add_holes(frame, intervention, area, forest, *start, areas);
                    continue;
                }
                const bool has_shape = !area.place.polygons.empty();
                const std::vector<config::Shape> pieces =
                    has_shape ? area.place.polygons
                              : std::vector<config::Shape>{outline_of(forest.grid, area.patches)};
                for (const config::Shape& piece : pieces) {
                    if (!piece.parts.empty()) {
                        areas.push_back(frame);
                        areas.back().shape = piece;
                    }
                }
            }
        }
    }
    return areas;
}

namespace {

struct AreaRow {
    const Regime& regime;
    const Intervention& row;
    const InterventionArea& area;
    int start_calendar_year;

    [[nodiscard]] std::string years() const {
        std::string text;
        for (const int year : area.planned.years) {
            text += joined(text.empty() ? "" : " ", std::to_string(start_calendar_year + year));
        }
        return text;
    }
    /// The row that it follows, where that decides.
    [[nodiscard]] std::string after() const {
        return area.planned.after ? regime.interventions()[*area.planned.after].name : "";
    }
    [[nodiscard]] std::optional<double> after_years() const {
        return area.planned.after ? std::optional<double>{row.after_years} : std::nullopt;
    }
};

TableOf<AreaRow> table_of_areas() {
    constexpr const char* given = "input regimes.list";
    constexpr const char* follows = "from the regime and the forest";
    return {
        "intervention_areas.csv",
        "Where the interventions of each regime act, as polygons, known before the run.",
        "a piece of ground on which an intervention acts, as known before the run",
        {{"regime", "name of the regime", given, [](const auto& of) { return of.regime.name(); }},
         {"intervention", "name of the row of the regime", given, [](const auto& of) { return of.row.name; }},
         {"treatment", "kind of treatment", given, [](const auto& of) { return name_of(of.row.treatment); }},
         {"where", "how the areas are laid out", given,
          [](const auto& of) { return name_of(of.row.ground.where); }},
         {"area", "number of the strip, slit, polygon, corridor or stand", follows,
          [](const auto& of) { return of.area.number; }},
         {"turn", "of the entries that take turns, from 1", follows,
          [](const auto& of) { return of.area.turn; }},
         {"first_year",
          "first year of the run in which it is due; empty where conditions or earlier rows decide", follows,
          [](const auto& of) { return of.area.first_year; }},
         {"years",
          "calendar years of the run in which the calendar brings it, blanks between; empty where another "
          "row decides",
          follows, [](const auto& of) { return of.years(); }},
         {"condition", "what must hold there besides, as columns of the regime; empty: nothing", given,
          [](const auto& of) { return of.area.planned.condition; }},
         {"after", "row that decides when it comes; empty where the calendar does", given,
          [](const auto& of) { return of.after(); }},
         {"after_years", 0, "years after that row", given, [](const auto& of) { return of.after_years(); }},
         {"area_ha", 4, "forest on it", follows, [](const auto& of) { return of.area.area_ha; }},
         {"basis",
          "plan, or start: a hole of a group cut as the forest of the start would get it (first replicate)",
          follows, [](const auto& of) { return of.area.at_the_start ? "start" : "plan"; }},
         {"wkt", "the ground as well-known text; a corridor in several rows", follows,
          [](const auto& of) { return wkt_of(of.area.shape); }}}};
}

}  // namespace

TableLayout intervention_areas_layout() {
    return table_of_areas();
}

std::vector<WrittenFile> write_intervention_areas(const std::filesystem::path& folder,
                                                  const Management& management,
                                                  std::span<const InterventionArea> areas,
                                                  int start_calendar_year) {
    if (areas.empty()) {
        return {};
    }
    return {table_of_areas().write(folder, [&](auto& rows) {
        for (const InterventionArea& area : areas) {
            const Regime& regime = management.regimes[area.regime];
            rows.add({regime, regime.interventions()[area.intervention], area, start_calendar_year});
        }
    })};
}

}  // namespace coupling::decades
