#include "coupling/results/report/first_warnings.hpp"

#include <algorithm>

#include "config/errors/brief.hpp"
#include "coupling/results/templates/page_template.hpp"
#include "coupling/results/text/element.hpp"
#include "coupling/results/text/messages.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::report {
namespace {

/// The lines from one to before another as a list.
PageFields warning_list(const std::vector<config::BriefMessage>& lines, std::size_t first, std::size_t last) {
    std::vector<PageFields> items;
    for (std::size_t i = first; i < last; ++i) {
        items.push_back({{"sentence", message_html(lines[i].sentence)},
                         {"has_more", lines[i].more > 0},
                         {"number", std::to_string(lines[i].more)}});
    }
    return {{"folded", first > 0}, {"lines_open", std::to_string(last - first)}, {"items", items}};
}

constexpr std::size_t most_open = 5;

/// How many lines stand open: one more rather than a fold for a single one.
std::size_t open_of(std::size_t lines) {
    return lines == most_open + 1 ? lines : std::min(most_open, lines);
}

/// `heading` says how many warnings there are and what they are about.
std::string alert(const std::vector<std::string>& sentences, const char* heading, const std::string& where) {
    if (sentences.empty()) {
        return "";
    }
    const std::vector<config::BriefMessage> lines = config::brief(sentences);
    const std::size_t open = open_of(lines.size());
    std::vector<PageFields> lists{warning_list(lines, 0, open)};
    if (open < lines.size()) {
        lists.push_back(warning_list(lines, open, lines.size()));
    }
    return filled_template("first_warnings.html",
                           {{"heading", page_text(heading, {{"warnings", std::to_string(sentences.size())}})},
                            {"where", where},
                            {"lists", lists}});
}

const char* heading_of(const config::Warnings& warnings) {
    return warnings.warnings().size() == 1 ? "{warnings} warning about this run"
                                           : "{warnings} warnings about this run";
}

const char* heading_of(const std::vector<std::string>& sentences) {
    return sentences.size() == 1 ? "{warnings} warning about these runs"
                                 : "{warnings} warnings about these runs";
}

std::string link(std::size_t warnings, const char* heading) {
    if (warnings == 0) {
        return "";
    }
    const std::string words = page_text(heading, {{"warnings", std::to_string(warnings)}});
    return element("p", {{"class", "soft"}}, element("a", {{"href", "#first-warnings"}}, words));
}

}  // namespace

std::string first_warnings(const config::Warnings& warnings) {
    return alert(warnings.warnings(), heading_of(warnings), page_text("the section Warnings lists all"));
}

bool are_all_first(const config::Warnings& warnings) {
    const std::vector<config::BriefMessage> lines = config::brief(warnings.warnings());
    return open_of(lines.size()) == lines.size() &&
           std::all_of(lines.begin(), lines.end(),
                       [](const config::BriefMessage& line) { return line.more == 0; });
}

std::set<std::string> open_first(const config::Warnings& warnings) {
    const std::vector<config::BriefMessage> lines = config::brief(warnings.warnings());
    std::set<std::string> open;
    for (std::size_t i = 0; i < open_of(lines.size()); ++i) {
        if (lines[i].more == 0) {
            open.insert(lines[i].sentence);
        }
    }
    return open;
}

std::string link_to_first_warnings(const config::Warnings& warnings) {
    return link(warnings.warnings().size(), heading_of(warnings));
}

std::string first_warnings(const std::vector<std::string>& sentences, const std::string& where) {
    return alert(sentences, heading_of(sentences), where);
}

std::string link_to_first_warnings(const std::vector<std::string>& sentences) {
    return link(sentences.size(), heading_of(sentences));
}

}  // namespace coupling::report
