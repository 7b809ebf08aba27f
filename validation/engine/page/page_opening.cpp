#include <algorithm>

#include "config/text/joined.hpp"
#include "coupling/results/report/html_table.hpp"
#include "coupling/results/text/join_texts.hpp"
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
    return report::page_text("{score_met_independent} of {score_independent}",
                             {{"score_met_independent", std::to_string(score.met_independent)},
                              {"score_independent", std::to_string(score.independent)}});
}

/// Names of the figures missed, such as "mean speed, m/s; tree hits per rock".
std::string missed_in(const CaseResult& result, const Side& side) {
    std::vector<std::string> names;
    for (const VerdictRow& row : result.rows) {
        if (row.*side.verdict == Verdict::missed) {
            names.push_back(row_name(row));
        }
    }
    for (const DirectionRow& row : result.directions) {
        if (row.variant == side.name && row.verdict == Verdict::missed) {
            names.push_back(escaped(direction_name(row)));
        }
    }
    return names.empty() ? report::page_text("none") : report::join_with_semicolons(names);
}

std::string overview(std::span<const CaseResult> cases) {
    report::HtmlTable table{
        "",
        {report::page_text("case"), report::page_text("strict"), report::page_text("default"),
         report::page_text("missed in strict"), report::page_text("missed in default")}};
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
    return joined(
        "<h2>", report::page_text("How to read this page"),
        "</h2>\n<dl class=\"facts words\"><div><dt>observed</dt><dd>",
        report::page_text("measured in the field"), "</dd></div><div><dt>published</dt><dd>",
        report::page_text("simulated by the authors of the model with their own program"),
        "</dd></div><div><dt>strict</dt><dd>",
        report::page_text("Bannwald with exactly what the paper states; where it is silent, our choices"),
        "</dd></div><div><dt>default</dt><dd>",
        report::page_text("Bannwald as it is shipped: our best. The forest has no strict set"),
        "</dd></div><div><dt>independent</dt><dd>",
        report::page_text("the figure was not used to rebuild slope or stand: a hit counts"),
        "</dd></div><div><dt>fitted</dt><dd>",
        report::page_text("the model was calibrated with the figure: a hit proves little"),
        "</dd></div><div><dt>rebuilding</dt><dd>",
        report::page_text("the figure was used to rebuild slope or stand, or it rests on choices or a "
                          "reference of our own: a hit proves little"),
        "</dd></div></dl>\n<p>",
        report::page_text(
            all_own ? "Criteria are those of criteria.csv in the folder of each case. A miss is printed as a "
                      "miss, with its likely cause where the folder gives one."
                    : "Criteria come from the published spread and were set before our model was run on the "
                      "case, unless the row is marked as fitted or its note says otherwise. A miss is "
                      "printed as a miss, with its likely cause. A figure marked ± has the standard "
                      "deviation between series of few rocks, as an experiment would have them."),
        "</p>\n");
}

}  // namespace

std::string page_title(std::span<const CaseResult> cases) {
    return report::page_text(all_own(cases) ? "Bannwald against own cases"
                                            : "Bannwald against the published cases");
}

std::string page_opening(std::span<const CaseResult> cases) {
    const Score strict = sum_of(cases, strict_side);
    const Score ours = sum_of(cases, default_side);
    const bool has_strict =
        std::any_of(cases.begin(), cases.end(), [](const CaseResult& result) { return result.has_strict; });
    return joined(
        "<h1>", page_title(cases), "</h1>\n<section class=\"card\"><p class=\"answer\">",
        report::join_sentences(
            {has_strict
                 ? report::page_text("<b>strict</b> meets <b>{strict}</b> criteria, of the independent ones "
                                     "{independent}.",
                                     {{"strict", strict.text()}, {"independent", independent_of(strict)}})
                 : "",
             report::page_text(
                 has_strict
                     ? "<b>default</b> meets <b>{ours}</b>, of the independent ones {independent}."
                     : "<b>default</b> meets <b>{ours}</b> criteria, of the independent ones {independent}.",
                 {{"ours", ours.text()}, {"independent", independent_of(ours)}})}),
        "</p>\n", overview(cases), "</section>\n", how_to_read(all_own(cases)));
}

}  // namespace coupling::validation
