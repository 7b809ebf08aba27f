#include "coupling/today/report/page.hpp"

#include "coupling/nets/net_page.hpp"
#include "coupling/page_scripts/page_scripts.hpp"
#include "coupling/results/report/first_warnings.hpp"
#include "coupling/results/report/markup.hpp"
#include "coupling/results/report/page_text.hpp"
#include "coupling/results/report/style.hpp"
#include "coupling/today/report/sections.hpp"

namespace coupling::report {

void write_page(std::ostream& out, const RunResults& results, const Figures& figures,
                const std::vector<WrittenFile>& files) {
    const std::vector<page_scripts::Script> scripts{page_scripts::charts(), page_scripts::slope()};
    const std::string name = escaped(results.scenario.file.stem().string());
    out << "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
        << page_scripts::policy(scripts)
        << "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
           "<meta name=\"generator\" content=\"Bannwald "
        << escaped(results.version) << "\"/>\n<title>" << page_text("today.page.rockfall_with_and_without")
        << name << "</title>\n<style>\n"
        << style() << "</style>\n</head>\n<body>\n<main>\n"
        << first_warnings(results.warnings) << opening(results, figures) << answers(results, figures)
        << nets(results) << slope_view(results) << maps(results) << charts(results, figures)
        << along_paths(results) << key_figures(results, figures) << grounds(results) << warnings(results)
        << settings(results) << sources_and_files(results, files) << "</main>\n"
        << page_scripts::elements(scripts) << "</body>\n</html>\n";
}

}  // namespace coupling::report
