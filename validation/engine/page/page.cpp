#include "validation/engine/page/page.hpp"

#include "config/text/joined.hpp"
#include "config/version.hpp"
#include "coupling/results/report/page_frame.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"
#include "validation/engine/page/page_parts.hpp"

namespace coupling::validation {
namespace {

using config::joined;
using report::escaped;

std::string notes_of(const CaseResult& result) {
    std::string items;
    for (const std::string& warning : result.warnings) {
        items += joined("<li><strong>", escaped(warning), "</strong></li>\n");
    }
    for (const std::string& note : result.notes) {
        items += joined("<li>", escaped(note), "</li>\n");
    }
    return items.empty() ? "" : joined("<ul class=\"notes\">\n", items, "</ul>\n");
}

std::string case_part(const CaseResult& result) {
    const Score strict = score_of(result, strict_side);
    const Score ours = score_of(result, default_side);
    std::string html = joined("<h2 id=\"", escaped(result.name), "\">",
                              escaped(result.title.empty() ? result.name : result.title),
                              "</h2>\n<p class=\"soft\">", escaped(result.citation), "</p>\n");
    if (!result.has_strict) {
        html += joined("<p class=\"lead\">",
                       report::page_text("Criteria met: <b>{ours}</b>.", {{"ours", ours.text()}}), "</p>\n");
    } else if (strict.met + strict.missed + ours.met + ours.missed > 0) {
        html += joined("<p class=\"lead\">",
                       report::page_text("Criteria met: <b>{strict}</b> in strict, <b>{ours}</b> in default.",
                                         {{"strict", strict.text()}, {"ours", ours.text()}}),
                       "</p>\n");
    }
    html += nearness(result);
    if (!result.rebuilt.empty()) {
        html += joined(result.has_strict ? joined("<p>", report::page_text("<b>What is rebuilt.</b>"))
                                         : joined("<p>", report::page_text("<b>What it shows.</b>")),
                       " ", escaped(result.rebuilt), "</p>\n");
    }
    html += notes_of(result);
    return joined(html, "<section class=\"card\">", verdict_table(result), misses(result), "</section>\n",
                  case_charts(result), plots_part(result), factors_part(result), variants_table(result),
                  choices_table(result));
}

}  // namespace

void write_validation_page(std::ostream& out, std::span<const CaseResult> cases) {
    const report::PageFrame frame{.title = page_title(cases),
                                  .version = config::version(),
                                  .scripts = {page_scripts::charts()},
                                  .style = std::string{page_style()},
                                  .before_main = {}};
    report::begin_page(out, frame);
    out << page_opening(cases);
    for (const CaseResult& result : cases) {
        out << case_part(result);
    }
    report::end_page(out, frame);
}

}  // namespace coupling::validation
