#include "coupling/assessments/compare/page/page.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "config/text/joined.hpp"
#include "config/version.hpp"
#include "coupling/assessments/compare/page/parts.hpp"
#include "coupling/assessments/compare/runs/run_tables.hpp"
#include "coupling/inputs/scenario/report_settings.hpp"
#include "coupling/results/report/first_warnings.hpp"
#include "coupling/results/report/head_of_run.hpp"
#include "coupling/results/report/html_table.hpp"
#include "coupling/results/report/page_frame.hpp"
#include "coupling/results/report/page_head.hpp"
#include "coupling/results/templates/page_files.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/messages.hpp"
#include "coupling/results/text/page_text.hpp"
#include "coupling/results/text/writing_language.hpp"

namespace coupling::compare {
namespace {

using config::joined;
using report::escaped;
using report::HtmlTable;

/// The warnings of all runs, each with the names of those that have it.
std::string warnings_of(std::span<const FinishedRun> runs, const SideBySide& comparison) {
    std::vector<std::pair<std::string, std::string>> entries;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        for (const std::string& sentence : runs[i].summary.warnings) {
            const auto known = std::find_if(entries.begin(), entries.end(),
                                            [&](const auto& entry) { return entry.first == sentence; });
            if (known == entries.end()) {
                entries.emplace_back(sentence, comparison.names[i]);
            } else {
                known->second += joined(", ", comparison.names[i]);
            }
        }
    }
    std::vector<std::string> sentences;
    for (const auto& [sentence, names] : entries) {
        sentences.push_back(joined(names, ": ", sentence));
    }
    return report::first_warnings(sentences, report::page_text("the pages of the runs list all"));
}

/// For whom, by whom and where, if all runs agree; the language of the first one. A title, a date and a logo
/// are those of a single run.
ReportSettings common_head(std::span<const FinishedRun> runs) {
    const auto common = [&](const char* key) {
        const std::string value = report::setting_of(runs.front().summary, key);
        const bool agreed = std::all_of(runs.begin(), runs.end(), [&](const FinishedRun& run) {
            return report::setting_of(run.summary, key) == value;
        });
        return agreed ? value : std::string{};
    };
    ReportSettings head;
    head.client = common("report.client");
    head.author = common("report.author");
    head.place = common("report.place");
    head.language = report::head_of_run(runs.front().summary).language;
    return head;
}

std::string opening(std::span<const FinishedRun> runs, const SideBySide& comparison) {
    std::string html = joined(report::page_head(common_head(runs), report::page_text("Runs side by side")),
                              warnings_of(runs, comparison), "<dl class=\"facts\">");
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const SummaryOfRun& run = runs[i].summary;
        html +=
            joined("<div><dt>", escaped(comparison.names[i]), "</dt><dd>", escaped(runs[i].folder.string()),
                   "<br/><span class=\"soft\">",
                   report::join_with_commas(
                       {report::page_text(
                            run.years > 0    ? run.rocks == 1 ? "{rocks} rock a year" : "{rocks} rocks a year"
                            : run.rocks == 1 ? "{rocks} rock"
                                             : "{rocks} rocks",
                            {{"rocks", report::grouped(run.rocks)}}),
                        run.years > 0 ? report::page_text(run.years == 1 ? "{years} year" : "{years} years",
                                                          {{"years", std::to_string(run.years)}})
                                      : "",
                        run.years > 0 ? report::page_text(run.replicates == 1 ? "{replicates} replicate"
                                                                              : "{replicates} replicates",
                                                          {{"replicates", std::to_string(run.replicates)}})
                                      : "",
                        report::page_text("seed {seed}", {{"seed", std::to_string(run.seed)}}),
                        report::page_text("version {version}", {{"version", escaped(run.version)}})}),
                   "</span></dd></div>");
    }
    html += "</dl>\n";
    for (const std::string& why : comparison.not_comparable) {
        html +=
            joined("<p class=\"warning\">",
                   report::page_text("<b>Not comparable:</b> {why}.", {{"why", report::message_html(why)}}),
                   "</p>\n");
    }
    for (const std::string& note : comparison.notes) {
        html += joined("<p class=\"lead\">",
                       report::page_text("Note: {note}.", {{"note", report::message_html(note)}}), "</p>\n");
    }
    return html;
}

void add_names(const SideBySide& comparison, std::vector<std::string>& head) {
    for (const std::string& name : comparison.names) {
        head.push_back(escaped(name));
    }
}

/// Keys of settings stay as the scenario has them; roles of inputs are words of the page's language.
void add_rows(const std::vector<Disagreement>& list, std::string (*name)(std::string_view),
              HtmlTable& table) {
    for (const Disagreement& d : list) {
        std::vector<std::string> cells{name(d.what)};
        for (const std::string& value : d.values) {
            cells.push_back(value.empty() ? "–" : escaped(value));
        }
        table.row(cells);
    }
}

std::string same_inputs(const SideBySide& comparison) {
    std::string roles;
    for (const std::string& role : comparison.same_inputs) {
        roles += joined(roles.empty() ? "" : ", ", report::message_html(role));
    }
    return roles.empty()
               ? ""
               : joined("<p>",
                        report::page_text("Inputs with the same content: {roles}.", {{"roles", roles}}),
                        "</p>\n");
}

