#include "coupling/decades/report/decade_page.hpp"

#include <algorithm>

#include "config/text/joined.hpp"
#include "coupling/decades/report/page_parts.hpp"
#include "coupling/page_scripts/page_scripts.hpp"
#include "coupling/results/report/first_warnings.hpp"
#include "coupling/results/report/listings.hpp"
#include "coupling/results/report/markup.hpp"
#include "coupling/results/report/style.hpp"

namespace coupling::decades {
namespace {

using config::joined;
using report::escaped;

std::vector<Section> sections_of(const PageContent& content, const RunView& run) {
    std::vector<Section> sections = content.first;
    sections.push_back({"The forest at the start, half-way and at the end", answers(run)});
    sections.push_back({"The slope in three dimensions", view_of_years(content, run)});
    sections.push_back({"Maps of the rocks", maps_of_falls(content, run)});
    sections.push_back({"The forest over the years", charts_of_regimes(run)});
    sections.push_back({"Species, losses and diameters", charts_by_regime(content, run)});
    sections.push_back({"The stand seen from above and from the side", pictures(content, run)});
    sections.push_back({"Warnings", report::list_of_warnings(content.warnings)});
    sections.push_back({"Settings", report::table_of_settings(content.scenario, [&](const std::string& key) {
                            return !content.shows_setting || content.shows_setting(key);
                        })});
    sections.push_back(
        {"Data",
         joined("<section class=\"card\"><p>Input files, named as in the scenario; please credit their "
                "owners as their licences ask.</p>",
                report::table_of_inputs(content.inputs), "</section>\n")});
    sections.push_back(
        {"Files of this run",
         joined("<section class=\"card\">", report::table_of_files("", content.files), "</section>\n")});
    return sections;
}

}  // namespace

void write_decade_page(std::ostream& out, const PageContent& content) {
    const RunView run = view_of(content.names, content.members);
    const std::vector<page_scripts::Script> scripts{page_scripts::charts(), page_scripts::slope()};
    out << "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
        << page_scripts::policy(scripts)
        << "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
           "<meta name=\"generator\" content=\"Bannwald "
        << escaped(content.version)
        << "\"/>\n<title>A forest over years: " << escaped(content.scenario.file.stem().string())
        << "</title>\n<style>" << report::style() << page_style() << "</style>\n</head>\n<body>\n"
        << fill_definitions() << "<main>\n"
        << report::first_warnings(content.warnings) << page_opening(content, run);
    for (const Section& section : sections_of(content, run)) {
        if (section.html.empty()) {
            continue;
        }
        if (!section.heading.empty()) {
            out << "<h2>" << section.heading << "</h2>\n";
        }
        out << section.html;
    }
    out << report::citation(content.version, content.scenario) << "</main>\n"
        << page_scripts::elements(scripts) << "</body>\n</html>\n";
}

}  // namespace coupling::decades
