#include "validation/engine/page/page.hpp"

#include <algorithm>

#include "config/version.hpp"
#include "coupling/results/report/page_frame.hpp"
#include "coupling/results/templates/page_files.hpp"
#include "coupling/results/templates/page_template.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"
#include "validation/engine/page/page_parts.hpp"

namespace coupling::validation {
namespace {

using report::escaped;
using report::PageFields;

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

std::vector<PageFields> as_rows(const char* name, const std::vector<std::string>& texts) {
    std::vector<PageFields> rows;
    for (const std::string& text : texts) {
        rows.push_back({{name, text}});
    }
    return rows;
}

std::optional<PageFields> nearness_fields(const CaseResult& result) {
    const Nearness found = nearness(result);
    return found.compared == 0 ? std::nullopt
                               : std::optional<PageFields>{{{"is_one", found.compared == 1},
                                                            {"compared", std::to_string(found.compared)},
                                                            {"ours_nearer", std::to_string(found.ours)},
                                                            {"strict_nearer", std::to_string(found.strict)}}};
}

PageFields case_fields(const CaseResult& result) {
    const Score strict = score_of(result, strict_side);
    const Score ours = score_of(result, default_side);
    return {{"name", result.name},
            {"title", result.title.empty() ? result.name : result.title},
            {"citation", result.citation},
            {"has_strict", result.has_strict},
            {"strict", result.has_strict ? strict.text() : "–"},
            {"ours", ours.text()},
            {"strict_misses", result.has_strict ? missed_in(result, strict_side) : "–"},
            {"our_misses", missed_in(result, default_side)},
            {"is_judged", !result.has_strict || strict.met + strict.missed + ours.met + ours.missed > 0},
            {"nearness", nearness_fields(result)},
            {"is_rebuilt", !result.rebuilt.empty()},
            {"rebuilt", result.rebuilt},
            {"has_notes", !result.warnings.empty() || !result.notes.empty()},
            {"warnings", as_rows("warning", result.warnings)},
            {"notes", as_rows("note", result.notes)},
            {"verdicts", verdict_table(result)},
            {"misses", misses(result)},
            {"charts", case_charts(result)},
            {"plots", plots_part(result)},
            {"factors", factors_part(result)},
            {"variants", variants_table(result)},
            {"choices", choices_table(result)}};
}

}  // namespace

void write_validation_page(std::ostream& out, std::span<const CaseResult> cases) {
    const bool are_own = std::ranges::all_of(cases, &CaseResult::is_own);
    const std::string title =
        report::page_text(are_own ? "Bannwald against own cases" : "Bannwald against the published cases");
    const report::PageFrame frame{.title = title,
                                  .version = config::version(),
                                  .scripts = {page_scripts::charts()},
                                  .style = std::string{report::page_file("validation.css")},
                                  .before_main = {}};
    std::vector<PageFields> parts;
    for (const CaseResult& result : cases) {
        parts.push_back(case_fields(result));
    }
    const Score strict = sum_of(cases, strict_side);
    const Score ours = sum_of(cases, default_side);
    report::begin_page(out, frame);
    out << report::filled_template("validation_page.html",
                                   {{"title", title},
                                    {"are_own", are_own},
                                    {"has_strict", std::ranges::any_of(cases, &CaseResult::has_strict)},
                                    {"strict", strict.text()},
                                    {"strict_independent", independent_of(strict)},
                                    {"ours", ours.text()},
                                    {"independent", independent_of(ours)},
                                    {"cases", parts}});
    report::end_page(out, frame);
}

}  // namespace coupling::validation
