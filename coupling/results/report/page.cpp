#include "coupling/results/report/page.hpp"

#include "coupling/results/report/markup.hpp"
#include "coupling/results/report/sections.hpp"

namespace coupling::report {

void write_page(std::ostream& out, const RunResults& results, const Figures& figures,
                const std::vector<WrittenFile>& files) {
    const std::string name = escaped(results.scenario.file.stem().string());
    out << "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
           "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; "
           "style-src "
           "'unsafe-inline'\"/>\n"
           "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
           "<meta name=\"generator\" content=\"Bannwald "
        << escaped(results.version) << "\"/>\n<title>Rockfall with and without forest: " << name
        << "</title>\n<style>" << style() << "</style>\n</head>\n<body>\n<main>\n"
        << opening(results, figures) << answers(results, figures) << maps(results) << charts(results, figures)
        << key_figures(results, figures) << warnings(results) << settings(results)
        << sources_and_files(results, files) << "</main>\n</body>\n</html>\n";
}

}  // namespace coupling::report
