#include <algorithm>

#include "config/text/joined.hpp"
#include "coupling/results/report/html_table.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"
#include "validation/engine/page/page_parts.hpp"

namespace coupling::validation {
namespace {

using config::joined;
using report::escaped;

Score sum_of(std::span<const CaseResult> cases, const Side& side) {
    Score sum;
    for (const CaseResult& result : cases) {
        sum.add(score_of(result, side));
    }
    return sum;
}

std::string independent_of(const Score& score) {
    return report::page_text("validation.page_opening.of",
                             {{"score_met_independent", std::to_string(score.met_independent)},
                              {"score_independent", std::to_string(score.independent)}});
}

/// Names of the figures missed, such as "mean speed, m/s; tree hits per rock".
std::string missed_in(const CaseResult& result, const Side& side) {
    std::string names;
    for (const VerdictRow& row : result.rows) {
        if (row.*side.verdict == Verdict::missed) {
            names += joined((names.empty() ? "" : "; "), row_name(row));
        }
    }
    for (const DirectionRow& row : result.directions) {
        if (row.variant == side.name && row.verdict == Verdict::missed) {
            names += joined((names.empty() ? "" : "; "), escaped(direction_name(row)));
        }
    }
    return names.empty() ? report::page_text("common.none") : names;
}

std::string overview(std::span<const CaseResult> cases) {
    report::HtmlTable table{
        "",
        {report::page_text("validation.page_opening.case"), report::page_text("common.strict"),
         report::page_text("common.default"), report::page_text("validation.page_opening.missed_in_strict"),
         report::page_text("validation.page_opening.missed_in_default")}};
    table.text_columns({3, 4});
    for (const CaseResult& result : cases) {
        table.row({joined("<a href=\"#", escaped(result.name), "\">",
                          escaped(result.title.empty() ? result.name : result.title), "</a>"),
                   result.has_strict ? score_of(result, strict_side).text() : "–",
                   score_of(result, default_side).text(),
                   result.has_strict ? missed_in(result, strict_side) : "–",
                   missed_in(result, default_side)});
    }
    return table.html();
}

bool all_own(std::span<const CaseResult> cases) {
    return std::all_of(cases.begin(), cases.end(), [](const CaseResult& result) { return result.is_own; });
}

std::string how_to_read(bool all_own) {
    return joined("<h2>", report::page_text("validation.page_opening.how_to_read_this_page"),
                  "</h2>\n<dl class=\"facts words\"><div><dt>observed</dt><dd>",
                  report::page_text("validation.page_opening.measured_in_the_field"),
                  "</dd></div><div><dt>published</dt><dd>",
                  report::page_text("validation.page_opening.simulated_by_the_authors_of_the"),
                  "</dd></div><div><dt>strict</dt><dd>",
                  report::page_text("validation.page_opening.bannwald_with_exactly_what_the"),
                  "</dd></div><div><dt>default</dt><dd>",
                  report::page_text("validation.page_opening.bannwald_as_it_is_shipped_our"),
                  "</dd></div><div><dt>independent</dt><dd>",
                  report::page_text("validation.page_opening.the_figure_was_not_used_to"),
                  "</dd></div><div><dt>fitted</dt><dd>",
                  report::page_text("validation.page_opening.the_model_was_calibrated_with"),
                  "</dd></div><div><dt>rebuilding</dt><dd>",
                  report::page_text("validation.page_opening.the_figure_was_used_to_rebuild"),
                  "</dd></div></dl>\n<p>",
                  report::page_text(all_own ? "validation.page_opening.criteria_of_own_cases"
                                            : "validation.page_opening.criteria_come_from_the"),
                  "</p>\n");
}

}  // namespace

std::string page_title(std::span<const CaseResult> cases) {
    return report::page_text(all_own(cases) ? "common.bannwald_against_own_cases"
                                            : "common.bannwald_against_the_published");
}

std::string page_opening(std::span<const CaseResult> cases) {
    const Score strict = sum_of(cases, strict_side);
    const Score ours = sum_of(cases, default_side);
    const bool has_strict =
        std::any_of(cases.begin(), cases.end(), [](const CaseResult& result) { return result.has_strict; });
    const std::string of_strict =
        has_strict ? report::page_text(
                         "validation.page_opening.strict_meets_criteria_of_the",
                         {{"strict", strict.text()}, {"independent_of_strict", independent_of(strict)}})
                   : "";
    return joined("<h1>", page_title(cases), "</h1>\n<section class=\"card\"><p class=\"answer\">",
                  report::page_text("validation.page_opening.default_meets_of_the",
                                    {{"of_strict", of_strict},
                                     {"ours", ours.text()},
                                     {"part", has_strict ? "</b>" : "</b> criteria"},
                                     {"independent_of_ours", independent_of(ours)}}),
                  "</p>\n", overview(cases), "</section>\n", how_to_read(all_own(cases)));
}

}  // namespace coupling::validation
