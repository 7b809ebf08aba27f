#include "coupling/results/report/listings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/results/report/deciding.hpp"
#include "coupling/results/report/html_table.hpp"
#include "coupling/results/report/markup.hpp"
#include "coupling/results/report/sections.hpp"

namespace coupling::report {
namespace {

using config::joined;

std::string projection_name(const std::string& text) {
    const std::size_t first = text.find('"');
    const std::size_t last = text.find('"', first + 1);
    return first == std::string::npos || last == std::string::npos
               ? "none: the DEM has no .prj file, so the grids have none either"
               : text.substr(first + 1, last - first - 1);
}

std::size_t zones_of(const Site& site) {
    std::vector<std::uint32_t> zones;
    for (const rockfall::ReleaseSource& source : site.sources) {
        zones.push_back(source.zone);
    }
    std::sort(zones.begin(), zones.end());
    return static_cast<std::size_t>(std::unique(zones.begin(), zones.end()) - zones.begin());
}

/// One row of the table of all rocks: a name and how to read the figure.
struct KeyFigure {
    const char* name;
    std::string (*value)(const SlopeFigures&);
};

std::string stop_share(const SlopeFigures& slope, rockfall::StopReason reason) {
    return percent(slope.by_reason[static_cast<std::size_t>(reason)].value);
}

std::string three(const Distribution& d) {
    return joined(three_digits(d.mean), " / ", three_digits(d.p90), " / ", three_digits(d.max));
}

using rockfall::StopReason;

constexpr std::array key_figure_rows{
    KeyFigure{"Rocks", [](const SlopeFigures& s) { return grouped(s.rocks); }},
    KeyFigure{"Came to rest on the ground",
              [](const SlopeFigures& s) { return stop_share(s, StopReason::at_rest); }},
    KeyFigure{"Caught by the roughness of the ground",
              [](const SlopeFigures& s) { return stop_share(s, StopReason::caught); }},
    KeyFigure{"Stopped at a tree", [](const SlopeFigures& s) { return stop_share(s, StopReason::tree); }},
    KeyFigure{"Stopped at a lying log", [](const SlopeFigures& s) { return stop_share(s, StopReason::log); }},
    KeyFigure{"Held by a net", [](const SlopeFigures& s) { return stop_share(s, StopReason::net); }},
    KeyFigure{"Left the terrain (not stopped)",
              [](const SlopeFigures& s) { return stop_share(s, StopReason::left_terrain); }},
    KeyFigure{"Given up (too many impacts, not stopped)",
              [](const SlopeFigures& s) { return stop_share(s, StopReason::gave_up); }},
    KeyFigure{"Run-out in plan, m: mean / 90 % / largest",
              [](const SlopeFigures& s) { return three(s.run_out_m); }},
    KeyFigure{"Highest speed of a rock, m/s: mean / 90 % / largest",
              [](const SlopeFigures& s) { return three(s.max_speed_mps); }},
    KeyFigure{"Mean speed of a rock, m/s",
              [](const SlopeFigures& s) { return three_digits(s.mean_speed_mps); }},
    KeyFigure{"Highest energy of a rock, kJ: mean / 90 % / largest",
              [](const SlopeFigures& s) { return three(s.max_energy_kj); }},
    KeyFigure{"Highest jump of a rock, m: mean / 90 % / largest",
              [](const SlopeFigures& s) { return three(s.max_height_m); }},
    KeyFigure{"Mean height of all jumps, m",
              [](const SlopeFigures& s) { return three_digits(s.jump_height_mean_m); }},
    KeyFigure{"Ground impacts per rock",
              [](const SlopeFigures& s) { return three_digits(s.ground_impacts_per_rock); }},
    KeyFigure{"Rocks that hit a tree", [](const SlopeFigures& s) { return percent(s.hit_a_tree.value); }},
    KeyFigure{"Tree hits per rock", [](const SlopeFigures& s) { return three_digits(s.tree_hits_per_rock); }},
    KeyFigure{"Trees broken per rock",
              [](const SlopeFigures& s) { return three_digits(s.trees_broken_per_rock); }},
    KeyFigure{"Energy taken by trees per rock, kJ",
              [](const SlopeFigures& s) { return three_digits(s.tree_energy_per_rock_kj); }},
    KeyFigure{"Hits on lying logs per rock",
              [](const SlopeFigures& s) { return three_digits(s.log_hits_per_rock); }},
    KeyFigure{"Logs broken per rock",
              [](const SlopeFigures& s) { return three_digits(s.logs_broken_per_rock); }},
    KeyFigure{"Energy taken by logs per rock, kJ",
              [](const SlopeFigures& s) { return three_digits(s.log_energy_per_rock_kj); }},
};

/// Sums over the trees of a diameter class.
struct DiameterClass {
    const char* name;
    double low_cm;
    std::uint64_t trees = 0;
    std::uint64_t hit = 0;
    std::uint64_t hits = 0;
    std::uint64_t broken = 0;
    std::uint64_t energy_j = 0;
};

std::string share_text(std::uint64_t part, std::uint64_t whole) {
    return whole == 0 ? "–" : percent(static_cast<double>(part) / static_cast<double>(whole));
}

std::string trees_by_diameter(const RunResults& results) {
    std::array<DiameterClass, 6> classes{{{"below 8 cm", 0.0},
                                          {"8 to 20 cm", 8.0},
                                          {"20 to 36 cm", 20.0},
                                          {"36 to 52 cm", 36.0},
                                          {"52 to 72 cm", 52.0},
                                          {"72 cm and more", 72.0}}};
    DiameterClass all{"all", 0.0};
    for (std::size_t i = 0; i < results.site.trees.size(); ++i) {
        const rockfall::StemTally& tally = results.tally.stems[i];
        auto at = classes.begin();
        while (at + 1 != classes.end() && results.site.trees[i].stem.dbh_cm >= (at + 1)->low_cm) {
            ++at;
        }
        for (DiameterClass* sums : {&*at, &all}) {
            ++sums->trees;
            sums->hit += tally.hits > 0 ? 1U : 0U;
            sums->hits += tally.hits;
            sums->broken += tally.broken;
            sums->energy_j += tally.energy_j;
        }
    }
    HtmlTable table{
        "Which trees take the energy: every tree is listed in tables/stems.csv. A hit counts as breaking if "
        "it "
        "exceeds the strength of the stem.",
        {"Diameter at breast height", "trees", "hit at least once", "hits", "of them breaking",
         "share of all energy taken"}};
    const auto add = [&](const DiameterClass& c) {
        table.row({c.name, grouped(c.trees), grouped(c.hit), grouped(c.hits), share_text(c.broken, c.hits),
                   share_text(c.energy_j, all.energy_j)});
    };
    for (const DiameterClass& c : classes) {
        if (c.trees > 0) {
            add(c);
        }
    }
    add(all);
    return table.html();
}

std::string section_of(const std::string& key) {
    return key.substr(0, key.find('.'));
}

}  // namespace

std::string fact(std::string_view name, const std::string& value) {
    return std::string{"<div><dt>"}.append(name).append("</dt><dd>").append(value).append("</dd></div>");
}

std::string rock_size(const Scenario& scenario) {
    switch (scenario.diameter_kind) {
        case DiameterKind::fixed:
            return joined(config::to_text(scenario.diameter_m), " m");
        case DiameterKind::classes: {
            const auto [low, high] =
                std::minmax_element(scenario.diameter_classes_m.begin(), scenario.diameter_classes_m.end());
            return low == scenario.diameter_classes_m.end()
                       ? "in classes"
                       : joined(config::to_text(*low), " to ", config::to_text(*high), " m, in classes");
        }
        case DiameterKind::uniform:
            return joined(config::to_text(scenario.diameter_low_m), " to ",
                          config::to_text(scenario.diameter_high_m), " m");
        case DiameterKind::lognormal:
            break;
    }
    return joined("log-normal, mean ", config::to_text(scenario.diameter_m), " m");
}

std::string motion_in_words(const Scenario& scenario) {
    const rockfall::ModelDescription& model = rockfall::description_of(scenario.rockfall.fall.motion.model);
    return joined(model.title, ": ", model.rocks);
}

std::string why_no_obstacles(const RunResults& results) {
    const Scenario& scenario = results.scenario;
    if (scenario.trees.empty() && scenario.logs.empty()) {
        return "neither trees nor logs were given";
    }
    const std::string files =
        joined(scenario.trees, scenario.trees.empty() || scenario.logs.empty() ? "" : " and ", scenario.logs);
    return joined("no trees or logs are left: ", escaped(files), " list none on the terrain");
}

std::string opening(const RunResults& results, const Figures&) {
    const Scenario& scenario = results.scenario;
    const Site& site = results.site;
    const config::GridFrame& frame = site.map_frame;
    std::string html = joined(
        "<h1>", results.with_forest ? "Rockfall with and without forest" : "Rockfall over the bare slope",
        "</h1>\n<p class=\"lead\">Scenario <b>", escaped(scenario.file.filename().string()),
        "</b>: ", grouped(results.rocks), " rocks were released from ", grouped(site.sources.size()),
        " places",
        (results.with_forest
             ? std::string{", each falling twice with the same random numbers: through the forest as it "
                           "stands, lying logs included, and over the bare slope without either."}
             : joined(" and fell over the bare slope: ", why_no_obstacles(results), ".")),
        "</p>\n<dl class=\"facts\">");
    html += fact("Terrain", joined(three_digits(frame.x_east_m() - frame.x_west_m), " × ",
                                   three_digits(frame.y_north_m() - frame.y_south_m), " m, cells of ",
                                   three_digits(frame.cell_width_m), " m"));
    html += fact("Release", joined(grouped(site.sources.size()), " sources in ", grouped(zones_of(site)),
                                   (zones_of(site) == 1 ? " zone" : " zones")));
    html += fact("Trees", grouped(site.trees.size()));
    if (!site.logs.empty()) {
        html += fact("Lying logs", grouped(site.logs.size()));
    }
    html += deciding_facts(scenario, site.sources, grouped(results.rocks));
    return joined(html, fact("Program", joined("Bannwald ", escaped(results.version))), "</dl>\n");
}

std::string key_figures(const RunResults& results, const Figures& figures) {
    const std::vector<Cover> covers = covers_of(results);
    std::vector<std::string> head{"All rocks"};
    for (const Cover cover : covers) {
        head.emplace_back(cover == Cover::forest ? "with forest" : "bare slope");
    }
    HtmlTable table{"", head};
    for (const KeyFigure& row : key_figure_rows) {
        std::vector<std::string> cells{row.name};
        for (const Cover cover : covers) {
            cells.push_back(row.value(figures.at(cover)));
        }
        table.row(cells);
    }
    return joined("<h2>Key figures</h2>\n<section class=\"card\">", table.html(), "</section>\n",
                  (results.with_forest && !results.site.trees.empty()
                       ? joined("<section class=\"card\">", trees_by_diameter(results), "</section>\n")
                       : ""));
}

std::string list_of_warnings(const config::Warnings& warnings) {
    if (warnings.sentences().empty()) {
        return "<p>None.</p>\n";
    }
    std::string html = "<ul class=\"notes\">";
    for (const std::string& sentence : warnings.sentences()) {
        html += joined("<li>", escaped(sentence), "</li>");
    }
    return joined(html, "</ul>\n");
}

std::string table_of_settings(const Scenario& scenario,
                              const std::function<bool(const std::string&)>& is_shown) {
    if (scenario.options == nullptr) {
        return "<p>Not recorded.</p>\n";
    }
    HtmlTable table{"Settings marked with ● differ from the default.",
                    {"setting", "value", "unit", "default", "meaning"}};
    table.text_columns({2, 4});
    std::string section;
    for (const config::ParameterRow& row : scenario.options->rows()) {
        if (!is_shown(row.key)) {
            continue;
        }
        if (section_of(row.key) != section) {
            section = section_of(row.key);
            table.group(joined("[", escaped(section), "]"));
        }
        table.row(
            {joined("<code>", escaped(row.key.substr(std::min(row.key.size(), section.size() + 1))),
                    "</code>"),
             row.value_text.empty() ? "–" : escaped(row.value_text), row.unit == "-" ? "" : escaped(row.unit),
             row.default_text.empty() ? "–" : escaped(row.default_text), escaped(row.meaning)},
            row.changed ? "changed" : "");
    }
    return joined("<section class=\"card\">", table.html(), "</section>\n");
}

std::string table_of_inputs(const std::vector<InputFile>& inputs) {
    HtmlTable table{"", {"role", "file", "bytes", "hash"}};
    table.text_columns({1});
    for (const InputFile& file : inputs) {
        table.row({escaped(file.role), escaped(file.name), grouped(file.bytes),
                   joined("<code>", escaped(file.hash), "</code>")});
    }
    return table.html();
}

std::string table_of_files(std::string_view caption, const std::vector<WrittenFile>& files) {
    HtmlTable table{caption, {"file", "holds"}};
    table.text_columns({1});
    for (const WrittenFile& file : files) {
        table.row({joined("<code>", escaped(file.path), "</code>"), escaped(file.sentence)});
    }
    return table.html();
}

std::string citation(const std::string& version, const Scenario& scenario) {
    return joined(
        "<h2>How to cite</h2>\n<p>Bannwald ", escaped(version),
        ": rockfall through forests on real terrain, GPL-3.0-or-later. Scenario ",
        escaped(scenario.file.filename().string()), ", seed ", std::to_string(scenario.seed),
        ". The rockfall model follows Rammer, W., Brauner, M., Dorren, L. K. A., Berger, F., Lexer, M. J. "
        "(2010): "
        "Evaluation of a 3-D rockfall module within a forest patch model. Natural Hazards and Earth "
        "System Sciences "
        "10, 699–711.</p>\n");
}

std::string warnings(const RunResults& results) {
    return joined("<h2>Warnings</h2>\n", list_of_warnings(results.warnings));
}

std::string settings(const RunResults& results) {
    return joined("<h2>Settings</h2>\n",
                  table_of_settings(results.scenario, [](const std::string&) { return true; }));
}

std::string sources_and_files(const RunResults& results, const std::vector<WrittenFile>& files) {
    return joined(
        "<h2>Data</h2>\n<section class=\"card\"><p>Projection: <b>",
        escaped(projection_name(results.site.projection)),
        "</b>. Input files, named as in the scenario; please credit their owners as their licences "
        "ask.</p>",
        table_of_inputs(results.site.inputs),
        "</section>\n<h2>Files of this run</h2>\n<section class=\"card\">",
        table_of_files("Grids have their projection (.prj) and a QGIS style (.qml) beside them.", files),
        "</section>\n", citation(results.version, results.scenario));
}

}  // namespace coupling::report
