#include "config/text/joined.hpp"
#include "coupling/results/report/listings.hpp"
#include "coupling/results/report/markup.hpp"
#include "coupling/today/report/sections.hpp"

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

}  // namespace

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