std::string disagreements(const SideBySide& comparison) {
    if (comparison.inputs.empty() && comparison.settings.empty()) {
        return joined("<h2>", report::page_text("What differs"), "</h2>\n<p>",
                      report::page_text("Settings and inputs are the same."), "</p>\n",
                      same_inputs(comparison));
    }
    std::vector<std::string> head{report::page_text("Setting or input")};
    add_names(comparison, head);
    HtmlTable table{report::page_text("Only what is not the same in all runs; inputs by their content, with "
                                      "the beginning of their hash where the names are the same."),
                    head};
    add_rows(comparison.settings, escaped, table);
    add_rows(comparison.inputs, report::message_html, table);
    return joined("<h2>", report::page_text("What differs"), "</h2>\n<section class=\"card\">", table.html(),
                  "</section>\n", same_inputs(comparison));
}

std::string in_words(const std::optional<Figure>& figure) {
    if (!figure || std::isnan(figure->value)) {
        return figure && !figure->why_none.empty()
                   ? joined("– <small>(", report::message_html(figure->why_none), ")</small>")
                   : "–";
    }
    const int decimals = std::abs(figure->value) < 10.0 ? 2 : 1;
    std::string text = report::fixed(figure->value, decimals);
    if (!std::isnan(figure->low) && !std::isnan(figure->high)) {
        text += joined(" <small>(", report::fixed(figure->low, decimals), " – ",
                       report::fixed(figure->high, decimals), ")</small>");
    }
    return figure->year < 0
               ? text
               : report::page_text("{value} in year {figure_year}",
                                   {{"value", text}, {"figure_year", std::to_string(figure->year)}});
}

std::string in_words(const std::optional<Difference>& difference) {
    if (!difference) {
        return "–";
    }
    const int decimals = std::abs(difference->value) < 10.0 ? 2 : 1;
    const std::string value =
        joined(difference->value > 0.0 ? "+" : "", report::fixed(difference->value, decimals));
    return !difference->has_interval() ? value
           : difference->is_more_than_chance()
               ? joined("<b>", value, "</b> *")
               : report::page_text("{value} <small>not significant</small>", {{"value", value}});
}

std::string title_of(const FigureKey& key) {
    const std::string course = course_name(key.regime, key.climate);
    return escaped(report::join_with_commas(
        {key.target.empty() ? report::page_text("forest") : key.target,
         course.empty() ? "" : report::page_text("regime {regime}", {{"regime", course}})}));
}

/// "" for figures of today.
std::string when_in_words(const std::string& when) {
    return when == over_years   ? report::page_text("mean over years")
           : when == last_year  ? report::page_text("last year")
           : when == worst_year ? report::page_text("worst year")
                                : std::string{};
}

std::string figures(const SideBySide& comparison, bool has_years, bool one_replicate) {
    std::vector<std::string> head{report::page_text("Figure")};
    add_names(comparison, head);
    for (std::size_t i = 1; i < comparison.letters.size(); ++i) {
        head.push_back(joined(comparison.letters[i], " − A"));
    }
    const std::string caption =
        one_replicate
            ? std::string{report::page_text(
                  "One replicate: no intervals; which differences are significant is not known.")}
            : report::page_text(
                  has_years
                      ? "In brackets: 95 % interval of the chance in the simulated rocks and years, over the "
                        "replicates; at worst years the 90 % interval of the mean. *: the difference is "
                        "statistically significant (95 %). Of many figures one in twenty is so by chance."
                      : "In brackets: 95 % interval of the chance in the simulated rocks. *: the difference "
                        "is "
                        "statistically significant (95 %). Of many figures one in twenty is so by chance.");
    HtmlTable table{
        has_years ? joined(caption, " ",
                           report::page_text(
                               "Over years the mean stands beside the last and the worst year. Species, "
                               "causes of death and timber of which no run has any are left out."))
                  : caption,
        head};
    std::string title;
    for (const Line& line : comparison.lines) {
        if (is_nothing_everywhere(line)) {
            continue;
        }
        if (title != title_of(line.key)) {
            title = title_of(line.key);
            table.group(title);
        }
        const std::string when = when_in_words(line.key.when);
        std::vector<std::string> cells{joined(escaped(line.key.quantity), when.empty() ? "" : ", ", when)};
        for (const auto& figure : line.figures) {
            cells.push_back(in_words(figure));
        }
        for (std::size_t i = 1; i < line.differences.size(); ++i) {
            cells.push_back(in_words(line.differences[i]));
        }
        table.row(cells);
    }
    return joined("<h2>", report::page_text("Figures"), "</h2>\n<section class=\"card\">", table.html(),
                  "</section>\n");
}

}  // namespace

void write_page(std::ostream& out, std::span<const FinishedRun> runs, const SideBySide& comparison,
                std::optional<config::Language> chosen) {
    const report::WritingLanguage language{chosen.value_or(common_head(runs).language)};
    const report::PageFrame frame{.title = report::page_text("Runs side by side"),
                                  .version = config::version(),
                                  .scripts = {page_scripts::charts()},
                                  .style = std::string{report::page_file("compare.css")},
                                  .before_main = {}};
    report::begin_page(out, frame);
    out << opening(runs, comparison) << disagreements(comparison) << interval_charts(comparison)
        << charts_over_years(runs, comparison) << distributions(runs, comparison) << maps(runs, comparison)
        << figures(comparison, runs.front().summary.years > 0, all_of_one_replicate(runs));
    report::end_page(out, frame);
}

}  // namespace coupling::compare
