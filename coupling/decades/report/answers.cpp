#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <set>

#include "config/text/joined.hpp"
#include "coupling/decades/report/page_parts.hpp"
#include "coupling/results/report/deciding.hpp"
#include "coupling/results/report/html_table.hpp"
#include "coupling/results/report/listings.hpp"
#include "coupling/results/report/markup.hpp"

namespace coupling::decades {
namespace {

using config::joined;
using report::escaped;
using report::fact;
using report::grouped;
using report::HtmlTable;
using report::three_digits;

struct NamedFigure {
    const char* name;
    double (*of)(const YearView&);
};

double all_losses(const YearView& year) {
    return std::accumulate(year.losses.begin(), year.losses.end(), 0.0,
                           [](double sum, const forest::Loss& loss) { return sum + loss.volume_m3pha; });
}

double felled(const YearView& year) {
    return year.losses[forest::index_of(forest::Cause::felled)].volume_m3pha;
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
    NamedFigure{"Dead wood as far as not rotted, dry, t/ha",
                [](const YearView& year) { return year.row->dead_stems_tpha; }},
};

constexpr std::array flows{
    NamedFigure{"Increment, m³/ha a year",
                [](const YearView& year) { return year.row->volume_increment_m3pha; }},
    NamedFigure{"Harvest, m³/ha a year", felled},
    NamedFigure{"Mortality, m³/ha a year",
                [](const YearView& year) { return all_losses(year) - felled(year); }},
    NamedFigure{"Ingrowth over 1 cm, stems/ha a year",
                [](const YearView& year) { return year.row->ingrowth_stems_pha; }},
};

/// Three digits, but nothing finer than a hundredth.
std::string figure_text(double value) {
    return value == 0.0 || value >= 10.0 ? three_digits(value) : report::fixed(value, 2);
}

std::string cell(const Band& band, bool with_band) {
    return with_band ? joined(figure_text(band.mean), " <small>(", figure_text(band.low), " – ",
                              figure_text(band.high), ")</small>")
                     : figure_text(band.mean);
}

/// One row of a table for each regime; with several of them under the name of the figure.
template <class CellsOf>
void add_rows(HtmlTable& table, const RunView& run, const char* name, const CellsOf& cells_of) {
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
    return joined(year == 0           ? "start"
                  : year == run.years ? joined("end, year ", std::to_string(year))
                                      : joined("year ", std::to_string(year)),
                  " <small>", std::to_string(calendar_year), "</small>");
}

std::string standing_table(const RunView& run, bool with_band) {
    std::vector<std::size_t> years{0, run.years / 2, run.years};
    years.erase(std::unique(years.begin(), years.end()), years.end());
    std::vector<std::string> head{"What stands"};
    for (const std::size_t year : years) {
        head.push_back(year_name(run, year));
    }
    HtmlTable table{
        with_band
            ? "Mean of the replicates; in brackets where nine in ten of them lie (5th to 95th "
              "percentile, straight between replicates). Dead wood has its full volume until less than "
              "a tenth of its density is left."
            : "One replicate: no intervals. Living trees from 1 cm diameter on; volume is stem wood over "
              "bark; dead wood has its full volume until less than a tenth of its density is left.",
        head};
    for (const NamedFigure& figure : standing) {
        add_rows(table, run, figure.name, [&](const RegimeView& regime) {
            std::vector<std::string> cells;
            for (const std::size_t year : years) {
                cells.push_back(cell(regime.band(year, figure.of), with_band));
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
    std::vector<std::string> head{"What came and went"};
    for (const Span& span : spans) {
        head.push_back(joined("years ", std::to_string(span.first), " to ", std::to_string(span.last)));
    }
    HtmlTable table{
        "Mean of the years. Increment is growth of the trees that began the year; harvest is what was "
        "felled, "
        "mortality all other losses.",
        head};
    for (const NamedFigure& figure : flows) {
        add_rows(table, run, figure.name, [&](const RegimeView& regime) {
            std::vector<std::string> cells;
            for (const Span& span : spans) {
                cells.push_back(cell(regime.mean_band(span.first, span.last, figure.of), with_band));
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
    return joined("<p class=\"answer\">",
                  run.regimes.size() > 1 ? joined("<b>", escaped(regime.title()), "</b>. ") : "", "Volume ",
                  from_to([](const YearView& year) { return year.stand->volume_m3pha; }),
                  "\u00a0m³/ha, stems from 12\u00a0cm on ",
                  from_to([](const YearView& year) { return stems_from_12_cm(*year.stand); }),
                  " per ha, dominant height ",
                  from_to([](const YearView& year) { return year.stand->dominant_height_m; }),
                  "\u00a0m; harvested ", figure_text(regime.mean_band(1, run.years, felled).mean),
                  "\u00a0m³/ha a year.</p>");
}

std::string area_text(const forest::PatchGrid& grid) {
    return joined(report::fixed(grid.area_ha(), grid.area_ha() < 10.0 ? 2 : 1), " ha on the map, ",
                  grouped(grid.size()), grid.size() == 1 ? " patch" : " patches");
}

std::string elevation_text(const forest::PatchGrid& grid) {
    const auto [low, high] = std::minmax_element(
        grid.patches().begin(), grid.patches().end(),
        [](const forest::Patch& a, const forest::Patch& b) { return a.ground_m < b.ground_m; });
    double slope_deg = 0.0;
    for (const forest::Patch& patch : grid.patches()) {
        slope_deg += patch.slope.in_degrees() / static_cast<double>(grid.size());
    }
    return joined(report::fixed(low->ground_m, 0), " to ", report::fixed(high->ground_m, 0),
                  " m above sea level, mean slope ", report::fixed(slope_deg, 0), "°");
}

std::string years_text(const RunView& run) {
    if (run.regimes.empty()) {
        return "0";
    }
    const std::vector<YearView>& years = run.regimes[0].replicates[0];
    const int start = years.front().row->calendar_year;
    return joined(std::to_string(run.years), ", ", std::to_string(start + 1), " to ",
                  std::to_string(years.back().row->calendar_year), "; start: end of ", std::to_string(start));
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
    return joined(grouped(rocks), " a year with rocks");
}

std::string list_of(const std::vector<std::string>& items) {
    std::string text;
    for (const std::string& item : items) {
        text += joined(text.empty() ? "" : ", ", item);
    }
    return text.empty() ? "–" : text;
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
        "<h1>A forest over ", std::to_string(run.years), " years</h1>\n<p class=\"lead\">Scenario <b>",
        escaped(content.scenario.file.filename().string()), "</b>: ", std::to_string(ran.size()),
        ran.size() == 1 ? " regime, " : " regimes, ",
        has_climates ? joined(std::to_string(run.climates.size()), " climates, ") : "", replicates,
        run.replicates() == 1 ? " replicate" : " replicates each",
        ". Replicates differ only in their random numbers",
        has_climates ? "; all begin with the same forest, and regimes and climates see the same chance" : "",
        ".</p>\n");
    std::vector<std::string> species_names;
    for (const std::size_t s : run.species) {
        species_names.push_back(escaped(content.names.species.all()[s].latin_name));
    }
    html += joined("<dl class=\"facts\">", fact("Forest", area_text(content.grid)));
    html += content.grid.size() > 0 ? fact("Ground", elevation_text(content.grid)) : "";
    html += joined(fact("Years", years_text(run)), fact("Regimes", list_of(regime_names)));
    html += joined(fact("Replicates", replicates), fact("Species", list_of(species_names)));
    html += content.climate.empty() ? ""
                                    : joined("<div class=\"row\"><dt>", has_climates ? "Climates" : "Climate",
                                             "</dt><dd>", breakable(escaped(content.climate)), "</dd></div>");
    if (has_rocks(content.scenario) && content.site != nullptr) {
        html += report::deciding_facts(content.scenario, content.site->sources, rocks_a_year(*content.site));
    } else {
        html += fact("Random seed",
                     report::marked(content.scenario, std::to_string(content.scenario.seed), {"run.seed"}));
    }
    return joined(html, fact("Program", joined("Bannwald ", escaped(content.version))), "</dl>\n");
}

std::string answers(const RunView& run) {
    if (run.regimes.empty()) {
        return "<p>No member of the run is done.</p>\n";
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
