#include "config/text/joined.hpp"
#include "coupling/assessments/today/report/sections.hpp"
#include "coupling/results/report/listings.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::report {
namespace {

using config::joined;

std::string projection_name(const std::string& text) {
    const std::size_t first = text.find('"');
    const std::size_t last = text.find('"', first + 1);
    return first == std::string::npos || last == std::string::npos
               ? page_text("none: the DEM has no .prj file, so the grids have none either")
               : text.substr(first + 1, last - first - 1);
}

}  // namespace

std::string warnings(const RunResults& results) {
    return joined("<h2>", page_text("Warnings"), "</h2>\n", list_of_warnings(results.warnings));
}

std::string settings(const RunResults& results) {
    return settings_section(results.scenario, [](const std::string&) { return true; });
}

std::string sources_and_files(const RunResults& results, const std::vector<WrittenFile>& files) {
    return joined(
        "<h2>", page_text("Data"), "</h2>\n<section class=\"card\"><p>",
        page_text("Projection: <b>{projection_name_projection}</b>. Input files, named as in the scenario; "
                  "please credit their owners as their licences ask.",
                  {{"projection_name_projection", escaped(projection_name(results.site.projection))}}),
        "</p>", table_of_inputs(results.site.inputs), "</section>\n<details><summary>",
        page_text("Files of this run"), "</summary><section class=\"card\">",
        table_of_files(page_text("Grids have their projection (.prj) and a QGIS style (.qml) beside them."),
                       files),
        "</section></details>\n", citation(results.version, results.scenario));
}

}  // namespace coupling::report
