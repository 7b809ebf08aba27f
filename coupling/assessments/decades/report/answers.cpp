#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <set>

#include "config/text/joined.hpp"
#include "coupling/assessments/decades/report/page_parts.hpp"
#include "coupling/assessments/decades/tables/departures_over_years.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/report/deciding.hpp"
#include "coupling/results/report/departures_line.hpp"
#include "coupling/results/report/first_warnings.hpp"
#include "coupling/results/report/html_table.hpp"
#include "coupling/results/report/listings.hpp"
#include "coupling/results/report/page_head.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::decades {
namespace {

using config::joined;
using report::escaped;
using report::fact;
using report::grouped;
using report::HtmlTable;
using report::page_text;
using report::three_digits;

struct NamedFigure {
    const char* name;
    double (*of)(const YearView&);
    Bounds bounds = not_negative;
    bool forest::DisturbanceLaw::*simulated = nullptr;  ///< nothing is shown of what was switched off
};

double all_losses(const YearView& year) {
    return std::accumulate(year.losses.begin(), year.losses.end(), 0.0,
                           [](double sum, const forest::Loss& loss) { return sum + loss.volume_m3pha; });
}

double felled(const YearView& year) {
    return year.work.felled_m3pha;
}
double salvaged(const YearView& year) {
    return year.work.salvaged_m3pha;
}
double removed(const YearView& year) {
    return year.work.removed_m3pha;
}
double left(const YearView& year) {
    return year.work.left_m3pha;
}
double margin(const YearView& year) {
    return year.work.margin_eur_pha();
}

template <forest::Cause cause>
double lost_to(const YearView& year) {
    return year.losses[forest::index_of(cause)].volume_m3pha;
}

constexpr std::array standing{
    NamedFigure{"Stems from 12 cm on, per ha",
                [](const YearView& year) { return stems_from_12_cm(*year.stand); }},
    NamedFigure{"Stems from 1 cm on, per ha", [](const YearView& year) { return year.stand->stems_pha; }},
    NamedFigure{"Basal area, m²/ha", [](const YearView& year) { return year.stand->basal_area_m2pha; }},
    NamedFigure{"Volume, m³/ha", [](const YearView& year) { return year.stand->volume_m3pha; }},
    NamedFigure{"Mean diameter (quadratic), cm",
                [](const YearView& year) { return year.stand->mean_dbh_cm; }},
    NamedFigure{"Dominant height, m", [](const YearView& year) { return year.stand->dominant_height_m; }},
    NamedFigure{"Leaf area index", [](const YearView& year) { return year.stand->leaf_area_index; }},
    NamedFigure{"Saplings below 1 cm, per ha", [](const YearView& year) { return year.row->saplings_pha; }},
    NamedFigure{"Standing dead wood, m³/ha", [](const YearView& year) { return year.row->snags_m3pha; }},
    NamedFigure{"Lying dead wood, m³/ha", [](const YearView& year) { return year.row->logs_m3pha; }},
    NamedFigure{
        "of both in decay classes 1 and 2 (hard), m³/ha",
        [](const YearView& year) { return year.row->dead_wood_m3pha[0] + year.row->dead_wood_m3pha[1]; }},
    NamedFigure{"in decay class 3 (soft outside), m³/ha",
                [](const YearView& year) { return year.row->dead_wood_m3pha[2]; }},
    NamedFigure{
        "in decay classes 4 and 5 (soft through), m³/ha",
        [](const YearView& year) { return year.row->dead_wood_m3pha[3] + year.row->dead_wood_m3pha[4]; }},
    NamedFigure{"Dead wood as far as not rotted, dry, t/ha",
                [](const YearView& year) { return year.row->dead_stems_tpha; }},
};

constexpr std::array flows{
    NamedFigure{"Increment, m³/ha a year",
                [](const YearView& year) { return year.row->volume_increment_m3pha; }},
    NamedFigure{"Felled, m³/ha a year", felled},
    NamedFigure{"Salvaged, m³/ha a year", salvaged},
    NamedFigure{"Removed from the forest, m³/ha a year", removed},
    NamedFigure{"Left of felled and salvaged, m³/ha a year", left},
    NamedFigure{"Contribution margin, EUR/ha a year", margin, {}},
    NamedFigure{"Mortality, m³/ha a year",
                [](const YearView& year) {
                    return all_losses(year) -
                           year.losses[forest::index_of(forest::Cause::felled)].volume_m3pha;
                }},
    NamedFigure{"of it by storms, m³/ha a year", lost_to<forest::Cause::wind>, not_negative,
                &forest::DisturbanceLaw::wind},
    NamedFigure{"of it by wet snow, m³/ha a year", lost_to<forest::Cause::snow>, not_negative,
                &forest::DisturbanceLaw::snow},
    NamedFigure{"of it by bark beetles, m³/ha a year", lost_to<forest::Cause::beetle>, not_negative,
                &forest::DisturbanceLaw::beetle},
    NamedFigure{"Ingrowth over 1 cm, stems/ha a year",
                [](const YearView& year) { return year.row->ingrowth_stems_pha; }},
};

/// Three digits, but nothing finer than a hundredth.
std::string figure_text(double value) {
    return value == 0.0 || value >= 10.0 ? three_digits(value) : report::fixed(value, 2);
}

std::string cell(const Band& band, bool with_band) {
    return with_band && band.has_interval()
               ? joined(figure_text(band.mean), " <small>(", figure_text(band.low), " – ",
                        figure_text(band.high), ")</small>")
               : figure_text(band.mean);
}

/// One row of a table for each regime; with several of them under the name of the figure.
template <class CellsOf>
void add_rows(HtmlTable& table, const RunView& run, const std::string& name, const CellsOf& cells_of) {
    if (run.regimes.size() > 1) {
        table.group(name);
    }
    for (const RegimeView& regime : run.regimes) {
        std::vector<std::string> cells{run.regimes.size() > 1 ? escaped(regime.title()) : name};
        for (std::string& text : cells_of(regime)) {
            cells.push_back(std::move(text));
        }
        table.row(cells);
    }
}

std::string year_name(const RunView& run, std::size_t year) {
    const std::int32_t calendar_year = run.regimes[0].replicates[0][year].row->calendar_year;
    return joined(year == 0           ? page_text("start")
                  : year == run.years ? page_text("end, year {year}", {{"year", std::to_string(year)}})
                                      : page_text("year {year}", {{"year", std::to_string(year)}}),
                  " <small>", std::to_string(calendar_year), "</small>");
}

std::string standing_table(const RunView& run, bool with_band) {
    std::vector<std::size_t> years;
    for (const std::size_t year : {std::size_t{0}, run.years / 2, run.years}) {
        if (years.empty() || years.back() != year) {
            years.push_back(year);
        }
    }
    std::vector<std::string> head{page_text("What stands")};
    for (const std::size_t year : years) {
        head.push_back(year_name(run, year));
    }
    HtmlTable table{
        with_band
            ? page_text("Mean of the replicates; in brackets its 90 % interval (Student’s t, skewness by "
                        "Hall 1992; none where all replicates are equal). Dead wood shrinks as it decays.")
            : page_text("One replicate: no intervals. Living trees from 1 cm diameter on; "
                        "volume is stem wood over bark; dead wood shrinks as it decays."),
        head};
    for (const NamedFigure& figure : standing) {
        add_rows(table, run, page_text(figure.name), [&](const RegimeView& regime) {
            std::vector<std::string> cells;
            for (const std::size_t year : years) {
                cells.push_back(cell(regime.band(year, figure.of, figure.bounds), with_band));
            }
            return cells;
        });
    }
    return joined("<section class=\"card\">", table.html(), "</section>\n");
}

std::string flow_table(const RunView& run, bool with_band) {
    struct Span {
        std::size_t first;
        std::size_t last;
    };
    const std::size_t middle = run.years / 2;
    std::vector<Span> spans;
    if (middle > 0) {
        spans = {{1, middle}, {middle + 1, run.years}};
    }
    spans.push_back({1, run.years});
    std::vector<std::string> head{page_text("What came and went")};
    for (const Span& span : spans) {
        head.push_back(page_text("years {span} to {span_last}", {{"span", std::to_string(span.first)},
                                                                 {"span_last", std::to_string(span.last)}}));
    }
    const forest::DisturbanceLaw& law = run.disturbance;
    HtmlTable table{
        joined(
            page_text(
                "Mean of the years. Increment is growth of the trees that began the year; Felled: living "
                "trees that were cut. Salvaged: dead trees worked up. Removed: wood that left the forest. "
                "Left: wood of both that stayed as stumps and logs (felled + salvaged = removed + left). "
                "Mortality is all losses but felling, salvaged trees included; storms, wet snow and bark "
                "beetles are parts of it. Contribution margin: revenue less felling, hauling, planting, "
                "tending and fencing."),
            law.wind || law.snow || law.beetle
                ? ""
                : joined(" ",
                         page_text("Storms, wet snow and bark beetles were not simulated ([disturbance])."))),
        head};
    for (const NamedFigure& figure : flows) {
        if (figure.simulated != nullptr && !(law.*figure.simulated)) {
            continue;
        }
        add_rows(table, run, page_text(figure.name), [&](const RegimeView& regime) {
            std::vector<std::string> cells;
            for (const Span& span : spans) {
                cells.push_back(
                    cell(regime.mean_band(span.first, span.last, figure.of, figure.bounds), with_band));
            }
            return cells;
        });
    }
    return joined("<section class=\"card\">", table.html(), "</section>\n");
}

/// "<b>A: none</b>: volume 410 to 560 m³/ha, ..."
std::string answer_of(const RunView& run, const RegimeView& regime) {
    const auto from_to = [&](double (*figure)(const YearView&)) {
        return joined(figure_text(regime.band(0, figure).mean), " → <b>",
                      figure_text(regime.band(run.years, figure).mean), "</b>");
    };
    return joined(
        "<p class=\"answer\">",
        run.regimes.size() > 1 ? joined("<b>", escaped(regime.title()), "</b>. ") : "",
        page_text(
            "Volume {stand_volume_m3pha} m³/ha, stems from 12 cm on {year_stand} per ha, dominant "
            "height {stand_dominant_height_m} m; felled {felled_mean}, salvaged {salvaged_mean}, removed "
            "{removed_mean}, left {left_mean} m³/ha a year; contribution margin {margin_mean} EUR/ha a year.",
            {{"stand_volume_m3pha", from_to([](const YearView& year) { return year.stand->volume_m3pha; })},
             {"year_stand", from_to([](const YearView& year) { return stems_from_12_cm(*year.stand); })},
             {"stand_dominant_height_m",
              from_to([](const YearView& year) { return year.stand->dominant_height_m; })},
             {"felled_mean", figure_text(regime.mean_band(1, run.years, felled).mean)},
             {"salvaged_mean", figure_text(regime.mean_band(1, run.years, salvaged).mean)},
             {"removed_mean", figure_text(regime.mean_band(1, run.years, removed).mean)},
             {"left_mean", figure_text(regime.mean_band(1, run.years, left).mean)},
             {"margin_mean", figure_text(regime.mean_band(1, run.years, margin).mean)}}),
        "</p>");
}

std::string area_text(const forest::PatchGrid& grid) {
    return page_text(grid.size() == 1 ? "{area_ha} ha on the map, {patches} patch"
                                      : "{area_ha} ha on the map, {patches} patches",
                     {{"area_ha", report::fixed(grid.area_ha(), grid.area_ha() < 10.0 ? 2 : 1)},
                      {"patches", grouped(grid.size())}});
}

std::string elevation_text(const forest::PatchGrid& grid) {
    const auto [low, high] = std::minmax_element(
        grid.patches().begin(), grid.patches().end(),
        [](const forest::Patch& a, const forest::Patch& b) { return a.ground_m < b.ground_m; });
    double slope_deg = 0.0;
    for (const forest::Patch& patch : grid.patches()) {
        slope_deg += patch.slope.in_degrees() / static_cast<double>(grid.size());
    }
    return page_text("{low_ground_m} to {high_ground_m} m above sea level, mean slope {slope_deg}°",
                     {{"low_ground_m", report::fixed(low->ground_m, 0)},
                      {"high_ground_m", report::fixed(high->ground_m, 0)},
                      {"slope_deg", report::fixed(slope_deg, 0)}});
}

std::string years_text(const RunView& run) {
    if (run.regimes.empty()) {
        return "0";
    }
    const std::vector<YearView>& years = run.regimes[0].replicates[0];
    const int start = years.front().row->calendar_year;
    return page_text("{years}, {first_year} to {last_year}; start: end of {start_year}",
                     {{"years", std::to_string(run.years)},
                      {"first_year", std::to_string(start + 1)},
                      {"last_year", std::to_string(years.back().row->calendar_year)},
                      {"start_year", std::to_string(start)}});
}

/// Names may break after their underscores rather than inside a word.
std::string breakable(const std::string& html) {
    std::string text;
    for (const char c : html) {
        text += c;
        text += c == '_' ? "<wbr/>" : "";
    }
    return text;
}

std::string rocks_a_year(const Site& site) {
    const std::uint64_t rocks =
        site.sources.empty() ? 0 : site.sources.back().first_rock + site.sources.back().rocks;
    return page_text("{rocks} a year with rocks", {{"rocks", grouped(rocks)}});
}

std::string list_of(const std::vector<std::string>& items) {
    return items.empty() ? "–" : report::join_with_commas(items);
}

/// What the forest of the start held beside its trees, and where that comes from.
std::string start_fact(const PageContent& content) {
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
    const ForestSettings& settings = content.scenario.forest;
    const auto source = [&](const std::string& file) {
        return !file.empty()                ? page_text("of the inventory")
               : settings.spin_up_years > 0 ? page_text("of {years} years of spin-up",
                                                        {{"years", std::to_string(settings.spin_up_years)}})
                                            : page_text("not given");
    };
    return members > 0.0 ? fact(page_text("Forest at the start"),
                                page_text("dead wood {dead_wood} m³/ha ({dead_wood_from}), young "
                                          "trees below 1 cm {young} a hectare ({young_from})",
                                          {{"dead_wood", report::fixed(dead_m3pha / members, 1)},
                                           {"dead_wood_from", source(settings.dead_wood)},
                                           {"young", report::fixed(young_pha / members, 0)},
                                           {"young_from", source(settings.saplings)}}))
                         : "";
}

/// Of all years and members together.
std::string leaving(const PageContent& content) {
    if (!has_rocks(content.scenario) || content.site == nullptr) {
        return "";
    }
    const rockfall::Terrain& terrain = content.site->slope.terrain;
    const auto departures = [&](Cover cover) {
        return departures_over_years(content.members, cover, terrain);
    };
    return report::departures_line({{page_text("over the bare slope"), departures(Cover::bare)},
                                    {page_text("with forest"), departures(Cover::forest)}});
}

/// Stems and basal area with which the forest begins: half a list of trees shows here.
std::string trees_fact(const RunView& run) {
    if (run.regimes.empty()) {
        return "";
    }
    const forest::StandFigures& start = *run.regimes[0].replicates[0].front().stand;
    return fact(page_text("Trees at the start"),
                page_text("{stems_pha} stems/ha, {basal_area_m2pha} m²/ha basal area",
                          {{"stems_pha", grouped(static_cast<std::uint64_t>(std::llround(start.stems_pha)))},
                           {"basal_area_m2pha", report::fixed(start.basal_area_m2pha, 1)}}));
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

}  // namespace

std::string page_opening(const PageContent& content, const RunView& run) {
    const bool has_climates = run.climates.size() > 1;
    std::set<std::string> ran;
    std::vector<std::string> regime_names;
    for (const RegimeView& regime : run.regimes) {
        const std::string name = has_climates && !run.chart_a_climate ? content.names.regimes.front()
                                                                      : regime.look.title_in_chart();
        if (ran.insert(name).second) {
            regime_names.push_back(breakable(escaped(name)));
        }
    }
    const std::string replicates = std::to_string(run.replicates());
    std::string html = joined(
        report::page_head(content.scenario.report, page_text("A forest over {run_years} years",
                                                             {{"run_years", std::to_string(run.years)}})),
        report::first_warnings(content.warnings), content.decision, leaving(content), "<p class=\"lead\">",
        report::join_sentences(
            {page_text("Scenario <b>{file}</b>: {extent}.",
                       {{"file", escaped(content.scenario.file.filename().string())},
                        {"extent", extent_in_words(run, ran.size())}}),
             page_text("Replicates differ only in their random numbers; from stand records, trees stand at "
                       "other places in each replicate."),
             has_climates ? page_text("Regimes and climates share the random numbers of each replicate, so "
                                      "that their differences are paired.")
                          : ""}),
        "</p>\n");
    std::vector<std::string> species_names;
    for (const std::size_t s : run.species) {
        species_names.push_back(escaped(content.names.species.all()[s].latin_name));
    }
    html += joined("<dl class=\"facts\">", fact(page_text("Forest"), area_text(content.grid)));
    html += content.grid.size() > 0 ? fact(page_text("Ground"), elevation_text(content.grid)) : "";
    html +=
        joined(fact(page_text("Years"), years_text(run)), fact(page_text("Regimes"), list_of(regime_names)));
    html += joined(trees_fact(run), start_fact(content));
    const auto row = [](const std::string& name, const std::string& value) {
        return joined("<div class=\"row\"><dt>", name, "</dt><dd>", value, "</dd></div>");
    };
    html +=
        joined(fact(page_text("Replicates"), replicates), row(page_text("Species"), list_of(species_names)));
    html += content.climate.empty() ? ""
                                    : row(has_climates ? page_text("Climates") : page_text("Climate"),
                                          breakable(escaped(content.climate)));
    if (has_rocks(content.scenario) && content.site != nullptr) {
        html += report::deciding_facts(content.scenario, content.site->sources, rocks_a_year(*content.site));
    } else {
        html +=
            fact(page_text("Random seed"),
                 report::marked(content.scenario, std::to_string(content.scenario.run.seed), {"run.seed"}));
    }
    return joined(html,
                  fact(page_text("Program"), page_text("Bannwald {content_version}",
                                                       {{"content_version", escaped(content.version)}})),
                  "</dl>\n");
}

std::string answers(const RunView& run) {
    if (run.regimes.empty()) {
        return joined("<p>", page_text("No member of the run is done."), "</p>\n");
    }
    const bool with_band = run.replicates() > 1;
    std::string html;
    if (run.years > 0) {
        html += "<section class=\"card\">";
        for (const RegimeView& regime : run.regimes) {
            html += run.chart_a_climate && regime.climate > 0 ? "" : answer_of(run, regime);
        }
        html += run.chart_a_climate ? other_climates() : "";
        html += "</section>\n";
    }
    html += standing_table(run, with_band);
    return run.years > 0 ? joined(html, flow_table(run, with_band)) : html;
}

}  // namespace coupling::decades
