#include "coupling/results/report/first_warnings.hpp"

#include <algorithm>

#include "config/errors/brief.hpp"
#include "config/text/joined.hpp"
#include "coupling/results/text/messages.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::report {
namespace {

using config::joined;

std::string items_of(const std::vector<config::BriefMessage>& lines, std::size_t first, std::size_t last,
                     const std::string& where) {
    std::string items;
    for (std::size_t i = first; i < last; ++i) {
        const std::string more =
            lines[i].more == 0 ? ""
                               : page_text("(and {number} more like this; {where})",
                                           {{"number", std::to_string(lines[i].more)}, {"where", where}});
        items += joined("<li>", message_html(lines[i].sentence), more.empty() ? "" : " ", more, "</li>");
    }
    return joined("<ul>", items, "</ul>");
}

/// `heading` says how many warnings there are and what they are about.
std::string alert(const std::vector<std::string>& sentences, const char* heading, const std::string& where) {
    constexpr std::size_t most = 5;
    if (sentences.empty()) {
        return "";
    }
    const std::vector<config::BriefMessage> lines = config::brief(sentences);
    const std::size_t open = lines.size() == most + 1 ? lines.size() : std::min(most, lines.size());
    std::string html = joined("<section class=\"alert\" aria-label=\"", page_text("Warnings"), "\">", "<b>",
                              page_text(heading, {{"warnings", std::to_string(sentences.size())}}), "</b>",
                              items_of(lines, 0, open, where));
    if (open < lines.size()) {
        html += joined("<details><summary>",
                       page_text("{lines_open} more", {{"lines_open", std::to_string(lines.size() - open)}}),
                       "</summary>", items_of(lines, open, lines.size(), where), "</details>");
    }
    return joined(html, "</section>\n");
}

}  // namespace

std::string first_warnings(const config::Warnings& warnings) {
    return alert(warnings.warnings(),
                 warnings.warnings().size() == 1 ? "{warnings} warning about this run"
                                                 : "{warnings} warnings about this run",
                 page_text("the section Warnings lists all"));
}

std::string first_warnings(const std::vector<std::string>& sentences, const std::string& where) {
    return alert(sentences,
                 sentences.size() == 1 ? "{warnings} warning about these runs"
                                       : "{warnings} warnings about these runs",
                 where);
}

}  // namespace coupling::report
