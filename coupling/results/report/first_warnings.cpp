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

/// `heading` is the key of its text, which says what the warnings are about.
std::string alert(const std::vector<std::string>& sentences, const char* heading, const std::string& where) {
    constexpr std::size_t most = 5;
    if (sentences.empty()) {
        return "";
    }
    const std::vector<config::BriefMessage> lines = config::brief(sentences);
    const std::size_t open = lines.size() == most + 1 ? lines.size() : std::min(most, lines.size());
    std::string html = joined(
        "<section class=\"alert\" aria-label=\"", page_text("Warnings"), "\">",
        page_text(heading, {{"sentences", std::to_string(sentences.size())},
                            {"part", sentences.size() == 1 ? page_text(" warning") : page_text(" warnings")},
                            {"lines_open", items_of(lines, 0, open, where)}}));
    if (open < lines.size()) {
        html += joined("<details><summary>",
                       page_text("{lines_open} more", {{"lines_open", std::to_string(lines.size() - open)}}),
                       "</summary>", items_of(lines, open, lines.size(), where), "</details>");
    }
    return joined(html, "</section>\n");
}

}  // namespace

std::string first_warnings(const config::Warnings& warnings) {
    return alert(warnings.warnings(), "<b>{sentences}{part} about this run</b>{lines_open}",
                 page_text("the section Warnings lists all"));
}

std::string first_warnings(const std::vector<std::string>& sentences, const std::string& where) {
    return alert(sentences, "<b>{sentences}{part} about these runs</b>{lines_open}", where);
}

}  // namespace coupling::report
