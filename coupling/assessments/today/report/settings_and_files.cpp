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
               ? page_text("today.settings_and_files.none_the_dem_has_no_prj_file_so")
               : text.substr(first + 1, last - first - 1);
}

}  // namespace

std::string warnings(const RunResults& results) {
    return joined("<h2>", page_text("common.warnings"), "</h2>\n", list_of_warnings(results.warnings));
}

std::string settings(const RunResults& results) {
    return settings_section(results.scenario, [](const std::string&) { return true; });
}

std::string sources_and_files(const RunResults& results, const std::vector<WrittenFile>& files) {
    return joined(
        "<h2>", page_text("common.data"), "</h2>\n<section class=\"card\"><p>",
        page_text("today.settings_and_files.projection_input_files_named_as",
                  {{"projection_name_projection", escaped(projection_name(results.site.projection))}}),
        "</p>", table_of_inputs(results.site.inputs), "</section>\n<details><summary>",
        page_text("common.files_of_this_run"), "</summary><section class=\"card\">",
        table_of_files(page_text("common.grids_have_their_projection_prj"), files), "</section></details>\n",
        citation(results.version, results.scenario));
}

}  // namespace coupling::report
