#include <algorithm>
#include <cmath>
#include <set>

#include "config/text/joined.hpp"
#include "coupling/assessments/decades/report/figure_cells.hpp"
#include "coupling/assessments/decades/report/page_parts.hpp"
#include "coupling/assessments/decades/tables/departures_over_years.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/report/deciding.hpp"
#include "coupling/results/report/departures_line.hpp"
#include "coupling/results/report/first_warnings.hpp"
#include "coupling/results/report/page_head.hpp"
#include "coupling/results/text/element.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::decades {
namespace {

using report::fixed;
using report::grouped;
using report::page_text;
using report::PageFields;

PageFields ground_fields(const forest::PatchGrid& grid) {
    const auto [low, high] = std::minmax_element(
        grid.patches().begin(), grid.patches().end(),
        [](const forest::Patch& a, const forest::Patch& b) { return a.ground_m < b.ground_m; });
    double slope_deg = 0.0;
    for (const forest::Patch& patch : grid.patches()) {
        slope_deg += patch.slope.in_degrees() / static_cast<double>(grid.size());
    }
    return {{"low_ground_m", fixed(low->ground_m, 0)},
            {"high_ground_m", fixed(high->ground_m, 0)},
            {"slope_deg", fixed(slope_deg, 0)}};
}

/// Years, and the stems and basal area with which the forest begins: half a list of trees shows here.
PageFields simulated_fields(const RunView& run) {
    const std::vector<YearView>& years = run.regimes[0].replicates[0];
    const int start = years.front().row->calendar_year;
    const forest::StandFigures& stand = *years.front().stand;
    return {{"years", std::to_string(run.years)},
            {"first_year", std::to_string(start + 1)},
            {"last_year", std::to_string(years.back().row->calendar_year)},
            {"start_year", std::to_string(start)},
            {"stems_pha", grouped(static_cast<std::uint64_t>(std::llround(stand.stems_pha)))},
            {"basal_area_m2pha", fixed(stand.basal_area_m2pha, 1)}};
}

std::string list_of(const std::vector<std::string>& items) {
    return items.empty() ? "–" : report::join_with_commas(items);
}

/// What the forest of the start held beside its trees, and where that comes from.
std::optional<PageFields> start_forest(const PageContent& content) {
    double dead_m3pha = 0.0;
    double young_pha = 0.0;
    double members = 0.0;
    for (const MemberYears& member : content.members) {
        if (!member.years.empty()) {
            dead_m3pha += member.years.front().snags_m3pha + member.years.front().logs_m3pha;
            young_pha += member.years.front().saplings_pha;
            members += 1.0;
        }
    }
    if (members == 0.0) {
        return std::nullopt;
    }
    const ForestSettings& settings = content.scenario.forest;
    const auto source = [&](const std::string& file) {
        return !file.empty()                ? page_text("of the inventory")
               : settings.spin_up_years > 0 ? page_text("of {years} years of spin-up",
                                                        {{"years", std::to_string(settings.spin_up_years)}})
                                            : page_text("not given");
    };
    return PageFields{{"dead_wood", fixed(dead_m3pha / members, 1)},
                      {"dead_wood_from", source(settings.dead_wood)},
                      {"young", fixed(young_pha / members, 0)},
                      {"young_from", source(settings.saplings)}};
}

/// Of all years and members together.
std::string leaving(const PageContent& content) {
    const rockfall::Terrain& terrain = content.site->slope.terrain;
    const auto departures = [&](Cover cover) {
        return departures_over_years(content.members, cover, terrain);
    };
    return report::departures_line({{page_text("over the bare slope"), departures(Cover::bare)},
                                    {page_text("with forest"), departures(Cover::forest)}});
}

/// What decides the rockfall; without rocks only the seed matters.
PageFields rock_fields(const PageContent& content) {
    if (!has_rocks(content.scenario) || content.site == nullptr) {
        return {{"leaving", ""},
                {"rocks", ""},
                {"seed", PageFields{{"marked", report::marked(content.scenario,
                                                              std::to_string(content.scenario.run.seed),
                                                              {"run.seed"})}}}};
    }
    const auto& sources = content.site->sources;
    return {{"leaving", leaving(content)},
            {"rocks", report::deciding_facts(content.scenario, sources,
                                             page_text("{rocks} a year with rocks",
                                                       {{"rocks", grouped(content.site->rocks())}}))},
            {"seed", false}};
}

/// "2 regimes, 3 climates, 5 replicates each".
std::string extent_in_words(const RunView& run, std::size_t regimes) {
    return report::join_with_commas(
        {page_text(regimes == 1 ? "{regimes} regime" : "{regimes} regimes",
                   {{"regimes", std::to_string(regimes)}}),
         run.climates.size() > 1
             ? page_text("{climates} climates", {{"climates", std::to_string(run.climates.size())}})
             : "",
         page_text(run.replicates() == 1 ? "{replicates} replicate" : "{replicates} replicates each",
                   {{"replicates", std::to_string(run.replicates())}})});
}

/// Regimes that ran, each once.
std::vector<std::string> regimes_that_ran(const PageContent& content, const RunView& run) {
    const bool are_climates = run.climates.size() > 1 && !run.chart_a_climate;
    std::set<std::string> ran;
    std::vector<std::string> regimes;
    for (const RegimeView& regime : run.regimes) {
        const std::string name = are_climates ? content.names.regimes.front() : regime.look.title_in_chart();
        if (ran.insert(name).second) {
            regimes.push_back(breakable(name));
        }
    }
    return regimes;
}

}  // namespace

PageFields page_opening(const PageContent& content, const RunView& run) {
    const forest::PatchGrid& grid = content.grid;
    const std::vector<std::string> regimes = regimes_that_ran(content, run);
    std::vector<std::string> species;
    for (const std::size_t s : run.species) {
        species.push_back(content.names.species.all()[s].latin_name);
    }
    PageFields fields = rock_fields(content);
    fields.insert(fields.end(),
                  {{"head", report::page_head(content.scenario.report,
                                              page_text("A forest over {run_years} years",
                                                        {{"run_years", std::to_string(run.years)}}))},
                   {"warnings_link", report::link_to_first_warnings(content.warnings)},
                   {"first_warnings", report::first_warnings(content.warnings)},
                   {"decision", content.decision},
                   {"file", content.scenario.file.filename().string()},
                   {"extent", extent_in_words(run, regimes.size())},
                   {"several_climates", run.climates.size() > 1},
                   {"is_one_patch", grid.size() == 1},
                   {"area_ha", report::hectares(grid.area_ha())},
                   {"patches", grouped(grid.size())},
                   {"ground", grid.size() > 0 ? std::optional{ground_fields(grid)} : std::nullopt},
                   {"simulated", run.regimes.empty() ? std::nullopt : std::optional{simulated_fields(run)}},
                   {"regimes", list_of(regimes)},
                   {"start_forest", start_forest(content)},
                   {"replicates", std::to_string(run.replicates())},
                   {"species", list_of(species)},
                   {"climates", content.climate.empty()
                                    ? std::nullopt
                                    : std::optional{PageFields{{"in_words", breakable(content.climate)}}}},
                   {"version", content.version}});
    return fields;
}

}  // namespace coupling::decades
