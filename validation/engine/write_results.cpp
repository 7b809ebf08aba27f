#include "validation/engine/write_results.hpp"

#include <algorithm>
#include <array>

#include "validation/engine/page/page.hpp"
#include "validation/engine/summary_table.hpp"
#include "validation/engine/tables.hpp"

namespace coupling::validation {

namespace {

/// A file beside the tables: its name, what it holds, who writes it.
struct TextFile {
    std::string name;
    std::string sentence;
    void (*write)(std::ostream&, std::span<const CaseResult>);
};

const TextFile page{"report.html", "everything, with charts", write_validation_page};
const std::array texts{TextFile{"overview.md", "how many criteria each case meets", write_overview},
                       TextFile{"summary.md", "the verdicts as a text", write_summary}};

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
        std::vector<std::string> all{page.name};
        for (const ResultTable& table : result_tables()) {
            all.push_back(table.layout->file);
        }
        for (const TextFile& text : texts) {
            all.push_back(text.name);
        }
        return all;
    }();
    return names;
}

std::vector<WrittenFile> write_results(std::span<const CaseResult> cases, ShortRun& results) {
    const auto add = [&](const std::string& name, const std::string& sentence, const auto& write) {
        results.add(name, sentence, [&](std::ostream& out) { write(out, cases); });
    };
    const bool any_variants =
        std::any_of(cases.begin(), cases.end(), [](const CaseResult& result) { return result.has_strict; });
    std::vector<TableLayout> layouts;
    add(page.name, page.sentence, page.write);
    for (const ResultTable& table : result_tables()) {
        if (any_variants || !table.of_variants) {
            add(table.layout->file, table.sentence, table.write);
            layouts.push_back(*table.layout);
        }
    }
    for (const TextFile& text : texts) {
        add(text.name, text.sentence, text.write);
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
                           layouts);
}

}  // namespace coupling::validation
