#include "coupling/assessments/compare/page/page.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "config/text/joined.hpp"
#include "config/version.hpp"
#include "coupling/assessments/compare/page/parts.hpp"
#include "coupling/assessments/compare/runs/run_tables.hpp"
#include "coupling/inputs/scenario/report_settings.hpp"
#include "coupling/results/report/deciding.hpp"
#include "coupling/results/report/first_warnings.hpp"
#include "coupling/results/report/head_of_run.hpp"
#include "coupling/results/report/page_frame.hpp"
#include "coupling/results/report/page_head.hpp"
#include "coupling/results/templates/page_files.hpp"
#include "coupling/results/templates/page_template.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/messages.hpp"
#include "coupling/results/text/page_text.hpp"
#include "coupling/results/text/writing_language.hpp"

namespace coupling::compare {
namespace {

using config::joined;
using report::escaped;
using report::PageFields;

/// The warnings of all runs, each with the names of those that have it.
std::vector<std::string> warnings_of(std::span<const FinishedRun> runs, const SideBySide& comparison) {
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
    return sentences;
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

/// "1 000 rocks, seed 1, version 1.0".
std::string size_and_seed(const SummaryOfRun& run) {
    const bool has_years = run.years > 0;
    return report::join_with_commas(
        {report::page_text(has_years        ? run.rocks == 1 ? "{rocks} rock a year" : "{rocks} rocks a year"
                           : run.rocks == 1 ? "{rocks} rock"
                                            : "{rocks} rocks",
                           {{"rocks", report::grouped(run.rocks)}}),
         has_years ? report::page_text(run.years == 1 ? "{years} year" : "{years} years",
                                       {{"years", std::to_string(run.years)}})
                   : "",
         has_years
             ? report::page_text(run.replicates == 1 ? "{replicates} replicate" : "{replicates} replicates",
                                 {{"replicates", std::to_string(run.replicates)}})
             : "",
         report::page_text("seed {seed}", {{"seed", std::to_string(run.seed)}}),
         report::page_text("version {version}", {{"version", run.version}})});
}

/// Messages in the language of the page as rows of a section, under this name.
std::vector<PageFields> messages_as(const char* name, const std::vector<std::string>& messages) {
    std::vector<PageFields> rows;
    for (const std::string& message : messages) {
        rows.push_back({{name, report::message_html(message)}});
    }
    return rows;
}

/// The motion models with what each is judged by, where the runs have different ones.
std::optional<PageFields> models_of(std::span<const FinishedRun> runs, const SideBySide& comparison) {
    const bool differ =
        std::any_of(comparison.settings.begin(), comparison.settings.end(),
                    [](const Disagreement& setting) { return setting.what == "rockfall.motion"; });
    if (!differ) {
        return std::nullopt;
    }
    std::vector<PageFields> rows;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const std::string model = report::setting_of(runs[i].summary, "rockfall.motion");
        rows.push_back(
            {{"run", comparison.names[i]}, {"model", model}, {"verdicts", report::verdicts_on_page(model)}});
    }
    return PageFields{{"rows", rows}};
}

PageFields opening(std::span<const FinishedRun> runs, const SideBySide& comparison) {
    std::vector<PageFields> rows;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        rows.push_back({{"name", comparison.names[i]},
                        {"folder", runs[i].folder.string()},
                        {"size_and_seed", size_and_seed(runs[i].summary)}});
    }
    const std::vector<std::string> warnings = warnings_of(runs, comparison);
    return {{"head", report::page_head(common_head(runs), report::page_text("Runs side by side"))},
            {"warnings_link", report::link_to_first_warnings(warnings)},
            {"first_warnings",
             report::first_warnings(warnings, report::page_text("the pages of the runs list all"))},
            {"runs", rows},
            {"models", models_of(runs, comparison)},
            {"not_comparable", messages_as("why_html", comparison.not_comparable)},
            {"notes", messages_as("note_html", comparison.notes)}};
}

/// Keys of settings stay as the scenario has them; roles of inputs are words of the page's language.
void add_rows(const std::vector<Disagreement>& list, std::string (*name)(std::string_view),
              std::vector<PageFields>& rows) {
    for (const Disagreement& d : list) {
        std::vector<PageFields> values;
        for (const std::string& value : d.values) {
            values.push_back({{"value", value.empty() ? "–" : value}});
        }
        rows.push_back({{"what", name(d.what)}, {"values", values}});
    }
}

PageFields disagreements(const SideBySide& comparison) {
    std::vector<PageFields> rows;
    add_rows(comparison.settings, escaped, rows);
    add_rows(comparison.inputs, report::message_html, rows);
    std::vector<std::string> roles;
    for (const std::string& role : comparison.same_inputs) {
        roles.push_back(report::message_html(role));
    }
    return {{"what_differs", part_if_any("rows", rows)},
            {"same_inputs", part_if_any("roles_html", report::join_with_commas(roles))}};
}

int decimals_of(double value) {
    return std::abs(value) < 10.0 ? 2 : 1;
}

PageFields cell_of(const std::optional<Figure>& figure) {
    if (!figure || std::isnan(figure->value)) {
        const std::string why = figure ? figure->why_none : "";
        return {{"known", std::optional<PageFields>{}},
                {"why_none", part_if_any("why", why.empty() ? "" : report::message_html(why))}};
    }
    const int decimals = decimals_of(figure->value);
    std::optional<PageFields> interval;
    if (!std::isnan(figure->low) && !std::isnan(figure->high)) {
        interval = PageFields{{"low", report::fixed(figure->low, decimals)},
                              {"high", report::fixed(figure->high, decimals)}};
    }
    return {{"known", std::optional{PageFields{{"value", report::fixed(figure->value, decimals)},
                                               {"in_year", figure->year >= 0},
                                               {"figure_year", std::to_string(figure->year)},
                                               {"interval", interval}}}}};
}

PageFields cell_of(const std::optional<Difference>& difference) {
    std::optional<PageFields> known;
    if (difference) {
        const bool has_interval = difference->has_interval();
        const bool is_significant = has_interval && difference->is_more_than_chance();
        known =
            PageFields{{"value", joined(difference->value > 0.0 ? "+" : "",
                                        report::fixed(difference->value, decimals_of(difference->value)))},
                       {"is_significant", is_significant},
                       {"is_not_significant", has_interval && !is_significant},
                       {"has_no_interval", !has_interval}};
    }
    return {{"known", known}};
}

std::string heading_of(const FigureKey& key, const ShownTargets& shown) {
    const std::string course = course_name(key.regime, key.climate);
    return report::join_with_commas(
        {key.target.empty() ? report::page_text("forest") : shown.name_of(key.target),
         course.empty() ? "" : report::page_text("regime {regime}", {{"regime", course}})});
}

/// "" for figures of today.
std::string when_in_words(const std::string& when) {
    return when == over_years   ? report::page_text("mean over years")
           : when == last_year  ? report::page_text("last year")
           : when == worst_year ? report::page_text("worst year")
                                : std::string{};
}

/// A figure in all runs, and its differences to the first one.
PageFields row_of(const Line& line) {
    std::vector<PageFields> values;
    for (const auto& figure : line.figures) {
        values.push_back(cell_of(figure));
    }
    std::vector<PageFields> differences;
    for (std::size_t i = 1; i < line.differences.size(); ++i) {
        differences.push_back(cell_of(line.differences[i]));
    }
    return {{"figure", report::join_with_commas({line.key.quantity, when_in_words(line.key.when)})},
            {"values", values},
            {"differences", differences}};
}

PageFields figures(const SideBySide& comparison, const ShownTargets& shown) {
    std::vector<PageFields> others;
    for (std::size_t i = 1; i < comparison.letters.size(); ++i) {
        others.push_back({{"letter", comparison.letters[i]}});
    }
    // The lines of a title stand one after the other.
    struct Group {
        std::string title;
        bool is_detail = false;
        std::vector<PageFields> lines;
    };
    std::vector<Group> by_title;
    for (const Line& line : comparison.lines) {
        if (is_nothing_everywhere(line)) {
            continue;
        }
        if (const std::string title = heading_of(line.key, shown);
            by_title.empty() || by_title.back().title != title) {
            by_title.push_back({title, !shown.prints(line.key.target), {}});
        }
        by_title.back().lines.push_back(row_of(line));
    }
    std::vector<PageFields> groups;
    for (const Group& group : by_title) {
        groups.push_back({{"title", group.title}, {"is_detail", group.is_detail}, {"lines", group.lines}});
    }
    return {{"others", others},
            {"columns", std::to_string(comparison.names.size() + others.size() + 1)},
            {"few_targets", shown.without_chart.empty()
                                ? std::nullopt
                                : std::optional{PageFields{{"charted", report::grouped(shown.charted())},
                                                           {"targets", report::grouped(shown.all)}}}},
            {"groups", groups}};
}

}  // namespace

void write_page(std::ostream& out, std::span<const FinishedRun> runs, const SideBySide& comparison,
                std::optional<config::Language> chosen) {
    const report::WritingLanguage language{chosen.value_or(common_head(runs).language)};
    const report::PageFrame frame{
        .title = report::page_text("Runs side by side"),
        .version = config::version(),
        .scripts = {page_scripts::charts()},
        .style = joined(report::page_file("short_print.css"), report::page_file("compare.css")),
        .before_main = {}};
    const ShownTargets shown = shown_targets(runs, comparison);
    PageFields fields{{"main_figures", interval_charts(comparison, shown)},
                      {"over_years", charts_over_years(runs, comparison)},
                      {"distributions", distributions(runs, comparison, shown)},
                      {"maps", maps(runs, comparison)},
                      {"has_years", runs.front().summary.years > 0},
                      {"one_replicate", all_of_one_replicate(runs)}};
    for (const PageFields& part :
         {opening(runs, comparison), disagreements(comparison), figures(comparison, shown)}) {
        fields.insert(fields.end(), part.begin(), part.end());
    }
    report::begin_page(out, frame);
    out << report::filled_template("compare_page.html", fields);
    report::end_page(out, frame);
}

}  // namespace coupling::compare
