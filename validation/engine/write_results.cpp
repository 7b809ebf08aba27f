#include "validation/engine/write_results.hpp"

#include <algorithm>
#include <functional>

#include "validation/engine/page/page.hpp"
#include "validation/engine/summary_table.hpp"
#include "validation/engine/tables.hpp"

namespace coupling::validation {

namespace {

/// A file of the results: its name, what it holds, who writes it.
struct ResultFile {
    std::string name;
    std::string sentence;
    std::function<void(std::ostream&, std::span<const CaseResult>)> write;
    bool of_variants = false;  ///< empty for cases with one set of settings, such as those of the forest
};

const std::vector<ResultFile>& files() {
    static const std::vector<ResultFile> list{
        {"report.html", "everything, with charts", write_validation_page},
        {"verdicts.csv", "every figure beside observed and published, with its criterion", write_verdicts},
        {"figures.csv", "every figure of every variant", write_figures},
        {"choices.csv", "the same figures under every moved choice", write_choices, true},
        {"run_out.csv", "share of rocks that get further than each distance", write_run_out, true},
        {"jumps.csv", "lengths of jumps by 10 m of slope length", write_jumps, true},
        {"tree_hits.csv", "share of rocks by number of tree hits", write_tree_hits, true},
        {"hit_heights.csv", "share of tree hits by height", write_hit_heights, true},
        {"factors.csv", "forest effects over combinations of settings", write_factors, true},
        {"directions.csv", "how figures go as settings grow, beside the literature", write_directions, true},
        {"plots.csv", "the points of the plots", write_plots},
        {"overview.md", "how many criteria each case meets", write_overview},
        {"summary.md", "the verdicts as a text", write_summary},
    };
    return list;
}

Json criteria_met(const CaseResult& result) {
    std::size_t criteria = 0;
    std::size_t strict = 0;
    std::size_t standard = 0;
    for (const VerdictRow& row : result.rows) {
        criteria += row.default_verdict != Verdict::no_criterion ? 1 : 0;
        strict += row.strict_verdict == Verdict::inside ? 1 : 0;
        standard += row.default_verdict == Verdict::inside ? 1 : 0;
    }
    Json json{{"case", result.name}, {"criteria", criteria}, {"met_by_default", standard}};
    if (result.has_strict) {
        json["met_by_strict"] = strict;
    }
    return json;
}

}  // namespace

const std::vector<std::string>& result_names() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        for (const ResultFile& file : files()) {
            all.push_back(file.name);
        }
        return all;
    }();
    return names;
}

std::vector<WrittenFile> write_results(std::span<const CaseResult> cases, ShortRun& results) {
    const bool any_variants =
        std::any_of(cases.begin(), cases.end(), [](const CaseResult& result) { return result.has_strict; });
    for (const ResultFile& file : files()) {
        if (any_variants || !file.of_variants) {
            results.add(file.name, file.sentence, [&](std::ostream& out) { file.write(out, cases); });
        }
    }
    Json names = Json::array();
    Json figures = Json::array();
    for (const CaseResult& result : cases) {
        names.push_back(result.name);
        figures.push_back(criteria_met(result));
    }
    return results.publish({.kind = "validate",
                            .run = {{"cases", std::move(names)}},
                            .figures = std::move(figures),
                            .inputs = {},
                            .warnings = {}},
                           {});
}

}  // namespace coupling::validation
